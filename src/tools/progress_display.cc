#include "tools/progress_display.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <utility>

namespace latticeworld::tools {
namespace {

constexpr int kBar = 20;  // characters
// What is done in less tells nothing of the rest.
constexpr double kLeastFraction = 0.05;
constexpr double kLeast_s = 0.5;

// m:ss, or h:mm:ss.
std::string TimeText(double seconds) {
  const long whole = std::lround(std::min(seconds, 3.6e6));
  char text[32];
  if (whole < 3600) {
    std::snprintf(text, sizeof(text), "%ld:%02ld", whole / 60, whole % 60);
  } else {
    std::snprintf(text, sizeof(text), "%ld:%02ld:%02ld", whole / 3600, whole / 60 % 60, whole % 60);
  }
  return text;
}

}  // namespace

double EstimateLeft(const std::vector<StageShare>& shares, std::string_view stage, double fraction,
                    double stage_s) {
  if (!(fraction >= kLeastFraction) || stage_s < kLeast_s) return -1.0;
  const double stage_left_s = stage_s * std::max(0.0, 1.0 - fraction) / fraction;
  const auto here = std::find_if(shares.begin(), shares.end(),
                                 [stage](const StageShare& entry) { return entry.stage == stage; });
  if (here == shares.end()) return stage_left_s;
  double later = 0.0;
  for (auto entry = here + 1; entry != shares.end(); ++entry) later += entry->share;
  return stage_left_s + stage_s / fraction * later / here->share;
}

std::string ProgressLine(std::string_view stage, double fraction, double left_s) {
  const double shown = std::isfinite(fraction) ? std::clamp(fraction, 0.0, 1.0) : 0.0;
  const int full = static_cast<int>(shown * kBar);
  std::string line = "[" + std::string(full, '#') + std::string(kBar - full, '-') + "] ";
  line += std::string(stage) + " " + std::to_string(std::lround(100.0 * shown)) + " %";
  if (left_s >= 0.0) line += ", " + TimeText(left_s) + " left";
  return line;
}

ProgressDisplay::ProgressDisplay(std::vector<StageShare> shares)
    : terminal_(::isatty(STDERR_FILENO) == 1), shares_(std::move(shares)) {}

void ProgressDisplay::Show(std::string_view stage, double fraction) {
  const bool begins = stage != stage_;
  if (begins) {
    stage_ = stage;
    stage_began_ = Clock::now();
    if (!terminal_) std::cerr << stage << " ...\n";
  }
  if (!terminal_) return;
  const double stage_s = std::chrono::duration<double>(Clock::now() - stage_began_).count();
  std::string line = ProgressLine(stage, fraction, EstimateLeft(shares_, stage, fraction, stage_s));
  if (line == line_) return;
  line_ = std::move(line);
  std::cerr << "\r\033[K" << line_ << std::flush;
}

void ProgressDisplay::Clear() {
  if (terminal_) std::cerr << "\r\033[K" << std::flush;
  line_.clear();
}

}  // namespace latticeworld::tools
