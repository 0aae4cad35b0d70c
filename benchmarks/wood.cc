#include "wood.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <utility>
#include <vector>

#include "latticeworld/common/random.h"

namespace latticeworld {
namespace {

std::shared_ptr<const Scene> Grow() {
  constexpr int kCells = 2000, kTrees = 100000;
  const GridGeometry geometry = GridGeometry::FromCells(kCells, 1000.0);
  Grid<float> height_m(kCells, kCells);
  for (int row = 0; row < kCells; ++row) {
    for (int col = 0; col < kCells; ++col) {
      const WorldPoint p = geometry.CenterOf({row, col});
      height_m(row, col) =
          static_cast<float>(20.0 * std::sin(p.x_m / 130.0 + 0.4) * std::cos(p.y_m / 170.0));
    }
  }
  auto terrain = std::make_shared<Terrain>();
  terrain->ground = HeightField(geometry, std::move(height_m));
  terrain->water_level_m = Grid<float>(kCells, kCells, std::numeric_limits<float>::quiet_NaN());
  terrain->surface = Grid<SurfaceClass>(kCells, kCells, SurfaceClass::kForestFloor);
  Scene wood;
  wood.terrain = terrain;
  const auto& models = wood.catalogue->models_of(AssetKind::kTree);
  RandomStream random(1, "wood");
  for (int i = 0; i < kTrees; ++i) {
    Asset tree;
    tree.model = models[static_cast<std::size_t>(i) % models.size()];
    tree.x_m = static_cast<float>(random.Uniform(-499.0, 499.0));
    tree.y_m = static_cast<float>(random.Uniform(-499.0, 499.0));
    tree.z_m = static_cast<float>(terrain->ground.HeightAt(tree.position()));
    tree.yaw_rad = static_cast<float>(random.Uniform(0.0, 6.28));
    tree.height_m = static_cast<float>(random.Uniform(8.0, 22.0));
    tree.half_length_m = tree.half_width_m = 0.2f * tree.height_m;
    tree.trunk_radius_m = 0.15f;
    wood.assets.push_back(tree);
  }
  wood.index = AssetIndex(geometry.size_m(), wood.assets);
  return std::make_shared<const Scene>(std::move(wood));
}

}  // namespace

std::shared_ptr<const Scene> KilometreOfWood() {
  static const std::shared_ptr<const Scene> wood = Grow();
  return wood;
}

EmbreeGeometry SolidTrees(RTCDevice device, const Scene& wood) {
  constexpr unsigned kMeridians = 6, kBands = 4, kSides = 7;
  std::vector<Eigen::Vector3f> points;
  std::vector<std::array<unsigned, 3>> corners;
  const auto around = [](unsigned k, unsigned count) {
    const float angle =
        2.0f * static_cast<float>(M_PI) * static_cast<float>(k % count) / static_cast<float>(count);
    return Eigen::Vector3f(std::cos(angle), std::sin(angle), 0.0f);
  };
  for (const Asset& tree : wood.assets) {
    const Eigen::Vector3f foot(tree.x_m, tree.y_m, tree.z_m);
    const Eigen::Vector3f middle = foot + 0.65f * tree.height_m * Eigen::Vector3f::UnitZ();
    const float half_m = 0.35f * tree.height_m;
    const auto first = static_cast<unsigned>(points.size());
    points.emplace_back(middle - half_m * Eigen::Vector3f::UnitZ());
    points.emplace_back(middle + half_m * Eigen::Vector3f::UnitZ());
    for (unsigned band = 1; band < kBands; ++band) {
      const float latitude = static_cast<float>(M_PI) * (static_cast<float>(band) / kBands - 0.5f);
      for (unsigned k = 0; k < kMeridians; ++k)
        points.emplace_back(middle +
                            tree.half_length_m * std::cos(latitude) * around(k, kMeridians) +
                            half_m * std::sin(latitude) * Eigen::Vector3f::UnitZ());
    }
    const auto on = [&](unsigned band, unsigned k) {
      return first + 2 + (band - 1) * kMeridians + k % kMeridians;
    };
    for (unsigned k = 0; k < kMeridians; ++k) {
      corners.push_back({first, on(1, k + 1), on(1, k)});
      corners.push_back({first + 1, on(kBands - 1, k), on(kBands - 1, k + 1)});
      for (unsigned band = 1; band + 1 < kBands; ++band) {
        corners.push_back({on(band, k), on(band, k + 1), on(band + 1, k)});
        corners.push_back({on(band, k + 1), on(band + 1, k + 1), on(band + 1, k)});
      }
    }
    const auto trunk = static_cast<unsigned>(points.size());
    for (unsigned k = 0; k < kSides; ++k) {
      points.emplace_back(foot + tree.trunk_radius_m * around(k, kSides));
      points.emplace_back(middle + tree.trunk_radius_m * around(k, kSides));
    }
    for (unsigned k = 0; k < kSides; ++k) {
      const unsigned here = trunk + 2 * k, next = trunk + 2 * ((k + 1) % kSides);
      corners.push_back({here, next, here + 1});
      corners.push_back({next, next + 1, here + 1});
    }
  }
  EmbreeGeometry geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE));
  void* vertices = rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0,
                                           RTC_FORMAT_FLOAT3, sizeof(points[0]), points.size());
  std::memcpy(vertices, points.data(), points.size() * sizeof(points[0]));
  void* triangles = rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0,
                                            RTC_FORMAT_UINT3, sizeof(corners[0]), corners.size());
  std::memcpy(triangles, corners.data(), corners.size() * sizeof(corners[0]));
  rtcCommitGeometry(geometry.get());
  return geometry;
}

}  // namespace latticeworld
