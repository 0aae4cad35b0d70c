#ifndef LATTICEWORLD_ROS_CONVERSION_REQUEST_FIELDS_H_
#define LATTICEWORLD_ROS_CONVERSION_REQUEST_FIELDS_H_

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <string>
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

using NamedNumber = std::pair<const char*, double>;
inline void CheckFinite(std::initializer_list<NamedNumber> fields,
                        std::vector<Violation>* violations) {
  for (const auto& [field, value] : fields) {
    if (std::isfinite(value)) continue;
    violations->push_back(
        {"out_of_range", field, FormatDouble(value) + " is not finite", FormatDouble(value)});
  }
}

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_CONVERSION_REQUEST_FIELDS_H_
