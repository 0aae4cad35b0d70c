#include "latticeworld/simulation/agent_names.h"

#include <algorithm>

#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

constexpr std::size_t kMaxNameLength = 64;

bool IsLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool IsNameCharacter(char c) { return IsLetter(c) || (c >= '0' && c <= '9') || c == '_'; }

}  // namespace

void CheckAgentName(std::string_view name, std::vector<Violation>* violations) {
  if (!name.empty() && name.size() <= kMaxNameLength && IsLetter(name.front()) &&
      std::all_of(name.begin(), name.end(), IsNameCharacter)) {
    return;
  }
  violations->push_back({"illegal_name", "name",
                         Quote(name) +
                             " is not legal; legal is a letter, then letters, digits and "
                             "underscores, at most " +
                             std::to_string(kMaxNameLength) + " characters",
                         Quote(name)});
}

std::string NumberedName(std::string_view kind, int number) {
  std::string name(kind);
  std::replace(name.begin(), name.end(), ' ', '_');
  return name + "_" + std::to_string(number);
}

Status NoneNamed(std::string_view kind, std::string_view name,
                 const std::vector<std::string>& names) {
  constexpr std::size_t kNamed = 50;  // nobody reads a thousand
  std::string message = "there is no " + std::string(kind) + " named " + Quote(name);
  if (names.empty()) return NotFound(message + ": there are none");
  const std::size_t named = std::min(kNamed, names.size());
  message += ": there are " + Join({names.begin(), names.begin() + named}, ", ");
  if (named < names.size()) {
    message += " and " + std::to_string(names.size() - named) + " more";
  }
  return NotFound(message);
}

}  // namespace latticeworld
