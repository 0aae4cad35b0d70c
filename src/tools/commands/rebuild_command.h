#ifndef LATTICEWORLD_TOOLS_COMMANDS_REBUILD_COMMAND_H_
#define LATTICEWORLD_TOOLS_COMMANDS_REBUILD_COMMAND_H_

namespace CLI {
class App;
}

namespace latticeworld::tools {

// latticeworld rebuild: a bundle's world, made again from what was asked and answered.
void AddRebuildCommand(CLI::App* app, int* exit_status);

}  // namespace latticeworld::tools

#endif  // LATTICEWORLD_TOOLS_COMMANDS_REBUILD_COMMAND_H_
