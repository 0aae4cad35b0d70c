#include <algorithm>
#include <cmath>

#include "latticeworld/common/random.h"
#include "latticeworld/scene/vegetation/model_mixture.h"
#include "latticeworld/scene/vegetation/patch_noise.h"
#include "latticeworld/scene/vegetation/scatter.h"

namespace latticeworld {
namespace {

constexpr double kTalusTimes = 12.0;  // denser below cliffs than on other ground of the class

// Few large ones among many small ones: log-normal, with the range's mean and deviation.
double DrawLogNormal(const SizeRange& range, PointRandom* random) {
  const double ratio = range.deviation / range.mean;
  const double variance = std::log(1.0 + ratio * ratio);
  const double size =
      range.mean * std::exp(std::sqrt(variance) * random->Normal() - 0.5 * variance);
  return std::clamp(size, range.low, range.high);
}

}  // namespace

void PlaceStones(Placement* placement) {
  const Terrain& terrain = placement->terrain;
  const std::uint64_t seed = StreamSeed(placement->seed, "scene/stones/models");
  const ModelMixture mixture(placement->catalogue, placement->environment, AssetKind::kStone,
                             terrain.weights.vocabulary, seed);
  const PatchNoise fields(StreamSeed(seed, "fields"), 40.0);
  const double turn_rad =
      placement->environment.fine_of(AssetType::kStone).rotation_deg[2] * M_PI / 180.0;

  const ClumpedDensity::Clumping clump = [&](WorldPoint point, char) {
    return 1.0 + 1.5 * mixture.clumping() * (fields.At(point) - 0.5) +
           kTalusTimes * placement->sites.At(point).talus;
  };
  const ClumpedDensity density(*placement, AssetKind::kStone, clump, [](char) { return 8.0; });
  const auto make = [&](const ScatterPlace& place, PointRandom* random, Asset* stone) {
    if (!IsSlopeAtMost(terrain, stone->position(), kSteepestForStones_deg)) {
      return Refusal::kTooSteep;
    }
    const std::optional<ModelMixture::Choice> choice =
        mixture.At(place.point, placement->sites.At(place.point), placement->canopy.At(place.point),
                   place.letter, random);
    if (!choice) return Refusal::kHabitat;
    const AssetModel& model = placement->catalogue.models()[choice->model];
    stone->model = choice->model;
    stone->season_variant = choice->season_variant;
    stone->material = choice->material;
    stone->height_m = static_cast<float>(DrawLogNormal(model.height_m, random));
    stone->scale = static_cast<float>(stone->height_m / model.height_m.mean);
    stone->half_length_m = static_cast<float>(stone->height_m * DrawSize(model.spread, random));
    stone->half_width_m = stone->half_length_m;
    stone->yaw_rad =
        static_cast<float>(std::remainder(random->Uniform(-M_PI, M_PI) + turn_rad, 2.0 * M_PI));
    return IsBuildable(terrain, stone->position(), SolidRadius(*stone) + kRoadMargin_m)
               ? Refusal::kNone
               : Refusal::kWaterOrRoad;
  };
  Scatter(placement, AssetKind::kStone, "scene/stones", density, make);
}

}  // namespace latticeworld
