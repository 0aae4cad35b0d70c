#include "latticeworld/viewer/payloads/world_grids.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "latticeworld/terrain/terrain.h"
#include "latticeworld/viewer/payloads/little_endian.h"

namespace latticeworld {
namespace {

constexpr int kMostValue = 65535;
constexpr double kLeastRange_m = 1.0;  // flat worlds have steps, too
constexpr float kNoWater = -std::numeric_limits<float>::infinity();

WorldPoint VertexAt(const HeightGrid& grid, int row, int col) {
  return {grid.west_m + col * grid.spacing_m, grid.north_m - row * grid.spacing_m};
}

// Level of the water above the cell of each vertex [m], kNoWater where it is dry.
Grid<float> LevelsAt(const Terrain& terrain, const HeightGrid& grid) {
  Grid<float> levels(grid.rows, grid.cols, kNoWater);
  for (int row = 0; row < grid.rows; ++row) {
    for (int col = 0; col < grid.cols; ++col) {
      const float level =
          terrain.water_level_m[terrain.geometry().CellAt(VertexAt(grid, row, col))];
      if (!std::isnan(level)) levels(row, col) = level;
    }
  }
  return levels;
}

// Levels carried one vertex into the land, where it stands above them.
Grid<float> Ashore(const Grid<float>& levels, const Grid<float>& heights) {
  Grid<float> ashore = levels;
  for (int row = 0; row < levels.rows(); ++row) {
    for (int col = 0; col < levels.cols(); ++col) {
      if (levels(row, col) != kNoWater) continue;
      float level = kNoWater;
      for (int r = row - 1; r <= row + 1; ++r) {
        for (int c = col - 1; c <= col + 1; ++c) level = std::max(level, levels.Clamped(r, c));
      }
      if (level <= heights(row, col)) ashore(row, col) = level;
    }
  }
  return ashore;
}

std::uint16_t StepsOf(const HeightGrid& grid, double z_m, int most) {
  return static_cast<std::uint16_t>(
      std::clamp<long>(std::lround((z_m - grid.low_m) / grid.step_m), 0, most));
}

}  // namespace

HeightGrid MakeHeightGrid(const Terrain& terrain) {
  const GridGeometry& geometry = terrain.geometry();
  HeightGrid grid;
  grid.rows = grid.cols = std::min(geometry.rows(), kMostVertices);
  const WorldPoint corner = geometry.CenterOf({0, 0});
  grid.west_m = corner.x_m;
  grid.north_m = corner.y_m;
  grid.spacing_m = geometry.resolution_m() * (geometry.rows() - 1) / (grid.rows - 1);

  Grid<float> heights(grid.rows, grid.cols);
  for (int row = 0; row < grid.rows; ++row) {
    for (int col = 0; col < grid.cols; ++col) {
      heights(row, col) = static_cast<float>(terrain.ground.HeightAt(VertexAt(grid, row, col)));
    }
  }
  const Grid<float> levels = LevelsAt(terrain, grid);
  double low_m = terrain.ground.min_m(), high_m = terrain.ground.max_m();
  for (const float level : levels) {
    if (level == kNoWater) continue;
    low_m = std::min<double>(low_m, level);
    high_m = std::max<double>(high_m, level);
  }
  grid.low_m = low_m;
  grid.step_m = std::max(high_m - low_m, kLeastRange_m) / (kMostValue - 1);

  const std::size_t bytes = 2 * heights.size();
  grid.heights.reserve(bytes);
  grid.waters.reserve(bytes);
  for (const float height : heights) {
    AppendLittleEndian(StepsOf(grid, height, kMostValue), &grid.heights);
  }
  for (const float level : Ashore(levels, heights)) {
    const int value = level == kNoWater ? 0 : 1 + StepsOf(grid, level, kMostValue - 1);
    AppendLittleEndian(static_cast<std::uint16_t>(value), &grid.waters);
  }
  return grid;
}

TextureGrid MakeTextureGrid(const Terrain& terrain) {
  const int cells = terrain.geometry().rows();
  TextureGrid texture;
  texture.rows = texture.cols = std::min(cells, kMostTexels);
  // First cell of each texel, and one after the last.
  const auto first_cell = [&](int texel) {
    return static_cast<int>(static_cast<std::int64_t>(texel) * cells / texture.rows);
  };
  const std::size_t texels = static_cast<std::size_t>(texture.rows) * texture.cols;
  texture.weights.reserve(texels * terrain.weights.classes.size());
  for (const ClassWeight& entry : terrain.weights.classes) {
    texture.letters.push_back(entry.letter);
    const Grid<std::uint8_t>& levels = entry.weight.levels();
    for (int row = 0; row < texture.rows; ++row) {
      for (int col = 0; col < texture.cols; ++col) {
        unsigned sum = 0, count = 0;
        for (int r = first_cell(row); r < first_cell(row + 1); ++r) {
          for (int c = first_cell(col); c < first_cell(col + 1); ++c, ++count) sum += levels(r, c);
        }
        texture.weights.push_back(static_cast<char>((sum + count / 2) / count));
      }
    }
  }
  texture.surfaces.reserve(texels);
  for (int row = 0; row < texture.rows; ++row) {
    for (int col = 0; col < texture.cols; ++col) {
      const CellIndex middle = {(first_cell(row) + first_cell(row + 1) - 1) / 2,
                                (first_cell(col) + first_cell(col + 1) - 1) / 2};
      texture.surfaces.push_back(static_cast<char>(terrain.surface[middle]));
    }
  }
  return texture;
}

}  // namespace latticeworld
