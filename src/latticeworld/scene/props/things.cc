#include "latticeworld/scene/props/things.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "latticeworld/common/random.h"
#include "latticeworld/common/text.h"
#include "latticeworld/layout/class_letters.h"
#include "latticeworld/scene/land_finder.h"
#include "latticeworld/scene/props/footbridges.h"
#include "latticeworld/scene/props/props.h"
#include "latticeworld/scene/props/thing_maker.h"
#include "latticeworld/scene/props/thing_sites.h"
#include "latticeworld/scene/vegetation/scatter.h"

namespace latticeworld {
namespace {

constexpr double kApart_m = 0.02;      // between things
constexpr double kFromHouses_m = 0.5;  // between things and houses
constexpr double kHouseFromHouse_m = 3.0;
constexpr double kMostDug_m = 1.2;  // that a hillside reaches up walls
constexpr double kDeepest_m = 6.0;
constexpr int kTries = 300;   // sites of a wish
constexpr int kWholeRun = 8;  // pieces of a fence that ends at the world's edge
constexpr char kFootbridge[] = "footbridge";
constexpr double kPierAboveWater_m = 0.45;
// What grows by itself keeps this far from what is asked for, so that it is seen, and from rows,
// rings and grids of trees farther [m].
constexpr double kClear_m = 1.5;
constexpr double kClearOfTrees_m = 5.0;

enum class Flaw { kNone, kOutside, kWater, kRoad, kDry, kSteep, kOccupied, kNoCrossing };
constexpr int kFlawCount = 8;
constexpr std::array<std::string_view, kFlawCount> kFlawWords = {"",
                                                                 "the world ends there",
                                                                 "there is water",
                                                                 "a road is there",
                                                                 "there is no water",
                                                                 "the ground is too steep",
                                                                 "something else stands there",
                                                                 "no water of 3 to 12 m with level "
                                                                 "banks is there to cross"};

// What of the ground a wish may stand on.
struct Ground {
  bool on_roads = false;
  bool in_water = false;
  bool is_pier = false;
};

class Placer {
 public:
  Placer(const std::vector<ThingWish>& wishes, Placement* placement)
      : wishes_(wishes),
        placement_(*placement),
        terrain_(placement->terrain),
        maker_(placement),
        land_(terrain_) {}

  PlacedThings Place() && {
    for (std::size_t i = 0; i < wishes_.size(); ++i) {
      if (!wishes_[i].name.empty() && wishes_[i].count == 1) names_.insert(wishes_[i].name);
    }
    MakeRoom();
    footprints_.resize(wishes_.size());
    for (std::size_t i = 0; i < wishes_.size(); ++i) PlaceWish(static_cast<int>(i));
    return std::move(placed_);
  }

 private:
  // What a site would get of a wish.
  struct Try {
    std::vector<MadeThing> made;
    std::array<int, kFlawCount> flaws{};
  };

  void Warn(const ThingWish& wish, const std::string& what) {
    placed_.warnings.push_back(Quote(wish.words.empty() ? wish.kind : wish.words) + ": " + what);
  }

  Ground GroundOf(const ThingWish& wish) const {
    const bool lies_in = wish.relation == ThingRelation::kIn;
    Ground ground;
    ground.is_pier = wish.kind == "pier";
    ground.on_roads = wish.position.has_value() ||
                      (lies_in && IsRoad(terrain_.weights.vocabulary, wish.target.letter));
    ground.in_water = ground.is_pier || (lies_in && wish.target.letter == class_letter::kWater);
    return ground;
  }

  static double FromHouses_m(const MadeThing& made) {
    return made.is_house ? kHouseFromHouse_m : kFromHouses_m;
  }

