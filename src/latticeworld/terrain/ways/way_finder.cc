#include "latticeworld/terrain/ways/way_finder.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <numeric>
#include <queue>
#include <utility>

#include "latticeworld/geomorphology/resample.h"
#include "latticeworld/terrain/forms/relief_measures.h"

namespace latticeworld::internal {
namespace {

constexpr int kCoarser = 8;      // cells of the lattice a step
constexpr int kReach = 5;        // steps that a move goes at most
constexpr float kDear = 120.0f;  // of what is too steep
constexpr int kDirections = 16;
constexpr float kTurn = 9.0f;  // of turning back, as a way of so many steps
constexpr int kWideTurn = 5;   // directions that a way with wide bends turns by at once

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

// Directions between two.
int Apart(int from, int to) {
  const int apart = std::abs(from - to);
  return std::min(apart, kDirections - apart);
}

float TurnCost(int from, int to) {
  const float half_turns = Apart(from, to) / (0.5f * kDirections);
  return kTurn * half_turns * half_turns;
}

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

WayFinder::WayFinder(const GridGeometry& lattice, const WayGround& ground)
    : lattice_(lattice),
      roads_(ground.road),
      geometry_(GridGeometry::FromCells(lattice.rows() / kCoarser, lattice.size_m())),
      height_m_(Resample(ground.height_m, geometry_.rows(), geometry_.cols())),
      road_(Coarse(ground.road)),
      blocked_(Coarse(ground.blocked)) {}

bool WayFinder::HasRoad() const { return std::find(road_.begin(), road_.end(), 1) != road_.end(); }

CellIndex WayFinder::TopOf(const ReliefPiece& piece) const {
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

CellIndex WayFinder::PassOf(const ReliefPiece& ridge) const {
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

// States are cells and the direction in which they are left: bends cost, so that legs are long.
std::vector<CellIndex> WayFinder::WayTo(CellIndex goal, From from, const Rule& rule) const {
  const auto max_slope = static_cast<float>(rule.max_slope);
  const int most_turn = rule.wide_bends ? kWideTurn : kDirections;
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
    if (from == From::kRoad ? road_[cell] != 0 : IsAtEdge(cell)) {
      std::vector<CellIndex> way;
      for (std::int32_t on = state; on >= 0; on = before[on]) {
        way.push_back({on / kDirections / cols, on / kDirections % cols});
      }
      return way;
    }
    for (const Move& move : moves) {
      const CellIndex to = {cell.row + move.rows, cell.col + move.cols};
      if (!height_m_.Contains(to) || blocked_[to] != 0) continue;
      if (cell != goal && Apart(state % kDirections, move.direction) > most_turn) continue;
      const float reached = cost + CostOf(cell, to, move.length, max_slope) +
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

std::vector<WorldPoint> WayFinder::LineTo(CellIndex goal, From from, const Rule& rule) const {
  std::vector<WorldPoint> line;
  const std::vector<CellIndex> way = WayTo(goal, from, rule);
  if (from == From::kEdge && !way.empty()) line.push_back(BorderBeside(way.front()));
  for (const CellIndex cell : way) line.push_back(geometry_.CenterOf(cell));
  if (line.size() < 2) return {};
  line = Rounded(std::move(line));
  if (from == From::kRoad && rule.wide_bends) JoinRoad(&line);
  return line;
}

void WayFinder::JoinRoad(std::vector<WorldPoint>* line) const {
  constexpr double kInto_cells = 2.0;
  const WorldPoint from = line->front();
  const CellIndex at = lattice_.CellAt(from);
  double least_m = std::numeric_limits<double>::infinity();
  WorldPoint nearest = from;
  for (int r = at.row - 2 * kCoarser; r <= at.row + 2 * kCoarser; ++r) {
    for (int c = at.col - 2 * kCoarser; c <= at.col + 2 * kCoarser; ++c) {
      if (!roads_.Contains({r, c}) || roads_(r, c) == 0) continue;
      const WorldPoint road = lattice_.CenterOf({r, c});
      const double off_m = std::hypot(road.x_m - from.x_m, road.y_m - from.y_m);
      if (off_m >= least_m) continue;
      least_m = off_m;
      nearest = road;
    }
  }
  if (std::isinf(least_m) || least_m <= lattice_.resolution_m()) return;
  const double on = kInto_cells * lattice_.resolution_m() / least_m;
  line->insert(line->begin(), {nearest.x_m + on * (nearest.x_m - from.x_m),
                               nearest.y_m + on * (nearest.y_m - from.y_m)});
}

bool WayFinder::IsOnTop(const ReliefPiece& piece, CellIndex cell) const {
  if (!piece.has_area()) {
    return DistanceToAxis_m(piece, geometry_.CenterOf(cell)) < 0.3 * piece.half_width_m;
  }
  const int per_cell = std::max(1, geometry_.rows() / kLayoutSize);
  return piece.area.Contains({std::min(cell.row / per_cell, kLayoutSize - 1),
                              std::min(cell.col / per_cell, kLayoutSize - 1)});
}

bool WayFinder::IsAtEdge(CellIndex cell) const {
  return cell.row == 0 || cell.col == 0 || cell.row == geometry_.rows() - 1 ||
         cell.col == geometry_.cols() - 1;
}

WorldPoint WayFinder::BorderBeside(CellIndex cell) const {
  const double half_m = geometry_.half_size_m();
  WorldPoint at = geometry_.CenterOf(cell);
  if (cell.col == 0 || cell.col == geometry_.cols() - 1) {
    at.x_m = cell.col == 0 ? -half_m : half_m;
  } else {
    at.y_m = cell.row == 0 ? half_m : -half_m;
  }
  return at;
}

float WayFinder::CostOf(CellIndex from, CellIndex to, float length, float max_slope) const {
  const auto run_m = length * static_cast<float>(geometry_.resolution_m());
  const float slope = std::abs(height_m_[to] - height_m_[from]) / run_m;
  const float over = std::max(0.0f, slope / max_slope - 1.0f);
  return length * (1.0f + kDear * over * (1.0f + over));
}

}  // namespace latticeworld::internal
