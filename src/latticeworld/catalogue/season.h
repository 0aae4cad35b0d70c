#ifndef LATTICEWORLD_CATALOGUE_SEASON_H_
#define LATTICEWORLD_CATALOGUE_SEASON_H_

#include <array>
#include <cstdint>

#include "latticeworld/common/enum_names.h"

namespace latticeworld {

enum class Season : std::uint8_t { kSpring, kSummer, kAutumn, kWinter };
inline constexpr int kSeasonCount = 4;

constexpr std::array<EnumName<Season>, kSeasonCount> EnumNames(Season) {
  return {{{Season::kSpring, "spring"},
           {Season::kSummer, "summer"},
           {Season::kAutumn, "autumn"},
           {Season::kWinter, "winter"}}};
}

}  // namespace latticeworld

#endif  // LATTICEWORLD_CATALOGUE_SEASON_H_
