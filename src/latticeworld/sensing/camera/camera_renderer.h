#ifndef LATTICEWORLD_SENSING_CAMERA_CAMERA_RENDERER_H_
#define LATTICEWORLD_SENSING_CAMERA_CAMERA_RENDERER_H_

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <string_view>
#include <vector>

#include "latticeworld/sensing/camera/camera_model.h"
#include "latticeworld/sensing/sensed_world.h"
#include "latticeworld/sensing/sensor_scene.h"
#include "latticeworld/sensing/sensor_suite.h"
#include "latticeworld/sensing/weather_effects.h"

namespace latticeworld {

// The same thing has the same number in every frame of a world: assets theirs in the scene plus
// one, agents and props a hash of their name below 2^31 (two of a thousand share one in one of
// a thousand worlds).
std::uint32_t AssetInstance(std::uint32_t asset);
std::uint32_t AgentInstance(std::string_view name);
std::uint32_t PropInstance(std::string_view name);

// What a picture is made of.
struct CameraShot {
  const SensorScene* scene = nullptr;
  const SensedWorld* world = nullptr;  // as the scene was updated with
  SensorConditions conditions;
  Eigen::Isometry3d map_from_optical = Eigen::Isometry3d::Identity();
  std::uint32_t except_agent = SensorScene::kNoAgent;
  std::uint64_t key = 0;  // of the picture's noise
  int threads = 1;
};

// Depth and label pictures, by one ray through the middle of every pixel, in tiles of 4 x 4.
class CameraRenderer {
 public:
  explicit CameraRenderer(const CameraModel& model);

  // Fills depth_m, classes and instances as `outputs` asks; the same with any number of threads.
  // Depth is of a stereo camera: it has noise, and nothing that keeps less than 5 % of its contrast
  // (NaN, as has the sky then). Labels are the truth: weather leaves them alone.
  void Render(const CameraShot& shot, const CameraOutputs& outputs, CameraFrame* frame) const;

 private:
  Eigen::Vector3f Direction(int row, int col) const;
  // Rows [begin, end), a tile high.
  void RenderStrip(const CameraShot& shot, const CameraOutputs& outputs, int begin, int end,
                   CameraFrame* frame) const;

  CameraModel model_;
  // x / z of the columns and y / z of the rows; or, of a lens that distorts, both of every pixel
  // (height x width).
  std::vector<float> column_slopes_, row_slopes_;
  std::vector<Eigen::Vector2f> distorted_;
};

// Adds a camera's noise to its colour picture.
void AddColourNoise(const CameraModel& model, std::uint64_t key, CameraFrame* frame);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SENSING_CAMERA_CAMERA_RENDERER_H_
