#include "latticeworld/simulation/agent_names.h"

#include <algorithm>

#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

constexpr std::size_t kMaxNameLength = 64;

bool IsLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool IsNameCharacter(char c) { return IsLetter(c) || (c >= '0' && c <= '9') || c == '_'; }

}  // namespace

Status CheckAgentName(std::string_view name) {
  if (!name.empty() && name.size() <= kMaxNameLength && IsLetter(name.front()) &&
      std::all_of(name.begin(), name.end(), IsNameCharacter)) {
    return Status();
  }
  return InvalidArgument("agent name " + Quote(name) +
                         " is not legal: it must begin with a letter and hold only letters, "
                         "digits and underscores, at most " +
                         std::to_string(kMaxNameLength) + " characters");
}

std::string NumberedName(AgentCategory category, int number) {
  std::string name(NameOf(category));
  std::replace(name.begin(), name.end(), ' ', '_');
  return name + "_" + std::to_string(number);
}

}  // namespace latticeworld
