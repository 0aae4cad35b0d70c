#ifndef LATTICEWORLD_SIMULATION_AGENTS_BODIES_QUADRUPED_GAIT_H_
#define LATTICEWORLD_SIMULATION_AGENTS_BODIES_QUADRUPED_GAIT_H_

#include <Eigen/Core>
#include <array>

#include "latticeworld/simulation/agents/bodies/footing.h"
#include "latticeworld/simulation/agents/bodies/leg_kinematics.h"
#include "latticeworld/simulation/physics_world.h"

namespace latticeworld {

// A trot: diagonal legs step together, half a stride apart from the other two, and each stands for
// a little more than half of it, so that all four bear for a moment. Where a foot is put down
// follows Raibert (1986, Legged Robots that Balance): below the hip, ahead by half of what the
// trunk travels while the foot stands, and further by a share of the speed that it has too much.

// Says where a leg is in its stride.
struct LegPhase {
  bool swings = false;
  double share = 0.0;        // of the swing that is over, [0, 1)
  double remaining_s = 0.0;  // of the swing
};
LegPhase PhaseOf(double gait_phase, int leg, double stride_period_s);
// True where all four legs stand.
bool AllStand(double gait_phase);
double StanceTime(double stride_period_s);

// What the controller knows of the body and wants of it, map frame.
struct GaitState {
  Eigen::Matrix3d map_from_base;
  Eigen::Vector3d base_m;        // origin of base_link
  Eigen::Vector3d center_m;      // between the hips
  Eigen::Vector3d velocity_mps;  // of center_m
  Eigen::Vector3d rate_radps;
  Eigen::Vector3d heading;  // unit, level
  std::array<Eigen::Vector3d, kLegs> angles_rad;
  std::array<Eigen::Vector3d, kLegs> feet_m;  // middles
  double ground_m = 0.0;                      // mean height of the ground below the hips
  Eigen::Vector3d normal;                     // of that ground, unit
};
GaitState StateOf(const QuadrupedDesign& design, const std::array<LegKinematics, kLegs>& legs,
                  const Footing& ground, BodyId body, const BodyMotion& motion,
                  const PhysicsWorld& physics);

// Returns where a foot stands when nothing is wanted: upright below its pitch joint, on the ground.
Eigen::Vector3d NeutralFoot(const QuadrupedDesign& design, const LegKinematics& leg,
                            const Footing& ground, const GaitState& state);

struct GaitCommand {
  Eigen::Vector3d velocity_mps;  // level, map frame
  double yaw_rate_radps = 0.0;
};
// Velocity of a standing leg's foot against the trunk, map axes: pushes the trunk on as commanded,
// to its height (raise_m above the standing one) and its attitude along the ground.
Eigen::Vector3d StanceVelocity(const QuadrupedDesign& design, const Footing& ground,
                               const GaitState& state, const GaitCommand& command, double raise_m,
                               int leg);
// The same of a swinging leg's: over the ground to where it is put down next.
Eigen::Vector3d SwingVelocity(const QuadrupedDesign& design, const LegKinematics& kinematics,
                              const Footing& ground, const GaitState& state,
                              const GaitCommand& command, int leg, const LegPhase& phase);

// Rates of a leg's joints that give its foot that velocity, within the reach of the leg.
Eigen::Vector3d JointRates(const LegKinematics& kinematics, const GaitState& state, int leg,
                           const Eigen::Vector3d& velocity_mps);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_AGENTS_BODIES_QUADRUPED_GAIT_H_
