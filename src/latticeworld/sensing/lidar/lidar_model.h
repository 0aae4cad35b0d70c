#ifndef LATTICEWORLD_SENSING_LIDAR_LIDAR_MODEL_H_
#define LATTICEWORLD_SENSING_LIDAR_LIDAR_MODEL_H_

#include <cstdint>
#include <string>
#include <vector>

namespace latticeworld {

// A spinning lidar; one ring: a 2D scanner. A revolution takes 1 / SensorSpec::rate_hz.
struct LidarModel {
  std::string name;                         // "hokuyo utm-30lx", "velodyne vlp-16", "ouster os1-64"
  std::string source;                       // where the figures are from
  std::vector<double> ring_elevations_rad;  // one a ring, in the order of `ring`; lowest first
  std::vector<double> ring_azimuths_rad;    // added to a column's, one a ring; empty: all 0
  int columns = 1024;                       // of a revolution, or of the field of view
  double first_azimuth_rad = -3.14159265358979;  // of column 0; counter-clockwise seen from above
  double field_of_view_rad = 6.28318530717959;   // (0, 2 pi]; the beam runs through the rest unseen
  // The time between the beams of one column: ring i fires ring_delay_s * i after the first.
  double ring_delay_s = 0.0;
  double min_range_m = 0.1, max_range_m = 30.0;  // 0 <= min < max
  // The reflectivity of the diffuse target that max_range_m is of, in clear air, (0, 1]; darker
  // ones are lost before, brighter ones give no echo from beyond either.
  double max_range_reflectivity = 0.1;
  double noise_m = 0.01;             // standard deviation of a range
  double range_step_m = 0.0;         // ranges are multiples of it; 0: not rounded
  double dropout_probability = 0.0;  // of a beam in clear air
};

// One echo. Invalid ones (nothing met, too near, dropped) are left out of clouds.
struct LidarPoint {
  float x_m = 0.0f, y_m = 0.0f, z_m = 0.0f;  // sensor frame of the moment of firing: not de-skewed
  float intensity = 0.0f;                    // [0, 255] after range and incidence
  std::uint16_t ring = 0;
  std::uint16_t column = 0;
  std::uint32_t time_ns = 0;  // after the revolution's begin
};

// A whole revolution. Stamp of messages: the revolution's END; points say when within it.
struct LidarSweep {
  double begin_s = 0.0, end_s = 0.0;  // simulated time
  int rings = 1, columns = 0;
  // Row-major (rings x columns), ring 0 first; infinity: nothing met; NaN: dropped; -infinity:
  // nearer than min_range_m (REP 117).
  std::vector<float> ranges_m;
  std::vector<float> intensities;  // the same shape
  std::vector<LidarPoint> points;  // valid ones, column by column; empty for 2D scanners
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SENSING_LIDAR_LIDAR_MODEL_H_
