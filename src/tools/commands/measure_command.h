#ifndef LATTICEWORLD_TOOLS_COMMANDS_MEASURE_COMMAND_H_
#define LATTICEWORLD_TOOLS_COMMANDS_MEASURE_COMMAND_H_

namespace CLI {
class App;
}

namespace latticeworld::tools {

// latticeworld measure: how much land is like nature's.
void AddMeasureCommand(CLI::App* app, int* exit_status);

}  // namespace latticeworld::tools

#endif  // LATTICEWORLD_TOOLS_COMMANDS_MEASURE_COMMAND_H_
