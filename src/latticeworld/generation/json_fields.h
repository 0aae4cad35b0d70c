#ifndef LATTICEWORLD_GENERATION_JSON_FIELDS_H_
#define LATTICEWORLD_GENERATION_JSON_FIELDS_H_

#include <array>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <string_view>

#include "latticeworld/common/enum_names.h"
#include "latticeworld/common/text.h"

// Strict reading of JSON objects for the .cc files of this room and of rooms above. A wrong key,
// type or value throws FieldError (or, while parsing, nlohmann's own exception); both are caught at
// the edge of the codec that uses them and become a Status.
namespace latticeworld::json_fields {

using Json = nlohmann::ordered_json;  // keys keep the order in which they were written

struct FieldError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Parses what anybody may have written. Bounded, because values are shown by recursion, so that
// depth costs stack, and ordered objects are searched key by key at each new one.
inline Json Parse(std::string_view content) {
  constexpr int kMaxDepth = 8;        // the files of a bundle have four levels
  constexpr int kMaxKeys = 64;        // of one object; they have twelve
  std::array<int, kMaxDepth> keys{};  // of the object that is open at each level
  return Json::parse(
      content.begin(), content.end(), [&keys](int depth, Json::parse_event_t event, const Json&) {
        const bool starts =
            event == Json::parse_event_t::object_start || event == Json::parse_event_t::array_start;
        if (starts && depth >= kMaxDepth) {
          throw FieldError("is nested deeper than " + std::to_string(kMaxDepth));
        }
        if (starts) keys[depth] = 0;
        if (event == Json::parse_event_t::key && ++keys[depth - 1] > kMaxKeys) {
          throw FieldError("has an object of more than " + std::to_string(kMaxKeys) + " keys");
        }
        return true;
      });
}

// A value as a message shows it: cut where it is long.
inline std::string Shown(const Json& value) {
  if (value.is_string()) return Quote(value.get_ref<const std::string&>());
  const std::string text = value.dump(-1, ' ', false, Json::error_handler_t::replace);
  return value.is_structured() ? Quote(text) : text;
}

[[noreturn]] inline void Fail(std::string_view key, const Json& value, const std::string& legal) {
  throw FieldError(std::string(key) + " is " + Shown(value) + ", not " + legal);
}

// The object has exactly these keys.
inline void ExpectKeys(const Json& object, std::initializer_list<std::string_view> keys) {
  if (!object.is_object()) throw FieldError(Shown(object) + " is not an object");
  for (const std::string_view key : keys) {
    if (!object.contains(std::string(key))) {
      throw FieldError("the key " + std::string(key) + " is missing");
    }
  }
  for (const auto& item : object.items()) {
    bool known = false;
    for (const std::string_view key : keys) known = known || key == item.key();
    if (!known) throw FieldError("the key " + Quote(item.key()) + " is unknown");
  }
}

inline const Json& Member(const Json& object, const char* key) { return object.at(key); }

inline std::string Text(const Json& object, const char* key) {
  const Json& value = Member(object, key);
  if (!value.is_string()) Fail(key, value, "a text");
  return value.get<std::string>();
}

inline bool Boolean(const Json& object, const char* key) {
  const Json& value = Member(object, key);
  if (!value.is_boolean()) Fail(key, value, "true or false");
  return value.get<bool>();
}

// Finite: JSON has no other numbers.
inline double Number(const Json& object, const char* key,
                     double low = std::numeric_limits<double>::lowest(),
                     double high = std::numeric_limits<double>::max()) {
  const Json& value = Member(object, key);
  if (!value.is_number() || !(value.get<double>() >= low && value.get<double>() <= high)) {
    Fail(key, value, "a number from " + FormatDouble(low) + " to " + FormatDouble(high));
  }
  return value.get<double>();
}

inline std::int64_t Integer(const Json& object, const char* key, std::int64_t low,
                            std::int64_t high) {
  const Json& value = Member(object, key);
  const bool legal = value.is_number_integer() && value.get<double>() >= static_cast<double>(low) &&
                     value.get<double>() <= static_cast<double>(high);
  if (!legal) {
    Fail(key, value, "a whole number from " + std::to_string(low) + " to " + std::to_string(high));
  }
  return value.get<std::int64_t>();
}

inline std::uint64_t Unsigned(const Json& object, const char* key) {
  const Json& value = Member(object, key);
  if (!value.is_number_unsigned()) Fail(key, value, "a whole number of at least 0");
  return value.get<std::uint64_t>();
}

template <typename Enum>
Enum Named(const Json& object, const char* key) {
  const std::string name = Text(object, key);
  const auto value = FromName<Enum>(name);
  if (!value) Fail(key, Member(object, key), "one of " + LegalNames<Enum>());
  return *value;
}

inline const Json& Array(const Json& object, const char* key) {
  const Json& value = Member(object, key);
  if (!value.is_array()) Fail(key, value, "an array");
  return value;
}

// Two spaces deep, with a final line end. Text that is not UTF-8 is repaired, never thrown at.
inline std::string Dump(const Json& value) {
  return value.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace latticeworld::json_fields

#endif  // LATTICEWORLD_GENERATION_JSON_FIELDS_H_
