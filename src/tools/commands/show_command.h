#ifndef LATTICEWORLD_TOOLS_COMMANDS_SHOW_COMMAND_H_
#define LATTICEWORLD_TOOLS_COMMANDS_SHOW_COMMAND_H_

namespace CLI {
class App;
}

namespace latticeworld::tools {

// Adds `latticeworld show`; when it is called, it sets *exit_status.
void AddShowCommand(CLI::App* app, int* exit_status);

}  // namespace latticeworld::tools

#endif  // LATTICEWORLD_TOOLS_COMMANDS_SHOW_COMMAND_H_
