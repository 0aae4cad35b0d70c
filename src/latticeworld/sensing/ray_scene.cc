#include "latticeworld/sensing/ray_scene.h"

#include <embree3/rtcore.h>

#include <limits>
#include <string>
#include <utility>

#include "latticeworld/geometry/height_field.h"

namespace latticeworld {
namespace {

Status StatusOf(RTCError error) {
  switch (error) {
    case RTC_ERROR_NONE:
      return Status();
    case RTC_ERROR_OUT_OF_MEMORY:
      return ResourceExhausted("no memory for the rays' ground");
    case RTC_ERROR_UNSUPPORTED_CPU:
      return Internal("Embree does not support this processor");
    default:
      return Internal("Embree failed with error " + std::to_string(static_cast<int>(error)));
  }
}

// Vertices of the cell centres and, around them, of the world's edge, up to which the surface goes
// on flat; from the south-west, eastward and then northward.
void FillVertices(const HeightField& ground, float* vertices) {
  const GridGeometry& geometry = ground.geometry();
  const int side = geometry.rows() + 2;
  const auto coordinate_m = [&](int i) {
    if (i == 0) return -geometry.half_size_m();
    if (i == side - 1) return geometry.half_size_m();
    return geometry.CenterOf({0, i - 1}).x_m;
  };
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      *vertices++ = static_cast<float>(coordinate_m(x));
      *vertices++ = static_cast<float>(coordinate_m(y));
      *vertices++ = ground.height_m().Clamped(geometry.rows() - y, x - 1);
    }
  }
}

}  // namespace

void RayScene::Release::operator()(RTCDeviceTy* device) const { rtcReleaseDevice(device); }
void RayScene::Release::operator()(RTCSceneTy* scene) const { rtcReleaseScene(scene); }

Result<RayScene> RayScene::Create(const HeightField& ground) {
  RayScene rays;
  rays.device_.reset(rtcNewDevice(nullptr));
  RTCDevice device = rays.device_.get();
  if (device == nullptr) return StatusOf(rtcGetDeviceError(nullptr));
  rays.scene_.reset(rtcNewScene(device));
  rtcSetSceneFlags(rays.scene_.get(), RTC_SCENE_FLAG_ROBUST);

  // Embree splits a cell of a grid between its second vertex of the first row and its first of the
  // second: with rows from south to north that is from south-east to north-west, as HeightField
  // splits it.
  const auto side = static_cast<std::size_t>(ground.geometry().rows()) + 2;
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_GRID);
  auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), side * side));
  auto* grid = static_cast<RTCGrid*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_GRID, 0,
                                                             RTC_FORMAT_GRID, sizeof(RTCGrid), 1));
  if (vertices != nullptr && grid != nullptr) {
    FillVertices(ground, vertices);
    *grid = {0, static_cast<unsigned int>(side), static_cast<unsigned short>(side),
             static_cast<unsigned short>(side)};
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(rays.scene_.get(), geometry);
  }
  rtcReleaseGeometry(geometry);
  rtcCommitScene(rays.scene_.get());
  LW_RETURN_IF_ERROR(StatusOf(rtcGetDeviceError(device)));
  return rays;
}

double RayScene::Distance(const Eigen::Vector3d& origin_m, const Eigen::Vector3d& direction) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit ray = {};
  ray.ray.org_x = static_cast<float>(origin_m.x());
  ray.ray.org_y = static_cast<float>(origin_m.y());
  ray.ray.org_z = static_cast<float>(origin_m.z());
  ray.ray.dir_x = static_cast<float>(direction.x());
  ray.ray.dir_y = static_cast<float>(direction.y());
  ray.ray.dir_z = static_cast<float>(direction.z());
  ray.ray.tfar = std::numeric_limits<float>::infinity();
  ray.ray.mask = ~0u;
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(scene_.get(), &context, &ray);
  return ray.hit.geomID == RTC_INVALID_GEOMETRY_ID ? std::numeric_limits<double>::infinity()
                                                   : ray.ray.tfar;
}

}  // namespace latticeworld
