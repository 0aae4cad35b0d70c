#ifndef LATTICEWORLD_TOOLS_ARGUMENTS_H_
#define LATTICEWORLD_TOOLS_ARGUMENTS_H_

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/common/request_fields.h"
#include "latticeworld/common/result.h"

namespace CLI {
class App;
}

namespace latticeworld::tools {

// Adds an option that takes one value, kept as it is typed: a command converts it itself, so that
// its error can name every unusable value and what would be right.
void AddValueOption(CLI::App* command, const std::string& name, const std::string& value_name,
                    const std::string& description);

// What was typed for the option; nullopt when it was not given.
std::optional<std::string> ValueOf(const CLI::App& command, const std::string& name);

// Converts values and collects what is wrong with them, one violation an option.
class ArgumentReader {
 public:
  explicit ArgumentReader(const CLI::App* command) : command_(command) {}

  // Each gives `absent` when the option was not given, and also after adding a violation.
  double Number(const std::string& name, double absent);
  std::int64_t Integer(const std::string& name, std::int64_t low, std::int64_t high,
                       std::int64_t absent);
  // Any whole number; which of them are legal is for somebody else to say.
  int Whole(const std::string& name, int absent);
  std::uint64_t Unsigned(const std::string& name, std::uint64_t absent);
  // Numbers parted by a comma; nullopt also when the option was not given.
  std::optional<std::pair<double, double>> NumberPair(const std::string& name);
  std::string Choice(const std::string& name, const std::vector<std::string>& legal,
                     const std::string& absent);
  // `option` makes sense only beside `needed`, or beside one of them.
  void RequireBeside(const std::string& option, const std::string& needed);
  void RequireBesideOneOf(const std::string& option, const std::vector<std::string>& needed);
  // At most one of `options` makes sense.
  void AllowOneOf(const std::vector<std::string>& options);

  // A value that the caller cannot use.
  void Refuse(const std::string& name, const std::string& given, const std::string& legal);
  // What the owner of the values has against them. options: for the owner's names. Nothing of an
  // option that is told as unusable already.
  void AddIllegal(const FieldNames& options, std::vector<Violation> illegal);

  // INVALID_ARGUMENT with every violation so far; OK when there is none.
  Status status() const;

 private:
  const CLI::App* command_;
  std::vector<Violation> violations_;
};

// The text that an option gives: what was typed, or the content of FILE when that is @FILE; "" when
// it was not given.
Result<std::string> TextOf(const CLI::App& command, const std::string& name);

// A refusal with violations, of the options that the owner's names came from; others stay.
Status UnderOptions(const FieldNames& options, const Status& status);

inline constexpr int kExitSuccess = 0;
inline constexpr int kExitFailure = 1;
inline constexpr int kExitUsage = 2;

// Says on stderr what failed, each violation on a line of its own. Gives the exit status:
// kExitUsage for INVALID_ARGUMENT, else kExitFailure.
int ReportFailure(const std::string& command, const Status& status);

}  // namespace latticeworld::tools

#endif  // LATTICEWORLD_TOOLS_ARGUMENTS_H_
