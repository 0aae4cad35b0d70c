#include "latticeworld/sensing/solids/surface_geometry.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "latticeworld/terrain/terrain.h"

namespace latticeworld {
namespace {

// Vertices stand at the cell centres and, around them, on the world's edge: `side` x `side` of
// them, from the south-west, eastward and then northward.
struct VertexGrid {
  explicit VertexGrid(const GridGeometry& the_geometry)
      : geometry(the_geometry), side(the_geometry.rows() + 2) {}

  // Returns x of the column i or, counted from the south, y of the row i [m].
  float Coordinate_m(int i) const {
    if (i == 0) return static_cast<float>(-geometry.half_size_m());
    if (i == side - 1) return static_cast<float>(geometry.half_size_m());
    return static_cast<float>(geometry.CenterOf({0, i - 1}).x_m);
  }
  float At(const Grid<float>& values, int x, int y) const {
    return values.Clamped(geometry.rows() - y, x - 1);
  }

  const GridGeometry& geometry;
  int side;
};

// Level of the water at a vertex; at a dry one that of the wet ones around, NaN without any.
float LevelAt(const VertexGrid& grid, const Grid<float>& level_m, int x, int y) {
  const float own_m = grid.At(level_m, x, y);
  if (!std::isnan(own_m)) return own_m;
  float sum_m = 0.0f;
  int count = 0;
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      const float near_m = grid.At(level_m, x + dx, y + dy);
      if (std::isnan(near_m)) continue;
      sum_m += near_m;
      ++count;
    }
  }
  return sum_m / static_cast<float>(count);
}

// A run of squares between two rows of vertices, as one rectangle.
struct Strip {
  int x_first, x_end;  // vertices; x_end included
  float south_first_m, south_end_m, north_first_m, north_end_m;
  bool level() const {
    return south_first_m == south_end_m && south_first_m == north_first_m &&
           south_first_m == north_end_m;
  }
};

std::vector<Eigen::Vector3f> WaterCorners(const Terrain& terrain) {
  const VertexGrid grid(terrain.geometry());
  const Grid<float>& level_m = terrain.water_level_m;
  std::vector<Eigen::Vector3f> corners;
  const auto add = [&](const Strip& strip, int y) {
    const float west_m = grid.Coordinate_m(strip.x_first), east_m = grid.Coordinate_m(strip.x_end);
    const float south_m = grid.Coordinate_m(y), north_m = grid.Coordinate_m(y + 1);
    corners.emplace_back(west_m, south_m, strip.south_first_m);
    corners.emplace_back(east_m, south_m, strip.south_end_m);
    corners.emplace_back(east_m, north_m, strip.north_end_m);
    corners.emplace_back(west_m, north_m, strip.north_first_m);
  };
  std::vector<Strip> row;
  for (int y = 0; y + 1 < grid.side; ++y) {
    row.clear();
    for (int x = 0; x + 1 < grid.side; ++x) {
      const auto is_wet = [&](int i, int j) { return !std::isnan(grid.At(level_m, i, j)); };
      if (!is_wet(x, y) && !is_wet(x + 1, y) && !is_wet(x, y + 1) && !is_wet(x + 1, y + 1))
        continue;
      const Strip square = {x,
                            x + 1,
                            LevelAt(grid, level_m, x, y),
                            LevelAt(grid, level_m, x + 1, y),
                            LevelAt(grid, level_m, x, y + 1),
                            LevelAt(grid, level_m, x + 1, y + 1)};
      // Lakes and seas are level: one rectangle a row does.
      if (!row.empty() && row.back().x_end == x && row.back().level() && square.level() &&
          row.back().south_end_m == square.south_first_m) {
        row.back().x_end = x + 1;
      } else {
        row.push_back(square);
      }
    }
    for (const Strip& strip : row) add(strip, y);
  }
  return corners;
}

}  // namespace

EmbreeGeometry GroundGeometry(RTCDevice device, const HeightField& ground) {
  // Embree splits a cell of a grid between its second vertex of the first row and its first of the
  // second: with rows from south to north that is from south-east to north-west, as HeightField
  // splits it.
  const VertexGrid grid(ground.geometry());
  const auto side = static_cast<std::size_t>(grid.side);
  EmbreeGeometry geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_GRID));
  auto* vertices = static_cast<float*>(
      rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                              3 * sizeof(float), side * side));
  auto* cells = static_cast<RTCGrid*>(rtcSetNewGeometryBuffer(
      geometry.get(), RTC_BUFFER_TYPE_GRID, 0, RTC_FORMAT_GRID, sizeof(RTCGrid), 1));
  if (vertices == nullptr || cells == nullptr) return geometry;
  for (int y = 0; y < grid.side; ++y) {
    for (int x = 0; x < grid.side; ++x) {
      *vertices++ = grid.Coordinate_m(x);
      *vertices++ = grid.Coordinate_m(y);
      *vertices++ = grid.At(ground.height_m(), x, y);
    }
  }
  *cells = {0, static_cast<unsigned int>(side), static_cast<unsigned short>(side),
            static_cast<unsigned short>(side)};
  rtcCommitGeometry(geometry.get());
  return geometry;
}

EmbreeGeometry WaterGeometry(RTCDevice device, const Terrain& terrain) {
  const std::vector<Eigen::Vector3f> corners = WaterCorners(terrain);
  if (corners.empty()) return nullptr;
  EmbreeGeometry geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_QUAD));
  auto* vertices = static_cast<Eigen::Vector3f*>(
      rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                              sizeof(Eigen::Vector3f), corners.size()));
  auto* indices = static_cast<unsigned*>(
      rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT4,
                              4 * sizeof(unsigned), corners.size() / 4));
  if (vertices == nullptr || indices == nullptr) return geometry;
  std::copy(corners.begin(), corners.end(), vertices);
  for (unsigned i = 0; i < corners.size(); ++i) indices[i] = i;
  rtcCommitGeometry(geometry.get());
  return geometry;
}

}  // namespace latticeworld
