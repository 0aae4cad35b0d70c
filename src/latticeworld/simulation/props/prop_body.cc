#include "latticeworld/simulation/props/prop_body.h"

#include <algorithm>
#include <cmath>

namespace latticeworld {
namespace {

constexpr double kGateClearance_m = 0.06;  // below its panel
constexpr double kHingeFriction = 0.04;    // torque over weight times width
constexpr double kDeckLeft = 0.6;          // share of its length that breaks out of a bridge
constexpr double kWoodModulus_pa = 10e9;

// Half of a gate's panel along its x.
double HalfPanel(const Prop& prop) {
  return prop.kind == PropKind::kGate ? 0.5 * prop.size_m.x() : 0.0;
}

BodyShape BoxOf(const Eigen::Vector3d& size_m, double base_m) {
  BodyShape box;
  box.form = ShapeForm::kBox;
  box.half_extents_m = 0.5 * size_m;
  box.center_m = {0.0, 0.0, base_m + 0.5 * size_m.z()};
  return box;
}

void AddCorners(const BodyShape& box, BodySpec* spec) {
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      for (const double z : {-1.0, 1.0}) {
        const Eigen::Vector3d corner =
            box.center_m + Eigen::Vector3d(x, y, z).cwiseProduct(box.half_extents_m);
        spec->ground_samples.push_back({corner, 0.0});
      }
    }
  }
}

Eigen::Vector3d BoxInertia(double mass_kg, const Eigen::Vector3d& size_m) {
  const Eigen::Vector3d square = size_m.cwiseProduct(size_m);
  return mass_kg / 12.0 *
         Eigen::Vector3d(square.y() + square.z(), square.x() + square.z(), square.x() + square.y());
}

void MakeStone(const Prop& prop, BodySpec* spec) {
  const double radius_m = 0.5 * prop.size_m.x();
  const double golden = 0.5 * (1.0 + std::sqrt(5.0));
  spec->center_height_m = radius_m * kStoneLies;
  const Eigen::Vector3d middle(0.0, 0.0, spec->center_height_m);
  // Turns (1, 1, 1), which looks out of a face, upwards.
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(std::acos(std::sqrt(1.0 / 3.0)),
                                                  Eigen::Vector3d(1.0, -1.0, 0.0).normalized()));
  for (int axis = 0; axis < 3; ++axis) {
    for (const double one : {-1.0, 1.0}) {
      for (const double gold : {-golden, golden}) {
        Eigen::Vector3d corner = Eigen::Vector3d::Zero();
        corner[axis] = one;
        corner[(axis + 1) % 3] = gold;
        spec->ground_samples.push_back({middle + radius_m * (turn * corner.normalized()), 0.0});
      }
    }
  }
  BodyShape ball;
  ball.radius_m = radius_m;
  ball.center_m = middle;
  spec->shapes.push_back(ball);
  spec->inertia_kgm2.setConstant(0.4 * prop.mass_kg * radius_m * radius_m);
}

}  // namespace

BodySpec PropBodyOf(const Prop& prop) {
  BodySpec spec;
  spec.mass_kg = prop.mass_kg;
  spec.max_speed_mps = 40.0;
  if (prop.kind == PropKind::kLooseStone) {
    MakeStone(prop, &spec);
    return spec;
  }
  const BodyShape box = BoxOf(prop.size_m, prop.kind == PropKind::kGate ? kGateClearance_m : 0.0);
  spec.shapes.push_back(box);
  spec.center_height_m = box.center_m.z();
  spec.inertia_kgm2 = BoxInertia(spec.mass_kg, prop.size_m);
  if (prop.kind != PropKind::kGate) AddCorners(box, &spec);
  if (prop.kind == PropKind::kCrate) return spec;
  AnchorSpec anchor;
  if (prop.kind == PropKind::kGate) {
    anchor.kind = AnchorKind::kHinge;
    anchor.pivot_m = {-HalfPanel(prop), 0.0, 0.0};
    anchor.low_rad = -kWidestOpening_rad;
    anchor.high_rad = kWidestOpening_rad;
    anchor.friction_nm = kHingeFriction * spec.mass_kg * kGravity_mps2 * prop.size_m.x();
  }
  spec.anchor = anchor;
  return spec;
}

Prop BrokenDeckOf(const Prop& bridge) {
  Prop deck = bridge;
  deck.size_m.x() *= kDeckLeft;
  deck.mass_kg *= kDeckLeft;
  return deck;
}

Buoyancy PropBuoyancyOf(const Prop& prop) {
  Buoyancy buoyancy;
  const Eigen::Vector3d& size = prop.size_m;
  buoyancy.drag_area_m2 = size.x() * size.z();
  switch (prop.kind) {
    case PropKind::kLooseStone:
      buoyancy.volume_m3 = M_PI / 6.0 * size.prod();
      break;
    case PropKind::kGate:
      buoyancy.volume_m3 = 0.4 * size.prod();  // slats
      break;
    case PropKind::kCrate:  // keeps water out
    case PropKind::kBridge:
    case PropKind::kPost:
      buoyancy.volume_m3 = size.prod();
      break;
  }
  return buoyancy;
}

double PostStiffness(const Prop& post) {
  const double thin_m = std::min(post.size_m.x(), post.size_m.y());
  const double wide_m = std::max(post.size_m.x(), post.size_m.y());
  return 3.0 * kWoodModulus_pa * wide_m * thin_m * thin_m * thin_m / 12.0 / post.size_m.z();
}

BodyMotion BeginningOf(const Prop& prop) {
  BodyMotion motion;
  motion.orientation = Eigen::AngleAxisd(prop.yaw_rad, Eigen::Vector3d::UnitZ());
  motion.position_m = {prop.position.x_m, prop.position.y_m, prop.z_m};
  motion.position_m += motion.orientation * Eigen::Vector3d(HalfPanel(prop), 0.0, 0.0);
  return motion;
}

BodyMotion PropPoseOf(const Prop& prop, const BodyMotion& body) {
  BodyMotion pose = body;
  pose.position_m -= body.orientation * Eigen::Vector3d(HalfPanel(prop), 0.0, 0.0);
  return pose;
}

}  // namespace latticeworld
