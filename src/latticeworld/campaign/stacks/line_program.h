#ifndef LATTICEWORLD_CAMPAIGN_STACKS_LINE_PROGRAM_H_
#define LATTICEWORLD_CAMPAIGN_STACKS_LINE_PROGRAM_H_

#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/campaign/stacks/child_process.h"
#include "latticeworld/common/result.h"

namespace latticeworld {

// A program that answers lines with lines. It is ended with this object, together with all that it
// started, and asked to end when this process does.
class LineProgram {
 public:
  // Starts the program in that folder. Errors: RESOURCE_EXHAUSTED.
  static Result<LineProgram> Start(const std::vector<std::string>& command,
                                   const std::filesystem::path& folder);
  LineProgram(LineProgram&& other) noexcept;
  LineProgram& operator=(LineProgram&&) = delete;
  ~LineProgram();

  // Says the line and waits for one, both without their ends. Errors, in words that begin with "the
  // program": DEADLINE_EXCEEDED (it did not hear or answer in time), FAILED_PRECONDITION (it
  // ended), INVALID_ARGUMENT (it says more than kMostBytes, or something that nobody asked for).
  Result<std::string> Ask(std::string_view line, double answer_time_s);

  static constexpr std::size_t kMostBytes = 1 << 20;

 private:
  explicit LineProgram(const ChildProcess& child) : child_(child) {}
  Status Gone();

  ChildProcess child_;
  std::string unread_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_CAMPAIGN_STACKS_LINE_PROGRAM_H_
