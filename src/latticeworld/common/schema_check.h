#ifndef LATTICEWORLD_COMMON_SCHEMA_CHECK_H_
#define LATTICEWORLD_COMMON_SCHEMA_CHECK_H_

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/common/status.h"

namespace latticeworld {

// Validates documents against a JSON Schema (draft 7), in this project's words.
class SchemaChecker {
 public:
  // The schema is a part of the program. It says "type" (one) of every value but enums, and uses no
  // anyOf, oneOf, allOf or not; references are of the form "#/definitions/...".
  explicit SchemaChecker(std::string_view schema);
  ~SchemaChecker();
  SchemaChecker(const SchemaChecker&) = delete;
  SchemaChecker& operator=(const SchemaChecker&) = delete;

  // Adds every violation, its pointer beginning with `origin`: missing_key, unknown_key,
  // wrong_type, out_of_range, unknown_value, bad_format, wrong_count, duplicate_value.
  void Check(const nlohmann::json& document, const std::string& origin,
             std::vector<Violation>* violations) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_COMMON_SCHEMA_CHECK_H_
