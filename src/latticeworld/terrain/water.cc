#include "latticeworld/terrain/water.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "latticeworld/geomorphology/blur.h"
#include "latticeworld/geomorphology/distance.h"

namespace latticeworld::internal {
namespace {

constexpr float kFreeboard_m = 0.10f;     // the shore's height above the water
constexpr float kMinFreeboard_m = 0.01f;  // and the least of it
constexpr float kMinDepth_m = 0.05f;
constexpr float kMaxDepth_m = 4.0f;
constexpr float kBedSlope = 0.25f;  // at the shore [m/m]
constexpr float kLeastDistance_cells = 0.25f;
constexpr double kBankSmoothingOfSize = 0.006;
constexpr double kMostLift_m = 0.1;
constexpr double kBedSmoothingOfSize = 0.004;

// A bank must not rise by more than a twentieth of a cell on its first cell.
double SteepestCurvature(const GridGeometry& geometry) { return 0.05 / geometry.resolution_m(); }

// How the banks curve in fixed-height scenes [1/m]: they reach wide, in proportion to the world.
double WideCurvature(const GridGeometry& geometry) {
  return std::min(std::clamp(2.5 / geometry.size_m(), 0.002, 0.05), SteepestCurvature(geometry));
}

// How they curve in the user's relief: near the water, which leaves true heights farther away
// alone, but wide enough that a bank of height_m stays climbable. A parabola's slope at the height
// h is 2 sqrt(curvature * h).
double ReliefCurvature(const GridGeometry& geometry, double height_m) {
  constexpr double kSteepestBank = 0.8;  // [m/m]
  const double climbable = kSteepestBank * kSteepestBank / (4.0 * std::max(height_m, 1.0));
  const double widest = 2.0 / geometry.size_m();
  const double narrowest = std::clamp(15.0 / geometry.size_m(), 0.01, 0.1);
  return std::min(std::clamp(climbable, widest, std::max(widest, narrowest)),
                  SteepestCurvature(geometry));
}

// The same for what is built beside water: roads and pads may stand on embankments.
double EmbankmentCurvature(const GridGeometry& geometry) {
  return std::min(std::clamp(10.0 / geometry.size_m(), 0.01, 0.1), 0.1 / geometry.resolution_m());
}

// The height above its water [m] below which nearly all of the shore lies; 0 without a shore.
double HighestShore(const Grid<unsigned char>& wet, const Grid<float>& level_m,
                    const Grid<float>& land_m) {
  constexpr double kNearlyAll = 0.98;
  std::vector<float> rise_m;
  for (int r = 0; r < wet.rows(); ++r) {
    for (int c = 0; c < wet.cols(); ++c) {
      if (wet(r, c) == 0) continue;
      ForEachNeighbour(wet, r, c, [&](int row, int col) {
        if (wet(row, col) == 0) rise_m.push_back(land_m(row, col) - level_m(r, c));
      });
    }
  }
  return rise_m.empty() ? 0.0 : Quantile(kNearlyAll, &rise_m);
}

// min(a, b), rounded where they meet: at most k / 4 below it (polynomial smooth minimum).
float SmoothMin(float a, float b, float k) {
  const float h = std::max(k - std::abs(a - b), 0.0f);
  return std::min(a, b) - h * h / (4.0f * k);
}

float SmoothMax(float a, float b, float k) { return -SmoothMin(-a, -b, k); }

}  // namespace

WaterShaper::WaterShaper(const GridGeometry& geometry, Grid<unsigned char> wet, WaterRule rule)
    : geometry_(geometry),
      wet_(std::move(wet)),
      rule_(rule),
      bank_curvature_per_m_(rule == WaterRule::kLevel ? WideCurvature(geometry)
                                                      : ReliefCurvature(geometry, 0.0)),
      any_(std::find(wet_.begin(), wet_.end(), 1) != wet_.end()),
      level_m_(wet_.rows(), wet_.cols(), std::numeric_limits<float>::quiet_NaN()) {}

void WaterShaper::ShapeBanks(Grid<float>* land_m) {
  if (!any_) return;
  level_m_ = WaterLevels(geometry_, ComponentsOf(wet_), *land_m, rule_, bank_curvature_per_m_);
  if (rule_ == WaterRule::kGraded) {
    bank_curvature_per_m_ = ReliefCurvature(geometry_, HighestShore(wet_, level_m_, *land_m));
  }

  // The widest valley and the widest dam around the water, by parabolas from every wet cell.
  const double curvature =
      bank_curvature_per_m_ * geometry_.resolution_m() * geometry_.resolution_m();
  valley_m_ = Grid<float>(wet_.rows(), wet_.cols());
  dam_m_ = Grid<float>(wet_.rows(), wet_.cols());
  for (std::size_t i = 0; i < wet_.size(); ++i) {
    const bool wet = wet_.data()[i] != 0;
    const float shore_m = level_m_.data()[i] + kFreeboard_m;
    valley_m_.data()[i] = wet ? shore_m : kNoFeature;
    dam_m_.data()[i] = wet ? -shore_m : kNoFeature;
  }
  LowerEnvelope(curvature, &valley_m_);
  LowerEnvelope(curvature, &dam_m_);
  for (float& value : dam_m_) value = -value;
  // Parabolas from a ragged shore meet in creases.
  const double smoothing_m = std::min(kBankSmoothingOfSize * geometry_.size_m(),
                                      std::sqrt(kMostLift_m / bank_curvature_per_m_));
  const double smoothing_cells = smoothing_m / geometry_.resolution_m();
  GaussianBlur(smoothing_cells, &valley_m_);
  GaussianBlur(smoothing_cells, &dam_m_);
  // At a straight shore the blur sees half a parabola: it lifts the valley by this much there.
  const auto lift_m = static_cast<float>(0.5 * curvature * smoothing_cells * smoothing_cells);
  for (std::size_t i = 0; i < wet_.size(); ++i) {
    const float valley = valley_m_.data()[i] - lift_m;
    const float dam = dam_m_.data()[i] + lift_m;
    // Between high and low water that are near each other the dam of one meets the valley of the
    // other.
    const float middle = 0.5f * (valley + dam);
    valley_m_.data()[i] = std::max(valley, middle);
    dam_m_.data()[i] = std::min(dam, middle);
  }

  // The farther from the water, the rounder a bank runs out into the land.
  constexpr float kLeastRounding_m = 0.16f;
  constexpr float kRounding = 0.5f;
  constexpr float kMostRounding_m = 1.5f;
  for (std::size_t i = 0; i < wet_.size(); ++i) {
    const float valley = valley_m_.data()[i];
    const float dam = dam_m_.data()[i];
    const float rounding_m =
        std::min(kLeastRounding_m + kRounding * (valley - dam), kMostRounding_m);
    float& land = land_m->data()[i];
    land = SmoothMax(SmoothMin(land, valley, rounding_m), dam, rounding_m);
  }
}

void WaterShaper::Settle(Grid<float>* land_m) const {
  if (!any_) return;
  const auto resolution_m = static_cast<float>(geometry_.resolution_m());
  // Distances from a ragged shore run in streaks: smooth them. Half a bell reaches over the shore,
  // by 0.4 of its deviation on average.
  const double smoothing_cells = kBedSmoothingOfSize * geometry_.rows();
  Grid<float> to_shore = DistanceTo(false, wet_);
  if (to_shore(0, 0) != kNoFeature) GaussianBlur(smoothing_cells, &to_shore);
  const auto overreach_cells = static_cast<float>(0.4 * smoothing_cells);
  const auto steeper =
      static_cast<float>(std::max(1.0, EmbankmentCurvature(geometry_) / bank_curvature_per_m_));
  for (int r = 0; r < wet_.rows(); ++r) {
    for (int c = 0; c < wet_.cols(); ++c) {
      float& land = (*land_m)(r, c);
      if (wet_(r, c) != 0) {
        const float distance_m =
            std::max(to_shore(r, c) - overreach_cells, kLeastDistance_cells) * resolution_m;
        // Without any shore the distance is infinite and the depth kMaxDepth_m.
        const float depth_m =
            kMinDepth_m +
            (kMaxDepth_m - kMinDepth_m) * (1.0f - std::exp(-distance_m * kBedSlope / kMaxDepth_m));
        land = level_m_(r, c) - depth_m;
        continue;
      }
      const float middle = 0.5f * (valley_m_(r, c) + dam_m_(r, c));
      const float reach = 0.5f * (valley_m_(r, c) - dam_m_(r, c));
      land = std::clamp(land, middle - reach, middle + steeper * reach);
      ForEachNeighbour(wet_, r, c, [&](int row, int col) {
        if (wet_(row, col) != 0) land = std::max(land, level_m_(row, col) + kMinFreeboard_m);
      });
    }
  }
}

}  // namespace latticeworld::internal
