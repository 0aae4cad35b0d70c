#include "latticeworld/reference_navigator/obstacle_layer.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace latticeworld {
namespace {

constexpr double kNever = -std::numeric_limits<double>::infinity();
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr int kBins = 720;  // of directions, half a degree each

int BinOf(double x_m, double y_m) {
  const double turn = std::atan2(y_m, x_m) / (2.0 * M_PI) + 0.5;
  return std::clamp(static_cast<int>(turn * kBins), 0, kBins - 1);
}

// The least power of 2 that is enough.
int CellsOf(const NavigatorOptions& options) {
  const double least = options.local_size_m / options.local_resolution_m - 1e-6;
  int cells = 8;
  while (cells < least) cells *= 2;
  return cells;
}

}  // namespace

ObstacleLayer::ObstacleLayer(const NavigatorOptions& options)
    : robot_(options.robot),
      cell_m_(options.local_resolution_m),
      cells_(CellsOf(options)),
      memory_s_(options.memory_s),
      seen_s_(cells_, cells_, kNever),
      distance_m_(cells_, cells_, kInfinity),
      hits_(cells_, cells_) {}

CellIndex ObstacleLayer::CellOf(double x_m, double y_m) const {
  return {static_cast<int>(std::floor(y_m / cell_m_)), static_cast<int>(std::floor(x_m / cell_m_))};
}

bool ObstacleLayer::IsInside(CellIndex cell) const {
  return cell.row >= corner_.row && cell.row < corner_.row + cells_ && cell.col >= corner_.col &&
         cell.col < corner_.col + cells_;
}

double ObstacleLayer::DistanceAt(WorldPoint point) const {
  const CellIndex cell = CellOf(point.x_m, point.y_m);
  if (!is_placed_ || !IsInside(cell)) return kInfinity;
  return distance_m_(Wrapped(cell.row), Wrapped(cell.col));
}

void ObstacleLayer::MoveTo(const Eigen::Vector3d& base_m) {
  middle_m_ = base_m;
  CellIndex corner = CellOf(base_m.x(), base_m.y());
  corner.row -= cells_ / 2;
  corner.col -= cells_ / 2;
  if (!is_placed_) corner_ = corner;
  is_placed_ = true;
  const CellIndex before = corner_;
  corner_ = corner;
  if (before == corner) return;
  // Rows and columns that were not in the window hold what stood at its other side.
  for (int row = corner.row; row < corner.row + cells_; ++row) {
    const bool whole = row < before.row || row >= before.row + cells_;
    for (int col = corner.col; col < corner.col + cells_; ++col) {
      if (!whole && col >= before.col && col < before.col + cells_) continue;
      seen_s_(Wrapped(row), Wrapped(col)) = kNever;
      distance_m_(Wrapped(row), Wrapped(col)) = kInfinity;
    }
  }
}

void ObstacleLayer::Forget() {
  std::fill(seen_s_.begin(), seen_s_.end(), kNever);
  std::fill(distance_m_.begin(), distance_m_.end(), kInfinity);
}

// Ground is what lies lowest around, raised by no more than the robot can climb over the distance
// between; what stands higher above it than a step is in the way, unless it is overhead.
void ObstacleLayer::JudgeByHeight(std::vector<Hit>* hits) const {
  constexpr double kGround_m = 0.4;
  constexpr int kAround = 3;
  const int size = static_cast<int>(cells_ * cell_m_ / kGround_m) + 2;
  Grid<float> lowest_m(size, size, kInfinity);
  const auto place = [&](const Eigen::Vector3d& at_m) {
    return CellIndex{static_cast<int>((at_m.y() - corner_.row * cell_m_) / kGround_m),
                     static_cast<int>((at_m.x() - corner_.col * cell_m_) / kGround_m)};
  };
  const auto lower = [&](const Eigen::Vector3d& at_m) {
    float& lowest = lowest_m[place(at_m)];
    lowest = std::min(lowest, static_cast<float>(at_m.z()));
  };
  lower(middle_m_);
  for (const Hit& hit : *hits) lower(hit.at_m);
  const auto rise = static_cast<float>(std::tan(robot_.max_slope_rad) * kGround_m);
  Grid<float> ground_m = lowest_m;
  for (int row = 0; row < size; ++row) {
    for (int col = 0; col < size; ++col) {
      if (!std::isfinite(lowest_m(row, col))) continue;
      for (int r = std::max(0, row - kAround); r <= std::min(size - 1, row + kAround); ++r) {
        for (int c = std::max(0, col - kAround); c <= std::min(size - 1, col + kAround); ++c) {
          const float far = std::hypot(static_cast<float>(r - row), static_cast<float>(c - col));
          ground_m(row, col) = std::min(ground_m(row, col), lowest_m(r, c) + far * rise);
        }
      }
    }
  }
  for (Hit& hit : *hits) {
    const double above_m = hit.at_m.z() - ground_m[place(hit.at_m)];
    // The ground itself may rise by `rise` within a cell.
    hit.is_obstacle = above_m > robot_.max_step_m + rise &&
                      above_m < std::max(robot_.height_m, robot_.max_step_m + rise + 0.1) + 0.1;
  }
}

