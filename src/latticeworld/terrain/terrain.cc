#include "latticeworld/terrain/terrain.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "latticeworld/common/check.h"
#include "latticeworld/terrain/cover.h"
#include "latticeworld/terrain/land.h"
#include "latticeworld/terrain/paving.h"
#include "latticeworld/terrain/water.h"

namespace latticeworld {
namespace {

// Borders wide and ragged enough that the squares of the layout do not show in the land.
DecodeOptions BorderOptions(const GridGeometry& geometry) {
  constexpr double kBlendWidth_cells = 0.6;
  DecodeOptions options;
  options.blend_width_m = kBlendWidth_cells * geometry.size_m() / kLayoutSize;
  options.noise_amplitude = 1.0;
  return options;
}

}  // namespace

double Terrain::WaterDepthAt(WorldPoint point) const {
  const float level_m = water_level_m[geometry().CellAt(point)];
  if (std::isnan(level_m)) return 0.0;
  return std::max(0.0, static_cast<double>(level_m) - ground.HeightAt(point));
}

SurfaceClass Terrain::SurfaceAt(WorldPoint point) const {
  return surface[geometry().CellAt(point)];
}

Result<Terrain> BuildTerrain(const TerrainRequest& request, const Progress& progress) {
  LW_CHECK(request.layout != nullptr, "a terrain needs a layout");
  const GridGeometry& geometry = request.geometry;
  const auto advance = [&progress](double fraction) {
    progress.Report("terrain", fraction);
    return progress.CheckCancelled();
  };

  LW_RETURN_IF_ERROR(advance(0.0));
  Terrain terrain;
  terrain.weights = DecodeLayout(*request.layout, geometry, BorderOptions(geometry), request.seed);
  const Grid<char> letters = internal::DominantLetters(terrain.weights);
  terrain.surface = internal::SurfacesOf(terrain.weights.vocabulary, letters);

  LW_RETURN_IF_ERROR(advance(0.4));
  const bool has_relief = request.relief != nullptr;
  Grid<float> land_m = has_relief
                           ? internal::ReliefLand(geometry, *request.relief)
                           : internal::ShapedLand(geometry, terrain.weights, letters, request.seed);

  LW_RETURN_IF_ERROR(advance(0.6));
  internal::WaterShaper water(
      geometry, internal::MaskOf('W', letters),
      has_relief ? internal::WaterRule::kGraded : internal::WaterRule::kLevel);
  water.ShapeBanks(&land_m);

  LW_RETURN_IF_ERROR(advance(0.8));
  if (terrain.weights.vocabulary == Vocabulary::kSuburb) {
    internal::LevelPads(geometry, internal::MaskOf('B', letters), &land_m);
    internal::SmoothRoads(geometry, internal::MaskOf('R', letters), &land_m);
  }
  water.Settle(&land_m);
  terrain.water_level_m = water.TakeLevel();
  terrain.ground = HeightField(geometry, std::move(land_m));
  LW_RETURN_IF_ERROR(advance(1.0));
  return terrain;
}

}  // namespace latticeworld
