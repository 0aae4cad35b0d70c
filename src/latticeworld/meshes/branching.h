#ifndef LATTICEWORLD_MESHES_BRANCHING_H_
#define LATTICEWORLD_MESHES_BRANCHING_H_

#include <vector>

#include "latticeworld/meshes/mesh_builder.h"

namespace latticeworld {

// A skeleton of wood: nodes, each grown from its parent. Parents come before their children.
struct Branching {
  std::vector<Vec3> nodes_m;
  std::vector<int> parents;      // -1: where it starts
  std::vector<float> radii_m;    // of the wood that leads to the node
  std::vector<float> lengths_m;  // of the way along the wood to the node
};

// Grows wood through points: each in turn is joined to the node from which the way is shortest, the
// way along the wood counting `balance` times as much: little wood with a little of it, short ways
// to the tips with much (the balanced spanning trees of Cuntz, Forstner, Borst and Haeusser 2010,
// One Rule to Grow Them All). `start` holds the trunk, each node the parent of the next, and
// start_lengths_m the ways to its nodes.
Branching GrowBranching(const std::vector<Vec3>& start_m, const std::vector<float>& start_lengths_m,
                        const std::vector<Vec3>& points_m, float balance);

// Rounds the bends of the wood but for its first `fixed` nodes and its tips.
void SmoothBranching(int fixed, Branching* branching);

// Radii by the pipe model (Shinozaki et al. 1964), exponent 2.3: between da Vinci's 2 and
// Murray's 3. foot_m: the radius where it starts.
void ThickenBranching(float foot_m, Branching* branching);

struct BranchTubes {
  float thick_m = 1e9f;  // from here on wood has `thick_sides`
  int sides = 3, thick_sides = 5;
  int skip_nodes = 0;  // the first ones are drawn by others
  int most = 1 << 20;  // at most as many triangles, the thickest branches first
};
// Tubes along the wood: a branch goes on into its thickest child, the others leave it.
void AddBranches(const Branching& branching, const BranchTubes& tubes, MeshBuilder* builder);
// The same as flat blades of one to three triangles a branch, none narrower than the half width.
void AddBranchBlades(const Branching& branching, const BranchTubes& tubes, float least_half_width_m,
                     MeshBuilder* builder);

}  // namespace latticeworld

#endif  // LATTICEWORLD_MESHES_BRANCHING_H_
