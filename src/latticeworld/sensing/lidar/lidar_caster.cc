#include "latticeworld/sensing/lidar/lidar_caster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "latticeworld/common/parallel.h"

namespace latticeworld {
namespace {

// Rays of a piece of work.
constexpr int kRaysOfPiece = 512;
// Fewer rays are not worth a thread of their own.
constexpr int kRaysOfThread = 1024;
// Sixteen rays are traced together: a nearly square bundle of them meets the fewest different
// boxes.
constexpr int kBlockRays = 16;
constexpr int kBlockColumns = 4;

// Calls fire(pose, ring) for the beams of columns [begin, end), block after block.
template <typename Fire>
void ForEachBeam(int rings, int begin, int end, const Fire& fire) {
  for (int first = begin; first < end;) {
    int width = rings == 1 ? kBlockRays : kBlockColumns;
    while (width > end - first) width /= 2;
    const int height = kBlockRays / width;
    for (int low = 0; low < rings; low += height) {
      for (int pose = first; pose < first + width; ++pose) {
        for (int ring = low; ring < std::min(low + height, rings); ++ring) fire(pose, ring);
      }
    }
    first += width;
  }
}

}  // namespace

LidarCaster::LidarCaster(const LidarModel& model, double rate_hz) : model_(model) {
  const double step_rad = model.field_of_view_rad / model.columns;
  column_s_ = step_rad / (2.0 * M_PI * rate_hz);
  for (std::size_t i = 0; i < model.ring_elevations_rad.size(); ++i) {
    const double elevation = model.ring_elevations_rad[i];
    // The head turns on while the rings of a column fire one after the other.
    double azimuth = 2.0 * M_PI * rate_hz * model.ring_delay_s * static_cast<double>(i);
    if (i < model.ring_azimuths_rad.size()) azimuth += model.ring_azimuths_rad[i];
    rings_.push_back(Eigen::Vector3d(std::cos(elevation) * std::cos(azimuth),
                                     std::cos(elevation) * std::sin(azimuth), std::sin(elevation))
                         .cast<float>());
  }
  for (int i = 0; i < model.columns; ++i) {
    const double azimuth = model.first_azimuth_rad + i * step_rad;
    columns_.push_back(Eigen::Vector2d(std::cos(azimuth), std::sin(azimuth)).cast<float>());
  }
}

LidarSweep LidarCaster::Begin(double begin_s, double end_s) const {
  LidarSweep sweep;
  sweep.begin_s = begin_s;
  sweep.end_s = end_s;
  sweep.rings = rings();
  sweep.columns = columns();
  const std::size_t beams = rings_.size() * columns_.size();
  sweep.ranges_m.assign(beams, std::numeric_limits<float>::quiet_NaN());
  sweep.intensities.assign(beams, 0.0f);
  return sweep;
}

// reach_m: how far the beam is followed.
inline void LidarCaster::SetRay(const LidarCast& cast, const ColumnPose& pose, int ring,
                                float reach_m, Ray* ray) const {
  ray->origin_m = pose.origin_m;
  ray->direction = pose.map_from_sensor * Direction(ring, pose.column);
  if (model_.ring_delay_s > 0.0) {
    const auto later_s = static_cast<float>(model_.ring_delay_s * ring);
    ray->origin_m += later_s * cast.velocity_mps;
    ray->direction += later_s * cast.turn_radps.cross(ray->direction);
  }
  ray->to_m = reach_m;
}

void LidarCaster::Fire(const LidarCast& cast, const std::vector<ColumnPose>& poses,
                       LidarSweep* sweep) const {
  const int count = static_cast<int>(poses.size());
  const int columns_of_piece = std::max(kBlockColumns, kRaysOfPiece / rings());
  const float reach_m = cast.receiver->Reach(cast.surfaces->MostReturned(*cast.world));
  const int threads = std::clamp(count * rings() / kRaysOfThread, 1, std::max(1, cast.threads));
  ParallelInPieces(count, columns_of_piece, threads, [&](int begin, int end) {
    std::array<Ray, kBlockRays> rays;
    std::array<RayHit, kBlockRays> hits;
    std::array<std::size_t, kBlockRays> places;  // in the sweep
    int loaded = 0;
    const auto trace = [&] {
      cast.scene->Trace(rays.data(), static_cast<std::size_t>(loaded), kSeesAll, cast.except_agent,
                        hits.data());
      for (int i = 0; i < loaded; ++i) {
        const float returned = hits[i].target == RayTarget::kNothing
                                   ? 0.0f
                                   : cast.surfaces->Return(rays[i], hits[i], *cast.world);
        const LidarEcho echo =
            cast.receiver->Receive(hits[i].distance_m, returned, cast.key, places[i]);
        sweep->ranges_m[places[i]] = echo.range_m;
        sweep->intensities[places[i]] = echo.intensity;
      }
      loaded = 0;
    };
    ForEachBeam(rings(), begin, end, [&](int pose, int ring) {
      SetRay(cast, poses[pose], ring, reach_m, &rays[loaded]);
      places[loaded] = static_cast<std::size_t>(ring) * columns_.size() + poses[pose].column;
      if (++loaded == kBlockRays) trace();
    });
    if (loaded > 0) trace();
  });
}

void LidarCaster::AddPoints(LidarSweep* sweep) const {
  sweep->points.clear();
  if (rings() == 1) return;
  sweep->points.reserve(sweep->ranges_m.size());
  for (int column = 0; column < columns(); ++column) {
    const double column_ns = 1e9 * FireTime(column);
    for (int ring = 0; ring < rings(); ++ring) {
      const std::size_t place = static_cast<std::size_t>(ring) * columns_.size() + column;
      const float range_m = sweep->ranges_m[place];
      if (!std::isfinite(range_m)) continue;
      const Eigen::Vector3f at_m = range_m * Direction(ring, column);
      LidarPoint point;
      point.x_m = at_m.x();
      point.y_m = at_m.y();
      point.z_m = at_m.z();
      point.intensity = sweep->intensities[place];
      point.ring = static_cast<std::uint16_t>(ring);
      point.column = static_cast<std::uint16_t>(column);
      point.time_ns =
          static_cast<std::uint32_t>(std::lround(column_ns + 1e9 * model_.ring_delay_s * ring));
      sweep->points.push_back(point);
    }
  }
}

}  // namespace latticeworld
