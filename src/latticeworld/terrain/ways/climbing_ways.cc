#include "latticeworld/terrain/ways/climbing_ways.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <numeric>
#include <queue>
#include <utility>

#include "latticeworld/geomorphology/blur.h"
#include "latticeworld/geomorphology/resample.h"
#include "latticeworld/terrain/forms/relief_measures.h"

namespace latticeworld::internal {
namespace {

constexpr double kWidth_m = 4.0;
constexpr int kCoarser = 8;      // cells of the lattice a step
constexpr int kReach = 5;        // steps that a move goes at most
constexpr float kDear = 120.0f;  // of what is too steep
constexpr int kDirections = 16;
constexpr float kTurn = 9.0f;  // of turning back, as a way of so many steps

struct Move {
  int rows, cols;
  float length;   // [steps]
  int direction;  // of kDirections
};

// Moves of every direction that the reach allows.
std::vector<Move> AllMoves() {
  std::vector<Move> moves;
  for (int r = -kReach; r <= kReach; ++r) {
    for (int c = -kReach; c <= kReach; ++c) {
      if (std::gcd(std::abs(r), std::abs(c)) != 1) continue;
      const double turn = std::atan2(r, c) / (2.0 * M_PI) + 1.0;
      const int direction = static_cast<int>(std::lround(turn * kDirections)) % kDirections;
      moves.push_back({r, c, std::hypot(static_cast<float>(r), static_cast<float>(c)), direction});
    }
  }
  return moves;
}

Grid<unsigned char> Coarse(const Grid<unsigned char>& mask) {
  Grid<unsigned char> coarse(mask.rows() / kCoarser, mask.cols() / kCoarser, 0);
  for (int r = 0; r < coarse.rows() * kCoarser; ++r) {
    for (int c = 0; c < coarse.cols() * kCoarser; ++c) {
      coarse(r / kCoarser, c / kCoarser) |= mask(r, c);
    }
  }
  return coarse;
}

class WayFinder {
 public:
  WayFinder(const GridGeometry& lattice, const ClimbingGround& ground, double max_slope)
      : geometry_(GridGeometry::FromCells(lattice.rows() / kCoarser, lattice.size_m())),
        height_m_(Resample(ground.height_m, geometry_.rows(), geometry_.cols())),
        road_(Coarse(ground.road)),
        blocked_(Coarse(ground.blocked)),
        max_slope_(static_cast<float>(max_slope)) {}

  bool HasRoad() const { return std::find(road_.begin(), road_.end(), 1) != road_.end(); }

  // The highest open place on top of a piece.
  CellIndex TopOf(const ReliefPiece& piece) const {
    CellIndex top{-1, -1};
    for (int r = 0; r < height_m_.rows(); ++r) {
      for (int c = 0; c < height_m_.cols(); ++c) {
        const CellIndex cell = {r, c};
        if (blocked_[cell] != 0 || !IsOnTop(piece, cell)) continue;
        if (top.row < 0 || height_m_[cell] > height_m_[top]) top = cell;
      }
    }
    return top;
  }

  // The lowest open place along a ridge between two tops.
  CellIndex PassOf(const ReliefPiece& ridge) const {
    const WorldPoint a = ridge.axis.front(), b = ridge.axis.back();
    CellIndex pass{-1, -1};
    for (double t = 0.0; t <= 1.0; t += 0.05) {
      const CellIndex cell =
          geometry_.CellAt({a.x_m + t * (b.x_m - a.x_m), a.y_m + t * (b.y_m - a.y_m)});
      if (blocked_[cell] != 0) continue;
      if (pass.row < 0 || height_m_[cell] < height_m_[pass]) pass = cell;
    }
    return pass;
  }

  // Returns the way from a road to the place; empty: none leads there. States are cells and the
  // direction in which they are left: bends cost, so that legs are long.
  std::vector<CellIndex> WayTo(CellIndex goal) const {
    using Entry = std::pair<float, std::int32_t>;
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    const std::vector<Move> moves = AllMoves();
    const int cols = height_m_.cols();
    std::vector<float> least(height_m_.size() * kDirections, kInfinity);
    std::vector<std::int32_t> before(least.size(), -1);
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    for (int direction = 0; direction < kDirections; ++direction) {
      const std::int32_t state = (goal.row * cols + goal.col) * kDirections + direction;
      least[state] = 0.0f;
      queue.push({0.0f, state});
    }
    while (!queue.empty()) {
      const auto [cost, state] = queue.top();
      queue.pop();
      if (cost > least[state]) continue;
      const std::int32_t index = state / kDirections;
      const CellIndex cell = {index / cols, index % cols};
      if (road_[cell] != 0) return Follow(state, before);
      for (const Move& move : moves) {
        const CellIndex to = {cell.row + move.rows, cell.col + move.cols};
        if (!height_m_.Contains(to) || blocked_[to] != 0) continue;
        const float reached = cost + CostOf(cell, to, move.length) +
                              (cell == goal ? 0.0f : TurnCost(state % kDirections, move.direction));
        const std::int32_t next = (to.row * cols + to.col) * kDirections + move.direction;
        if (reached >= least[next]) continue;
        least[next] = reached;
        before[next] = state;
        queue.push({reached, next});
      }
    }
    return {};
  }

