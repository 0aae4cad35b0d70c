#include "tools/command_line.h"

int main(int argc, char** argv) { return latticeworld::tools::RunCommandLine(argc, argv); }
