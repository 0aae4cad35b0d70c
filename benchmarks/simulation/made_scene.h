#ifndef LATTICEWORLD_BENCHMARKS_SIMULATION_MADE_SCENE_H_
#define LATTICEWORLD_BENCHMARKS_SIMULATION_MADE_SCENE_H_

#include <cstdint>
#include <memory>
#include <vector>

#include "latticeworld/scene/scene.h"

namespace latticeworld {

// A scene made by hand: rolling grass (slopes up to 7 degrees) with trees on a jittered lattice.
// Cheap to make at any size, and not bound by what worlds may hold.
struct MadeScene {
  double size_m = 1024.0;
  double resolution_m = 1.0;
  int trees = 0;
  double clearing_m = 0.0;  // no trunk nearer than this to a start or to `spots`
  std::vector<WorldPoint> spots;
  std::vector<AgentStart> agents;

  AgentStart& AddAgent(AgentCategory category, AgentState state, int team, WorldPoint position);
  std::shared_ptr<const Scene> Build() const;
};

// count places on a square lattice `spacing_m` apart around the origin.
std::vector<WorldPoint> Lattice(int count, double spacing_m);

}  // namespace latticeworld

#endif  // LATTICEWORLD_BENCHMARKS_SIMULATION_MADE_SCENE_H_
