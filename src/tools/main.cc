#include <csignal>

#include "tools/command_line.h"

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow fails to be written, no more
  return latticeworld::tools::RunCommandLine(argc, argv);
}
