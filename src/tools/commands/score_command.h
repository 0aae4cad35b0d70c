#ifndef LATTICEWORLD_TOOLS_COMMANDS_SCORE_COMMAND_H_
#define LATTICEWORLD_TOOLS_COMMANDS_SCORE_COMMAND_H_

namespace CLI {
class App;
}

namespace latticeworld::tools {

// latticeworld score: how well worlds match the words that they were made from.
void AddScoreCommand(CLI::App* app, int* exit_status);

}  // namespace latticeworld::tools

#endif  // LATTICEWORLD_TOOLS_COMMANDS_SCORE_COMMAND_H_
