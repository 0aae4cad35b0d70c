#ifndef LATTICEWORLD_SENSING_CAMERA_CAMERA_MODEL_H_
#define LATTICEWORLD_SENSING_CAMERA_CAMERA_MODEL_H_

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace latticeworld {

// A pinhole camera with lens distortion ("plumb bob": Brown 1966, coefficients as OpenCV has them).
// Pixel (u, v) has its middle at (u, v); x right, y down, z forward.
struct CameraModel {
  int width = 320, height = 240;        // [16, 4096]
  double fx_px = 277.0, fy_px = 277.0;  // > 0
  double cx_px = 159.5, cy_px = 119.5;
  std::array<double, 5> distortion = {};  // k1, k2, p1, p2, k3
  double near_m = 0.05, far_m = 100.0;    // of depth
  double depth_noise = 0.0;               // standard deviation at 1 m [m]; grows with the square
                                          // of the distance (stereo: Gallup et al. 2008)
  double colour_noise = 0.0;              // standard deviation of a channel, [0, 255]
};
// How far from the axis, on the plane z = 1, the distortion is certainly monotonous; infinity
// without distortion.
double MonotonousRadius(const CameraModel& model);
// The point on the plane z = 1 that the distortion moves to `distorted`, by Newton's iteration
// within MonotonousRadius; none: there is no such point.
std::optional<Eigen::Vector2d> Undistort(const CameraModel& model,
                                         const Eigen::Vector2d& distorted);
// Unit direction in the optical frame of what falls onto a pixel; undoes the distortion. Where
// nothing falls onto it: of the rim of what does.
Eigen::Vector3d DirectionOf(const CameraModel& model, double u_px, double v_px);
// Returns where a point of the optical frame falls [px]; none: it is behind the camera, or so far
// aside that the distortion is no longer monotonous there.
std::optional<Eigen::Vector2d> Project(const CameraModel& model, const Eigen::Vector3d& point_m);

// What one moment's pictures are; row-major, empty where not asked for. All of one moment.
struct CameraFrame {
  double time_s = 0.0;
  std::vector<std::uint8_t> colour;   // (height x width x 3) RGB
  std::vector<float> depth_m;         // (height x width) along the optical axis; infinity: nothing
                                      // up to far_m, NaN: dropped, -infinity: nearer than near_m
  std::vector<std::uint8_t> classes;  // (height x width) SensedClass
  std::vector<std::uint32_t> instances;  // (height x width) 0: none; else the same thing has the
                                         // same number in every frame of a world
};

// What a label picture tells apart.
enum class SensedClass : std::uint8_t {
  kSky = 0,
  kGround,
  kWater,
  kRoad,
  kTree,
  kPlant,  // bushes, grasses, crops, flowers
  kStone,
  kBuilding,
  kAgent,
  kProp,
  kBridge  // of roads; footbridges are props
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SENSING_CAMERA_CAMERA_MODEL_H_