  // Gives a building that is to stand in a village the place of one of its houses: the nearest to
  // the middle of them all where its walls keep off roads, water, steep ground and `others`.
  void TakePlaceOfHouse(std::size_t index, const std::vector<MadeThing>& others) {
    ThingWish& wish = wishes_[index];
    const bool in_village = wish.relation == ThingRelation::kIn && wish.count == 1 &&
                            IsBuilding(terrain_.weights.vocabulary, wish.target.letter);
    if (!in_village || wish.position || !wish.zone.is_anywhere()) return;
    const MadeThing building = maker_.Make(wish, SeedOf(index), 0, {0.0, 0.0}, 0.0);
    if (!building.is_house) return;
    const Footprint& own = building.footprint;
    std::vector<Footprint> houses;
    WorldPoint middle;
    for (const Asset& asset : placement_.assets)
      if (asset.kind == AssetKind::kBuilding) houses.push_back(FootprintOf(asset));
    for (const Footprint& house : houses) {
      middle.x_m += house.centre.x_m / static_cast<double>(houses.size());
      middle.y_m += house.centre.y_m / static_cast<double>(houses.size());
    }
    const auto away_m = [middle](const Footprint& house) {
      return std::hypot(house.centre.x_m - middle.x_m, house.centre.y_m - middle.y_m);
    };
    std::stable_sort(houses.begin(), houses.end(),
                     [&](const Footprint& a, const Footprint& b) { return away_m(a) < away_m(b); });
    for (const Footprint& house : houses) {
      for (const double turn_rad : {0.0, M_PI / 2.0, -M_PI / 2.0}) {
        const double yaw_rad = house.yaw_rad + turn_rad;
        // It reaches back from where the front of the house was, to keep off the road there.
        const double depth_m = turn_rad == 0.0 ? own.half_length_m : own.half_width_m;
        const WorldPoint place = house.At(house.half_length_m - depth_m, 0.0);
        const MadeThing made = maker_.Make(wish, SeedOf(index), 0, place, yaw_rad);
        const bool free = std::none_of(others.begin(), others.end(), [&](const MadeThing& other) {
          return GapBetween(made.footprint, other.footprint) < kHouseFromHouse_m;
        });
        if (!free || FlawOfPlace(wish, made, kMostDug_m) != Flaw::kNone) continue;
        wish.position = place;
        wish.heading_rad = yaw_rad;
        return;
      }
    }
  }

  // Houses, and what stands about them, go where a thing with an exact place or a building of the
  // village is to stand.
  void MakeRoom() {
    std::vector<MadeThing> things;
    for (std::size_t i = 0; i < wishes_.size(); ++i) {
      if (!maker_.Knows(wishes_[i].kind)) continue;
      TakePlaceOfHouse(i, things);
      const ThingWish& wish = wishes_[i];
      if (!wish.position) continue;
      things.push_back(
          maker_.Make(wish, SeedOf(i), 0, *wish.position, wish.heading_rad.value_or(0.0)));
    }
    if (things.empty()) return;
    std::vector<Asset>& assets = placement_.assets;
    const auto is_house = [](const Asset& asset) { return asset.kind == AssetKind::kBuilding; };
    const std::size_t all = assets.size();
    const auto before = std::count_if(assets.begin(), assets.end(), is_house);
    const auto in_the_way = [&](const Asset& house) {
      const Footprint walls = FootprintOf(house);
      return std::any_of(things.begin(), things.end(), [&](const MadeThing& thing) {
        return GapBetween(walls, thing.footprint) < FromHouses_m(thing);
      });
    };
    assets.erase(std::remove_if(assets.begin(), assets.end(), in_the_way), assets.end());
    if (assets.size() == all) return;
    const auto gone = before - std::count_if(assets.begin(), assets.end(), is_house);
    if (gone > 0) {
      placed_.warnings.push_back((gone == 1 ? "a house" : std::to_string(gone) + " houses") +
                                 std::string(" made room for other buildings or exact places"));
    }
    placement_.solids = SolidSet(terrain_.geometry().size_m());
    for (const Asset& asset : assets) placement_.solids.Add(asset.position(), SolidRadius(asset));
  }

  std::uint64_t SeedOf(std::size_t wish) const {
    return StreamSeed(placement_.seed, "scene/things/" + std::to_string(wish));
  }

