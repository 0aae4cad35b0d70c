#ifndef LATTICEWORLD_SIMULATION_AGENTS_AGENT_H_
#define LATTICEWORLD_SIMULATION_AGENTS_AGENT_H_

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "latticeworld/common/random.h"
#include "latticeworld/scene/scene.h"
#include "latticeworld/simulation/agents/minds/mind.h"
#include "latticeworld/simulation/physics_world.h"
#include "latticeworld/simulation/simulator.h"
#include "latticeworld/simulation/world_state.h"
#include "latticeworld/species/species.h"

namespace latticeworld {

// How its body is at the moment; of the body's own controllers (locomotion).
struct Posture {
  bool down = false;              // knocked over: a free body until it gets up
  std::uint64_t still_since = 0;  // episode step; while down
  double gait_phase = 0.0;        // [0, 1), of a quadruped's stride
  double water_s = 0.0;           // time in water that harms it
  bool commanded_joints = false;  // some joint follows a JointCommand
  bool stands = false;            // a quadruped whose joints are locked
  bool righting = false;          // a fallen quadruped that turns its trunk up
  // What a quadruped's gait has learnt to ask for on top of what is wanted: speed forwards and to
  // the left [m/s], height [m]; and turning.
  Eigen::Vector3d gait_trim = Eigen::Vector3d::Zero();
  double turn_trim_radps = 0.0;
};

// An agent. Plain data: a copy of it, and of the physics world's snapshot, is all of it.
struct Agent {
  Agent(AgentId own_id, RandomStream random) : id(own_id), mind(random) {}

  AgentId id;
  std::string name;
  const Species* species = nullptr;  // of SimulatorOptions::species; never null once begun
  AgentState state = AgentState::kIdle;
  int team = 0;
  bool controllable = false;
  std::string policy;  // its own; "": its team's, else its category's usual one
  AgentStart start;    // for respawning
  BodyId body = 0;
  double hit_points = 1.0;
  std::uint64_t died_at = 0;  // episode step; while dead
  Behaviour behaviour = Behaviour::kIdle;
  Mind mind;
  Posture posture;
  std::optional<VelocityCommand> command{};            // clamped to the species' limits
  std::uint64_t command_until = 0;                     // episode step
  std::map<std::size_t, JointTarget> joint_targets{};  // by joint, while commanded
  std::uint64_t joints_until = 0;                      // episode step
  bool strike_wanted = false;                          // commanded, not struck yet
  std::uint64_t next_blow = 0;                         // episode step
  VelocityCommand driven;                              // what the locomotion has ramped up to
  BodyMotion motion;                                   // after the last step
  std::uint64_t next_collision = 0;  // collisions before this step are not told again

  bool alive() const { return hit_points > 0.0; }
  bool able() const { return alive() && !posture.down; }
  WorldPoint place() const { return {motion.position_m.x(), motion.position_m.y()}; }
};

// True when agents of the two teams fight: both take sides, and different ones. 0 is neutral.
inline bool AreEnemies(int team, int other) { return team != 0 && other != 0 && team != other; }

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_AGENTS_AGENT_H_
