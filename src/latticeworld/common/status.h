#ifndef LATTICEWORLD_COMMON_STATUS_H_
#define LATTICEWORLD_COMMON_STATUS_H_

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace latticeworld {

// Codes and their numbers are those of gRPC (google.rpc.Code).
enum class StatusCode : std::uint8_t {
  kOk = 0,
  kCancelled = 1,
  kUnknown = 2,
  kInvalidArgument = 3,
  kDeadlineExceeded = 4,
  kNotFound = 5,
  kAlreadyExists = 6,
  kPermissionDenied = 7,
  kResourceExhausted = 8,
  kFailedPrecondition = 9,
  kAborted = 10,
  kOutOfRange = 11,
  kUnimplemented = 12,
  kInternal = 13,
  kUnavailable = 14,
  kDataLoss = 15,
  kUnauthenticated = 16,
};

// "INVALID_ARGUMENT" and so on.
std::string_view ToString(StatusCode code);

// One thing that is wrong with an input. A validation collects every violation before it answers.
struct Violation {
  std::string code;     // stable and short, for programs: "wrong_line_count", "unknown_key", ...
  std::string pointer;  // JSON pointer, parameter name or "row 3, column 7": where it is wrong
  std::string message;  // what was given and what is legal
  std::string given;    // the offending value, as given
};

// The outcome of what can fail. Expected failures are values; nothing here throws.
class [[nodiscard]] Status {
 public:
  Status() = default;  // OK
  Status(StatusCode code, std::string message, std::vector<Violation> violations = {});

  // INVALID_ARGUMENT whose message is `what` followed by the first kViolationsTold violations and
  // how many more there are; OK when there is none. violations() has them all.
  static constexpr int kViolationsTold = 20;
  static Status FromViolations(std::string_view what, std::vector<Violation> violations);

  bool ok() const { return code_ == StatusCode::kOk; }
  StatusCode code() const { return code_; }
  const std::string& message() const { return message_; }
  const std::vector<Violation>& violations() const { return violations_; }

  // The same failure with `context` and ": " before its message; OK stays OK.
  Status WithContext(std::string_view context) const;

  // "INVALID_ARGUMENT: size must be ..."
  std::string ToString() const;

 private:
  StatusCode code_ = StatusCode::kOk;
  std::string message_;
  std::vector<Violation> violations_;
};

Status InvalidArgument(std::string message);
Status NotFound(std::string message);
Status PermissionDenied(std::string message);
Status FailedPrecondition(std::string message);
Status ResourceExhausted(std::string message);
Status Unavailable(std::string message);
Status DataLoss(std::string message);
Status Cancelled(std::string message);
Status Internal(std::string message);

}  // namespace latticeworld

#endif  // LATTICEWORLD_COMMON_STATUS_H_
