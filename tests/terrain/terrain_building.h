#ifndef LATTICEWORLD_TESTS_TERRAIN_TERRAIN_BUILDING_H_
#define LATTICEWORLD_TESTS_TERRAIN_TERRAIN_BUILDING_H_

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "latticeworld/geomorphology/slope.h"
#include "latticeworld/terrain/terrain.h"
#include "latticeworld/terrain/water/shallow_rivers.h"
#include "terrain/test_layouts.h"

namespace latticeworld {

inline Terrain Build(const SymbolicLayout& layout, const GridGeometry& geometry, std::uint64_t seed,
                     const Relief* relief = nullptr) {
  TerrainRequest request;
  request.geometry = geometry;
  request.layout = &layout;
  request.relief = relief;
  request.seed = seed;
  request.options.fords = RiversAreShallow(geometry.size_m());
  return BuildTerrain(request, Progress()).value();
}

// Falls by 40 m from north to south along a valley in the middle whose sides rise by 25 m.
inline Relief Valley() {
  Grid<float> height_m(100, 140);
  for (int r = 0; r < 100; ++r) {
    for (int c = 0; c < 140; ++c) {
      const double u = (c + 0.5) / 140.0 - 0.52;
      height_m(r, c) = static_cast<float>(40.0 * (1.0 - r / 99.0) + 100.0 * u * u +
                                          1.5 * std::sin(0.3 * r) * std::sin(0.21 * c));
    }
  }
  return MakeRelief(std::move(height_m));
}

// Hills 40 m high whose sides slope by up to 40 % in a world of 512 m.
inline Relief Hills() {
  Grid<float> height_m(129, 129);
  for (int r = 0; r < 129; ++r) {
    for (int c = 0; c < 129; ++c) {
      height_m(r, c) = static_cast<float>(20.0 + 20.0 * std::sin(0.09 * r) * std::cos(0.08 * c));
    }
  }
  return MakeRelief(std::move(height_m));
}

inline bool IsWet(const Terrain& terrain, int r, int c) {
  return !std::isnan(terrain.water_level_m(r, c));
}

// 1 on and below the decks of bridges, and as far around them as asked.
inline Grid<unsigned char> AtDecks(const Terrain& terrain, double around_m) {
  const GridGeometry& geometry = terrain.geometry();
  Grid<unsigned char> at(geometry.rows(), geometry.cols(), 0);
  for (const Bridge& bridge : terrain.bridges) {
    for (const BridgePart& part : PartsOf(bridge, terrain.ground)) {
      if (part.kind != BridgePartKind::kDeck) continue;
      const double cosine = std::cos(part.yaw_rad), sine = std::sin(part.yaw_rad);
      for (int r = 0; r < at.rows(); ++r) {
        for (int c = 0; c < at.cols(); ++c) {
          const WorldPoint point = geometry.CenterOf({r, c});
          const double dx = point.x_m - part.middle.x_m, dy = point.y_m - part.middle.y_m;
          if (std::abs(cosine * dx + sine * dy) <= part.half_length_m + around_m &&
              std::abs(cosine * dy - sine * dx) <= part.half_width_m + around_m) {
            at(r, c) = 1;
          }
        }
      }
    }
  }
  return at;
}

// Abutments, whose faces are steep, are left out.
inline std::vector<double> SlopesOfClass_deg(const Terrain& terrain, SurfaceClass surface) {
  const Grid<float> slope =
      GradientMagnitude(terrain.ground.height_m(), terrain.geometry().resolution_m());
  constexpr double kAbutment_m = 6.0;
  const Grid<unsigned char> abutment = AtDecks(terrain, kAbutment_m);
  std::vector<double> slopes;
  for (int r = 0; r < slope.rows(); ++r) {
    for (int c = 0; c < slope.cols(); ++c) {
      if (terrain.surface(r, c) == surface && abutment(r, c) == 0) {
        slopes.push_back(std::atan(slope(r, c)) * 180.0 / M_PI);
      }
    }
  }
  std::sort(slopes.begin(), slopes.end());
  return slopes;
}

// The value below which `share` of the sorted ones lie; 0 of none.
inline double At(const std::vector<double>& sorted, double share) {
  return sorted.empty() ? 0.0 : sorted[static_cast<std::size_t>(share * (sorted.size() - 1))];
}

}  // namespace latticeworld

#endif  // LATTICEWORLD_TESTS_TERRAIN_TERRAIN_BUILDING_H_
