#include "latticeworld/sensing/solids/bridge_shapes.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>

#include "latticeworld/terrain/terrain.h"

namespace latticeworld {
namespace {

constexpr unsigned kSides = 6;  // of a box, each one quadrangle
// Counter-clockwise seen from outside; corners as AddCorners has them.
constexpr std::array<std::array<unsigned, 4>, kSides> kBoxSides = {
    {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};

// Bit 0: ahead, bit 1: to the left, bit 2: above.
void AddCorners(const BridgePart& part, std::vector<Eigen::Vector3f>* corners) {
  const double cosine = std::cos(part.yaw_rad), sine = std::sin(part.yaw_rad);
  for (int i = 0; i < 8; ++i) {
    const double x = (i & 1 ? 1.0 : -1.0) * part.half_length_m;
    const double y = (i & 2 ? 1.0 : -1.0) * part.half_width_m;
    corners->push_back(Eigen::Vector3d(part.middle.x_m + cosine * x - sine * y,
                                       part.middle.y_m + sine * x + cosine * y,
                                       i & 4 ? part.top_m : part.bottom_m)
                           .cast<float>());
  }
}

}  // namespace

BridgeShapes::BridgeShapes(RTCDevice device, const Terrain& terrain) {
  std::vector<Eigen::Vector3f> corners;
  for (std::size_t i = 0; i < terrain.bridges.size(); ++i) {
    for (const BridgePart& part : PartsOf(terrain.bridges[i], terrain.ground)) {
      AddCorners(part, &corners);
      parts_.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint8_t>(part.kind)});
    }
  }
  if (parts_.empty()) return;
  EmbreeGeometry geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_QUAD));
  auto* vertices = static_cast<Eigen::Vector3f*>(
      rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                              sizeof(Eigen::Vector3f), corners.size()));
  auto* indices = static_cast<unsigned*>(
      rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT4,
                              4 * sizeof(unsigned), kSides * parts_.size()));
  if (vertices == nullptr || indices == nullptr) return;
  std::copy(corners.begin(), corners.end(), vertices);
  for (unsigned box = 0; box < parts_.size(); ++box) {
    for (const auto& side : kBoxSides) {
      for (const unsigned corner : side) *indices++ = 8 * box + corner;
    }
  }
  rtcCommitGeometry(geometry.get());
  scene_.reset(rtcNewScene(device));
  rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_ROBUST);
  rtcAttachGeometry(scene_.get(), geometry.get());
  rtcCommitScene(scene_.get());
}

void BridgeShapes::Describe(unsigned primitive, RayHit* hit) const {
  const Part& part = parts_[primitive / kSides];
  hit->target = RayTarget::kBridge;
  hit->index = part.bridge;
  hit->part = part.kind;
}

}  // namespace latticeworld
