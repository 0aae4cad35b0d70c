#include "latticeworld/relief/sketch/sketch_courses.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

#include "latticeworld/common/check.h"
#include "latticeworld/geomorphology/distance.h"
#include "latticeworld/geomorphology/noise.h"
#include "latticeworld/relief/sketch/cheapest_ways.h"

namespace latticeworld::internal {
namespace {

// What a step of one cell over open land costs, on average, and what it costs elsewhere.
constexpr int kOpenLand = 200;
constexpr int kOnValley = 4;
constexpr int kOverRidge = 8000;
constexpr float kRoughness = 1.5f;    // open land costs 1 + kRoughness * noise,
constexpr float kEasiestLand = 0.2f;  // but no less than this
// Leaving over a border without a valley costs as much as this share of the side over open land.
constexpr float kToOpenBorder = 0.25f;
// Strokes this near [sides] belong together; one this near to the border reaches it.
constexpr float kGap = 0.02f;

// The floor of a channel falls by this [heights a side] where all the land drains through it, and
// by more where less does: slope ~ area^-theta (Flint 1974).
constexpr float kTrunkSlope = 0.15f;
constexpr float kConcavity = 0.4f;
constexpr float kSmallestArea = 5e-4f;  // of all land: the head of a drawn valley
// Floors approach this height, however long and steep their course.
constexpr float kHighestFloor = 0.9f;
// A mouth through which hardly any land drains lies this high above the one of most land, since it
// has a way to go yet; in between by the share of the land.
constexpr float kHighestMouth = 0.3f;
constexpr float kMouthExponent = 0.3f;

// Calls visit(row, col) along the border, once around.
template <typename Visit>
void AlongBorder(int rows, int cols, Visit visit) {
  for (int c = 0; c < cols; ++c) visit(0, c);
  for (int r = 1; r < rows; ++r) visit(r, cols - 1);
  for (int c = cols - 2; c >= 0 && rows > 1; --c) visit(rows - 1, c);
  for (int r = rows - 2; r > 0 && cols > 1; --r) visit(r, 0);
}

// Labels the 8-connected parts of mask from 1; 0 elsewhere.
Grid<std::int32_t> LabelParts(const Grid<unsigned char>& mask) {
  Grid<std::int32_t> label(mask.rows(), mask.cols(), 0);
  int count = 0;
  std::vector<CellIndex> open;
  for (int r = 0; r < mask.rows(); ++r) {
    for (int c = 0; c < mask.cols(); ++c) {
      if (mask(r, c) == 0 || label(r, c) != 0) continue;
      label(r, c) = ++count;
      open.push_back({r, c});
      while (!open.empty()) {
        const CellIndex cell = open.back();
        open.pop_back();
        for (int i = 0; i < 9; ++i) {
          const CellIndex next{cell.row + i / 3 - 1, cell.col + i % 3 - 1};
          if (!mask.Contains(next) || mask[next] == 0 || label[next] != 0) continue;
          label[next] = count;
          open.push_back(next);
        }
      }
    }
  }
  return label;
}

// A place where a valley system meets the border.
struct Opening {
  int system = 0;
  std::vector<CellIndex> cells;  // in a row along the border
  double ridge_distance = 0.0;   // mean over them
};

std::vector<Opening> FindOpenings(const Grid<std::int32_t>& system_of,
                                  const Grid<float>& ridge_distance) {
  std::vector<Opening> openings;
  AlongBorder(system_of.rows(), system_of.cols(), [&](int r, int c) {
    const int system = system_of(r, c);
    if (system == 0) return;
    const bool continues = !openings.empty() && openings.back().system == system &&
                           std::abs(openings.back().cells.back().row - r) +
                                   std::abs(openings.back().cells.back().col - c) <=
                               1;
    if (!continues) openings.push_back({system, {}, 0.0});
    openings.back().cells.push_back({r, c});
  });
  // The border is a ring: an opening at its first cell may be the end of the last one.
  if (openings.size() > 1) {
    Opening& first = openings.front();
    Opening& last = openings.back();
    const CellIndex a = first.cells.front();
    const CellIndex b = last.cells.back();
    if (first.system == last.system && std::abs(a.row - b.row) + std::abs(a.col - b.col) <= 1) {
      first.cells.insert(first.cells.end(), last.cells.begin(), last.cells.end());
      openings.pop_back();
    }
  }
  for (Opening& opening : openings) {
    for (const CellIndex cell : opening.cells) opening.ridge_distance += ridge_distance[cell];
    opening.ridge_distance /= static_cast<double>(opening.cells.size());
  }
  return openings;
}

// Valley systems: strokes with small gaps between them, and what is as near to them; 0 elsewhere.
Grid<std::int32_t> FindSystems(const Grid<float>& valley_distance,
                               const Grid<float>& ridge_distance) {
  Grid<unsigned char> near(valley_distance.rows(), valley_distance.cols());
  const float gap = kGap * static_cast<float>(near.cols());
  std::transform(valley_distance.begin(), valley_distance.end(), ridge_distance.begin(),
                 near.begin(), [gap](float valley, float ridge) {
                   return static_cast<unsigned char>(valley <= gap && valley < 0.5f * ridge);
                 });
  return LabelParts(near);
}

// What each cell of the border costs to leave by, kNever elsewhere.
std::vector<std::int32_t> StartCosts(const Grid<std::int32_t>& system,
                                     const Grid<float>& valley_distance,
                                     const Grid<float>& ridge_distance) {
  const int rows = system.rows();
  const int cols = system.cols();
  const std::vector<Opening> openings = FindOpenings(system, ridge_distance);
  std::vector<std::int32_t> start(system.size(), kNever);
  const auto open_border =
      static_cast<std::int32_t>(kToOpenBorder * static_cast<float>(cols) * kOpenLand);
  bool any = false;
  AlongBorder(rows, cols, [&](int r, int c) {
    if (system(r, c) != 0 || ridge_distance(r, c) == 0.0f) return;
    start[r * cols + c] = open_border;
    any = true;
  });
  // If one system has several openings, water leaves by the one farthest from the ridges.
  for (const Opening& opening : openings) {
    const bool lowest = std::none_of(openings.begin(), openings.end(), [&](const Opening& other) {
      return other.system == opening.system && other.ridge_distance > opening.ridge_distance;
    });
    if (!lowest) continue;
    any = true;
    for (const CellIndex cell : opening.cells) {
      // Straight from the end of the stroke to the border.
      start[cell.row * cols + cell.col] =
          static_cast<std::int32_t>(valley_distance[cell] * kOnValley);
    }
  }
  // Ridges all along the border: over them.
  if (!any) AlongBorder(rows, cols, [&](int r, int c) { start[r * cols + c] = open_border; });
  return start;
}

Grid<std::int32_t> StepCosts(const Grid<unsigned char>& valley, const Grid<unsigned char>& ridge,
                             std::uint64_t seed, int threads) {
  NoiseOptions rough;
  rough.wavelength_m = 0.1;
  rough.octaves = 3;
  rough.gain = 0.6;
  const int cells = valley.rows();
  const Grid<float> noise = FractalNoise(GridGeometry::FromCells(cells, 1.0), rough, seed, threads);
  Grid<std::int32_t> cost(cells, cells);
  for (std::size_t i = 0; i < cost.size(); ++i) {
    const float land = std::max(kEasiestLand, 1.0f + kRoughness * noise.data()[i]);
    cost.data()[i] = valley.data()[i] != 0  ? kOnValley
                     : ridge.data()[i] != 0 ? kOverRidge
                                            : static_cast<std::int32_t>(land * kOpenLand);
  }
  return cost;
}

// Heights of the mouths, by the land that drains through each.
float MouthHeight(float area_cells, float most_cells) {
  return kHighestMouth * (1.0f - std::pow(area_cells / most_cells, kMouthExponent));
}

// Raises floors from the mouths up, so that each lies above one beside it, as little as the slopes
// allow: so the two ends of a valley that runs around a hill meet at one height.
void RaiseFloors(const std::vector<float>& area_cells, const Grid<unsigned char>& lake,
                 Courses* courses) {
  const int cells = lake.cols();
  const Grid<unsigned char>& valley = courses->valley;
  using Entry = std::pair<float, std::int32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  constexpr float kUnknown = std::numeric_limits<float>::infinity();
  std::vector<float> rise(valley.size(), kUnknown);
  float most = 1.0f;
  for (std::size_t i = 0; i < valley.size(); ++i) {
    if (courses->mouth.data()[i] != 0) most = std::max(most, area_cells[i]);
  }
  for (std::size_t i = 0; i < valley.size(); ++i) {
    if (courses->mouth.data()[i] == 0) continue;
    rise[i] = MouthHeight(area_cells[i], most);
    queue.emplace(rise[i], static_cast<std::int32_t>(i));
  }
  while (!queue.empty()) {
    const auto [height, cell] = queue.top();
    queue.pop();
    if (height > rise[cell]) continue;
    courses->floor.data()[cell] = kHighestFloor * (1.0f - std::exp(-height / kHighestFloor));
    for (int i = 0; i < 9; ++i) {
      const CellIndex next{cell / cells + i / 3 - 1, cell % cells + i % 3 - 1};
      if (!valley.Contains(next) || valley[next] == 0) continue;
      const std::int32_t index = next.row * cells + next.col;
      float up = 0.0f;
      if (lake[next] == 0 || lake.data()[cell] == 0) {
        const float length = (i % 2 == 0 ? 1.41421356f : 1.0f) / static_cast<float>(cells);
        const float share =
            std::max(kSmallestArea, area_cells[index] / static_cast<float>(valley.size()));
        up = length * kTrunkSlope * std::pow(share, -kConcavity);
      }
      if (height + up >= rise[index]) continue;
      rise[index] = height + up;
      queue.emplace(rise[index], index);
    }
  }
}

}  // namespace

Courses FindCourses(const Grid<unsigned char>& valley, const Grid<unsigned char>& lake,
                    const Grid<unsigned char>& ridge, std::uint64_t seed, int threads) {
  LW_CHECK(valley.rows() == valley.cols(), "the land of a sketch is square");
  const int cells = valley.rows();
  Courses courses{valley, Grid<unsigned char>(cells, cells, 0), Grid<float>(cells, cells, 0.0f)};
  if (std::none_of(valley.begin(), valley.end(), [](unsigned char v) { return v != 0; })) {
    return courses;
  }
  const Grid<float> valley_distance = DistanceTo(true, valley, threads);
  const Grid<float> ridge_distance = DistanceTo(true, ridge, threads);
  const Grid<std::int32_t> system = FindSystems(valley_distance, ridge_distance);
  const Ways ways = CheapestWays(StepCosts(valley, ridge, seed, threads), system,
                                 StartCosts(system, valley_distance, ridge_distance));

  // A valley that ends in the land goes on the way that its water takes.
  std::vector<float> area_cells(valley.size(), 1.0f);
  for (std::size_t i = ways.order.size(); i-- > 0;) {
    const std::int32_t cell = ways.order[i];
    const std::int32_t receiver = ways.receiver[cell];
    const bool on_course = courses.valley.data()[cell] != 0;
    if (receiver == cell) {
      courses.mouth.data()[cell] = on_course;
      continue;
    }
    area_cells[receiver] += area_cells[cell];
    unsigned char& below = courses.valley.data()[receiver];
    if (on_course && below == 0) below = kImplied;
  }
  RaiseFloors(area_cells, lake, &courses);
  return courses;
}

}  // namespace latticeworld::internal
