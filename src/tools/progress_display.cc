#include "tools/progress_display.h"

#include <unistd.h>

#include <cmath>
#include <iostream>

namespace latticeworld::tools {

ProgressDisplay::ProgressDisplay() : terminal_(::isatty(STDERR_FILENO) == 1) {}

void ProgressDisplay::Show(std::string_view stage, double fraction) {
  if (terminal_) {
    std::cerr << "\r\033[K" << stage << " " << std::lround(100.0 * fraction) << " %" << std::flush;
  } else if (stage != stage_) {
    std::cerr << stage << " ...\n";
  }
  stage_ = stage;
}

void ProgressDisplay::Clear() {
  if (terminal_) std::cerr << "\r\033[K" << std::flush;
}

}  // namespace latticeworld::tools
