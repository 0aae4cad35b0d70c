#include "latticeworld/terrain/water/banks.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "latticeworld/geomorphology/blur.h"
#include "latticeworld/geomorphology/distance.h"
#include "latticeworld/layout/symbolic_layout.h"
#include "latticeworld/terrain/cones.h"

namespace latticeworld::internal {
namespace {

constexpr double kFreeboard_m = 0.10;        // of the shore above its water
constexpr double kFreeboardOfSize = 0.0005;  // less in small worlds
constexpr double kSmoothing_cells = 1.5;
// Banks are so wide, as a share of a layout cell.
constexpr double kBankOfCell = 0.7;
constexpr float kCrest_cells = 4.0f;
// River beds: as deep as this slope makes them over a quarter of a layout cell.
constexpr double kRiverBank_cells = 0.25;  // layout cells
constexpr double kRiverBankSlope = 0.30;
constexpr double kMaxRiverDepth_m = 2.5;
constexpr double kLakeBedSlope = 0.25;
constexpr double kMaxLakeDepth_m = 4.0;

}  // namespace

double RiverDepth_m(double size_m) {
  return std::min(kRiverBankSlope * kRiverBank_cells * size_m / kLayoutSize, kMaxRiverDepth_m);
}

float SmoothMin(float a, float b, float k) {
  const float h = std::max(k - std::abs(a - b), 0.0f);
  return std::min(a, b) - h * h / (4.0f * k);
}

float SmoothMax(float a, float b, float k) { return -SmoothMin(-a, -b, k); }

Banks::Banks(const GridGeometry& lattice, const WaterBodies& water, const Grid<float>& level_m,
             double slope)
    : cell_m_(lattice.resolution_m()),
      layout_cell_m_(lattice.size_m() / kLayoutSize),
      size_m_(lattice.size_m()),
      water_(water),
      any_(!water.bodies.cells.empty()),
      level_everywhere_m_(level_m.rows(), level_m.cols(), 0.0f),
      to_water_(DistanceTo(true, water.wet)) {
  if (!any_) return;
  const Grid<std::int32_t> nearest = NearestOf(water.wet);
  for (std::size_t i = 0; i < nearest.size(); ++i) {
    level_everywhere_m_.data()[i] = level_m.data()[nearest.data()[i]];
  }
  const auto freeboard_m = static_cast<float>(std::min(kFreeboard_m, kFreeboardOfSize * size_m_));
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  highest_m_ = Grid<float>(level_m.rows(), level_m.cols(), kInfinity);
  lowest_m_ = Grid<float>(level_m.rows(), level_m.cols(), -kInfinity);
  for (const std::int32_t cell : water.bodies.cells) {
    highest_m_.data()[cell] = lowest_m_.data()[cell] = level_m.data()[cell] + freeboard_m;
  }
  // A dam has a crest.
  for (std::size_t i = 0; i < nearest.size(); ++i) {
    if (to_water_.data()[i] > kCrest_cells) continue;
    lowest_m_.data()[i] = level_everywhere_m_.data()[i] + freeboard_m;
  }
  const auto rise_m = static_cast<float>(slope * cell_m_);
  LowerCones(rise_m, &highest_m_);
  UpperCones(rise_m, &lowest_m_);
  // Cones from a ragged shore meet in creases. The blur lifts the foot of a cone by this much.
  GaussianBlur(kSmoothing_cells, &highest_m_);
  GaussianBlur(kSmoothing_cells, &lowest_m_);
  const auto bank_m = static_cast<float>(kBankOfCell * layout_cell_m_);
  const auto cell_m = static_cast<float>(cell_m_);
  const auto lift_m = static_cast<float>(0.4 * kSmoothing_cells) * rise_m;
  for (std::size_t i = 0; i < highest_m_.size(); ++i) {
    float& high = highest_m_.data()[i];
    float& low = lowest_m_.data()[i];
    high -= lift_m;
    // Farther from the water land is as steep as it likes.
    const float beyond_m = std::max(to_water_.data()[i] * cell_m - bank_m, 0.0f);
    high += 0.5f * beyond_m * beyond_m / bank_m;
    if (high < low) high = low = 0.5f * (high + low);
  }
}

void Banks::Shape(Grid<float>* land_m) const {
  if (!any_) return;
  // The farther from the water, the rounder a bank runs out into the land.
  constexpr float kRounding = 0.5f;
  const auto least_m = static_cast<float>(0.05 * cell_m_);
  const auto most_m = static_cast<float>(std::min(1.5, 0.1 * layout_cell_m_));
  for (std::size_t i = 0; i < land_m->size(); ++i) {
    if (water_.wet.data()[i] != 0) continue;
    const float high = highest_m_.data()[i], low = lowest_m_.data()[i];
    const float rounding_m = std::min(least_m + kRounding * (high - low), most_m);
    float& land = land_m->data()[i];
    land = SmoothMax(SmoothMin(land, high, rounding_m), low, rounding_m);
  }
}

void Banks::Clamp(const Grid<unsigned char>& mask, Grid<float>* values_m) const {
  if (!any_) return;
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (mask.data()[i] == 0 || water_.wet.data()[i] != 0) continue;
    float& value = values_m->data()[i];
    value = std::clamp(value, lowest_m_.data()[i], highest_m_.data()[i]);
  }
}

void Banks::Raise(const Grid<unsigned char>& mask, Grid<float>* values_m) const {
  if (!any_) return;
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (mask.data()[i] == 0 || water_.wet.data()[i] != 0) continue;
    float& value = values_m->data()[i];
    value = std::max(value, lowest_m_.data()[i]);
  }
}

void Banks::Dig(const Grid<float>* most_depth_m, Grid<float>* land_m) const {
  if (!any_) return;
  Grid<float> to_shore = DistanceTo(false, water_.wet);
  // Without any shore the distance is infinite.
  const bool shore = to_shore(0, 0) != kNoFeature;
  if (shore) GaussianBlur(1.0, &to_shore);
  Grid<float> lake(land_m->rows(), land_m->cols());
  for (std::size_t i = 0; i < lake.size(); ++i) lake.data()[i] = water_.still.data()[i] >= 0;
  GaussianBlur(0.3 * layout_cell_m_ / cell_m_, &lake);

  const auto bank_m = static_cast<float>(kRiverBank_cells * layout_cell_m_);
  const auto river_depth_m = static_cast<float>(RiverDepth_m(size_m_));
  const auto lake_depth_m = static_cast<float>(std::max(kMaxLakeDepth_m, 0.003 * size_m_) -
                                               static_cast<double>(river_depth_m));
  for (const std::int32_t cell : water_.bodies.cells) {
    const float distance_m =
        std::max(to_shore.data()[cell] - 0.5f, 0.0f) * static_cast<float>(cell_m_);
    const float t = std::min(distance_m / bank_m, 1.0f);
    float depth_m = river_depth_m * t * (2.0f - t);
    const float beyond_m = std::max(distance_m - 0.5f * bank_m, 0.0f);
    depth_m += lake.data()[cell] * lake_depth_m *
               (1.0f - std::exp(-beyond_m * static_cast<float>(kLakeBedSlope) / lake_depth_m));
    if (most_depth_m != nullptr) depth_m = std::min(depth_m, most_depth_m->data()[cell]);
    land_m->data()[cell] = level_everywhere_m_.data()[cell] - depth_m;
  }
}

}  // namespace latticeworld::internal
