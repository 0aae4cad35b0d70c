#ifndef LATTICEWORLD_TOOLS_PROGRESS_DISPLAY_H_
#define LATTICEWORLD_TOOLS_PROGRESS_DISPLAY_H_

#include <string>
#include <string_view>

namespace latticeworld::tools {

// Shows on stderr how far a generation is: on a terminal one line that is rewritten, elsewhere one
// line a stage.
class ProgressDisplay {
 public:
  ProgressDisplay();
  void Show(std::string_view stage, double fraction);
  void Clear();  // takes the terminal's line away

 private:
  bool terminal_;
  std::string stage_;
};

}  // namespace latticeworld::tools

#endif  // LATTICEWORLD_TOOLS_PROGRESS_DISPLAY_H_
