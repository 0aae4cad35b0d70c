#include "latticeworld/scene/props/thing_maker.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "latticeworld/common/random.h"
#include "latticeworld/scene/props/props.h"
#include "latticeworld/scene/props/thing_sites.h"
#include "latticeworld/scene/vegetation/scatter.h"
#include "latticeworld/scene/vegetation/trees.h"

namespace latticeworld {
namespace {

constexpr double kSolitaryPerM2 = 1e-3;  // trees that stand by themselves
constexpr double kOfCrown = 0.4;         // of a tree's, that reaches over nothing large
constexpr double kLeastStone_m = 0.35;   // half length of single stones of usual size
constexpr double kLargeFrom_m = 1.0;     // half length of what stands on the lowest ground below it

std::optional<std::uint8_t> ModelNamed(const Catalogue& catalogue, std::string_view name) {
  const auto& models = catalogue.models();
  const auto found = std::find_if(models.begin(), models.end(),
                                  [&](const AssetModel& model) { return model.name == name; });
  if (found == models.end()) return std::nullopt;
  return static_cast<std::uint8_t>(found - models.begin());
}

// The lowest ground below walls, so that no corner floats; of what is slight the middle one.
double BaseOf(const Terrain& terrain, const Footprint& footprint) {
  double base_m = terrain.ground.HeightAt(footprint.centre);
  if (footprint.half_length_m < kLargeFrom_m) return base_m;
  for (const WorldPoint& corner : footprint.Corners()) {
    base_m = std::min(base_m, terrain.ground.HeightAt(corner));
  }
  return base_m;
}

// Trees of a row have crowns that only just meet, but none is less than half as large as it was.
void FitTree(double crown_m, Asset* tree) {
  const double fits = crown_m / (2.0 * double{tree->half_length_m});
  const auto scale = static_cast<float>(std::clamp(fits, 0.5, 1.0));
  for (float* length : {&tree->height_m, &tree->half_length_m, &tree->half_width_m,
                        &tree->trunk_radius_m, &tree->scale}) {
    *length *= scale;
  }
}

}  // namespace

Footprint FootprintOfThing(const Asset& asset) {
  if (asset.kind == AssetKind::kBuilding) return FootprintOf(asset);
  double half_m = asset.half_length_m;
  if (asset.kind == AssetKind::kTree) {
    half_m = std::max(double{asset.trunk_radius_m}, kOfCrown * half_m);
  }
  return {asset.position(), asset.yaw_rad, half_m, half_m};
}

bool ThingMaker::Knows(const std::string& kind) const {
  return FindThingKind(kind) != nullptr || ModelNamed(placement_.catalogue, kind).has_value();
}

const ModelMixture& ThingMaker::MixtureOf(AssetKind kind) {
  const auto found = mixtures_.find(kind);
  if (found != mixtures_.end()) return found->second;
  return mixtures_
      .emplace(kind, ModelMixture(placement_.catalogue, placement_.environment, kind,
                                  placement_.terrain.weights.vocabulary,
                                  StreamSeed(placement_.seed, "scene/things/models")))
      .first->second;
}

void ThingMaker::SizeAsset(const AssetModel& model, double vigour, double size, PointRandom* random,
                           Asset* asset) const {
  if (model.kind == AssetKind::kTree) {
    SizeTree(model, vigour, kSolitaryPerM2, random, asset);
  } else {
    asset->height_m = static_cast<float>(DrawSize(model.height_m, random));
    asset->scale = static_cast<float>(asset->height_m / model.height_m.mean);
    if (model.kind == AssetKind::kBuilding) {
      const double scale =
          model.is_house() ? placement_.environment.fine_of(AssetType::kArchitecture).scale : 1.0;
      asset->half_length_m = static_cast<float>(scale * DrawSize(model.half_length_m, random));
      asset->half_width_m = static_cast<float>(scale * DrawSize(model.half_width_m, random));
      asset->height_m = static_cast<float>(scale * asset->height_m);
      asset->scale = static_cast<float>(scale);
    } else {
      asset->half_length_m = static_cast<float>(asset->height_m * DrawSize(model.spread, random));
      asset->half_width_m = asset->half_length_m;
      // A stone that is asked for is one that is seen.
      if (model.kind == AssetKind::kStone && asset->half_length_m < kLeastStone_m) {
        size *= kLeastStone_m / double{asset->half_length_m};
      }
    }
  }
  for (float* length : {&asset->height_m, &asset->half_length_m, &asset->half_width_m,
                        &asset->trunk_radius_m, &asset->scale}) {
    *length = static_cast<float>(size * *length);
  }
}

ModelMixture::Choice ThingMaker::ChooseModel(const ThingWish& wish, std::uint64_t seed,
                                             AssetKind kind, WorldPoint place,
                                             PointRandom* random) {
  const bool alike = wish.arrangement != ThingArrangement::kNone;
  if (const auto known = alike_.find(seed); alike && known != alike_.end()) return known->second;
  const ModelMixture& mixture = MixtureOf(kind);
  const char letter =
      placement_.terrain.weights.DominantAt(placement_.terrain.geometry().CellAt(place));
  std::optional<ModelMixture::Choice> choice =
      mixture.At(place, placement_.sites.At(place), 0.0, letter, random);
  // If none grows by itself, one is planted.
  if (!choice) choice = mixture.Dress(placement_.catalogue.models_of(kind).front(), random);
  if (alike) alike_.emplace(seed, *choice);
  return *choice;
}

Asset ThingMaker::MakeAsset(const ThingWish& wish, AssetKind kind,
                            std::optional<std::uint8_t> model, std::uint64_t seed, WorldPoint place,
                            double yaw_rad, PointRandom* random) {
  const ModelMixture::Choice choice =
      model ? MixtureOf(kind).Dress(*model, random) : ChooseModel(wish, seed, kind, place, random);
  Asset asset;
  asset.kind = kind;
  asset.model = choice.model;
  asset.season_variant = choice.season_variant;
  asset.material = choice.material;
  const AssetModel& of = placement_.catalogue.models()[choice.model];
  if (wish.arrangement == ThingArrangement::kNone || kind == AssetKind::kBuilding) {
    SizeAsset(of, choice.vigour, wish.size, random, &asset);
  } else {
    // Nearly as large as the first one of its wish.
    PointRandom first(seed, 0);
    SizeAsset(of, choice.vigour, wish.size * random->Uniform(0.95, 1.05), &first, &asset);
    if (kind == AssetKind::kTree) FitTree(0.95 * SpacingOf(wish), &asset);
  }
  asset.yaw_rad = static_cast<float>(std::remainder(yaw_rad, 2.0 * M_PI));
  StandAt(placement_.terrain, place, &asset);
  return asset;
}

MadeThing ThingMaker::Make(const ThingWish& wish, std::uint64_t seed, int number, WorldPoint place,
                           double yaw_rad) {
  PointRandom random(seed, static_cast<std::uint64_t>(number));
  const ThingKind* kind = FindThingKind(wish.kind);
  MadeThing made;
  if (kind != nullptr && kind->source == ThingSource::kProp) {
    Prop prop = UsualProp(*FromName<PropKind>(kind->stands_for));
    prop.size_m *= std::clamp(wish.size, 0.5, 2.0);  // beyond it is none of its kind
    prop.mass_kg = UsualMass(prop.kind, prop.size_m);
    prop.strength = UsualStrength(prop.kind, prop.size_m);
    prop.position = place;
    prop.yaw_rad = std::remainder(yaw_rad, 2.0 * M_PI);
    prop.z_m = GroundUnder(placement_.terrain, prop);
    made.footprint = latticeworld::FootprintOf(prop);
    made.prop = std::move(prop);
    return made;
  }
  std::optional<std::uint8_t> model;
  AssetKind asset_kind = AssetKind::kTree;
  if (kind != nullptr && kind->source == ThingSource::kAsset) {
    asset_kind = *FromName<AssetKind>(kind->stands_for);
  } else {
    model = ModelNamed(placement_.catalogue, kind != nullptr ? kind->stands_for : wish.kind);
    asset_kind = placement_.catalogue.models()[*model].kind;
  }
  Asset asset = MakeAsset(wish, asset_kind, model, seed, place, yaw_rad, &random);
  made.footprint = FootprintOfThing(asset);
  if (asset_kind == AssetKind::kBuilding) {
    asset.z_m = static_cast<float>(BaseOf(placement_.terrain, made.footprint));
  }
  made.is_house =
      asset_kind == AssetKind::kBuilding && made.footprint.half_length_m >= kLargeFrom_m;
  made.steepest_deg = made.is_house                        ? kSteepestForBuildings_deg
                      : asset_kind == AssetKind::kBuilding ? 25.0
                                                           : kSteepestForTrees_deg;
  made.asset = asset;
  return made;
}

}  // namespace latticeworld
