#include "latticeworld/exporting/ground_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "latticeworld/geometry/grid.h"
#include "latticeworld/rendering/looks/ground_colors.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {
namespace {

constexpr int kTextureQuality = 92;  // of the JPEG, [0, 100]
constexpr float kDry = -std::numeric_limits<float>::infinity();

Eigen::Vector2f TextureCoordinate(const SurfaceLattice& lattice, int row, int col) {
  return {static_cast<float>(col) / static_cast<float>(lattice.cols - 1),
          static_cast<float>(row) / static_cast<float>(lattice.rows - 1)};
}

// Adds both triangles of a quad by the numbers of its vertices.
void AddQuad(std::uint32_t north_west, std::uint32_t north_east, std::uint32_t south_west,
             std::uint32_t south_east, std::vector<std::uint32_t>* corners) {
  corners->insert(corners->end(), {north_west, south_west, south_east});
  corners->insert(corners->end(), {north_west, south_east, north_east});
}

// Level of the water over the vertices [m], carried one vertex into land above it; kDry elsewhere.
Grid<float> WaterLevels(const Terrain& terrain, const SurfaceLattice& lattice) {
  Grid<float> wet(lattice.rows, lattice.cols, kDry);
  for (int row = 0; row < lattice.rows; ++row) {
    for (int col = 0; col < lattice.cols; ++col) {
      const float level =
          terrain.water_level_m[terrain.geometry().CellAt(lattice.PointOf(row, col))];
      if (!std::isnan(level)) wet(row, col) = level;
    }
  }
  Grid<float> levels = wet;
  for (int row = 0; row < lattice.rows; ++row) {
    for (int col = 0; col < lattice.cols; ++col) {
      if (wet(row, col) != kDry) continue;
      float level = kDry;
      for (int r = row - 1; r <= row + 1; ++r) {
        for (int c = col - 1; c <= col + 1; ++c) level = std::max(level, wet.Clamped(r, c));
      }
      if (level <= terrain.ground.HeightAt(lattice.PointOf(row, col))) levels(row, col) = level;
    }
  }
  return levels;
}

}  // namespace

SurfaceLattice MakeLattice(const ExportRegion& region, double spacing_m, int most_vertices) {
  const double longest_m = std::max(region.width_m(), region.depth_m());
  const double step_m = std::max(spacing_m, longest_m / (most_vertices - 1));
  const auto vertices = [&](double length_m) {
    // A hair less, so that what fits evenly does.
    return std::clamp(1 + static_cast<int>(std::ceil(length_m / step_m - 1e-6)), 2, most_vertices);
  };
  return {region, vertices(region.depth_m()), vertices(region.width_m())};
}

SurfaceMesh GroundMesh(const Terrain& terrain, const SurfaceLattice& lattice) {
  SurfaceMesh mesh;
  const std::size_t vertices = static_cast<std::size_t>(lattice.rows) * lattice.cols;
  mesh.positions_m.reserve(vertices);
  mesh.texture_coordinates.reserve(vertices);
  for (int row = 0; row < lattice.rows; ++row) {
    for (int col = 0; col < lattice.cols; ++col) {
      const WorldPoint point = lattice.PointOf(row, col);
      mesh.positions_m.push_back(
          Eigen::Vector3d(point.x_m, point.y_m, terrain.ground.HeightAt(point)).cast<float>());
      mesh.texture_coordinates.push_back(TextureCoordinate(lattice, row, col));
    }
  }
  mesh.normals.assign(vertices, Eigen::Vector3f::Zero());
  for (int row = 0; row + 1 < lattice.rows; ++row) {
    for (int col = 0; col + 1 < lattice.cols; ++col) {
      const auto at = static_cast<std::uint32_t>(row * lattice.cols + col);
      const auto below = at + static_cast<std::uint32_t>(lattice.cols);
      AddQuad(at, at + 1, below, below + 1, &mesh.corners);
    }
  }
  for (std::size_t i = 0; i < mesh.corners.size(); i += 3) {
    const Eigen::Vector3f& a = mesh.positions_m[mesh.corners[i]];
    const Eigen::Vector3f normal = (mesh.positions_m[mesh.corners[i + 1]] - a)
                                       .cross(mesh.positions_m[mesh.corners[i + 2]] - a);
    for (int k = 0; k < 3; ++k) mesh.normals[mesh.corners[i + k]] += normal;
  }
  for (Eigen::Vector3f& normal : mesh.normals) normal.normalize();
  return mesh;
}