// A plane of rays meets the ground where that rises by as much as the sensor is above it.
void ObstacleLayer::JudgeByPlane(const Eigen::Vector3d& sensor_m, const GroundGuess* ground,
                                 std::vector<Hit>* hits) const {
  constexpr double kUneven_m = 0.12;
  for (Hit& hit : *hits) {
    hit.is_obstacle = true;
    if (ground == nullptr) continue;
    const double wanted_m = hit.at_m.z() - middle_m_.z();
    const double most_m =
        ground->MostRise({sensor_m.x(), sensor_m.y()}, {hit.at_m.x(), hit.at_m.y()});
    hit.is_obstacle = wanted_m > most_m + kUneven_m;
  }
}

// Flakes and drops are hit one at a time, things by many rays at once: hits that have too few
// beside them are left out, and fewer are asked for the farther away and the sparser rays are
// (after the dynamic radius outlier removal of Charron, Phillips and Waslander 2018).
void ObstacleLayer::DropLoneOnes(const Eigen::Vector3d& sensor_m, std::vector<Hit>* hits) {
  constexpr double kNear_m = 6.0, kMiddle_m = 12.0;
  constexpr std::uint8_t kMany = 255;
  for (const Hit& hit : *hits) {
    if (!hit.is_obstacle) continue;
    const CellIndex cell = CellOf(hit.at_m.x(), hit.at_m.y());
    std::uint8_t& count = hits_(Wrapped(cell.row), Wrapped(cell.col));
    if (count < kMany) ++count;
  }
  std::vector<std::size_t> lone;
  for (std::size_t i = 0; i < hits->size(); ++i) {
    const Hit& hit = (*hits)[i];
    if (!hit.is_obstacle) continue;
    const double far_m = (hit.at_m - sensor_m).head<2>().norm();
    const int needed = far_m < kNear_m ? 3 : far_m < kMiddle_m ? 2 : 1;
    const CellIndex cell = CellOf(hit.at_m.x(), hit.at_m.y());
    int around = 0;
    for (int row = cell.row - 1; row <= cell.row + 1; ++row)
      for (int col = cell.col - 1; col <= cell.col + 1; ++col)
        around += hits_(Wrapped(row), Wrapped(col));
    if (around < needed) lone.push_back(i);
  }
  for (const Hit& hit : *hits) {
    const CellIndex cell = CellOf(hit.at_m.x(), hit.at_m.y());
    hits_(Wrapped(cell.row), Wrapped(cell.col)) = 0;
  }
  for (const std::size_t i : lone) (*hits)[i].is_obstacle = false;
}

// Frees what rays passed over: up to the first obstacle in a direction, else to the farthest that
// was seen there. Rays that go up say nothing of what stands low.
void ObstacleLayer::Clear(const SensorSighting& sighting, const std::vector<Hit>& hits) {
  const Eigen::Vector3d sensor_m = sighting.map_from_sensor.translation();
  // Hits tell, by direction, how far rays went and where the first obstacle is.
  std::vector<double> free_m(kBins, 0.0), blocked_m(kBins, kInfinity);
  for (const Hit& hit : hits) {
    const double x_m = hit.at_m.x() - sensor_m.x(), y_m = hit.at_m.y() - sensor_m.y();
    const int bin = BinOf(x_m, y_m);
    const double far_m = std::hypot(x_m, y_m);
    if (hit.is_obstacle) {
      // A ray's neighbours may pass beside the same thing.
      for (int k = -1; k <= 1; ++k) {
        double& nearest = blocked_m[(bin + k + kBins) % kBins];
        nearest = std::min(nearest, far_m);
      }
    } else {
      free_m[bin] = std::max(free_m[bin], far_m);
    }
  }
  // Rays that met nothing went as far as they could.
  for (const Eigen::Vector3f& miss : sighting.misses_m) {
    const Eigen::Vector3d way = sighting.map_from_sensor.linear() * miss.cast<double>();
    const double level_m = std::hypot(way.x(), way.y());
    if (!sighting.planar && way.z() > -0.02 * level_m) continue;
    free_m[BinOf(way.x(), way.y())] = std::max(free_m[BinOf(way.x(), way.y())], level_m);
  }
  // Cells that lie nearer than that are freed.
  for (int row = corner_.row; row < corner_.row + cells_; ++row) {
    for (int col = corner_.col; col < corner_.col + cells_; ++col) {
      double& seen = seen_s_(Wrapped(row), Wrapped(col));
      if (seen == kNever) continue;
      const double x_m = (col + 0.5) * cell_m_ - sensor_m.x();
      const double y_m = (row + 0.5) * cell_m_ - sensor_m.y();
      // Any ray over the cell will do: rays may be farther apart than bins.
      const double far_m = std::hypot(x_m, y_m);
      const int beside = std::min(
          static_cast<int>(0.5 * cell_m_ / std::max(far_m, cell_m_) * kBins / (2.0 * M_PI)) + 1, 8);
      const int middle = BinOf(x_m, y_m);
      double end_m = 0.0;
      for (int k = -beside; k <= beside; ++k) {
        const auto bin = static_cast<std::size_t>((middle + k + kBins) % kBins);
        end_m = std::max(end_m, std::min(free_m[bin], blocked_m[bin] - 2.0 * cell_m_));
      }
      if (far_m < end_m) seen = kNever;
    }
  }
}

