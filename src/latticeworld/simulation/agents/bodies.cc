#include "latticeworld/simulation/agents/bodies.h"

#include <cmath>

#include "latticeworld/scene/spawn_rules.h"
#include "latticeworld/simulation/agents/species.h"

namespace latticeworld {
namespace {

Eigen::Vector3d CylinderInertia(double mass_kg, double radius_m, double height_m) {
  const double across = mass_kg * (3.0 * radius_m * radius_m + height_m * height_m) / 12.0;
  return {across, across, 0.5 * mass_kg * radius_m * radius_m};
}

// Four driven wheels below a flat chassis; the battery keeps its weight low.
BodySpec WheeledBody(const Species& species) {
  constexpr double kWheelMass_kg = 1.5;
  constexpr double kAxleOffset_m = 0.18;  // front and rear axles before and behind the centre
  constexpr double kChassisLength_m = 0.56, kChassisWidth_m = 0.36, kChassisLow_m = 0.1;
  BodySpec body;
  body.mass_kg = species.mass_kg - 4.0 * kWheelMass_kg;
  const double height_m = species.height_m - kChassisLow_m;
  body.inertia_kgm2 =
      body.mass_kg / 12.0 *
      Eigen::Vector3d(kChassisWidth_m * kChassisWidth_m + height_m * height_m,
                      kChassisLength_m * kChassisLength_m + height_m * height_m,
                      kChassisLength_m * kChassisLength_m + kChassisWidth_m * kChassisWidth_m);
  body.center_height_m = 0.16;
  body.half_length_m = kAxleOffset_m + kWheelRadius_m;
  body.half_width_m = 0.5 * kWheelTrack_m + 0.04;
  body.radius_m = std::hypot(body.half_length_m, body.half_width_m);
  for (const double x : {kAxleOffset_m, -kAxleOffset_m}) {
    for (const double y : {0.5 * kWheelTrack_m, -0.5 * kWheelTrack_m}) {
      body.wheels.push_back({{x, y, kWheelRadius_m}, kWheelRadius_m, kWheelMass_kg, 14.0});
    }
  }
  for (const double x : {0.5 * kChassisLength_m, -0.5 * kChassisLength_m}) {
    for (const double y : {0.5 * kChassisWidth_m, -0.5 * kChassisWidth_m}) {
      for (const double z : {kChassisLow_m, species.height_m}) {
        body.ground_samples.push_back({{x, y, z}, 0.0});
      }
    }
  }
  return body;
}

}  // namespace

BodySpec BodyOf(AgentCategory category) {
  const Species& species = SpeciesOf(category);
  const Locomotion locomotion = LocomotionOf(category);
  BodySpec body;
  if (locomotion == Locomotion::kWheels) {
    body = WheeledBody(species);
  } else {
    body.radius_m = BodyRadius(category);
    body.mass_kg = species.mass_kg;
    body.inertia_kgm2 = CylinderInertia(species.mass_kg, body.radius_m, species.height_m);
    body.center_height_m = 0.5 * species.height_m;
    body.upright = true;
    if (locomotion == Locomotion::kLegs) {
      body.ground_samples = {{Eigen::Vector3d::Zero(), 0.0}};
    } else {
      const double half_m = 0.5 * species.height_m;
      body.ground_samples = {{{0.0, 0.0, half_m}, half_m}};
      body.may_rest = false;
    }
    if (locomotion == Locomotion::kFins) {
      const double reach_m = 0.7 * body.radius_m;
      const double half_m = 0.5 * species.height_m;
      body.ground_samples.push_back({{reach_m, 0.0, half_m}, 0.5 * half_m});
      body.ground_samples.push_back({{-reach_m, 0.0, half_m}, 0.5 * half_m});
    }
  }
  body.height_m = species.height_m;
  body.grip = species.grip;
  return body;
}

}  // namespace latticeworld
