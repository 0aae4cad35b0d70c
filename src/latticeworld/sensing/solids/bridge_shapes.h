#ifndef LATTICEWORLD_SENSING_SOLIDS_BRIDGE_SHAPES_H_
#define LATTICEWORLD_SENSING_SOLIDS_BRIDGE_SHAPES_H_

#include <cstdint>
#include <vector>

#include "latticeworld/sensing/solids/embree_handles.h"
#include "latticeworld/sensing/solids/ray_scene.h"

namespace latticeworld {

struct Terrain;

// The bridges of a terrain's roads as rays meet them: the boxes of their parts.
class BridgeShapes {
 public:
  BridgeShapes() = default;
  // Errors are the device's.
  BridgeShapes(RTCDevice device, const Terrain& terrain);

  // Returns the scene of the bridges; null: there are none.
  RTCScene scene() const { return scene_.get(); }
  // Sets target, index and part of a hit in the scene.
  void Describe(unsigned primitive, RayHit* hit) const;

 private:
  struct Part {
    std::uint32_t bridge = 0;
    std::uint8_t kind = 0;  // BridgePartKind
  };

  EmbreeScene scene_;
  std::vector<Part> parts_;  // one a box
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SENSING_SOLIDS_BRIDGE_SHAPES_H_