  WorldPoint PointOf(CellIndex cell) const { return geometry_.CenterOf(cell); }

 private:
  bool IsOnTop(const ReliefPiece& piece, CellIndex cell) const {
    if (!piece.has_area()) {
      return DistanceToAxis_m(piece, geometry_.CenterOf(cell)) < 0.3 * piece.half_width_m;
    }
    const int per_cell = std::max(1, geometry_.rows() / kLayoutSize);
    return piece.area.Contains({std::min(cell.row / per_cell, kLayoutSize - 1),
                                std::min(cell.col / per_cell, kLayoutSize - 1)});
  }

  float CostOf(CellIndex from, CellIndex to, float length) const {
    const auto run_m = length * static_cast<float>(geometry_.resolution_m());
    const float slope = std::abs(height_m_[to] - height_m_[from]) / run_m;
    const float over = std::max(0.0f, slope / max_slope_ - 1.0f);
    return length * (1.0f + kDear * over * (1.0f + over));
  }

  static float TurnCost(int from, int to) {
    const int apart = std::abs(from - to);
    const float half_turns = std::min(apart, kDirections - apart) / (0.5f * kDirections);
    return kTurn * half_turns * half_turns;
  }

  std::vector<CellIndex> Follow(std::int32_t state, const std::vector<std::int32_t>& before) const {
    std::vector<CellIndex> way;
    for (; state >= 0; state = before[state]) {
      const std::int32_t index = state / kDirections;
      way.push_back({index / height_m_.cols(), index % height_m_.cols()});
    }
    return way;
  }

  GridGeometry geometry_;
  Grid<float> height_m_;
  Grid<unsigned char> road_;
  Grid<unsigned char> blocked_;
  float max_slope_;
};

// Corners cut off twice (Chaikin 1974).
std::vector<WorldPoint> Rounded(std::vector<WorldPoint> line) {
  for (int round = 0; round < 2 && line.size() > 2; ++round) {
    std::vector<WorldPoint> cut = {line.front()};
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      const WorldPoint a = line[i], b = line[i + 1];
      cut.push_back({0.75 * a.x_m + 0.25 * b.x_m, 0.75 * a.y_m + 0.25 * b.y_m});
      cut.push_back({0.25 * a.x_m + 0.75 * b.x_m, 0.25 * a.y_m + 0.75 * b.y_m});
    }
    cut.push_back(line.back());
    line = std::move(cut);
  }
  return line;
}

}  // namespace

std::vector<Street> ClimbingWays(const std::vector<ReliefWish>& wishes,
                                 const std::vector<ReliefPiece>& pieces,
                                 const GridGeometry& lattice, const ClimbingGround& ground,
                                 double max_slope) {
  std::vector<Street> ways;
  const auto is_climbed = [&wishes](const ReliefPiece& piece) {
    const ReliefWish& wish = wishes[static_cast<std::size_t>(piece.wish)];
    if (wish.kind == ReliefKind::kSaddle && piece.kind != ReliefKind::kRidge) return false;
    const std::vector<ReliefTie>& ties = wish.ties;
    return std::any_of(ties.begin(), ties.end(),
                       [](const ReliefTie& tie) { return tie.kind == ReliefTie::Kind::kClimbed; });
  };
  if (std::none_of(pieces.begin(), pieces.end(), is_climbed)) return ways;
  const WayFinder finder(lattice, ground, max_slope);
  if (!finder.HasRoad()) return ways;
  for (const ReliefPiece& piece : pieces) {
    if (!is_climbed(piece)) continue;
    const bool pass = wishes[static_cast<std::size_t>(piece.wish)].kind == ReliefKind::kSaddle;
    const CellIndex top = pass ? finder.PassOf(piece) : finder.TopOf(piece);
    if (top.row < 0) continue;
    Street street;
    for (const CellIndex cell : finder.WayTo(top)) street.line.push_back(finder.PointOf(cell));
    if (street.line.size() < 2) continue;
    street.line = Rounded(std::move(street.line));
    street.width_m = kWidth_m;
    ways.push_back(std::move(street));
  }
  return ways;
}

}  // namespace latticeworld::internal
