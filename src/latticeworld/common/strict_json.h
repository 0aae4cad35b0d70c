#ifndef LATTICEWORLD_COMMON_STRICT_JSON_H_
#define LATTICEWORLD_COMMON_STRICT_JSON_H_

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/common/status.h"

namespace latticeworld {

// What is parsed at all; a schema or a reader says what is legal.
struct JsonLimits {
  std::size_t max_bytes = 1 << 20;
  int max_depth = 8;                 // containers within each other
  std::size_t max_keys = 64;         // of one object that are kept
  std::size_t max_elements = 65536;  // of one array that are kept
};

// A key as a JSON pointer writes it (RFC 6901); what is too long for a message is cut.
std::string PointerToken(std::string_view key);

// Parses a text that may be hostile, in memory linear in its length and time linear in its length
// times max_elements (the parser looks through an array after each container in it). Adds a
// violation, its pointer beginning with `origin`, for each key of an object that stands there more
// than once (duplicate_key), for a text that is too long (too_long), no UTF-8 (bad_encoding), no
// JSON (parse_error), or nested too deep (too_deep). It keeps only as much of what is too deep or
// too many as shows that. False: there is no document.
bool ParseStrictly(std::string_view text, const std::string& origin, const JsonLimits& limits,
                   nlohmann::json* json, std::vector<Violation>* violations);

// What a person or a program can still use: cuts violations to 500, and says at the end how many
// there were more (more_violations).
void LimitViolations(std::vector<Violation>* violations);

}  // namespace latticeworld

#endif  // LATTICEWORLD_COMMON_STRICT_JSON_H_