SurfaceMesh WaterMesh(const Terrain& terrain, const SurfaceLattice& lattice) {
  const Grid<float> levels = WaterLevels(terrain, lattice);
  SurfaceMesh mesh;
  constexpr std::uint32_t kNone = ~0u;
  Grid<std::uint32_t> numbers(lattice.rows, lattice.cols, kNone);
  const auto vertex = [&](int row, int col) {
    if (numbers(row, col) == kNone) {
      numbers(row, col) = static_cast<std::uint32_t>(mesh.positions_m.size());
      const WorldPoint point = lattice.PointOf(row, col);
      mesh.positions_m.emplace_back(static_cast<float>(point.x_m), static_cast<float>(point.y_m),
                                    levels(row, col));
      mesh.normals.push_back(Eigen::Vector3f::UnitZ());
      mesh.texture_coordinates.push_back(TextureCoordinate(lattice, row, col));
    }
    return numbers(row, col);
  };
  for (int row = 0; row + 1 < lattice.rows; ++row) {
    for (int col = 0; col + 1 < lattice.cols; ++col) {
      if (levels(row, col) == kDry || levels(row, col + 1) == kDry ||
          levels(row + 1, col) == kDry || levels(row + 1, col + 1) == kDry) {
        continue;
      }
      const std::uint32_t nw = vertex(row, col), ne = vertex(row, col + 1);
      const std::uint32_t sw = vertex(row + 1, col), se = vertex(row + 1, col + 1);
      AddQuad(nw, ne, sw, se, &mesh.corners);
    }
  }
  return mesh;
}

Result<std::string> GroundTexture(const Scene& scene, const ExportRegion& region, int most_px) {
  try {
    const cv::Mat whole = MaterialsOf(scene).color;
    const GridGeometry& geometry = scene.geometry();
    // The part that is cut out consists of whole cells, at least one.
    const auto first = [](double cell) { return static_cast<int>(std::floor(cell + 0.5 + 1e-6)); };
    const auto last = [](double cell) { return static_cast<int>(std::ceil(cell + 0.5 - 1e-6)); };
    const int west = std::clamp(first(geometry.ColOf(region.west_m)), 0, whole.cols - 1);
    const int north = std::clamp(first(geometry.RowOf(region.north_m)), 0, whole.rows - 1);
    const int east = std::clamp(last(geometry.ColOf(region.east_m)), west + 1, whole.cols);
    const int south = std::clamp(last(geometry.RowOf(region.south_m)), north + 1, whole.rows);
    cv::Mat color = whole(cv::Rect(west, north, east - west, south - north));
    const int longest = std::max(color.cols, color.rows);
    if (longest > most_px) {
      const double scale = static_cast<double>(most_px) / longest;
      const cv::Size size(std::max(1L, std::lround(scale * color.cols)),
                          std::max(1L, std::lround(scale * color.rows)));
      cv::Mat smaller;
      cv::resize(color, smaller, size, 0.0, 0.0, cv::INTER_AREA);
      color = smaller;
    }
    cv::Mat bytes;
    color.convertTo(bytes, CV_8UC3, 255.0);
    std::vector<unsigned char> jpeg;
    if (!cv::imencode(".jpg", bytes, jpeg, {cv::IMWRITE_JPEG_QUALITY, kTextureQuality}))
      return Internal("cannot encode the ground's colours");
    return std::string(jpeg.begin(), jpeg.end());
  } catch (const cv::Exception& error) {
    return Internal(std::string("cannot paint the ground: ") + error.what());
  }
}

}  // namespace latticeworld
