#ifndef LATTICEWORLD_TOOLS_COMMANDS_GENERATE_COMMAND_H_
#define LATTICEWORLD_TOOLS_COMMANDS_GENERATE_COMMAND_H_

namespace CLI {
class App;
}

namespace latticeworld::tools {

// Adds `latticeworld generate`; when it is called, it sets *exit_status.
void AddGenerateCommand(CLI::App* app, int* exit_status);

}  // namespace latticeworld::tools

#endif  // LATTICEWORLD_TOOLS_COMMANDS_GENERATE_COMMAND_H_
