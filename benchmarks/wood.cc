#include "wood.h"

#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

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

}  // namespace latticeworld
