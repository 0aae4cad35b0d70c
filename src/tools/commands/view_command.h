#ifndef LATTICEWORLD_TOOLS_COMMANDS_VIEW_COMMAND_H_
#define LATTICEWORLD_TOOLS_COMMANDS_VIEW_COMMAND_H_

namespace CLI {
class App;
}

namespace latticeworld::tools {

// `latticeworld view`: shows the world of a bundle, as it begins, to browsers.
void AddViewCommand(CLI::App* app, int* exit_status);

}  // namespace latticeworld::tools

#endif  // LATTICEWORLD_TOOLS_COMMANDS_VIEW_COMMAND_H_