  void PlaceWish(int index) {
    const ThingWish& wish = wishes_[index];
    if (!maker_.Knows(wish.kind)) {
      Warn(wish, Quote(wish.kind) + " is no kind of thing");
      return;
    }
    const int room = kMostThings - static_cast<int>(placed_.things.size());
    const int count = std::clamp(wish.count, 0, room);
    if (count < wish.count) {
      Warn(wish, "a world holds at most " + std::to_string(kMostThings) + " things; " +
                     std::to_string(count) + " of " + std::to_string(wish.count) + " are placed");
    }
    const Footprint own =
        maker_.Make(wish, SeedOf(static_cast<std::size_t>(index)), 0, {0.0, 0.0}, 0.0).footprint;
    const ThingSites sites(wish, own, footprints_, terrain_, &land_);
    if (!sites.problem().empty()) Warn(wish, sites.problem());
    // Without an arrangement each has a site of its own.
    const bool together = wish.arrangement != ThingArrangement::kNone || sites.arranges_by_itself();
    RandomStream random(SeedOf(static_cast<std::size_t>(index)), "sites");
    std::array<int, kFlawCount> flaws{};
    int standing = 0;
    for (int first = 0; first < count; first += together ? count : 1) {
      Try best = wish.kind == kFootbridge
                     ? FindCrossing(wish, sites, &random)
                     : Find(wish, index, first, together ? count : 1, sites, &random);
      for (int i = 0; i < kFlawCount; ++i) flaws[i] += best.flaws[i];
      standing += static_cast<int>(best.made.size());
      for (MadeThing& made : best.made) Add(index, count, std::move(made));
    }
    if (standing >= std::min(count, wish.count_least)) return;
    const auto most = std::max_element(flaws.begin(), flaws.end()) - flaws.begin();
    Warn(wish, std::to_string(standing) + " of " + std::to_string(count) +
                   " stand: " + std::string(kFlawWords[static_cast<std::size_t>(most)]));
  }

  // The best of the sites.
  Try Find(const ThingWish& wish, int index, int first, int count, const ThingSites& sites,
           RandomStream* random) {
    // Long rows are tried less often.
    const int tries = wish.position ? 1 : std::max(10, kTries * 10 / std::max(10, count));
    Try best;
    for (int i = 0; i < tries; ++i) {
      const std::vector<ThingSites::Slot> slots = sites.Draw(count, i, tries, random);
      Try now;
      for (std::size_t k = 0; k < slots.size(); ++k) {
        if (!terrain_.geometry().Contains(slots[k].place)) {
          ++now.flaws[static_cast<int>(Flaw::kOutside)];
          continue;
        }
        MadeThing made = maker_.Make(wish, SeedOf(static_cast<std::size_t>(index)),
                                     first + static_cast<int>(k), slots[k].place, slots[k].yaw_rad);
        // Walls are dug in deep only where no try has found better.
        const double most_dug_m = 3 * i < 2 * tries ? kMostDug_m : kDeepest_m;
        const Flaw flaw = FlawOf(wish, made, now.made, most_dug_m);
        if (flaw == Flaw::kNone) {
          now.made.push_back(std::move(made));
        } else {
          ++now.flaws[static_cast<int>(flaw)];
        }
      }
      if (now.made.size() > best.made.size() || i == 0) best = std::move(now);
      if (best.made.size() == std::min(slots.size(), static_cast<std::size_t>(count)) &&
          static_cast<int>(best.made.size()) >= std::min(count, kWholeRun)) {
        break;
      }
    }
    return best;
  }

  // A footbridge crosses the water where its wish is drawn, or near its exact place.
  Try FindCrossing(const ThingWish& wish, const ThingSites& sites, RandomStream* random) {
    constexpr int kDraws = 3000;
    constexpr double kNearPlace_m = 8.0;
    Try found;
    for (int i = 0; i < kDraws; ++i) {
      WorldPoint point = sites.DrawWater(random);
      if (wish.position) {
        point = {wish.position->x_m + random->Uniform(-kNearPlace_m, kNearPlace_m),
                 wish.position->y_m + random->Uniform(-kNearPlace_m, kNearPlace_m)};
      }
      if (!terrain_.geometry().Contains(point)) continue;
      std::optional<Prop> bridge = FootbridgeAt(terrain_, point);
      if (!bridge) continue;
      MadeThing made;
      bridge->z_m = GroundUnder(terrain_, *bridge);
      made.footprint = latticeworld::FootprintOf(*bridge);
      made.prop = std::move(bridge);
      if (StandsFree(made, {})) {
        found.made.push_back(std::move(made));
        return found;
      }
      ++found.flaws[static_cast<int>(Flaw::kOccupied)];
    }
    ++found.flaws[static_cast<int>(Flaw::kNoCrossing)];
    return found;
  }

