#ifndef LATTICEWORLD_TOOLS_COMMANDS_SENSORS_COMMAND_H_
#define LATTICEWORLD_TOOLS_COMMANDS_SENSORS_COMMAND_H_

namespace CLI {
class App;
}

namespace latticeworld::tools {

// Adds `latticeworld sensors`; when it is called, it sets *exit_status.
void AddSensorsCommand(CLI::App* app, int* exit_status);

}  // namespace latticeworld::tools

#endif  // LATTICEWORLD_TOOLS_COMMANDS_SENSORS_COMMAND_H_
