#ifndef LATTICEWORLD_TESTS_MAPPING_HAND_MADE_SCENE_H_
#define LATTICEWORLD_TESTS_MAPPING_HAND_MADE_SCENE_H_

#include <cmath>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "latticeworld/scene/scene.h"

namespace latticeworld {

// A dry grassy scene without assets whose cell centres are at height(x_m, y_m).
template <typename Height>
Scene MakeScene(int cells, double size_m, Height&& height) {
  const GridGeometry geometry = GridGeometry::FromCells(cells, size_m);
  Grid<float> height_m(cells, cells);
  for (int row = 0; row < cells; ++row) {
    for (int col = 0; col < cells; ++col) {
      const WorldPoint point = geometry.CenterOf({row, col});
      height_m(row, col) = static_cast<float>(height(point.x_m, point.y_m));
    }
  }
  auto terrain = std::make_shared<Terrain>();
  terrain->ground = HeightField(geometry, std::move(height_m));
  terrain->water_level_m = Grid<float>(cells, cells, std::numeric_limits<float>::quiet_NaN());
  terrain->surface = Grid<SurfaceClass>(cells, cells, SurfaceClass::kGrass);
  Scene scene;
  scene.terrain = terrain;
  return scene;
}

// The scene with those assets, each put on the ground.
inline Scene WithAssets(Scene scene, std::vector<Asset> assets) {
  for (Asset& asset : assets)
    asset.z_m = static_cast<float>(scene.terrain->ground.HeightAt(asset.position()));
  scene.assets = std::move(assets);
  scene.index = AssetIndex(scene.geometry().size_m(), scene.assets);
  return scene;
}

// The scene with water up to level_m wherever the ground is lower.
inline Scene WithWater(Scene scene, float level_m) {
  auto terrain = std::make_shared<Terrain>(*scene.terrain);
  const Grid<float>& height_m = terrain->ground.height_m();
  for (int row = 0; row < height_m.rows(); ++row) {
    for (int col = 0; col < height_m.cols(); ++col)
      if (height_m(row, col) < level_m) terrain->water_level_m(row, col) = level_m;
  }
  scene.terrain = terrain;
  return scene;
}

// The scene with its ground made of surface(x_m, y_m).
template <typename Surface>
Scene WithSurfaces(Scene scene, Surface&& surface) {
  auto terrain = std::make_shared<Terrain>(*scene.terrain);
  for (int row = 0; row < terrain->surface.rows(); ++row) {
    for (int col = 0; col < terrain->surface.cols(); ++col) {
      const WorldPoint point = scene.geometry().CenterOf({row, col});
      terrain->surface(row, col) = surface(point.x_m, point.y_m);
    }
  }
  scene.terrain = terrain;
  return scene;
}

inline Asset MakeTree(float x_m, float y_m, float height_m, float crown_m, float trunk_m) {
  Asset tree;
  tree.kind = AssetKind::kTree;
  tree.model = Catalogue::BuiltIn()->models_of(tree.kind).front();
  tree.x_m = x_m;
  tree.y_m = y_m;
  tree.height_m = height_m;
  tree.half_length_m = tree.half_width_m = crown_m;
  tree.trunk_radius_m = trunk_m;
  return tree;
}

inline Asset MakeRound(AssetKind kind, float x_m, float y_m, float height_m, float radius_m) {
  Asset asset = MakeTree(x_m, y_m, height_m, radius_m, 0.0f);
  asset.kind = kind;
  asset.model = Catalogue::BuiltIn()->models_of(kind).front();
  return asset;
}

inline Asset MakeBuilding(float x_m, float y_m, float height_m, float half_length_m,
                          float half_width_m, float yaw_rad) {
  Asset building = MakeRound(AssetKind::kBuilding, x_m, y_m, height_m, half_length_m);
  building.half_width_m = half_width_m;
  building.yaw_rad = yaw_rad;
  return building;
}

}  // namespace latticeworld

#endif  // LATTICEWORLD_TESTS_MAPPING_HAND_MADE_SCENE_H_
