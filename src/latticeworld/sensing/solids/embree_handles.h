#ifndef LATTICEWORLD_SENSING_SOLIDS_EMBREE_HANDLES_H_
#define LATTICEWORLD_SENSING_SOLIDS_EMBREE_HANDLES_H_

#include <embree3/rtcore.h>

#include <memory>

#include "latticeworld/common/status.h"

namespace latticeworld {

// Embree's objects, released when they go.
struct ReleaseEmbree {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
  void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
};
using EmbreeDevice = std::unique_ptr<RTCDeviceTy, ReleaseEmbree>;
using EmbreeScene = std::unique_ptr<RTCSceneTy, ReleaseEmbree>;
using EmbreeGeometry = std::unique_ptr<RTCGeometryTy, ReleaseEmbree>;

// The device's first error since it was asked last; null: of making a device.
Status EmbreeStatus(RTCDevice device);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SENSING_SOLIDS_EMBREE_HANDLES_H_
