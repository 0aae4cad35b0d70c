#ifndef LATTICEWORLD_SENSING_LIDAR_LIDAR_CASTER_H_
#define LATTICEWORLD_SENSING_LIDAR_LIDAR_CASTER_H_

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "latticeworld/sensing/lidar/lidar_model.h"
#include "latticeworld/sensing/lidar/lidar_receiver.h"
#include "latticeworld/sensing/lidar/lidar_surfaces.h"
#include "latticeworld/sensing/sensed_world.h"
#include "latticeworld/sensing/sensor_scene.h"

namespace latticeworld {

// The pose of a lidar, frame map, when it fires the first beam of a column.
struct ColumnPose {
  int column = 0;
  Eigen::Matrix3f map_from_sensor = Eigen::Matrix3f::Identity();
  Eigen::Vector3f origin_m = Eigen::Vector3f::Zero();
};

// What the columns of one cast have in common.
struct LidarCast {
  const SensorScene* scene = nullptr;
  const LidarSurfaces* surfaces = nullptr;
  const LidarReceiver* receiver = nullptr;
  const SensedWorld* world = nullptr;  // as the scene was updated with
  std::uint32_t except_agent = SensorScene::kNoAgent;
  // The sensor's motion, frame map: the beams of a column fire one after the other.
  Eigen::Vector3f velocity_mps = Eigen::Vector3f::Zero();
  Eigen::Vector3f turn_radps = Eigen::Vector3f::Zero();
  std::uint64_t key = 0;  // of the sweep's noise
  int threads = 1;
};

// The beams of a spinning lidar.
class LidarCaster {
 public:
  // One revolution takes 1 / rate_hz.
  LidarCaster(const LidarModel& model, double rate_hz);

  int columns() const { return static_cast<int>(columns_.size()); }
  int rings() const { return static_cast<int>(rings_.size()); }
  // Returns the time from the revolution's begin to a column's first beam [s].
  double FireTime(int column) const { return column * column_s_; }

  // Returns a sweep in which every beam counts as dropped until Fire fills it.
  LidarSweep Begin(double begin_s, double end_s) const;
  // Fires the columns and puts their echoes into the sweep; the same with any number of threads.
  void Fire(const LidarCast& cast, const std::vector<ColumnPose>& poses, LidarSweep* sweep) const;
  // The valid echoes as points, in the sensor's frame of each one's moment; none of a 2D scanner.
  void AddPoints(LidarSweep* sweep) const;

 private:
  // Unit, sensor frame.
  Eigen::Vector3f Direction(int ring, int column) const {
    const Eigen::Vector3f& beam = rings_[ring];
    const Eigen::Vector2f& turn = columns_[column];
    return {turn.x() * beam.x() - turn.y() * beam.y(), turn.y() * beam.x() + turn.x() * beam.y(),
            beam.z()};
  }

  void SetRay(const LidarCast& cast, const ColumnPose& pose, int ring, float reach_m,
              Ray* ray) const;

  LidarModel model_;
  double column_s_;
  std::vector<Eigen::Vector3f> rings_;    // beams of column azimuth 0
  std::vector<Eigen::Vector2f> columns_;  // cosine and sine of their azimuths
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SENSING_LIDAR_LIDAR_CASTER_H_
