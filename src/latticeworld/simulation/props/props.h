#ifndef LATTICEWORLD_SIMULATION_PROPS_PROPS_H_
#define LATTICEWORLD_SIMULATION_PROPS_PROPS_H_

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/scene/props/standing_props.h"
#include "latticeworld/scene/scene.h"
#include "latticeworld/scene/scene_changes.h"
#include "latticeworld/simulation/physics_world.h"
#include "latticeworld/simulation/world_state.h"

namespace latticeworld {

// The crates, stones, gates, bridges and posts of a running world.
class Props {
 public:
  // scene, physics: outlive this. Begins with the scene's props.
  Props(const Scene& scene, PhysicsWorld* physics);

  // Plain data, to copy into a snapshot.
  struct Running {
    Prop prop;  // of a broken bridge: the plank that broke out of it
    BodyId body = 0;
    // Averaged over a fifth of a second: what bridges bear [N], what pushes at posts [N m].
    double load = 0.0;
    double overload_s = 0.0;  // how long that has been more than the strength
    bool broken = false;
    bool open = false;                   // gates: as told last
    std::optional<double> wanted_rad{};  // gates: opening that it is told to turn to
    // The block that maps have: where it stood still last, or began. None: they do not show it.
    std::optional<PropBlock> on_maps{};
    bool open_on_maps = false;              // gates
    std::optional<BodyMotion> looked_at{};  // when that was looked at: spares looking again
  };
  using State = std::map<std::string, Running>;  // by name

  // Puts it onto the ground, whatever its z_m says. prop: legal (ValidateSpawn) and of a name that
  // is not in use, by the caller. Errors: OUT_OF_RANGE (not wholly in the world),
  // FAILED_PRECONDITION (inside a solid asset or another prop), RESOURCE_EXHAUSTED (too many).
  // changes: assets that do not stand are in nobody's way.
  Result<std::string> Add(const Prop& prop, const SceneChanges& changes = {});
  // Errors: NOT_FOUND.
  Status Remove(const std::string& name);
  // opening_rad: 0 closed, [-1.5, 1.5]. Errors: NOT_FOUND, FAILED_PRECONDITION (no gate),
  // OUT_OF_RANGE.
  Status OpenGate(const std::string& name, double opening_rad);
  bool Has(const std::string& name) const { return state_.count(name) != 0; }
  // "": not a prop's.
  std::string NameOf(BodyId body) const;

  // Part of the physics' judge: whether the anchored body of a kBody contact gives way to it: a
  // post that breaks under the blow.
  bool GivesWay(const Contact& contact);
  // Exerts, before the physics' step, gate motors, buoyancy and drag in water.
  void Act(const Atmosphere& atmosphere, double step_s);
  // Lets, after the physics' step, give way what is overloaded; tells broke, opened and closed.
  // True: something broke, and standing() is another.
  bool Step(double step_s, std::uint64_t step, std::vector<Event>* events);

  // Now and then: what stands still more than half a cell of the scene from where maps have it, or
  // a gate that was opened or closed, is on them where it is. True: standing() is another.
  bool Follow();
  // Returns the props as maps show them; never null.
  const std::shared_ptr<const StandingProps>& standing() const { return standing_; }
  // Whether that is where the scene has them.
  bool is_as_begun() const { return is_as_begun_; }
  // The upright box around one of state().
  PropBlock BoxNow(const Running& running) const;

  const State& state() const { return state_; }
  // Is to be called after the physics was restored to the same moment.
  void Restore(const State& state);
  std::vector<PropSnapshot> Snapshots() const;  // sorted by name
  void AddTo(Digest* digest) const;

 private:
  // What broke a post in this step, and what that leaves of its speed.
  struct Blow {
    BodyId by = 0;
    double by_kg = 0.0;  // with which it hit
    Eigen::Vector3d impulse_ns = Eigen::Vector3d::Zero();
    Eigen::Vector3d point_m = Eigen::Vector3d::Zero();
  };

  void Begin(const Prop& prop);
  Status CheckPlace(const Prop& prop, const SceneChanges& changes) const;
  void ListStanding();
  void AddLoads(double step_s);
  void Break(Running* running);
  void TurnGate(Running* running, double step_s);
  bool TellGate(Running* running);

  const Scene& scene_;
  PhysicsWorld* const physics_;
  State state_;
  std::map<BodyId, std::string> names_;
  std::shared_ptr<const StandingProps> standing_;
  bool is_as_begun_ = true;
  std::map<std::string, Blow> blows_;  // of this step; empty between steps
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_PROPS_PROPS_H_
