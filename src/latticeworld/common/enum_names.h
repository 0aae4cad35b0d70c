#ifndef LATTICEWORLD_COMMON_ENUM_NAMES_H_
#define LATTICEWORLD_COMMON_ENUM_NAMES_H_

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace latticeworld {

template <typename Enum>
struct EnumName {
  Enum value;
  std::string_view name;
};

// Beside an enum, give its names once:
//   constexpr std::array<EnumName<Season>, 4> EnumNames(Season) { return {{{kSpring, "spring"},
//   ...}}; }
// (found by argument-dependent lookup), and these three work for it.

// The name of a value; "?" for a value outside the table.
template <typename Enum>
constexpr std::string_view NameOf(Enum value) {
  for (const auto& entry : EnumNames(Enum{})) {
    if (entry.value == value) return entry.name;
  }
  return "?";
}

// The value of a name; nullopt when there is none of that name.
template <typename Enum>
constexpr std::optional<Enum> FromName(std::string_view name) {
  for (const auto& entry : EnumNames(Enum{})) {
    if (entry.name == name) return entry.value;
  }
  return std::nullopt;
}

// "spring, summer, autumn, winter": for error messages and schemas.
template <typename Enum>
std::string LegalNames() {
  std::string names;
  for (const auto& entry : EnumNames(Enum{})) {
    if (!names.empty()) names += ", ";
    names += entry.name;
  }
  return names;
}

}  // namespace latticeworld

#endif  // LATTICEWORLD_COMMON_ENUM_NAMES_H_
