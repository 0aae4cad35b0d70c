#ifndef LATTICEWORLD_TOOLS_PROGRESS_DISPLAY_H_
#define LATTICEWORLD_TOOLS_PROGRESS_DISPLAY_H_

#include <chrono>
#include <string>
#include <string_view>
#include <vector>

namespace latticeworld::tools {

// What part of its time a work usually spends in one of its stages, in (0, 1].
struct StageShare {
  std::string_view stage;
  double share;
};

// How long a work still takes [s], its present stage having come to `fraction` in stage_s seconds:
// the rest of that stage at the pace of its beginning, and what `shares` has after it. -1 as long
// as too little is done to tell. A stage that is not in `shares` stands for itself alone.
double EstimateLeft(const std::vector<StageShare>& shares, std::string_view stage, double fraction,
                    double stage_s);

// "[######--------------] terrain 30 %, 0:12 left"; without a time where left_s is negative.
std::string ProgressLine(std::string_view stage, double fraction, double left_s);

// Shows on stderr how far a work is: on a terminal one line that is rewritten, with the time that
// is left, elsewhere one line a stage.
class ProgressDisplay {
 public:
  // shares: of the stages that take time, in their order; none: each stage is told of by itself
  explicit ProgressDisplay(std::vector<StageShare> shares = {});
  void Show(std::string_view stage, double fraction);
  void Clear();  // takes the terminal's line away

 private:
  using Clock = std::chrono::steady_clock;

  bool terminal_;
  std::vector<StageShare> shares_;
  std::string stage_, line_;
  Clock::time_point stage_began_;
};

}  // namespace latticeworld::tools

#endif  // LATTICEWORLD_TOOLS_PROGRESS_DISPLAY_H_
