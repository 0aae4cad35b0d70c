#include "latticeworld/scene/settlements/building_models.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "latticeworld/scene/placement.h"

namespace latticeworld {
namespace {

constexpr std::array<std::string_view, kBuildingUseCount> kNames = {
    "detached house", "row house",       "farmhouse", "barn",
    "shed",           "apartment block", "tower",     "church"};

}  // namespace

BuildingModels::BuildingModels(const Catalogue& catalogue, double scale)
    : catalogue_(catalogue), scale_(scale) {
  const std::vector<std::uint8_t>& buildings = catalogue.models_of(AssetKind::kBuilding);
  for (std::size_t use = 0; use < kNames.size(); ++use) {
    models_[use] = buildings.front();
    for (const std::uint8_t model : buildings) {
      if (catalogue.models()[model].name != kNames[use]) continue;
      models_[use] = model;
      has_[use] = true;
    }
  }
}

BuildingSize BuildingModels::Draw(BuildingUse use, PointRandom* random) const {
  const AssetModel& model = catalogue_.models()[ModelOf(use)];
  BuildingSize size;
  size.half_length_m = scale_ * DrawSize(model.half_length_m, random);
  size.half_width_m = scale_ * DrawSize(model.half_width_m, random);
  double height_m = DrawSize(model.height_m, random);
  if (model.storey_m > 0.0) {
    // The same share of a storey is left to the roof whatever the number of storeys.
    const double roof_m = std::fmod(model.height_m.mean, model.storey_m);
    const double storeys = std::max(1.0, std::round((height_m - roof_m) / model.storey_m));
    height_m =
        std::clamp(storeys * model.storey_m + roof_m, model.height_m.low, model.height_m.high);
  }
  size.height_m = scale_ * height_m;
  return size;
}

}  // namespace latticeworld
