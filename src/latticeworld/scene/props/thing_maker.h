#ifndef LATTICEWORLD_SCENE_PROPS_THING_MAKER_H_
#define LATTICEWORLD_SCENE_PROPS_THING_MAKER_H_

#include <cstdint>
#include <map>
#include <optional>

#include "latticeworld/layout/thing_kinds.h"
#include "latticeworld/layout/thing_wish.h"
#include "latticeworld/scene/footprint.h"
#include "latticeworld/scene/placement.h"
#include "latticeworld/scene/props/prop.h"
#include "latticeworld/scene/vegetation/model_mixture.h"

namespace latticeworld {

// A single thing as it would stand: an asset or a prop.
struct MadeThing {
  std::optional<Asset> asset;
  std::optional<Prop> prop;
  Footprint footprint;

  bool is_house = false;
  double steepest_deg = 25.0;  // ground that it stands on
};

// Makes single things. What one looks like depends on its wish, its number and its place alone, but
// for trees, bushes and stones in an arrangement: they are alike, as what is planted is.
class ThingMaker {
 public:
  // placement: outlives this.
  explicit ThingMaker(const Placement* placement) : placement_(*placement) {}

  // Whether there is such a kind: one of thing_kinds.h, or a model of the catalogue.
  bool Knows(const std::string& kind) const;
  // seed: of the wish. kind: known.
  MadeThing Make(const ThingWish& wish, std::uint64_t seed, int number, WorldPoint place,
                 double yaw_rad);

 private:
  const ModelMixture& MixtureOf(AssetKind kind);
  ModelMixture::Choice ChooseModel(const ThingWish& wish, std::uint64_t seed, AssetKind kind,
                                   WorldPoint place, PointRandom* random);
  Asset MakeAsset(const ThingWish& wish, AssetKind kind, std::optional<std::uint8_t> model,
                  std::uint64_t seed, WorldPoint place, double yaw_rad, PointRandom* random);
  void SizeAsset(const AssetModel& model, double vigour, double size, PointRandom* random,
                 Asset* asset) const;

  const Placement& placement_;
  std::map<AssetKind, ModelMixture> mixtures_;
  std::map<std::uint64_t, ModelMixture::Choice> alike_;  // of arranged assets, by their wish's seed
};

// What a thing covers, seen from above: a tree's stem and the inner part of its crown, walls, the
// square around what is round.
Footprint FootprintOfThing(const Asset& asset);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SCENE_PROPS_THING_MAKER_H_