  Flaw FlawOf(const ThingWish& wish, const MadeThing& made, const std::vector<MadeThing>& beside,
              double most_dug_m) {
    const Flaw flaw = FlawOfPlace(wish, made, most_dug_m);
    if (flaw != Flaw::kNone) return flaw;
    return StandsFree(made, beside) ? Flaw::kNone : Flaw::kOccupied;
  }

  // Of the land alone.
  Flaw FlawOfPlace(const ThingWish& wish, const MadeThing& made, double most_dug_m) const {
    const Footprint& footprint = made.footprint;
    const double limit_m = terrain_.geometry().half_size_m();
    for (const WorldPoint& corner : footprint.Corners()) {
      if (!(std::abs(corner.x_m) < limit_m && std::abs(corner.y_m) < limit_m)) {
        return Flaw::kOutside;
      }
    }
    Ground ground = GroundOf(wish);
    // Walls have no floor in water.
    if (made.is_house && !wish.position) ground.in_water = ground.is_pier;
    if (const Flaw flaw = ground.is_pier ? FlawOfPier(footprint) : FlawOfGround(footprint, ground);
        flaw != Flaw::kNone) {
      return flaw;
    }
    if (!ground.is_pier && !IsSlopeAtMost(terrain_, footprint.centre, made.steepest_deg)) {
      return Flaw::kSteep;
    }
    if (made.is_house && !wish.position && RiseWithin_m(footprint) > most_dug_m) {
      return Flaw::kSteep;
    }
    return Flaw::kNone;
  }

  // Returns whether a thing stands free of those of the same try, of all others and of houses.
  bool StandsFree(const MadeThing& made, const std::vector<MadeThing>& beside) {
    const Footprint& footprint = made.footprint;
    for (const MadeThing& other : beside) {
      if (Near(footprint, other.footprint, kApart_m)) return false;
    }
    for (const std::vector<Footprint>& others : footprints_) {
      for (const Footprint& other : others) {
        if (Near(footprint, other, kApart_m)) return false;
      }
    }
    for (std::size_t i = 0; i < houses(); ++i) {
      if (Near(footprint, FootprintOf(placement_.assets[i]), FromHouses_m(made))) return false;
    }
    return true;
  }

  // Returns the difference between the highest and the lowest ground of what walls cover.
  double RiseWithin_m(const Footprint& footprint) const {
    double low_m = INFINITY, high_m = -INFINITY;
    for (const double along : {-1.0, 0.0, 1.0}) {
      for (const double left : {-1.0, 0.0, 1.0}) {
        const double height_m = terrain_.ground.HeightAt(
            footprint.At(along * footprint.half_length_m, left * footprint.half_width_m));
        low_m = std::min(low_m, height_m);
        high_m = std::max(high_m, height_m);
      }
    }
    return high_m - low_m;
  }

  static bool Near(const Footprint& a, const Footprint& b, double gap_m) {
    const double dx = a.centre.x_m - b.centre.x_m, dy = a.centre.y_m - b.centre.y_m;
    const double reach_m = a.radius_m() + b.radius_m() + gap_m;
    return dx * dx + dy * dy <= reach_m * reach_m && GapBetween(a, b) < gap_m;
  }

  // Houses stand before things in the list of assets.
  std::size_t houses() {
    if (houses_ < 0) houses_ = static_cast<long>(placement_.assets.size());
    return static_cast<std::size_t>(houses_);
  }

