#include "latticeworld/simulation/agents/look_around.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/simulation/agents/steering.h"

namespace latticeworld {
namespace {

constexpr double kClearance_m = 0.12;  // kept from solid things beside the body's own radius
constexpr double kEdge_m = 0.3;        // kept from the edge of the world
constexpr double kThin_m = 0.02;       // of the ray that must not go through a wall

double StrideOf(const Species& species) { return species.plan == BodyPlan::kSwimmer ? 2.0 : 0.5; }

// What does not depend on solid things.
bool IsGroundGood(const Surroundings& world, const Agent& agent, WorldPoint place) {
  const Species& species = *agent.species;
  const double half_m = world.scene.geometry().half_size_m() - species.radius_m - kEdge_m;
  if (!(std::abs(place.x_m) <= half_m && std::abs(place.y_m) <= half_m)) return false;
  if (species.plan == BodyPlan::kFlyer) return true;
  const double depth_m = world.WaterDepthAt(place);
  if (species.plan == BodyPlan::kSwimmer) return depth_m >= species.wade_depth_m;
  if (depth_m > species.wade_depth_m) return false;
  // No steeper than it can climb, nor than its feet hold on wet or snowy ground.
  const double friction = world.surfaces.Of(world.scene.terrain->SurfaceAt(place)).friction;
  const double max_slope_rad = std::min(species.max_slope_rad, std::atan(species.grip * friction));
  return world.scene.terrain->ground.SlopeAt(place) <= max_slope_rad;
}

bool IsGroundGoodAlong(const Surroundings& world, const Agent& agent, WorldPoint from,
                       WorldPoint to) {
  const double length_m = DistanceBetween(from, to);
  const int strides = std::max(1, static_cast<int>(std::ceil(length_m / StrideOf(*agent.species))));
  for (int i = 1; i <= strides; ++i) {
    const double share = static_cast<double>(i) / strides;
    if (!IsGroundGood(
            world, agent,
            {from.x_m + share * (to.x_m - from.x_m), from.y_m + share * (to.y_m - from.y_m)}))
      return false;
  }
  return true;
}

double MarginOf(const Agent& agent) { return agent.species->radius_m + kClearance_m; }

// is_clear(from, to, margin): of solid things.
template <typename IsClear>
bool StandsAt(const Surroundings& world, const Agent& agent, WorldPoint place,
              const IsClear& is_clear) {
  if (!IsGroundGood(world, agent, place)) return false;
  return agent.species->plan == BodyPlan::kFlyer || is_clear(place, place, MarginOf(agent));
}

template <typename IsClear>
bool GoesTo(const Surroundings& world, const Agent& agent, WorldPoint from, WorldPoint to,
            bool begins_well, const IsClear& is_clear) {
  // From where it should not be (pushed, or begun too close to something) any way out will do that
  // does not lead through a wall.
  if (!begins_well) {
    return StandsAt(world, agent, to, is_clear) &&
           (agent.species->plan == BodyPlan::kFlyer || is_clear(from, to, kThin_m));
  }
  if (!IsGroundGoodAlong(world, agent, from, to)) return false;
  return agent.species->plan == BodyPlan::kFlyer || is_clear(from, to, MarginOf(agent));
}

}  // namespace

bool CanStand(const Surroundings& world, const Agent& agent, WorldPoint place) {
  return StandsAt(world, agent, place, [&](WorldPoint from, WorldPoint to, double margin_m) {
    return IsWayClear(world.scene, world.changes, from, to, margin_m, agent.species->height_m);
  });
}

bool CanGo(const Surroundings& world, const Agent& agent, WorldPoint from, WorldPoint to) {
  const auto is_clear = [&](WorldPoint a, WorldPoint b, double margin_m) {
    return IsWayClear(world.scene, world.changes, a, b, margin_m, agent.species->height_m);
  };
  return GoesTo(world, agent, from, to, StandsAt(world, agent, from, is_clear), is_clear);
}

LookAround::LookAround(const Surroundings& world, const Agent& agent, double reach_m)
    : world_(world),
      agent_(agent),
      solids_(world.scene, world.changes, agent.place(),
              agent.species->plan == BodyPlan::kFlyer ? 0.0 : reach_m + MarginOf(agent),
              agent.species->height_m),
      begins_well_(StandsAt(world, agent, agent.place(),
                            [this](WorldPoint from, WorldPoint to, double margin_m) {
                              return solids_.IsWayClear(from, to, margin_m);
                            })) {}

bool LookAround::CanGo(double heading_rad, double distance_m) const {
  const WorldPoint here = agent_.place();
  return GoesTo(world_, agent_, here, Ahead(here, heading_rad, distance_m), begins_well_,
                [this](WorldPoint from, WorldPoint to, double margin_m) {
                  return solids_.IsWayClear(from, to, margin_m);
                });
}

std::optional<double> LookAround::ClearHeading(double wanted_rad, double distance_m,
                                               int* turn_side) const {
  constexpr double kTurns_rad[] = {0.0, 0.4, 0.8, 1.2, 1.6, 2.1, 2.7};
  for (const double turn_rad : kTurns_rad) {
    for (const int side : {*turn_side, -*turn_side}) {
      const double heading_rad = WrapAngle(wanted_rad + side * turn_rad);
      if (!CanGo(heading_rad, distance_m)) continue;
      if (turn_rad > 0.0) *turn_side = side;
      return heading_rad;
    }
  }
  return std::nullopt;
}

}  // namespace latticeworld
