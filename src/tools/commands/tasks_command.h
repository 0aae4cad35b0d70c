#ifndef LATTICEWORLD_TOOLS_COMMANDS_TASKS_COMMAND_H_
#define LATTICEWORLD_TOOLS_COMMANDS_TASKS_COMMAND_H_

namespace CLI {
class App;
}

namespace latticeworld::tools {

// `latticeworld tasks`: draws navigation tasks in the world of a bundle.
void AddTasksCommand(CLI::App* app, int* exit_status);

}  // namespace latticeworld::tools

#endif  // LATTICEWORLD_TOOLS_COMMANDS_TASKS_COMMAND_H_
