#ifndef LATTICEWORLD_SIMULATION_PHYSICS_WORLD_H_
#define LATTICEWORLD_SIMULATION_PHYSICS_WORLD_H_

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <vector>

#include "latticeworld/terrain/surface.h"

namespace latticeworld {

class Digest;

using BodyId = std::uint32_t;  // never used twice by one world; 0 is no body

inline constexpr double kGravity_mps2 = 9.81;

// A point (radius 0) or a ball of a body that the ground holds up, in base_link.
struct GroundSample {
  Eigen::Vector3d offset_m = Eigen::Vector3d::Zero();
  double radius_m = 0.0;
};

// A driven wheel on an axle along y of base_link; the ground sees it as a ball.
struct WheelSpec {
  Eigen::Vector3d center_m = Eigen::Vector3d::Zero();  // in base_link; y > 0: left
  double radius_m = 0.1;
  double mass_kg = 1.0;
  double max_torque_nm = 10.0;
  double width_m = 0.06;
};

// A body. Towards solid things and other bodies it is an upright prism over its footprint; towards
// the ground it is its samples and wheels.
struct BodySpec {
  double mass_kg = 1.0;                                    // without wheels
  Eigen::Vector3d inertia_kgm2 = Eigen::Vector3d::Ones();  // principal, axes of base_link
  double center_height_m = 0.0;                            // centre of mass above base_link
  double height_m = 1.0;
  double radius_m = 0.5;       // of a round footprint
  double half_length_m = 0.0;  // both > 0: a rectangular footprint along x and y instead
  double half_width_m = 0.0;
  std::vector<GroundSample> ground_samples;
  std::vector<WheelSpec> wheels;
  bool upright = false;           // never pitches or rolls
  bool may_rest = true;           // sleeps when nothing moves it
  double grip = 1.0;              // times the friction of the surface
  double wheel_side_grip = 0.55;  // sideways friction of wheels, share of that along the wheel
};

// map_from_base and its velocities, all in the map frame.
struct BodyMotion {
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
  Eigen::Vector3d linear_velocity_mps = Eigen::Vector3d::Zero();  // of the origin of base_link
  Eigen::Vector3d angular_velocity_radps = Eigen::Vector3d::Zero();

  double yaw_rad() const {
    const Eigen::Vector3d forward = orientation * Eigen::Vector3d::UnitX();
    return std::atan2(forward.y(), forward.x());
  }
};

enum class ContactKind : std::uint8_t { kGround, kAsset, kBody, kBoundary };

struct Contact {
  BodyId body = 0;
  ContactKind kind = ContactKind::kGround;
  std::uint32_t other = 0;  // kAsset: index of the asset; kBody: BodyId; else 0
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  // unit, into `body`
  double depth_m = 0.0;
  double approach_mps = 0.0;  // speed at which the two come together, >= 0
};

// Rigid bodies over the ground and among the solid assets of one scene. Same calls, same motions,
// bit for bit, on the same build, whatever other worlds do in the process.
class PhysicsWorld {
 public:
  virtual ~PhysicsWorld() = default;

  // Puts base_link at that place and heading: wheeled bodies lean with the ground, and no sample or
  // wheel begins below it.
  virtual BodyId Add(const BodySpec& spec, const Eigen::Vector3d& position_m, double yaw_rad) = 0;
  virtual void Remove(BodyId body) = 0;

  // What the feet of a body (its ground samples) push towards until told otherwise, map frame.
  // Traction is limited by friction. Zero: it stands and holds.
  virtual void SetWalkVelocity(BodyId body, const Eigen::Vector3d& velocity_mps) = 0;
  // Rates that the wheels of a side are driven towards, within their torque [rad/s].
  virtual void SetWheelRates(BodyId body, double left_radps, double right_radps) = 0;
  // Act at the centre of mass during the next step, map frame [N], [N m].
  virtual void AddForce(BodyId body, const Eigen::Vector3d& force_n) = 0;
  virtual void AddTorque(BodyId body, const Eigen::Vector3d& torque_nm) = 0;

  // What weather has made of the ground from the next step on; at first it is the scene's. Bodies
  // that rest wake up when their hold on the ground changes.
  virtual void SetGround(const GroundState& ground) = 0;

  // Moves a body as a whole; wheels keep their places on it.
  virtual void Place(BodyId body, const BodyMotion& motion) = 0;
  virtual BodyMotion MotionOf(BodyId body) const = 0;
  // Deepest that any wheel or sample of the body is below the ground [m], 0 where none is.
  virtual double SinkageOf(BodyId body) const = 0;
  virtual bool IsResting(BodyId body) const = 0;

  // solver_seed: of the solver's order of constraints.
  virtual void Step(double step_s, std::uint64_t solver_seed) = 0;
  // Of the last step, in the order in which they were found.
  virtual const std::vector<Contact>& contacts() const = 0;
  // All that the future of the bodies depends on.
  virtual void AddTo(Digest* digest) const = 0;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_PHYSICS_WORLD_H_
