#ifndef LATTICEWORLD_SCENE_SETTLEMENTS_BUILDING_MODELS_H_
#define LATTICEWORLD_SCENE_SETTLEMENTS_BUILDING_MODELS_H_

#include <array>
#include <cstdint>

#include "latticeworld/catalogue/catalogue.h"
#include "latticeworld/scene/point_random.h"

namespace latticeworld {

// What settlements are built of. Each use has the model of its name in the catalogue.
enum class BuildingUse : std::uint8_t {
  kDetachedHouse,
  kRowHouse,
  kFarmhouse,
  kBarn,
  kShed,
  kApartmentBlock,
  kTower,
  kChurch
};
inline constexpr int kBuildingUseCount = 8;

// The outside of one building.
struct BuildingSize {
  double half_length_m = 0.0;  // towards the front
  double half_width_m = 0.0;   // half the frontage
  double height_m = 0.0;
};

class BuildingModels {
 public:
  // scale: of the environment's architecture; it stretches every size.
  BuildingModels(const Catalogue& catalogue, double scale);

  // The catalogue's model of that name, or else its first building.
  std::uint8_t ModelOf(BuildingUse use) const { return models_[static_cast<std::size_t>(use)]; }
  // Whether the catalogue has a building of that name.
  bool Has(BuildingUse use) const { return has_[static_cast<std::size_t>(use)]; }
  // Drawn from the model's ranges; the height in whole storeys and a roof where it has storeys.
  BuildingSize Draw(BuildingUse use, PointRandom* random) const;

 private:
  const Catalogue& catalogue_;
  double scale_;
  std::array<std::uint8_t, kBuildingUseCount> models_{};
  std::array<bool, kBuildingUseCount> has_{};
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SCENE_SETTLEMENTS_BUILDING_MODELS_H_
