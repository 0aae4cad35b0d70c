#ifndef LATTICEWORLD_SIMULATION_SIMULATOR_SIMULATOR_IMPL_H_
#define LATTICEWORLD_SIMULATION_SIMULATOR_SIMULATOR_IMPL_H_

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "latticeworld/simulation/agents/agent.h"
#include "latticeworld/simulation/agents/bodies/bodies.h"
#include "latticeworld/simulation/agents/minds/surroundings.h"
#include "latticeworld/simulation/agents/ways/agent_grid.h"
#include "latticeworld/simulation/agents/ways/path_finder.h"
#include "latticeworld/simulation/props/felling.h"
#include "latticeworld/simulation/props/props.h"
#include "latticeworld/simulation/simulator.h"
#include "latticeworld/simulation/simulator/running_weather.h"
#include "latticeworld/simulation/simulator/straying.h"

namespace latticeworld {

struct Impact;

// The simulator. Its parts stand in files of their own: the step in simulator_impl.cc, what is
// asked of it in simulator_commands.cc, spawning.cc and prop_spawning.cc, how agents begin and
// come back in beginning.cc, what goes astray in straying.cc, what collides in
// simulator_collisions.cc, and how its state is shown, hashed and kept in simulator_state.cc and
// simulator_snapshot.cc.
class SimulatorImpl : public Simulator, private ContactJudge {
 public:
  SimulatorImpl(std::shared_ptr<const Scene> scene, const SimulatorOptions& options,
                std::uint64_t seed);

  Status Command(const std::string& agent, const VelocityCommand& command) override;
  Status CommandJoints(const std::string& agent,
                       const std::vector<JointCommand>& commands) override;
  Status Strike(const std::string& agent) override;
  Status SetPolicy(const PolicyChange& change) override;
  void Step() override;
  std::shared_ptr<const WorldState> State() const override;
  std::vector<Event> TakeEvents() override;
  Result<std::string> Spawn(const SpawnRequest& request) override;
  Status Remove(const std::string& agent) override;
  Result<std::string> SpawnProp(const Prop& prop) override;
  Status RemoveProp(const std::string& prop) override;
  Status OpenGate(const std::string& prop, double opening_rad) override;
  Status SetWeather(const WeatherChange& change) override;
  const Atmosphere& WeatherTarget() const override { return weather_->target(); }
  void Reset(std::uint64_t seed) override;
  std::shared_ptr<const SimulatorSnapshot> Save() const override;
  Status Restore(const SimulatorSnapshot& snapshot) override;
  std::string StateHash() const override;
  const Scene& scene() const override { return *scene_; }
  const SimulatorOptions& options() const override { return options_; }
  std::uint64_t seed() const override { return seed_; }

 private:
  struct Snapshot;

  bool GivesWay(const Contact& contact) override;
  Surroundings World();
  // Lists what has become of trees and props.
  void ListChanges();
  // Events are told through this, and bounded for a caller who does not take them.
  void TellOf(EventKind kind, const std::string& who, const std::string& other,
              const Eigen::Vector3d& position_m);
  // An agent's, a prop's or a felled tree's ("tree_7"); "": nobody's.
  std::string NameOfBody(BodyId body) const;

  // The parts of a step.
  void StepWeather();
  void ThinkAndDrive();
  void ActOnThings();
  void ReadMotions();
  void Collide();
  void StepThings();
  void Respawn();
  void BoundEvents();

  // Agents take turns at what need not be done in every step: each has one in a tenth of a second.
  bool HasTurn(AgentId id) const { return (episode_step_ + id) % turns_ == 0; }

  // Tells the ground what the weather has made of it.
  void WeatherGround();
  // Whether bodies climb as steep on them, as far as maps care.
  static bool HoldAlike(const SurfaceTable& a, const SurfaceTable& b);
  void TellWeather(const std::string& what);

  // An agent that begins now, with a body at the start's place. policy: its own; may be empty.
  Agent& Begin(const AgentStart& start, const Species& species, const std::string& policy);
  // Gives it a body, health and a mind as at its start, at the place.
  void Embody(Agent* agent, WorldPoint place);
  // Where base_link of an agent that begins at the place begins [m].
  double StartHeight(const Agent& agent, WorldPoint place) const;
  // Where it can come back: at its start, or near it.
  std::optional<WorldPoint> PlaceToRespawn(Agent* agent);

