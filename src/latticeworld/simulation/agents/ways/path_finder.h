#ifndef LATTICEWORLD_SIMULATION_AGENTS_WAYS_PATH_FINDER_H_
#define LATTICEWORLD_SIMULATION_AGENTS_WAYS_PATH_FINDER_H_

#include <cstdint>
#include <memory>
#include <vector>

#include "latticeworld/geometry/grid_geometry.h"

namespace latticeworld {

struct Scene;
struct SceneChanges;
struct Species;

struct FoundPath {
  std::vector<WorldPoint> points;  // corners in order, without the start; empty: no way at all
  bool complete = false;           // ends at the goal; else at the place nearest to it
  double length_m = 0.0;
};

// Shortest ways over the traversability map, for bodies of a few classes of size, slope and wading
// depth. What it answers depends on its arguments and the changes alone, never on what was asked
// before.
class PathFinder {
 public:
  // scene: outlives this.
  explicit PathFinder(const Scene& scene);
  ~PathFinder();
  PathFinder(const PathFinder&) = delete;
  PathFinder& operator=(const PathFinder&) = delete;

  // What has become of the scene's assets; cheap where little is different from before. Both lists
  // in the order of assets.
  void Update(const SceneChanges& changes);

  // A* over cells of about one metre, pulled straight: at most 1.25 of the cheapest way in steps
  // from cell to cell, and mostly shorter. max_nodes: after so many cells the way to the nearest
  // place found so far is the answer.
  FoundPath Find(const Species& species, WorldPoint from, WorldPoint to, int max_nodes = 4000);
  // Whether the species can go straight from one place to the other.
  bool IsStraightFree(const Species& species, WorldPoint from, WorldPoint to);

 private:
  struct Layers;
  std::unique_ptr<Layers> layers_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_AGENTS_WAYS_PATH_FINDER_H_
