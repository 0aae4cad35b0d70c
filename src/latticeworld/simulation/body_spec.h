#ifndef LATTICEWORLD_SIMULATION_BODY_SPEC_H_
#define LATTICEWORLD_SIMULATION_BODY_SPEC_H_

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace latticeworld {

inline constexpr double kGravity_mps2 = 9.81;

// A part of how a body meets solid things and other bodies, in base_link.
enum class ShapeForm : std::uint8_t { kBall, kCapsule, kBox };
struct BodyShape {
  ShapeForm form = ShapeForm::kBall;
  Eigen::Vector3d center_m = Eigen::Vector3d::Zero();
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  // base from shape
  double radius_m = 0.5;                                            // ball, capsule
  double half_length_m = 0.0;  // capsule: of the straight part, along its z
  Eigen::Vector3d half_extents_m = Eigen::Vector3d::Zero();  // box
};

// A point (radius 0) or a ball of a body that the ground holds up, in base_link.
struct GroundSample {
  Eigen::Vector3d offset_m = Eigen::Vector3d::Zero();
  double radius_m = 0.0;
};

// A wheel on an axle along y of base_link; ground and bodies see it as a ball.
struct WheelSpec {
  Eigen::Vector3d center_m = Eigen::Vector3d::Zero();  // in base_link, at rest; y > 0: left
  double radius_m = 0.1;
  double mass_kg = 1.0;
  double max_torque_nm = 10.0;  // 0: it is not driven
  double width_m = 0.06;
  double side_grip = 0.55;        // sideways friction, share of that along the wheel
  double max_steering_rad = 0.0;  // 0: it is not steered
  double spring_npm = 0.0;        // suspension; 0: rigid
  double damper_nspm = 0.0;
  double travel_m = 0.0;  // up and down from center_m
};

// A rigid part that turns on a motorised hinge about another one. Everything is given in base_link
// with all joints at angle 0.
struct LinkSpec {
  int parent = -1;  // an earlier link; -1: the trunk
  double mass_kg = 1.0;
  Eigen::Vector3d inertia_kgm2 = Eigen::Vector3d::Ones();  // principal, axes of base_link
  Eigen::Vector3d center_m = Eigen::Vector3d::Zero();      // of mass
  Eigen::Vector3d anchor_m = Eigen::Vector3d::Zero();  // of the hinge; origin of the link's frame
  Eigen::Vector3d axis = Eigen::Vector3d::UnitY();     // unit; right-handed positive
  double low_rad = -M_PI, high_rad = M_PI;             // stops
  double max_effort_nm = 10.0;
  double max_rate_radps = 20.0;
  std::vector<GroundSample> ground_samples;
};

// How a body is held by the world.
enum class AnchorKind : std::uint8_t {
  kFixed,  // does not move at all: posts, decks
  kHinge   // turns about an upright axis: gates
};
struct AnchorSpec {
  AnchorKind kind = AnchorKind::kFixed;
  Eigen::Vector3d pivot_m = Eigen::Vector3d::Zero();  // kHinge: a point of the axis, in base_link
  double low_rad = -M_PI / 2, high_rad = M_PI / 2;    // kHinge: stops
  double friction_nm = 0.0;                           // kHinge: torque that it takes to turn it
};

// A body. Towards solid things and other bodies it is its shapes and wheels; towards the ground its
// samples and wheels and those of its links.
struct BodySpec {
  double mass_kg = 1.0;                                    // of the trunk
  Eigen::Vector3d inertia_kgm2 = Eigen::Vector3d::Ones();  // principal, axes of base_link
  double center_height_m = 0.0;                            // centre of mass above base_link
  std::vector<BodyShape> shapes;
  std::vector<GroundSample> ground_samples;
  std::vector<WheelSpec> wheels;
  std::vector<LinkSpec> links;
  std::optional<AnchorSpec> anchor;
  bool upright = false;          // never pitches or rolls
  bool may_rest = true;          // sleeps when nothing moves it
  bool meets_boundary = true;    // the world's edge holds it back; beyond it the ground goes on
  double grip = 1.0;             // times the friction of the surface
  double max_speed_mps = 100.0;  // no force or blow makes it faster

  double total_mass_kg() const;
  // Radius of the ball around the shapes' and wheels' extent, about base_link.
  double reach_m() const;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_BODY_SPEC_H_
