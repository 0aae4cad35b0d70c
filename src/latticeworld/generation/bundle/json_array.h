#ifndef LATTICEWORLD_GENERATION_BUNDLE_JSON_ARRAY_H_
#define LATTICEWORLD_GENERATION_BUNDLE_JSON_ARRAY_H_

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/generation/json_fields.h"

namespace latticeworld::json_fields {

struct ArrayLimits {
  const char* thing;  // what an entry is, in the singular: "agent"
  std::size_t most_bytes;
  std::size_t most_entries;
};

// The entries of a file that is one JSON array; `decode` makes one of an entry's JSON and throws
// FieldError for what is wrong in it. Errors: DATA_LOSS, naming the entry.
template <typename Entry, typename Decode>
Result<std::vector<Entry>> DecodeArray(std::string_view content, const ArrayLimits& limits,
                                       const Decode& decode) {
  const std::string thing = limits.thing;
  try {
    if (content.size() > limits.most_bytes) {
      throw FieldError("is " + std::to_string(content.size()) + " bytes long; at most " +
                       std::to_string(limits.most_bytes) + " are legal");
    }
    const Json json = Parse(content);
    if (!json.is_array()) throw FieldError("is not an array");
    if (json.size() > limits.most_entries) {
      throw FieldError("has " + std::to_string(json.size()) + " " + thing + "s; at most " +
                       std::to_string(limits.most_entries) + " are legal");
    }
    std::vector<Entry> entries;
    for (const Json& entry : json) {
      try {
        entries.push_back(decode(entry));
      } catch (const FieldError& error) {
        throw FieldError(thing + " " + std::to_string(entries.size()) + ": " + error.what());
      }
    }
    return entries;
  } catch (const FieldError& error) {
    return DataLoss(error.what());
  } catch (const Json::exception& error) {
    return DataLoss(error.what());
  }
}

template <typename Entry, typename Encode>
std::string EncodeArray(const std::vector<Entry>& entries, const Encode& encode) {
  Json json = Json::array();
  for (const Entry& entry : entries) json.push_back(encode(entry));
  return Dump(json);
}

}  // namespace latticeworld::json_fields

#endif  // LATTICEWORLD_GENERATION_BUNDLE_JSON_ARRAY_H_
