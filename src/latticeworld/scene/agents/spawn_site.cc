#include "latticeworld/scene/agents/spawn_site.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "latticeworld/common/text.h"
#include "latticeworld/scene/scene_changes.h"
#include "latticeworld/scene/weather/water_depth.h"
#include "latticeworld/species/species_catalogue.h"

namespace latticeworld {
namespace {

constexpr int kRimPoints = 8;

// The centre and the rim of a body.
std::array<WorldPoint, kRimPoints + 1> FootprintOf(WorldPoint position, double radius_m) {
  std::array<WorldPoint, kRimPoints + 1> points;
  points[0] = position;
  for (int i = 0; i < kRimPoints; ++i) {
    const double angle_rad = 2.0 * M_PI * i / kRimPoints;
    points[i + 1] = {position.x_m + radius_m * std::cos(angle_rad),
                     position.y_m + radius_m * std::sin(angle_rad)};
  }
  return points;
}

double SteepestFor(Locomotion locomotion) {
  return locomotion == Locomotion::kWheels ? kSteepestForWheels_deg : kSteepestForLegs_deg;
}

std::string Figure(double value) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.2f", value);
  return text;
}

}  // namespace

double HoldingSlope_deg(AgentCategory category, double friction) {
  constexpr double kOfGrip = 0.9;
  const Species& species = SpeciesCatalogue::BuiltIn()->Of(category);
  double slope_rad = species.max_slope_rad;
  if (species.vehicle) {
    const bool skids = species.vehicle->drive == DriveKind::kSkidSteer;
    const double side_grip = species.grip * (skids ? kSkidSideGrip : kTyreSideGrip);
    slope_rad = std::min(slope_rad, std::atan(kOfGrip * side_grip * friction));
  }
  return std::min(slope_rad * 180.0 / M_PI, SteepestFor(LocomotionOf(category)));
}

SpawnSite ExamineSpawn(const Scene& scene, const Atmosphere& atmosphere, AgentCategory category,
                       double body_radius_m, WorldPoint position, const SceneChanges* changes) {
  const Terrain& terrain = *scene.terrain;
  const double half_m = terrain.geometry().half_size_m();
  if (!(body_radius_m > 0.0 && body_radius_m < half_m)) {
    return {SpawnFlaw::kIllegalRadius, body_radius_m, 0};
  }
  // Written so that NaN is outside.
  const double limit_m = half_m - body_radius_m;
  if (!(std::abs(position.x_m) <= limit_m && std::abs(position.y_m) <= limit_m)) {
    return {SpawnFlaw::kOutsideWorld, limit_m, 0};
  }

  SpawnSite site;
  const Locomotion locomotion = LocomotionOf(category);
  if (locomotion != Locomotion::kWings) {
    double deepest_m = 0.0, shallowest_m = INFINITY;
    for (const WorldPoint& point : FootprintOf(position, body_radius_m)) {
      const double depth_m = WaterDepthAt(terrain, atmosphere, point);
      deepest_m = std::max(deepest_m, depth_m);
      shallowest_m = std::min(shallowest_m, depth_m);
    }
    if (locomotion == Locomotion::kFins) {
      if (shallowest_m < kSwimmingDepth_m) return {SpawnFlaw::kTooShallow, shallowest_m, 0};
    } else if (deepest_m > kFordingDepth_m) {
      return {SpawnFlaw::kTooDeep, deepest_m, 0};
    }
  }
  scene.index.ForEachNear(position, body_radius_m, [&](std::uint32_t asset) {
    if (site.flaw == SpawnFlaw::kNone &&
        SolidContains(scene.assets[asset], position, body_radius_m) &&
        (changes == nullptr || changes->Stands(asset))) {
      site = {SpawnFlaw::kSolid, 0.0, asset};
    }
  });
  if (site.flaw != SpawnFlaw::kNone) return site;
  if (locomotion == Locomotion::kLegs || locomotion == Locomotion::kWheels) {
    double steepest_rad = 0.0;
    for (const WorldPoint& point : FootprintOf(position, body_radius_m)) {
      steepest_rad = std::max(steepest_rad, terrain.ground.SlopeAt(point));
    }
    const double steepest_deg = steepest_rad * 180.0 / M_PI;
    if (steepest_deg > SteepestFor(locomotion)) return {SpawnFlaw::kTooSteep, steepest_deg, 0};
    site.slope_deg = steepest_deg;
  }
  return site;
}

std::string Describe(const Scene& scene, AgentCategory category, double body_radius_m,
                     const SpawnSite& site) {
  const Locomotion locomotion = LocomotionOf(category);
  const double half_m = scene.geometry().half_size_m();
  switch (site.flaw) {
    case SpawnFlaw::kNone:
      return "nothing is in the way";
    case SpawnFlaw::kIllegalRadius:
      return "a body radius must be above 0 and below " + FormatDouble(half_m) +
             " m, half the world, not " + FormatDouble(body_radius_m);
    case SpawnFlaw::kOutsideWorld:
      return "a body of radius " + FormatDouble(body_radius_m) +
             " m is inside the world when x and y are from " + FormatDouble(-site.figure) + " to " +
             FormatDouble(site.figure) + " m";
    case SpawnFlaw::kSolid: {
      const Asset& asset = scene.assets[site.asset];
      return "a " + std::string(NameOf(asset.kind)) + " at (" + Figure(asset.x_m) + ", " +
             Figure(asset.y_m) + ") stands within the body's radius of " +
             FormatDouble(body_radius_m) + " m";
    }
    case SpawnFlaw::kTooDeep:
      return "the water is " + Figure(site.figure) + " m deep, and at most " +
             FormatDouble(kFordingDepth_m) + " m can be forded";
    case SpawnFlaw::kTooShallow:
      return "the water is " + Figure(site.figure) + " m deep, and a swimmer needs " +
             FormatDouble(kSwimmingDepth_m) + " m";
    case SpawnFlaw::kTooSteep:
      return "the ground slopes by " + Figure(site.figure) + " degrees, and " +
             (locomotion == Locomotion::kWheels ? "wheels" : "legs") + " stand on at most " +
             FormatDouble(SteepestFor(locomotion));
  }
  return "?";
}

}  // namespace latticeworld
