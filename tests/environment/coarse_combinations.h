#ifndef LATTICEWORLD_TESTS_ENVIRONMENT_COARSE_COMBINATIONS_H_
#define LATTICEWORLD_TESTS_ENVIRONMENT_COARSE_COMBINATIONS_H_

#include "latticeworld/environment/attributes.h"

namespace latticeworld {

inline constexpr int kCoarseCombinations = 9 * 4 * 3 * 6 * 7;

template <typename Visit>
void ForEveryCoarse(Visit&& visit) {
  for (const auto& terrain : EnumNames(TerrainType{})) {
    for (const auto& season : EnumNames(Season{})) {
      for (const auto& style : EnumNames(ArtisticStyle{})) {
        for (const auto& weather : EnumNames(Weather{})) {
          for (const auto& time : EnumNames(TimeOfDay{})) {
            visit(CoarseAttributes{terrain.value, season.value, style.value, weather.value,
                                   time.value});
          }
        }
      }
    }
  }
}

// Every combination of what rules can see: the artistic style is always realistic.
template <typename Visit>
void ForEveryPhysicalCoarse(Visit&& visit) {
  ForEveryCoarse([&](const CoarseAttributes& coarse) {
    if (coarse.artistic_style == ArtisticStyle::kRealistic) visit(coarse);
  });
}

}  // namespace latticeworld

#endif  // LATTICEWORLD_TESTS_ENVIRONMENT_COARSE_COMBINATIONS_H_