void ObstacleLayer::See(const SensorSighting& sighting, const GroundGuess* ground) {
  if (!is_placed_) return;
  constexpr double kHighest_m = 10.0;
  std::vector<Hit> hits;
  hits.reserve(sighting.hits_m.size());
  for (const Eigen::Vector3f& hit : sighting.hits_m) {
    const Eigen::Vector3d at_m = sighting.map_from_sensor * hit.cast<double>();
    // Far ones would not fit into cells' numbers.
    const Eigen::Vector3d off_m = (at_m - middle_m_).cwiseAbs();
    if (!(off_m.head<2>().maxCoeff() < cells_ * cell_m_) || !(off_m.z() <= kHighest_m)) continue;
    if (IsInside(CellOf(at_m.x(), at_m.y()))) hits.push_back({at_m, false});
  }
  if (sighting.planar) {
    JudgeByPlane(sighting.map_from_sensor.translation(), ground, &hits);
  } else {
    JudgeByHeight(&hits);
  }
  DropLoneOnes(sighting.map_from_sensor.translation(), &hits);
  Clear(sighting, hits);
  for (const Hit& hit : hits) {
    if (!hit.is_obstacle) continue;
    const CellIndex cell = CellOf(hit.at_m.x(), hit.at_m.y());
    double& seen = seen_s_(Wrapped(cell.row), Wrapped(cell.col));
    seen = std::max(seen, sighting.time_s);
  }
}

void ObstacleLayer::Settle(double time_s) {
  // Distances by two sweeps over the window (Borgefors 1986), at most 4 % too long.
  const auto at = [&](int row, int col) -> float& {
    return distance_m_(Wrapped(row), Wrapped(col));
  };
  const int first_row = corner_.row, first_col = corner_.col;
  const int last_row = first_row + cells_ - 1, last_col = first_col + cells_ - 1;
  for (int row = first_row; row <= last_row; ++row) {
    for (int col = first_col; col <= last_col; ++col) {
      double& seen = seen_s_(Wrapped(row), Wrapped(col));
      if (seen < time_s - memory_s_) seen = kNever;
      at(row, col) = seen == kNever ? kInfinity : 0.0f;
    }
  }
  const auto straight = static_cast<float>(0.96 * cell_m_);
  const auto slanted = static_cast<float>(1.36 * cell_m_);
  const auto relax = [&](float* distance, int row, int col, float step) {
    if (row < first_row || row > last_row || col < first_col || col > last_col) return;
    *distance = std::min(*distance, at(row, col) + step);
  };
  for (int row = first_row; row <= last_row; ++row) {
    for (int col = first_col; col <= last_col; ++col) {
      float* distance = &at(row, col);
      relax(distance, row, col - 1, straight);
      relax(distance, row - 1, col - 1, slanted);
      relax(distance, row - 1, col, straight);
      relax(distance, row - 1, col + 1, slanted);
    }
  }
  for (int row = last_row; row >= first_row; --row) {
    for (int col = last_col; col >= first_col; --col) {
      float* distance = &at(row, col);
      relax(distance, row, col + 1, straight);
      relax(distance, row + 1, col + 1, slanted);
      relax(distance, row + 1, col, straight);
      relax(distance, row + 1, col - 1, slanted);
      if (*distance > kFar_m) *distance = kInfinity;
    }
  }
}

}  // namespace latticeworld
