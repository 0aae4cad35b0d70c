// Bushes, flowers, tufts of grass and what grows along shores.

#include <algorithm>
#include <cmath>
#include <string>

#include "latticeworld/common/random.h"
#include "latticeworld/scene/vegetation/model_mixture.h"
#include "latticeworld/scene/vegetation/patch_noise.h"
#include "latticeworld/scene/vegetation/scatter.h"

namespace latticeworld {
namespace {

// Makes plants of a mixture: called from several threads at once.
class PlantMaker {
 public:
  PlantMaker(const Placement& placement, const AssetIndex& solids, AssetKind kind,
             std::uint64_t seed)
      : placement_(placement),
        solids_(solids),
        kind_(kind),
        mixture_(placement.catalogue, placement.environment, kind,
                 placement.terrain.weights.vocabulary, seed) {}

  const ModelMixture& mixture() const { return mixture_; }

  Refusal Make(const ScatterPlace& place, PointRandom* random, Asset* plant,
               bool shore_only) const {
    const Terrain& terrain = placement_.terrain;
    if (!IsSlopeAtMost(terrain, plant->position(), kSteepestForGroundCover_deg)) {
      return Refusal::kTooSteep;
    }
    if (!IsBuildable(terrain, plant->position(), 0.0)) return Refusal::kWaterOrRoad;
    if (!IsFreeOfSolids(placement_, solids_, plant->position())) return Refusal::kOccupied;
    const Site site = placement_.sites.At(place.point);
    const double canopy = placement_.canopy.At(place.point);
    const std::optional<ModelMixture::Choice> choice =
        shore_only ? mixture_.OfShoreAt(place.point, site, canopy, place.letter, random)
                   : mixture_.At(place.point, site, canopy, place.letter, random);
    if (!choice) return Refusal::kHabitat;
    const AssetModel& model = placement_.catalogue.models()[choice->model];
    plant->model = choice->model;
    plant->season_variant = choice->season_variant;
    plant->material = choice->material;
    const double growth =
        placement_.catalogue.season_variants(TypeOf(kind_))[choice->season_variant].growth;
    const double full_m = DrawSize(model.height_m, random);
    plant->height_m = static_cast<float>(full_m * growth);
    plant->scale = static_cast<float>(full_m / model.height_m.mean);
    plant->half_length_m = static_cast<float>(full_m * DrawSize(model.spread, random));
    plant->half_width_m = plant->half_length_m;
    plant->yaw_rad = static_cast<float>(random->Uniform(-M_PI, M_PI));
    return Refusal::kNone;
  }

 private:
  const Placement& placement_;
  const AssetIndex& solids_;
  AssetKind kind_;
  ModelMixture mixture_;
};

// Scatters one kind; clumping is a function of its patch noise, [0, 1], and of the point.
void PlaceCover(Placement* placement, const AssetIndex& solids, AssetKind kind, double patch_m,
                double peak,
                const std::function<double(double patch, WorldPoint point)>& clumping) {
  const std::string stream = "scene/" + std::string(NameOf(kind));
  const std::uint64_t seed = StreamSeed(placement->seed, stream + "/models");
  const PlantMaker maker(*placement, solids, kind, seed);
  const PatchNoise patches(StreamSeed(seed, "patches"), patch_m);
  const ClumpedDensity::Clumping clump = [&](WorldPoint point, char) {
    return clumping(patches.At(point), point);
  };
  const ClumpedDensity density(*placement, kind, clump, [peak](char) { return peak; });
  Scatter(placement, kind, stream, density,
          [&maker](const ScatterPlace& place, PointRandom* random, Asset* plant) {
            return maker.Make(place, random, plant, /*shore_only=*/false);
          });
}

// A belt along water, broken by gaps.
class ShoreDensity : public ScatterDensity {
 public:
  ShoreDensity(const Placement& placement, double per_m2, std::uint64_t seed)
      : placement_(placement), per_m2_(per_m2), gaps_(seed, 20.0) {}

  double largest_per_m2() const override { return per_m2_; }
  double MostAt(CellIndex cell) const override {
    return placement_.sites.ToWater(placement_.terrain.geometry().CenterOf(cell)) < kNear_m
               ? per_m2_
               : 0.0;
  }
  double At(WorldPoint point, double, char* letter) const override {
    const Terrain& terrain = placement_.terrain;
    *letter = terrain.weights.DominantAt(terrain.geometry().CellAt(point));
    const double from_water = placement_.sites.ToWater(point) / kShoreBelt_m;
    if (from_water >= 1.0) return 0.0;
    return per_m2_ * (1.0 - from_water) * std::clamp(3.0 * gaps_.At(point) - 0.8, 0.0, 1.0);
  }

 private:
  static constexpr double kNear_m = 2.0 * kShoreBelt_m;
  const Placement& placement_;
  double per_m2_;
  PatchNoise gaps_;
};

void PlaceShoreBelt(Placement* placement, const AssetIndex& solids, AssetKind kind) {
  const std::string stream = "scene/shore/" + std::string(NameOf(kind));
  const std::uint64_t seed = StreamSeed(placement->seed, stream + "/models");
  const PlantMaker maker(*placement, solids, kind, seed);
  const double per_m2 = ShorePerM2(kind) * placement->environment.fine_of(TypeOf(kind)).density *
                        placement->thinning[kind];
  if (!maker.mixture().has_shore_models() || per_m2 <= 0.0) return;
  const ShoreDensity density(*placement, per_m2, StreamSeed(seed, "gaps"));
  // What does not grow at one shore was not asked for there: it is no shortfall of the kind.
  Tally::Kind& tally = placement->tally.Of(kind);
  const Tally::Kind before = tally;
  const std::size_t standing = placement->assets.size();
  Scatter(placement, kind, stream, density,
          [&maker](const ScatterPlace& place, PointRandom* random, Asset* plant) {
            return maker.Make(place, random, plant, /*shore_only=*/true);
          });
  tally = before;
  tally.wanted += static_cast<double>(placement->assets.size() - standing);
}

}  // namespace

double ShorePerM2(AssetKind kind) {
  return kind == AssetKind::kGrassTuft ? 0.8 : kind == AssetKind::kBush ? 0.05 : 0.0;
}

void PlaceShorePlants(Placement* placement, const AssetIndex& solids) {
  PlaceShoreBelt(placement, solids, AssetKind::kBush);
  PlaceShoreBelt(placement, solids, AssetKind::kGrassTuft);
}

void PlaceBushes(Placement* placement, const AssetIndex& solids) {
  // Most along the edges of forests, where crowns hide about half of the sky.
  PlaceCover(placement, solids, AssetKind::kBush, 25.0, 3.0,
             [placement](double patch, WorldPoint point) {
               const double canopy = placement->canopy.At(point);
               const double edge = 4.0 * canopy * (1.0 - canopy);
               return 0.4 + 0.8 * patch + 2.0 * edge * edge;
             });
}

void PlaceFlowers(Placement* placement, const AssetIndex& solids) {
  // Flowers grow in patches, fewer in the shade.
  PlaceCover(placement, solids, AssetKind::kFlower, 14.0, 4.0,
             [placement](double patch, WorldPoint point) {
               const double within = std::max(0.0, patch - 0.5) / 0.5;
               return (0.06 + 2.5 * within) * (1.0 - 0.6 * placement->canopy.At(point));
             });
}

void PlaceGrassTufts(Placement* placement, const AssetIndex& solids) {
  PlaceCover(placement, solids, AssetKind::kGrassTuft, 10.0, 1.6,
             [](double patch, WorldPoint) { return 0.5 + patch; });
}

}  // namespace latticeworld