  // Tells of what physics slowed down, once for as long as it goes on.
  void TellSlowed();
  // Freezes what physics could not compute.
  void FreezeStrayed();
  void Freeze(Agent* agent);
  // Notes that it strays. True: it was well before, so that it is to be told.
  bool BeginsToStray(const std::string& name);
  // Takes out of the world what has strayed for too long.
  void RemoveLost();
  // Takes an agent out of the world, untold.
  void Erase(AgentId id);
  bool IsFrozen(AgentId id) const { return frozen_until_.count(id) != 0; }
  // Lets go who was frozen long enough, and holds the others where they are.
  void HoldFrozen();
  void FindLostProps();

  // One side of a collision: tells it, hurts and knocks over. other: name of the other side.
  // push: unit, away from it. other_id: 0 where it is no agent.
  void Suffer(AgentId id, const Impact& impact, const Eigen::Vector3d& push,
              const std::string& other, AgentId other_id);
  std::string NameOfOther(const Contact& contact) const;

  // Errors: NOT_FOUND.
  Result<Agent*> FindAgent(const std::string& name);
  // The same, and FAILED_PRECONDITION for one that nobody outside may command.
  Result<Agent*> FindCommandable(const std::string& name);
  bool IsExternal(const Agent& agent) const;
  // Its own policy or its team's; "": neither.
  const std::string& PolicyAsTold(const Agent& agent) const;
  // The one that it follows; "": it obeys commands.
  std::string PolicyOf(const Agent& agent) const;
  const std::vector<JointName>& JointsOfSpecies(const Species& species) const;

  // Errors: see Spawn.
  Result<const Species*> SpeciesFor(const SpawnRequest& request) const;
  Status CheckRequest(const SpawnRequest& request, const Species& species) const;
  Status CheckName(const std::string& name) const;
  Result<WorldPoint> PlaceFor(const SpawnRequest& request, const Species& species);
  // FAILED_PRECONDITION when an agent, a prop or a stem that lies or will lie there is in the
  // way of a body there.
  // except: not in its own way; 0: nobody.
  Status CheckFree(const Species& species, WorldPoint place, AgentId except) const;
  bool IsNameTaken(const std::string& name) const;
  std::string NumberedNameFor(const std::string& kind) const;

  AgentSnapshot SnapshotOf(const Agent& agent) const;
  std::vector<JointSnapshot> JointSnapshotsOf(const Agent& agent) const;

  const std::shared_ptr<const Scene> scene_;
  const SimulatorOptions options_;
  const std::uint64_t turns_;  // steps from one turn of an agent to its next
  // Kept over resets: what it answers depends on the changes that it is told alone.
  PathFinder paths_;
  std::uint64_t seed_;
  std::uint64_t step_ = 0;
  std::uint64_t episode_step_ = 0;
  RandomStream spawn_random_;
  std::unique_ptr<PhysicsWorld> physics_;
  // Made by Reset.
  std::optional<Felling> felling_;
  std::optional<Props> props_;
  std::optional<RunningWeather> weather_;
  std::optional<SurfaceTable> surfaces_;  // under that weather
  SceneChanges changes_;                  // of all three, as maps show them
  std::uint64_t map_version_ = 0;
  std::optional<GroundState> map_ground_;  // what maps show of it; none: as the scene has it
  AgentId last_agent_ = 0;
  std::map<AgentId, Agent> agents_;
  std::map<std::string, AgentId> ids_;  // by name
  std::map<BodyId, AgentId> agent_of_body_;
  std::map<AgentId, std::uint64_t> frozen_until_;  // episode step
  std::map<std::string, Stray> strays_;            // agents, props and trees, by name
  std::map<BodyId, std::uint64_t> slowed_until_;   // episode step until which it is not told again
  std::set<std::string> lost_;                     // of this step; empty between steps
  std::map<int, std::string> team_policies_;
  std::vector<Agent*> in_order_;  // of agents_, by id; empty: made by the next step
  AgentGrid near_;                // made by each step
  std::vector<Event> events_;
  mutable std::map<const Species*, std::vector<JointName>> joints_;  // as asked for; never walked
  mutable std::shared_ptr<const WorldState> state_;                  // null: made when asked for
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_SIMULATOR_SIMULATOR_IMPL_H_
