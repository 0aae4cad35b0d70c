#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/common/random.h"
#include "latticeworld/scene/placement.h"
#include "latticeworld/scene/props/footbridges.h"
#include "latticeworld/scene/props/props.h"
#include "latticeworld/scene/props/standing_props.h"
#include "latticeworld/scene/road_finder.h"

namespace latticeworld {
namespace {

constexpr double kApart_m = 0.3;       // between props, and between them and what is solid
constexpr double kFromAgents_m = 4.0;  // beyond the prop's own radius
constexpr int kMost = 1000;            // props of a world at its start

// The shares of houses that have crates beside them, and a gate to their street.
constexpr double kWithCrates = 0.12;
constexpr double kWithGate = 0.2;
constexpr int kMostCratesOfHouse = 3;
constexpr double kFarthestStreet_m = 16.0;  // from a house's front to where its gate is
constexpr double kGateFromRoad_m = 1.6;

constexpr double kStonesPerKm2 = 40.0;
constexpr double kSteepestForLooseStones_deg = 15.0;  // they lie still up to about 20
constexpr double kOnOpenGround = 0.25;                // share of their density on rock

constexpr double kPostRowsPerKm2 = 8.0;
constexpr int kPostsOfRow = 5;
constexpr double kPostSpacing_m = 8.0;
constexpr double kPostFromRoad_m = 1.2;
constexpr double kFarthestRoad_m = 20.0;

class Placer {
 public:
  Placer(const Scene& scene, std::uint64_t seed)
      : scene_(scene),
        terrain_(*scene.terrain),
        seed_(seed),
        roads_(terrain_),
        props_(scene.props) {
    AddBridges(terrain_, &road_bridges_);
    for (const SceneThing& thing : scene.things) names_.insert(thing.name);
  }

  std::vector<Prop> Place() && {
    PlaceBridges();
    PlaceGates();
    PlaceCrates();
    PlacePosts();
    PlaceLooseStones();
    std::sort(props_.begin(), props_.end(),
              [](const Prop& a, const Prop& b) { return a.name < b.name; });
    return std::move(props_);
  }

 private:
  double area_km2() const { return std::pow(scene_.geometry().size_m() / 1000.0, 2); }
  bool IsHouse(const Asset& asset) const {
    return scene_.catalogue->models()[asset.model].is_house();
  }
  WorldPoint Anywhere(RandomStream* random) const {
    const double half_m = scene_.geometry().half_size_m();
    return {random->Uniform(-half_m, half_m), random->Uniform(-half_m, half_m)};
  }

  // Whether it would be wholly in the world and clear of solids, agents and other props.
  // Of those of roads.
  bool IsClearOfBridges(const Footprint& footprint) const {
    return std::none_of(
        road_bridges_.decks.begin(), road_bridges_.decks.end(),
        [&](const PropDeck& deck) { return GapBetween(footprint, deck.footprint) < kApart_m; });
  }

  bool IsClear(const Prop& prop) const {
    if (props_.size() >= static_cast<std::size_t>(kMost)) return false;
    const Footprint footprint = FootprintOf(prop);
    for (const WorldPoint& corner : footprint.Corners()) {
      if (!scene_.geometry().Contains(corner)) return false;
    }
    bool clear = true;
    scene_.index.ForEachNear(
        footprint.centre, footprint.radius_m() + kApart_m, [&](std::uint32_t index) {
          const Asset& asset = scene_.assets[index];
          const double gap_m = asset.kind == AssetKind::kBuilding
                                   ? GapBetween(footprint, FootprintOf(asset))
                                   : GapTo(footprint, asset.position()) - SolidRadius(asset);
          clear = clear && gap_m >= kApart_m;
        });
    for (const AgentStart& agent : scene_.agents) {
      clear = clear && GapTo(footprint, agent.position) >= kFromAgents_m;
    }
    for (const Prop& other : props_) {
      if (!clear) break;
      clear = GapBetween(footprint, FootprintOf(other)) >= kApart_m;
    }
    return clear && IsClearOfBridges(footprint);
  }
  // Returns whether the prop stands on ground that is dry, no road and no steeper.
  bool IsOnLand(const Prop& prop, double steepest_deg) const {
    const Footprint footprint = FootprintOf(prop);
    return IsBuildable(terrain_, footprint.centre, footprint.radius_m()) &&
           IsSlopeAtMost(terrain_, footprint.centre, steepest_deg);
  }

  void Add(Prop prop) {
    std::string name(NameOf(prop.kind));
    std::replace(name.begin(), name.end(), ' ', '_');
    do {
      prop.name = name + "_" + std::to_string(++count_[prop.kind]);
    } while (names_.count(prop.name) > 0);
    prop.z_m = GroundUnder(terrain_, prop);
    props_.push_back(std::move(prop));
  }

  void PlaceBridges() {
    for (const Prop& bridge : FindFootbridges(terrain_, roads_, seed_)) {
      if (IsClear(bridge)) Add(bridge);
    }
  }

