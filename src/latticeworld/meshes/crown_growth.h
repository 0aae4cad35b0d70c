#ifndef LATTICEWORLD_MESHES_CROWN_GROWTH_H_
#define LATTICEWORLD_MESHES_CROWN_GROWTH_H_

#include "latticeworld/meshes/branching.h"
#include "latticeworld/meshes/crown.h"
#include "latticeworld/meshes/shapes.h"

namespace latticeworld {

// How much of what a branched crown has at a detail. Lengths are shares of the crown's size.
struct CrownParts {
  int wood = 0;              // triangles of branches as tubes
  int blades = 0;            // triangles of branches as flat blades, for far away
  float blade_width = 0.0f;  // their least half width
  int leaves = 0;            // triangles of leaves
  float leaf = 0.1f;         // size
  float clump = 0.2f;        // how far leaves lie around the wood
  int twigs = 0;             // triangles of twigs when bare
  float twig = 0.3f;         // length
  float twig_width = 0.01f;  // half width
};

struct CrownStyle {
  CrownParts parts;
  bool needles = false;  // in tufts on level clouds, or leaves all round
  float thick_m = 1e9f;  // from here on branches are rounder
};

// Branches, twigs and leaves of a crown whose first nodes are a trunk drawn by others.
void AddCrown(const Branching& wood, std::size_t trunk_nodes, const Crown& crown,
              const CrownStyle& style, const ShapeInput& input, MeshBuilder* builder);

}  // namespace latticeworld

#endif  // LATTICEWORLD_MESHES_CROWN_GROWTH_H_
