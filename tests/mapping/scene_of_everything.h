#ifndef LATTICEWORLD_TESTS_MAPPING_SCENE_OF_EVERYTHING_H_
#define LATTICEWORLD_TESTS_MAPPING_SCENE_OF_EVERYTHING_H_

#include <cmath>
#include <cstdint>
#include <vector>

#include "latticeworld/common/random.h"
#include "mapping/hand_made_scene.h"

namespace latticeworld {

inline double Hills(double x_m, double y_m) {
  return 3.0 * std::sin(x_m / 5.0) + 2.0 * std::cos(y_m / 3.0) + 0.7;
}

// 32 m of hills at 0.5 m with six trees, bushes and stones, a building and a flower; the trees are
// assets 0, 3, 6 and so on.
inline Scene SceneOfEverything(std::uint64_t seed) {
  RandomStream random(seed, "octree_test");
  const auto place = [&] { return static_cast<float>(random.Uniform(-15.0, 15.0)); };
  std::vector<Asset> assets;
  for (int i = 0; i < 6; ++i) {
    assets.push_back(MakeTree(place(), place(), static_cast<float>(random.Uniform(3.0, 9.0)),
                              static_cast<float>(random.Uniform(0.8, 2.5)), 0.31f));
    assets.push_back(MakeRound(AssetKind::kBush, place(), place(), 1.3f, 0.9f));
    assets.push_back(MakeRound(AssetKind::kStone, place(), place(), 1.1f, 0.8f));
  }
  assets.push_back(MakeBuilding(place(), place(), 7.3f, 4.1f, 2.7f,
                                static_cast<float>(random.Uniform(0.0, 3.0))));
  assets.push_back(MakeRound(AssetKind::kFlower, 1.1f, 1.1f, 9.0f, 3.0f));
  return WithAssets(MakeScene(64, 32.0, Hills), assets);
}

}  // namespace latticeworld

#endif  // LATTICEWORLD_TESTS_MAPPING_SCENE_OF_EVERYTHING_H_