  Flaw FlawOfGround(const Footprint& footprint, const Ground& ground) const {
    constexpr double kStep_m = 1.0;
    const double reach_x_m = footprint.half_length_m + (ground.on_roads ? 0.0 : kRoadMargin_m);
    const double reach_y_m = footprint.half_width_m + (ground.on_roads ? 0.0 : kRoadMargin_m);
    const int steps_x = std::max(1, static_cast<int>(std::ceil(2.0 * reach_x_m / kStep_m)));
    const int steps_y = std::max(1, static_cast<int>(std::ceil(2.0 * reach_y_m / kStep_m)));
    for (int i = 0; i <= steps_x; ++i) {
      for (int j = 0; j <= steps_y; ++j) {
        const WorldPoint point = footprint.At((2.0 * i / steps_x - 1.0) * reach_x_m,
                                              (2.0 * j / steps_y - 1.0) * reach_y_m);
        if (!ground.in_water && terrain_.WaterDepthAt(point) > 0.0) return Flaw::kWater;
        if (!ground.on_roads && terrain_.SurfaceAt(point) == SurfaceClass::kRoad) {
          return Flaw::kRoad;
        }
      }
    }
    return Flaw::kNone;
  }

  // Its foot is on land, its head over water.
  Flaw FlawOfPier(const Footprint& footprint) const {
    const WorldPoint foot = footprint.At(-footprint.half_length_m, 0.0);
    const WorldPoint head = footprint.At(footprint.half_length_m, 0.0);
    if (terrain_.WaterDepthAt(foot) > 0.0) return Flaw::kWater;
    if (terrain_.WaterDepthAt(head) <= 0.0 || terrain_.WaterDepthAt(footprint.centre) <= 0.0) {
      return Flaw::kDry;
    }
    return Flaw::kNone;
  }

  void Add(int index, int count, MadeThing made) {
    const ThingWish& wish = wishes_[index];
    SceneThing thing;
    thing.kind = wish.kind;
    thing.wish = index;
    thing.name = count == 1 && !wish.name.empty()
                     ? wish.name
                     : NewName(wish.name.empty() ? wish.kind : wish.name);
    thing.position = made.footprint.centre;
    thing.yaw_rad = made.footprint.yaw_rad;
    footprints_[index].push_back(made.footprint);
    houses();  // counted before the first thing stands
    if (made.prop) {
      thing.position = made.prop->position;
      made.prop->name = thing.name;
      placed_.props.push_back(*std::move(made.prop));
    } else {
      if (wish.kind == "pier") LiftPier(made.footprint, &*made.asset);
      thing.asset = static_cast<std::int32_t>(placement_.assets.size());
      AddAsset(&placement_, *made.asset);
    }
    const bool of_trees = made.asset && made.asset->kind == AssetKind::kTree &&
                          wish.arrangement != ThingArrangement::kNone;
    placement_.solids.Add(made.footprint.centre,
                          made.footprint.radius_m() + (of_trees ? kClearOfTrees_m : kClear_m));
    placed_.things.push_back(std::move(thing));
  }

  // Its deck lies over the water.
  void LiftPier(const Footprint& footprint, Asset* pier) const {
    const CellIndex head = terrain_.geometry().CellAt(footprint.At(footprint.half_length_m, 0.0));
    const double deck_m = double{terrain_.water_level_m[head]} + kPierAboveWater_m;
    const double bed_m = terrain_.ground.HeightAt(terrain_.geometry().CenterOf(head));
    pier->height_m = static_cast<float>(std::max(double{pier->height_m}, deck_m - bed_m));
    pier->z_m = static_cast<float>(deck_m - double{pier->height_m});
  }

  std::string NewName(std::string base) {
    for (char& c : base) {
      const bool legal = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
      if (!legal) c = '_';
    }
    for (int number = 1;; ++number) {
      std::string name = base + "_" + std::to_string(number);
      if (names_.insert(name).second) return name;
    }
  }

  std::vector<ThingWish> wishes_;
  Placement& placement_;
  const Terrain& terrain_;
  ThingMaker maker_;
  LandFinder land_;
  std::vector<std::vector<Footprint>> footprints_;  // of what stands of each wish
  std::set<std::string> names_;
  long houses_ = -1;
  PlacedThings placed_;
};

}  // namespace

PlacedThings PlaceThings(const std::vector<ThingWish>& wishes, Placement* placement) {
  return Placer(wishes, placement).Place();
}

}  // namespace latticeworld
