#ifndef LATTICEWORLD_TOOLS_COMMAND_LINE_H_
#define LATTICEWORLD_TOOLS_COMMAND_LINE_H_

namespace latticeworld::tools {

// The whole of the program `latticeworld`. Gives its exit status: 0 success, 1 failure, 2 unusable
// arguments, texts or pictures.
int RunCommandLine(int argc, const char* const* argv);

}  // namespace latticeworld::tools

#endif  // LATTICEWORLD_TOOLS_COMMAND_LINE_H_
