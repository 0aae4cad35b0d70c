#ifndef LATTICEWORLD_TOOLS_COMMANDS_EXPORT_COMMAND_H_
#define LATTICEWORLD_TOOLS_COMMANDS_EXPORT_COMMAND_H_

namespace CLI {
class App;
}

namespace latticeworld::tools {

// Adds `latticeworld export`: a bundle's world in the formats of other programs.
void AddExportCommand(CLI::App* app, int* exit_status);

}  // namespace latticeworld::tools

#endif  // LATTICEWORLD_TOOLS_COMMANDS_EXPORT_COMMAND_H_
