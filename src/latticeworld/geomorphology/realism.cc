#include "latticeworld/geomorphology/realism.h"

#include <algorithm>
#include <cstddef>

#include "latticeworld/common/check.h"
#include "latticeworld/geomorphology/realism_channels.h"
#include "latticeworld/geomorphology/realism_relief.h"
#include "latticeworld/geomorphology/realism_spectrum.h"

namespace latticeworld {
namespace {

constexpr int kMinSide = 64;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

RealismMeasures NothingMeasured() {
  RealismMeasures none;
  none.relief_m = kNone;
  none.slope_quantiles_rad.fill(kNone);
  none.mean_slope_rad = kNone;
  none.hypsometric_curve.fill(kNone);
  none.hypsometric_integral = kNone;
  none.depression_share = kNone;
  none.channel_area_m2 = kNone;
  none.spectrum_min_m = kNone;
  none.spectrum_max_m = kNone;
  return none;
}

}  // namespace

RealismMeasures MeasureRealism(const Grid<float>& height_m, double resolution_m,
                               const Grid<unsigned char>* water, int threads) {
  LW_CHECK(resolution_m > 0.0, "a cell has a size");
  LW_CHECK(
      water == nullptr || (water->rows() == height_m.rows() && water->cols() == height_m.cols()),
      "water lies on the same grid");
  RealismMeasures measures = NothingMeasured();
  if (height_m.rows() < kMinSide || height_m.cols() < kMinSide) return measures;
  Grid<unsigned char> dry(height_m.rows(), height_m.cols(), 1);
  if (water != nullptr) {
    std::transform(water->begin(), water->end(), dry.begin(),
                   [](unsigned char wet) { return wet != 0 ? 0 : 1; });
  }
  const auto dry_cells = std::count(dry.begin(), dry.end(), 1);
  measures.dry_share = static_cast<double>(dry_cells) / dry.size();
  if (dry_cells == 0) return measures;
  MeasureSlopes(height_m, resolution_m, dry, &measures);
  MeasureHypsometry(height_m, dry, &measures);
  MeasureChannels(height_m, resolution_m, dry, threads, &measures);
  MeasureSpectra(height_m, resolution_m, DryWindow(dry), threads, &measures);
  return measures;
}

}  // namespace latticeworld
