#include "latticeworld/terrain/ways/benches.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "latticeworld/geomorphology/blur.h"
#include "latticeworld/geomorphology/slope.h"
#include "latticeworld/terrain/components.h"
#include "latticeworld/terrain/lattice.h"
#include "latticeworld/terrain/masked_blur.h"
#include "latticeworld/terrain/ways/embankment.h"

namespace latticeworld::internal {
namespace {

constexpr double kFieldRiserSlope = 0.30;  // steepest of the steps between fields [m/m]
constexpr double kFieldBench_m = 0.8;      // height of a step
constexpr float kLeastSlope = 0.04f;       // of fields that have benches [m/m]
constexpr double kLeastRiser = 0.25;       // of a bench's run
constexpr double kPadRiserSlope = 0.45;
constexpr double kPadBankSlope = 0.45;      // of the land beside pads [m/m]
constexpr double kPadBench_cells = 1.5;     // run of a terrace [layout cells]
constexpr double kLevelBelow_cells = 0.20;  // relief of a wholly level piece [layout cells]

float SmoothStep(float t) {
  t = std::clamp(t, 0.0f, 1.0f);
  return t * t * (3.0f - 2.0f * t);
}

// height in steps of bench_m, of which the share `riser` of the run leads from one to the next.
float Terraced(float height_m, float bench_m, float riser) {
  const float steps = height_m / bench_m;
  const float whole = std::floor(steps);
  const float t = (steps - whole - 0.5f) / riser + 0.5f;
  return bench_m * (whole + SmoothStep(t));
}

// The share of the run that a step needs where land of this slope must stay below riser_slope. The
// smooth step is 1.5 times as steep in its middle as on average.
float RiserFor(float slope, double riser_slope) {
  return std::clamp(1.5f * slope / static_cast<float>(riser_slope), static_cast<float>(kLeastRiser),
                    1.0f);
}

}  // namespace

void TerraceFields(const GridGeometry& lattice, const Grid<float>& weight, Grid<float>* land_m) {
  Grid<float> smooth = *land_m;
  GaussianBlur(0.6 * LatticeCellsPerLayoutCell(lattice), &smooth);
  const Grid<float> slope = GradientMagnitude(smooth, lattice.resolution_m());
  // Steps have to be a few cells wide: coarse lattices have higher ones.
  const auto bench_m = static_cast<float>(
      kFieldBench_m * std::max(std::min(1.0, lattice.size_m() / 512.0), lattice.resolution_m()));
  for (std::size_t i = 0; i < smooth.size(); ++i) {
    const float w = weight.data()[i];
    if (w <= 0.02f) continue;
    const float riser = RiserFor(slope.data()[i], kFieldRiserSlope);
    const float benched = Terraced(smooth.data()[i], bench_m, riser);
    // A field that is too steep for a bench keeps its slope. Nearly level fields need none.
    const float share = SmoothStep((w - 0.3f) / 0.5f) * SmoothStep((1.0f - riser) / 0.3f) *
                        SmoothStep((slope.data()[i] - kLeastSlope) / kLeastSlope);
    float& land = land_m->data()[i];
    land += share * (benched - land);
  }
}

void LevelPads(const GridGeometry& lattice, const Grid<unsigned char>& building, const Banks& banks,
               Grid<float>* land_m, Grid<float>* share) {
  if (std::find(building.begin(), building.end(), 1) == building.end()) return;
  const double layout_cell = LatticeCellsPerLayoutCell(lattice);
  const double layout_cell_m = layout_cell * lattice.resolution_m();
  Grid<float> pad_m = BlurMasked(building, *land_m, 0.6 * layout_cell).value;
  const Grid<float> slope = GradientMagnitude(pad_m, lattice.resolution_m());
  const Components pieces = ComponentsOf(building);
  for (int i = 0; i < pieces.count(); ++i) {
    double sum = 0.0;
    float low = pad_m.data()[pieces.cells[pieces.begin[i]]];
    float high = low;
    std::vector<float> slopes;
    for (int k = pieces.begin[i]; k < pieces.begin[i + 1]; ++k) {
      const float height = pad_m.data()[pieces.cells[k]];
      sum += height;
      low = std::min(low, height);
      high = std::max(high, height);
      slopes.push_back(slope.data()[pieces.cells[k]]);
    }
    const auto mean = static_cast<float>(sum / (pieces.begin[i + 1] - pieces.begin[i]));
    const bool level = high - low < kLevelBelow_cells * layout_cell_m;
    const float typical = Quantile(0.5, &slopes);
    const auto bench_m =
        std::max(static_cast<float>(kPadBench_cells * layout_cell_m) * typical, 1e-3f);
    for (int k = pieces.begin[i]; k < pieces.begin[i + 1]; ++k) {
      float& height = pad_m.data()[pieces.cells[k]];
      const float riser = RiserFor(slope.data()[pieces.cells[k]], kPadRiserSlope);
      height = level ? mean : Terraced(height, bench_m, riser);
    }
  }
  banks.Clamp(building, &pad_m);
  LayInto(building, pad_m, static_cast<float>(kPadBankSlope * lattice.resolution_m()), land_m,
          share);
}

}  // namespace latticeworld::internal
