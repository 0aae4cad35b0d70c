#ifndef LATTICEWORLD_COMMON_REQUEST_FIELDS_H_
#define LATTICEWORLD_COMMON_REQUEST_FIELDS_H_

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "latticeworld/common/enum_names.h"
#include "latticeworld/common/status.h"
#include "latticeworld/common/text.h"

namespace latticeworld {

// Reading of a request's fields: what is wrong is added to *violations, under the field's name.

inline void RefuseUnknown(const std::string& field, const std::string& given,
                          const std::string& legal, std::vector<Violation>* violations) {
  violations->push_back(
      {"unknown_value", field, Quote(given) + " is unknown; legal are " + legal, Quote(given)});
}

// The enum value that a field names, with '_' for ' ' as well.
template <typename Enum>
std::optional<Enum> ReadName(const std::string& field, const std::string& given,
                             std::vector<Violation>* violations) {
  std::string name = given;
  std::replace(name.begin(), name.end(), '_', ' ');
  const std::optional<Enum> value = FromName<Enum>(name);
  if (!value) RefuseUnknown(field, given, LegalNames<Enum>(), violations);
  return value;
}

// The refusal of a request of which something cannot be read: what that is, and what its owner has
// against the rest, so that all is told at once. A request that can be read is for its owner alone
// to judge.
inline Status RefuseUnread(std::string_view what, std::vector<Violation> unread,
                           std::vector<Violation> rest) {
  std::move(rest.begin(), rest.end(), std::back_inserter(unread));
  return Status::FromViolations(what, std::move(unread));
}

// What an interface calls the fields that a validation names: {the validation's name, its own}.
using FieldNames = std::vector<std::pair<std::string_view, std::string_view>>;

// Gives violations the pointers that their readers know. One that is not among the names stays.
inline void Rename(const FieldNames& names, std::vector<Violation>* violations) {
  for (Violation& violation : *violations) {
    const auto known = std::find_if(names.begin(), names.end(), [&violation](const auto& name) {
      return name.first == violation.pointer;
    });
    if (known != names.end()) violation.pointer = known->second;
  }
}

}  // namespace latticeworld

#endif  // LATTICEWORLD_COMMON_REQUEST_FIELDS_H_
