#ifndef LATTICEWORLD_TOOLS_COMMANDS_QUERY_COMMAND_H_
#define LATTICEWORLD_TOOLS_COMMANDS_QUERY_COMMAND_H_

namespace CLI {
class App;
}

namespace latticeworld::tools {

// `latticeworld query`: what is called so in a bundle's world, and where it begins.
void AddQueryCommand(CLI::App* app, int* exit_status);

}  // namespace latticeworld::tools

#endif  // LATTICEWORLD_TOOLS_COMMANDS_QUERY_COMMAND_H_