  // Places gates between a house's front and its street, with a post on either side; the hinge is
  // on the left as one comes out of the house.
  void PlaceGates() {
    RandomStream random(seed_, "scene/elements/gates");
    for (const Asset& house : scene_.assets) {
      if (!IsHouse(house) || !random.Chance(kWithGate)) continue;
      const Footprint front = FootprintOf(house);
      const WorldPoint door = front.At(front.half_length_m + 0.5, 0.0);
      const std::optional<RoadFinder::Road> road = roads_.Nearest(door);
      if (!road || road->distance_m > kFarthestStreet_m) continue;
      if (std::cos(road->heading_rad - house.yaw_rad) < 0.9) continue;  // it looks elsewhere
      const double away_m = road->distance_m + 0.5 - kGateFromRoad_m;
      if (away_m < 1.0) continue;
      Prop gate = UsualProp(PropKind::kGate);
      Prop hinge_post = UsualProp(PropKind::kPost), latch_post = hinge_post;
      const double half_m = 0.5 * gate.size_m.x(), gap_m = 0.1;
      const Footprint line = {front.At(front.half_length_m + away_m, 0.0), house.yaw_rad, 0.0, 0.0};
      gate.position = line.At(0.0, half_m);
      hinge_post.position = line.At(0.0, half_m + gap_m);
      latch_post.position = line.At(0.0, -half_m - gap_m);
      gate.yaw_rad = std::remainder(house.yaw_rad - M_PI / 2.0, 2.0 * M_PI);
      hinge_post.yaw_rad = latch_post.yaw_rad = gate.yaw_rad;
      const bool fits = IsClear(gate) && IsClear(hinge_post) && IsClear(latch_post) &&
                        IsOnLand(gate, kSteepestForBuildings_deg) &&
                        IsOnLand(hinge_post, kSteepestForBuildings_deg) &&
                        IsOnLand(latch_post, kSteepestForBuildings_deg);
      if (!fits) continue;
      Add(gate);
      Add(hinge_post);
      Add(latch_post);
    }
  }

  void PlaceCrates() {
    RandomStream random(seed_, "scene/elements/crates");
    for (const Asset& house : scene_.assets) {
      if (!IsHouse(house) || !random.Chance(kWithCrates)) continue;
      const Footprint walls = FootprintOf(house);
      const int count = random.UniformInt(1, kMostCratesOfHouse);
      const double side = random.Chance(0.5) ? 1.0 : -1.0;
      for (int i = 0; i < count; ++i) {
        Prop crate = UsualProp(PropKind::kCrate);
        crate.size_m *= random.Uniform(0.8, 1.6);
        crate.mass_kg = UsualMass(crate.kind, crate.size_m);
        crate.position =
            walls.At(walls.half_length_m * random.Uniform(-0.8, 0.8),
                     side * (walls.half_width_m + crate.size_m.x() + random.Uniform(0.2, 0.8)));
        crate.yaw_rad = std::remainder(house.yaw_rad + random.Uniform(-0.3, 0.3), 2.0 * M_PI);
        if (IsOnLand(crate, kSteepestForBuildings_deg) && IsClear(crate)) Add(crate);
      }
    }
  }

  // Places rows of posts along roads, each at one distance from the road's edge.
  void PlacePosts() {
    RandomStream random(seed_, "scene/elements/posts");
    const int rows = static_cast<int>(std::lround(kPostRowsPerKm2 * area_km2()));
    constexpr int kTries = 12;
    for (int row = 0; row < rows; ++row) {
      for (int i = 0; i < kTries; ++i) {
        WorldPoint place = Anywhere(&random);
        const std::optional<RoadFinder::Road> road = roads_.Nearest(place);
        if (!road || road->distance_m > kFarthestRoad_m) continue;
        PlaceRow(place, *road);
        break;
      }
    }
  }
  void PlaceRow(WorldPoint place, RoadFinder::Road road) {
    for (int i = 0; i < kPostsOfRow; ++i) {
      const double closer_m = road.distance_m - kPostFromRoad_m;
      place = {place.x_m + closer_m * std::cos(road.heading_rad),
               place.y_m + closer_m * std::sin(road.heading_rad)};
      Prop post = UsualProp(PropKind::kPost);
      post.position = place;
      post.yaw_rad = road.heading_rad;
      if (IsOnLand(post, kSteepestForBuildings_deg) && IsClear(post)) Add(post);
      place = {place.x_m - kPostSpacing_m * std::sin(road.heading_rad),
               place.y_m + kPostSpacing_m * std::cos(road.heading_rad)};
      if (!scene_.geometry().Contains(place)) return;
      const std::optional<RoadFinder::Road> next = roads_.Nearest(place);
      if (!next || next->distance_m > kFarthestRoad_m) return;
      road = *next;
    }
  }

  void PlaceLooseStones() {
    RandomStream random(seed_, "scene/elements/loose stones");
    const int tries = static_cast<int>(std::lround(kStonesPerKm2 * area_km2()));
    for (int i = 0; i < tries; ++i) {
      Prop stone = UsualProp(PropKind::kLooseStone);
      stone.position = Anywhere(&random);
      stone.size_m.setConstant(random.Uniform(0.15, 0.5));
      stone.mass_kg = UsualMass(stone.kind, stone.size_m);
      stone.yaw_rad = random.Uniform(-M_PI, M_PI);
      const SurfaceClass surface = terrain_.SurfaceAt(stone.position);
      const bool stony = surface == SurfaceClass::kRock || surface == SurfaceClass::kBarren;
      const bool tilled = surface == SurfaceClass::kFarmland || surface == SurfaceClass::kBuilding;
      const bool wanted = random.Chance(stony ? 1.0 : tilled ? 0.0 : kOnOpenGround);
      if (wanted && IsOnLand(stone, kSteepestForLooseStones_deg) && IsClear(stone)) Add(stone);
    }
  }

  const Scene& scene_;
  const Terrain& terrain_;
  const std::uint64_t seed_;
  const RoadFinder roads_;
  StandingProps road_bridges_;
  std::map<PropKind, int> count_;
  std::set<std::string> names_;  // of things
  std::vector<Prop> props_;
};

}  // namespace

std::vector<Prop> PlaceProps(const Scene& scene, std::uint64_t seed) {
  return Placer(scene, seed).Place();
}

}  // namespace latticeworld
