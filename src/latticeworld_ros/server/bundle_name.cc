#include "latticeworld_ros/server/bundle_name.h"

#include <algorithm>

#include "latticeworld/common/text.h"

namespace latticeworld {

Status CheckBundleName(std::string_view name) {
  constexpr std::size_t kMaxLength = 128;
  const auto is_alphanumeric = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
  };
  const auto is_legal = [&](char c) {
    return is_alphanumeric(c) || c == '_' || c == '-' || c == '.';
  };
  if (!name.empty() && name.size() <= kMaxLength && is_alphanumeric(name[0]) &&
      std::all_of(name.begin(), name.end(), is_legal)) {
    return Status();
  }
  return InvalidArgument("name is " + Quote(name) +
                         "; legal is a letter or digit, then letters, digits, '_', '-' and '.', at "
                         "most 128 characters, no path");
}

}  // namespace latticeworld
