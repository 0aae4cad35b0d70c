#include "latticeworld/simulation/props/tree_body.h"

#include <algorithm>
#include <cmath>

namespace latticeworld {
namespace {

// Shares of the height, as maps show trees: the crown begins at 0.3 and ends at the top.
constexpr double kCrownMiddle = 0.65;
constexpr double kCrownHalf = 0.35;
constexpr double kStemMass = 0.75;
constexpr double kFormFactor = 0.45;    // stem volume over cylinder, as in PhysicsOf
constexpr double kTreeOverStem = 1.35;  // volume of wood of the whole tree over that of the stem
constexpr double kTaper = 0.8;          // share of its radius that a stem loses up to its tip
constexpr double kBoughs = 0.4;         // share of the crown's radius that bears a lying tree
constexpr double kLean_rad = 0.1;       // at which roots or stem have given way
constexpr double kDragCoefficient = 1.0;
// Roots: natural frequency and damping ratio of the foot on them, weights that they hold, and the
// share of uprightness (cosine of the lean) up to which they do.
constexpr double kRootRate_radps = 6.0;
constexpr double kRootDamping = 0.7;
constexpr double kRootWeights = 2.0;
constexpr double kTornUpright = 0.4;

double RadiusAt(const Asset& tree, double share) {
  return tree.trunk_radius_m * (1.0 - kTaper * share);
}

void AddSamples(const Asset& tree, BodySpec* spec) {
  const double radius_m = tree.trunk_radius_m, height_m = tree.height_m;
  const double boughs_m = kBoughs * tree.half_length_m;
  const Eigen::Vector2d around[] = {{1.0, 0.0}, {0.0, 1.0}, {-1.0, 0.0}, {0.0, -1.0}};
  for (const Eigen::Vector2d& side : around) {
    spec->ground_samples.push_back({{radius_m * side.x(), radius_m * side.y(), 0.0}, 0.0});
    spec->ground_samples.push_back(
        {{boughs_m * side.x(), boughs_m * side.y(), kCrownMiddle * height_m}, 0.0});
  }
  for (const double share : {0.2, 0.45, 0.7, 1.0}) {
    spec->ground_samples.push_back({{0.0, 0.0, share * height_m}, RadiusAt(tree, share)});
  }
}

}  // namespace

BodySpec TreeBodyOf(const Asset& tree, const AssetPhysics& physics) {
  const double height_m = tree.height_m, radius_m = tree.trunk_radius_m;
  const double crown_m = tree.half_length_m;
  BodySpec spec;
  spec.mass_kg = std::max(1.0, physics.mass_kg);
  const double stem_kg = kStemMass * spec.mass_kg, crown_kg = spec.mass_kg - stem_kg;

  // The stem is a paraboloid over its base: its centre is at 1/3 of its height.
  const double stem_z_m = height_m / 3.0, crown_z_m = kCrownMiddle * height_m;
  spec.center_height_m = (stem_kg * stem_z_m + crown_kg * crown_z_m) / spec.mass_kg;
  const double stem_off_m = stem_z_m - spec.center_height_m;
  const double crown_off_m = crown_z_m - spec.center_height_m;
  const double half_m = kCrownHalf * height_m;
  const double across_kgm2 =
      stem_kg * (height_m * height_m / 18.0 + radius_m * radius_m / 6.0 + stem_off_m * stem_off_m) +
      crown_kg * ((half_m * half_m + crown_m * crown_m) / 5.0 + crown_off_m * crown_off_m);
  const double along_kgm2 =
      stem_kg * radius_m * radius_m / 3.0 + crown_kg * 2.0 / 5.0 * crown_m * crown_m;
  spec.inertia_kgm2 = {across_kgm2, across_kgm2, along_kgm2};

  BodyShape stem;
  stem.form = ShapeForm::kCapsule;
  stem.radius_m = RadiusAt(tree, 0.3);
  stem.half_length_m = std::max(0.0, 0.5 * height_m - stem.radius_m);
  stem.center_m = {0.0, 0.0, 0.5 * height_m};
  spec.shapes.push_back(stem);
  AddSamples(tree, &spec);
  spec.max_speed_mps = 40.0;
  spec.meets_boundary = false;  // its crown may lie across the world's edge
  return spec;
}

Buoyancy TreeBuoyancyOf(const Asset& tree) {
  Buoyancy buoyancy;
  const double radius_m = tree.trunk_radius_m;
  buoyancy.volume_m3 = kTreeOverStem * kFormFactor * M_PI * radius_m * radius_m * tree.height_m;
  buoyancy.drag_area_m2 = kDragCoefficient * radius_m * tree.height_m;
  return buoyancy;
}

BodyMotion BeginningOfFall(const Asset& tree, const Eigen::Vector2d& direction, double rate_radps) {
  const Eigen::Vector3d axis(-direction.y(), direction.x(), 0.0);
  BodyMotion motion;
  motion.orientation = Eigen::AngleAxisd(kLean_rad, axis);
  // No part of the foot goes below the ground by leaning.
  motion.position_m = {tree.x_m, tree.y_m, tree.z_m + tree.trunk_radius_m * std::sin(kLean_rad)};
  motion.angular_velocity_radps = rate_radps * axis;
  return motion;
}

FallenTree StemOf(std::uint32_t asset, const Asset& tree, const BodyMotion& motion) {
  const double height_m = tree.height_m;
  return {asset, motion.position_m,
          motion.position_m + motion.orientation * Eigen::Vector3d(0.0, 0.0, height_m)};
}

Eigen::Vector3d RootForce(const Asset& tree, const BodySpec& spec, const BodyMotion& motion) {
  const double upright = (motion.orientation * Eigen::Vector3d::UnitZ()).z();
  if (upright < kTornUpright) return Eigen::Vector3d::Zero();
  // Mass that the foot of the free rod has for a push across it.
  const double arm_m = spec.center_height_m;
  const double foot_kg = 1.0 / (1.0 / spec.mass_kg + arm_m * arm_m / spec.inertia_kgm2.x());
  Eigen::Vector3d force =
      -foot_kg *
      (kRootRate_radps * kRootRate_radps *
           (motion.position_m - Eigen::Vector3d(tree.x_m, tree.y_m, motion.position_m.z())) +
       2.0 * kRootDamping * kRootRate_radps * motion.linear_velocity_mps);
  force.z() = 0.0;
  const double limit_n = kRootWeights * spec.mass_kg * kGravity_mps2;
  if (force.norm() > limit_n) force *= limit_n / force.norm();
  return force;
}

Eigen::Vector3d ToppleTorque(const BodySpec& spec, const BodyMotion& motion,
                             const Eigen::Vector2d& toward) {
  constexpr double kToppled =
      0.7;  // upright share of the stem's axis below which it falls by itself
  constexpr double kFastest_radps = 1.0;
  constexpr double kLean = 0.5;  // sine of 30 degrees
  const Eigen::Vector3d up = motion.orientation * Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d axis(-toward.y(), toward.x(), 0.0);
  if (up.z() < kToppled || motion.angular_velocity_radps.dot(axis) > kFastest_radps) {
    return Eigen::Vector3d::Zero();
  }
  return kLean * spec.mass_kg * kGravity_mps2 * spec.center_height_m * axis;
}

}  // namespace latticeworld
