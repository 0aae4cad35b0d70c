#ifndef LATTICEWORLD_TOOLS_COMMANDS_DATASET_COMMAND_H_
#define LATTICEWORLD_TOOLS_COMMANDS_DATASET_COMMAND_H_

namespace CLI {
class App;
}

namespace latticeworld::tools {

// `latticeworld dataset`: writes training data in chat format.
void AddDatasetCommand(CLI::App* app, int* exit_status);

}  // namespace latticeworld::tools

#endif  // LATTICEWORLD_TOOLS_COMMANDS_DATASET_COMMAND_H_
