#include "latticeworld/navigation/distance_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <tuple>
#include <utility>

#include "latticeworld/navigation/navigable_map.h"

namespace latticeworld {
namespace {

constexpr float kFar = std::numeric_limits<float>::infinity();
// This near to the goal, distances are those of straight lines: the front is too bent there for
// planes.
constexpr int kStraightCells = 8;

struct Step {
  int row, col;
};
// The steps to the eight neighbours of a cell, each beside the next.
constexpr std::array<Step, 8> kAround = {
    {{0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {1, 0}, {1, 1}}};

// Cells in the order of their distances, in buckets as wide as the least step between two, so that
// the order within a bucket does not matter.
class Front {
 public:
  // Half cells: more than the longest step between two cells is, diagonally on the steepest ground.
  static constexpr std::size_t kBuckets = 256;

  explicit Front(double width_m) : width_m_(width_m), buckets_(kBuckets) {}

  void Push(float distance_m, std::uint32_t cell) {
    const auto bucket = static_cast<std::uint64_t>(distance_m / width_m_);
    buckets_[std::max(bucket, at_) % kBuckets].push_back({distance_m, cell});
    ++size_;
  }
  bool Pop(float* distance_m, std::uint32_t* cell) {
    if (size_ == 0) return false;
    while (buckets_[at_ % kBuckets].empty()) ++at_;
    auto& bucket = buckets_[at_ % kBuckets];
    std::tie(*distance_m, *cell) = bucket.back();
    bucket.pop_back();
    --size_;
    return true;
  }

 private:
  double width_m_;
  std::vector<std::vector<std::pair<float, std::uint32_t>>> buckets_;
  std::uint64_t at_ = 0;
  std::size_t size_ = 0;
};

// Works on grids with a blocked rim, so that neighbours need no checks.
class Marcher {
 public:
  Marcher(const NavigableMap& map, double max_m)
      : map_(map),
        max_m_(max_m),
        run_m_(static_cast<float>(map.geometry().resolution_m())),
        stride_(map.free.cols() + 2),
        ways_(static_cast<std::size_t>(stride_) * (map.free.rows() + 2), 0),
        height_m_(ways_.size(), 0.0f),
        distance_m_(ways_.size(), kFar),
        front_(0.5 * run_m_) {
    for (int i = 0; i < 8; ++i) {
      offset_[i] = kAround[i].row * stride_ + kAround[i].col;
      square_m2_[i] = (i % 2 == 0 ? 1.0f : 2.0f) * run_m_ * run_m_;
    }
    FillWays();
  }

  Grid<float> Run(WorldPoint goal) {
    Begin(goal);
    float distance = 0.0f;
    std::uint32_t cell = 0;
    while (front_.Pop(&distance, &cell)) {
      // A shorter way to it came out before.
      if (distance > distance_m_[cell]) continue;
      for (int i = 0; i < 8; ++i) {
        const std::uint32_t next = cell + offset_[i];
        if ((ways_[cell] >> i & 1) != 0 && distance_m_[next] > distance)
          Improve(next, cell, (i + 4) % 8);
      }
    }
    Grid<float> result(map_.free.rows(), map_.free.cols());
    for (int row = 0; row < result.rows(); ++row) {
      const float* from = distance_m_.data() + Padded(row, 0);
      std::copy(from, from + result.cols(), result.row(row));
    }
    return result;
  }

 private:
  std::uint32_t Padded(int row, int col) const {
    return static_cast<std::uint32_t>((row + 1) * stride_ + col + 1);
  }

  // Finds in which of the eight directions each cell can be left; diagonals need both cells that
  // they pass between.
  void FillWays() {
    std::vector<std::uint8_t> free(ways_.size(), 0);
    for (int row = 0; row < map_.free.rows(); ++row) {
      const std::uint32_t begin = Padded(row, 0);
      std::copy(map_.free.row(row), map_.free.row(row) + map_.free.cols(), free.data() + begin);
      std::copy(map_.ground.height_m().row(row), map_.ground.height_m().row(row) + map_.free.cols(),
                height_m_.data() + begin);
    }
    for (int row = 0; row < map_.free.rows(); ++row) {
      for (int col = 0; col < map_.free.cols(); ++col) {
        const std::uint32_t cell = Padded(row, col);
        if (free[cell] == 0) continue;
        for (int i = 0; i < 8; ++i) {
          const bool sides = i % 2 == 0 || (free[cell + offset_[(i + 1) % 8]] != 0 &&
                                            free[cell + offset_[(i + 7) % 8]] != 0);
          if (sides && free[cell + offset_[i]] != 0)
            ways_[cell] = static_cast<std::uint8_t>(ways_[cell] | 1 << i);
        }
      }
    }
  }

  void Begin(WorldPoint goal) {
    const CellIndex middle = map_.geometry().CellAt(goal);
    for (int row = middle.row - kStraightCells; row <= middle.row + kStraightCells; ++row) {
      for (int col = middle.col - kStraightCells; col <= middle.col + kStraightCells; ++col) {
        if (!map_.free.Contains({row, col})) continue;
        const SurfaceLine line = MeasureLine(map_, map_.geometry().CenterOf({row, col}), goal);
        // Lines over walls of ground would not fit into the front.
        if (line.is_free && line.length_m < 0.25 * Front::kBuckets * run_m_)
          Reach(Padded(row, col), static_cast<float>(line.length_m));
      }
    }
  }

  void Reach(std::uint32_t cell, float distance_m) {
    if (!(distance_m < distance_m_[cell]) || distance_m > max_m_) return;
    distance_m_[cell] = distance_m;
    front_.Push(distance_m, cell);
  }

  // `cell` by way of its neighbour in that direction, and the two triangles that they are corners
  // of.
  void Improve(std::uint32_t cell, std::uint32_t neighbour, int direction) {
    const Edge near = EdgeTo(cell, neighbour, direction);
    float best_m = near.distance_m + std::sqrt(near.square_m2);
    for (const int side : {(direction + 1) % 8, (direction + 7) % 8}) {
      if ((ways_[cell] >> side & 1) == 0) continue;
      const std::uint32_t other = cell + offset_[side];
      // A front that comes over the side between them has reached both before.
      if (distance_m_[other] < best_m)
        best_m = std::min(best_m, Across(near, EdgeTo(cell, other, side)));
    }
    Reach(cell, best_m);
  }

  // The step from a cell to a neighbour.
  struct Edge {
    int direction;
    float rise_m;
    float square_m2;   // of its length
    float distance_m;  // of the neighbour to the goal
  };
  Edge EdgeTo(std::uint32_t cell, std::uint32_t neighbour, int direction) const {
    const float rise_m = height_m_[neighbour] - height_m_[cell];
    return {direction, rise_m, square_m2_[direction] + rise_m * rise_m, distance_m_[neighbour]};
  }

  // The distance at the corner of a flat triangle between two edges, over whose third side a plane
  // front comes; infinity where it comes from beside that side.
  float Across(const Edge& a, const Edge& b) const {
    // One edge is straight and one diagonal: in plan their product is the square of the straight.
    const float product = square_m2_[0] + a.rise_m * b.rise_m;
    // The gradient n of the front has length 1, and a.n, b.n are what the distances differ by from
    // t, that of the corner.
    const float determinant = a.square_m2 * b.square_m2 - product * product;
    const float difference = a.distance_m - b.distance_m;
    const float sum = a.square_m2 + b.square_m2 - 2.0f * product;  // of the third side
    const float root = determinant * (sum - difference * difference);
    if (!(root >= 0.0f)) return kFar;
    const float to_a = b.square_m2 - product, to_b = a.square_m2 - product;
    const float t = (to_a * a.distance_m + to_b * b.distance_m + std::sqrt(root)) / sum;
    const float rise_a = t - a.distance_m, rise_b = t - b.distance_m;
    const bool between =
        b.square_m2 * rise_a >= product * rise_b && a.square_m2 * rise_b >= product * rise_a;
    return between ? t : kFar;
  }

  const NavigableMap& map_;
  const double max_m_;
  const float run_m_;
  const int stride_;
  std::array<std::uint32_t, 8> offset_ = {};  // wraps around for those before the cell
  std::array<float, 8> square_m2_ = {};       // of steps in plan
  std::vector<std::uint8_t> ways_;            // bit i: it can be left towards kAround[i]
  std::vector<float> height_m_;
  std::vector<float> distance_m_;
  Front front_;
};

}  // namespace

double DistanceField::At(WorldPoint point) const {
  if (!geometry.Contains(point)) return kFar;
  const double row = std::clamp(geometry.RowOf(point.y_m), 0.0, distance_m.rows() - 1.0);
  const double col = std::clamp(geometry.ColOf(point.x_m), 0.0, distance_m.cols() - 1.0);
  const int r = std::min(static_cast<int>(row), distance_m.rows() - 2);
  const int c = std::min(static_cast<int>(col), distance_m.cols() - 2);
  double sum = 0.0, weights = 0.0;
  for (int i = 0; i < 4; ++i) {
    const float value = distance_m(r + i / 2, c + i % 2);
    if (value == kFar) continue;
    const double weight = std::max(0.0, 1.0 - std::abs(row - (r + i / 2))) *
                          std::max(0.0, 1.0 - std::abs(col - (c + i % 2)));
    sum += weight * value;
    weights += weight;
  }
  return weights > 0.0 ? sum / weights : kFar;
}

Result<DistanceField> DistancesTo(const NavigableMap& map, WorldPoint goal, double max_m) {
  LW_RETURN_IF_ERROR(CheckInside(map.geometry(), goal, "the goal"));
  if (!map.IsFree(goal))
    return FailedPrecondition("the robot cannot be at the goal: it is not free");
  DistanceField field;
  field.geometry = map.geometry();
  field.goal = goal;
  field.distance_m = Marcher(map, max_m).Run(goal);
  return field;
}

}  // namespace latticeworld
