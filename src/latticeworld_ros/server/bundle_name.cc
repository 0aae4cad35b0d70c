#include "latticeworld_ros/server/bundle_name.h"

#include <algorithm>

#include "latticeworld/common/text.h"

namespace latticeworld {

Status CheckBundleName(std::string_view name, std::size_t most_characters) {
  const auto is_alphanumeric = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
  };
  const auto is_legal = [&](char c) {
    return is_alphanumeric(c) || c == '_' || c == '-' || c == '.';
  };
  if (!name.empty() && name.size() <= most_characters && is_alphanumeric(name[0]) &&
      std::all_of(name.begin(), name.end(), is_legal)) {
    return Status();
  }
  return Status::FromViolations(
      "illegal name", {{"illegal_name", "name",
                        "is " + Quote(name) +
                            "; legal is a letter or digit, then letters, digits, '_', '-' and "
                            "'.', at most " +
                            std::to_string(most_characters) + " characters, no path",
                        Quote(name)}});
}

}  // namespace latticeworld
