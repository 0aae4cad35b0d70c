#ifndef LATTICEWORLD_SIMULATION_PROPS_FELLING_H_
#define LATTICEWORLD_SIMULATION_PROPS_FELLING_H_

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "latticeworld/scene/asset_physics.h"
#include "latticeworld/scene/footprint.h"
#include "latticeworld/scene/scene.h"
#include "latticeworld/scene/scene_changes.h"
#include "latticeworld/simulation/physics_world.h"
#include "latticeworld/simulation/world_state.h"

namespace latticeworld {

// No more trees than this fall in a world; when so many have, the others hold.
inline constexpr int kMaxFelledTrees = 500;

// Trees that fall. Owns the bodies of those that fell. A tree falls when a blow, or what pushes it
// for about a tenth of a second, has at its base the moment at which its roots or its stem fail
// (PhysicsOf). Stones and buildings hold.
class Felling {
 public:
  // scene, physics: outlive this.
  Felling(const Scene& scene, PhysicsWorld* physics);

  // Plain data, to copy into a snapshot.
  struct Tree {
    BodyId body = 0;  // 0: it is gone from the world
    double still_s = 0.0;
    double falling_s = 0.0;  // since it began to move
    bool at_rest = false;
    Eigen::Vector2d toward = Eigen::Vector2d::UnitX();  // unit, where it falls to
    FallenTree lies{};  // where it came to rest last; before that, where it began to fall
  };
  struct State {
    std::map<std::uint32_t, Tree> trees;  // by asset
    // Moments of what pushes standing trees, averaged [N m], map frame, where they push to.
    std::map<std::uint32_t, Eigen::Vector2d> pushes;
  };

  // Part of the physics' judge: whether the asset of a kAsset contact gives way to it. It falls in
  // Step; what hit it keeps the speed that the energy of breaking leaves it.
  bool GivesWay(const Contact& contact);
  // Exerts, before the physics' step, what holds the foot of a falling tree, and the water's forces
  // on what lies.
  void Act(const Atmosphere& atmosphere);
  // What a step did.
  struct Outcome {
    bool changes = false;  // changes() are others
    bool maps = false;     // a tree came to rest, moved where it lies, or left the world
  };
  // Makes, after the physics' step, bodies of the trees that gave way or are pushed beyond their
  // strength, and tells felled_tree (name_of: of the body that did it) and tree_came_to_rest; a
  // tree that leaves the world is gone (left_world).
  Outcome Step(double step_s, std::uint64_t step, const std::function<std::string(BodyId)>& name_of,
               std::vector<Event>* events);
  // Takes a tree that fell out of the world and tells left_world. name: "tree_<asset>"; others are
  // left alone.
  void Remove(const std::string& name, std::uint64_t step, std::vector<Event>* events);

  const State& state() const { return state_; }
  // Is to be called after the physics was restored to the same moment.
  void Restore(const State& state);
  // Trees that lie, and as gone those that still fall or have left the world.
  const SceneChanges& changes() const { return changes_; }
  // What stems that lie or fall cover, and where those that fall will lie, seen from above.
  std::vector<Footprint> Obstacles() const;
  // Returns the felled trees by asset; those that have left the world never come to rest.
  std::vector<FelledTree> Snapshots() const;
  static std::string NameOf(std::uint32_t asset);
  // Which tree a body is.
  std::optional<std::uint32_t> AssetOf(BodyId body) const;
  void AddTo(Digest* digest) const;

 private:
  // A tree that gave way in this step.
  struct Fall {
    BodyId by = 0;
    Eigen::Vector2d moment_nm = Eigen::Vector2d::Zero();  // points where it falls to
    double rate_radps = 0.0;
    Eigen::Vector3d impulse_ns = Eigen::Vector3d::Zero();  // on what did it
    Eigen::Vector3d point_m = Eigen::Vector3d::Zero();
  };

  bool CanFall(std::uint32_t asset) const;
  AssetPhysics PhysicsOfTree(std::uint32_t asset) const;
  void Push(double step_s);
  void Begin(std::uint32_t asset, const Fall& fall);
  // Whether it has come to rest, or has left its place of rest.
  bool Follow(std::uint32_t asset, double step_s, Tree* tree);
  bool HasLeft(const BodyMotion& motion) const;
  void Lose(Tree* tree);
  void ListChanges();

  const Scene& scene_;
  PhysicsWorld* const physics_;
  State state_;
  std::map<std::uint32_t, Fall> falls_;  // of this step; empty between steps
  SceneChanges changes_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_PROPS_FELLING_H_
