// Bodies that stand straight while they are well: characters, animals, flyers, swimmers.

#include <algorithm>
#include <cmath>

#include "latticeworld/simulation/agents/bodies/body_plans.h"

namespace latticeworld {
namespace {

Eigen::Vector3d CylinderInertia(double mass_kg, double radius_m, double height_m) {
  const double across = mass_kg * (3.0 * radius_m * radius_m + height_m * height_m) / 12.0;
  return {across, across, 0.5 * mass_kg * radius_m * radius_m};
}

BodySpec UprightBody(const Species& species) {
  BodySpec body;
  body.mass_kg = species.mass_kg;
  body.center_height_m = 0.5 * species.height_m;
  body.upright = true;
  return body;
}

}  // namespace

BodySpec BipedBody(const Species& species) {
  // Shoulders: what the body lies on when it has been knocked over.
  constexpr double kThickness = 0.12;  // half of it, share of the height
  BodySpec body = UprightBody(species);
  body.inertia_kgm2 = CylinderInertia(species.mass_kg, 0.15 * species.height_m, species.height_m);
  BodyShape capsule;
  capsule.form = ShapeForm::kCapsule;
  capsule.radius_m = std::min(species.radius_m, 0.49 * species.height_m);
  capsule.half_length_m = 0.5 * species.height_m - capsule.radius_m;
  capsule.center_m.z() = 0.5 * species.height_m;
  body.shapes = {capsule};
  // On its feet only the first touches the ground, on slopes too: the others keep clear of a slope
  // of 0.9 rad.
  body.ground_samples = {{Eigen::Vector3d::Zero(), 0.0}};
  for (const double share : {0.25, 0.55, 1.0 - kThickness}) {
    body.ground_samples.push_back(
        {{0.0, 0.0, share * species.height_m}, kThickness * species.height_m});
  }
  return body;
}

BodySpec GrazerBody(const Species& species) {
  constexpr double kHalfLength = 0.92, kHalfWidth = 0.36;  // shares of the radius
  constexpr double kLow = 0.12, kHigh = 0.9;               // shares of the height
  BodySpec body = UprightBody(species);
  const Eigen::Vector3d half_m(kHalfLength * species.radius_m, kHalfWidth * species.radius_m,
                               0.5 * (kHigh - kLow) * species.height_m);
  body.inertia_kgm2 = BoxInertia(species.mass_kg, 2.0 * half_m);
  const Eigen::Vector3d center_m(0.0, 0.0, 0.5 * (kHigh + kLow) * species.height_m);
  body.shapes = {BoxShape(center_m, half_m)};
  // It stands on the first; dead it lies on the others, which no slope that it goes onto touches.
  body.ground_samples = {{Eigen::Vector3d::Zero(), 0.0}};
  const double along_m = 0.6 * half_m.x();
  const double belly_m =
      std::max(0.5 * species.height_m,
               std::min(0.75 * species.height_m, 1.15 * std::tan(species.max_slope_rad) * along_m));
  for (const double x : {along_m, -along_m}) {
    for (const double y : {half_m.y(), -half_m.y()}) {
      body.ground_samples.push_back({{x, y, belly_m}, 0.0});
      body.ground_samples.push_back({{x, y, kHigh * species.height_m}, 0.0});
    }
  }
  return body;
}

BodySpec FlyerBody(const Species& species) {
  BodySpec body = UprightBody(species);
  const double half_m = 0.5 * species.height_m;
  body.inertia_kgm2 = CylinderInertia(species.mass_kg, species.radius_m, species.height_m);
  const double across_m = std::sqrt(0.5) * species.radius_m;
  body.shapes = {BoxShape({0.0, 0.0, half_m}, {across_m, across_m, half_m})};
  body.ground_samples = {{{0.0, 0.0, half_m}, half_m}};
  body.may_rest = false;
  return body;
}

BodySpec SwimmerBody(const Species& species) {
  BodySpec body = UprightBody(species);
  const double half_m = 0.5 * species.height_m;
  body.inertia_kgm2 = CylinderInertia(species.mass_kg, species.radius_m, species.height_m);
  BodyShape capsule;
  capsule.form = ShapeForm::kCapsule;
  capsule.center_m.z() = half_m;
  capsule.orientation = Eigen::AngleAxisd(0.5 * M_PI, Eigen::Vector3d::UnitY());
  capsule.radius_m = half_m;
  capsule.half_length_m = std::max(0.0, species.radius_m - half_m);
  body.shapes = {capsule};
  const double reach_m = 0.7 * species.radius_m;
  body.ground_samples = {{{0.0, 0.0, half_m}, half_m},
                         {{reach_m, 0.0, half_m}, 0.5 * half_m},
                         {{-reach_m, 0.0, half_m}, 0.5 * half_m}};
  body.may_rest = false;
  return body;
}

}  // namespace latticeworld
