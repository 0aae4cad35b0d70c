#include "latticeworld/scene/vegetation/canopy.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/geomorphology/blur.h"

namespace latticeworld {
namespace {

constexpr double kCell_m = 4.0;
constexpr int kFewestCells = 8, kMostCells = 256;  // a side
constexpr double kSmoothing_m = 5.0;               // standard deviation

}  // namespace

Canopy::Canopy(double world_size_m)
    : geometry_(GridGeometry::FromCells(
          std::clamp(static_cast<int>(world_size_m / kCell_m), kFewestCells, kMostCells),
          world_size_m)),
      cover_(geometry_.rows(), geometry_.cols(), 0.0f) {}

Canopy::Canopy(double world_size_m, const std::vector<Asset>& assets, int threads)
    : Canopy(world_size_m) {
  const double cell_m = geometry_.resolution_m();
  for (const Asset& asset : assets) {
    if (asset.kind != AssetKind::kTree) continue;
    const double crown_m2 = M_PI * double{asset.half_length_m} * asset.half_length_m;
    cover_[geometry_.CellAt(asset.position())] += static_cast<float>(crown_m2 / (cell_m * cell_m));
  }
  GaussianBlur(kSmoothing_m / cell_m, &cover_, threads);
  for (float& cover : cover_) cover = 1.0f - std::exp(-cover);
}

}  // namespace latticeworld
