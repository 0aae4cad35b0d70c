#include "latticeworld/terrain/paving.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "latticeworld/geomorphology/blur.h"
#include "latticeworld/terrain/components.h"

namespace latticeworld::internal {
namespace {

// Lengths for a world of 512 m, whose layout cells are 16 m wide; they scale with the cell.
constexpr double kRoadSmoothing_cells = 0.6;  // layout cells
constexpr double kPadSmoothing_cells = 0.5;
constexpr double kBlending_cells = 0.3;
constexpr double kLayoutCellsPerWorld = 32.0;

double ToCells(const GridGeometry& geometry, double layout_cells) {
  return layout_cells * geometry.rows() / kLayoutCellsPerWorld;
}

bool Any(const Grid<unsigned char>& mask) {
  return std::find(mask.begin(), mask.end(), 1) != mask.end();
}

// A blur of the masked cells alone: sum(mask * height) / sum(mask) under a Gaussian.
struct MaskedBlur {
  Grid<float> height_m;  // meaningful where share is not tiny
  Grid<float> share;     // Gaussian share of masked cells, in [0, 1]
};

MaskedBlur BlurMasked(const Grid<unsigned char>& mask, const Grid<float>& height_m,
                      double sigma_cells) {
  MaskedBlur result{Grid<float>(mask.rows(), mask.cols()), Grid<float>(mask.rows(), mask.cols())};
  for (std::size_t i = 0; i < mask.size(); ++i) {
    result.share.data()[i] = mask.data()[i];
    result.height_m.data()[i] = mask.data()[i] != 0 ? height_m.data()[i] : 0.0f;
  }
  GaussianBlur(sigma_cells, &result.share);
  GaussianBlur(sigma_cells, &result.height_m);
  constexpr float kTiny = 1e-3f;
  for (std::size_t i = 0; i < mask.size(); ++i) {
    result.height_m.data()[i] /= std::max(result.share.data()[i], kTiny);
  }
  return result;
}

float SmoothStep(float low, float high, float x) {
  const float t = std::clamp((x - low) / (high - low), 0.0f, 1.0f);
  return t * t * (3.0f - 2.0f * t);
}

// Lays the masked heights into the land, and leads over to it around them.
void BlendIn(const GridGeometry& geometry, const Grid<unsigned char>& mask,
             const Grid<float>& height_m, Grid<float>* land_m) {
  const MaskedBlur around = BlurMasked(mask, height_m, ToCells(geometry, kBlending_cells));
  for (std::size_t i = 0; i < mask.size(); ++i) {
    const float weight = SmoothStep(0.02f, 0.45f, around.share.data()[i]);
    float& land = land_m->data()[i];
    land += weight * (around.height_m.data()[i] - land);
  }
}

}  // namespace

void SmoothRoads(const GridGeometry& geometry, const Grid<unsigned char>& road,
                 Grid<float>* land_m) {
  if (!Any(road)) return;
  const MaskedBlur smooth = BlurMasked(road, *land_m, ToCells(geometry, kRoadSmoothing_cells));
  BlendIn(geometry, road, smooth.height_m, land_m);
}

void LevelPads(const GridGeometry& geometry, const Grid<unsigned char>& building,
               Grid<float>* land_m) {
  if (!Any(building)) return;
  Grid<float> height_m =
      BlurMasked(building, *land_m, ToCells(geometry, kPadSmoothing_cells)).height_m;
  // A piece is wholly level while its relief is small, and keeps its lie when it is large.
  const double layout_cell_m = geometry.size_m() / kLayoutCellsPerWorld;
  const auto level_below_m = static_cast<float>(0.06 * layout_cell_m);
  const auto keep_above_m = static_cast<float>(0.2 * layout_cell_m);
  const Components pieces = ComponentsOf(building);
  for (int i = 0; i < pieces.count(); ++i) {
    double sum = 0.0;
    float low = height_m.data()[pieces.cells[pieces.begin[i]]];
    float high = low;
    for (int k = pieces.begin[i]; k < pieces.begin[i + 1]; ++k) {
      const float height = height_m.data()[pieces.cells[k]];
      sum += height;
      low = std::min(low, height);
      high = std::max(high, height);
    }
    const auto mean = static_cast<float>(sum / (pieces.begin[i + 1] - pieces.begin[i]));
    const float keep = SmoothStep(level_below_m, keep_above_m, high - low);
    for (int k = pieces.begin[i]; k < pieces.begin[i + 1]; ++k) {
      float& height = height_m.data()[pieces.cells[k]];
      height = mean + keep * (height - mean);
    }
  }
  BlendIn(geometry, building, height_m, land_m);
}

}  // namespace latticeworld::internal
