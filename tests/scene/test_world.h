#ifndef LATTICEWORLD_TESTS_SCENE_TEST_WORLD_H_
#define LATTICEWORLD_TESTS_SCENE_TEST_WORLD_H_

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "latticeworld/scene/scene.h"

namespace latticeworld {

// A terrain made by hand, so that these tests know what the ground is.
struct TestGround {
  Vocabulary vocabulary = Vocabulary::kSuburb;
  double size_m = 256.0;
  int cells = 256;
  std::function<char(WorldPoint)> letter_at;
  std::function<double(WorldPoint)> height_at_m = [](WorldPoint) { return 0.0; };
  // Of the water; NaN: dry.
  std::function<double(WorldPoint)> water_at_m = [](WorldPoint) { return NAN; };
};
// Weights are 1 for the letter of each cell. Suburb's R is road.
std::shared_ptr<const Terrain> MakeTerrain(const TestGround& ground);

// Level ground of one class, dry.
std::shared_ptr<const Terrain> MakeUniform(Vocabulary vocabulary, char letter,
                                           double size_m = 256.0);

// Hills, patches of every letter about 32 m wide and lakes 3.5 m deep where the letter is W.
std::shared_ptr<const Terrain> MakePatchwork(Vocabulary vocabulary, std::uint64_t seed);

// Every density at `density`, the first variant and material of each type, summer, sunny.
EnvironmentConfig MakeEnvironment(double density);

// The request of a scene with the built-in catalogue.
SceneRequest MakeRequest(std::shared_ptr<const Terrain> terrain,
                         const EnvironmentConfig& environment, std::uint64_t seed);

// What BuildScene says; fails the test when it fails.
SceneAnswer Build(std::shared_ptr<const Terrain> terrain, const EnvironmentConfig& environment,
                  std::uint64_t seed);

std::vector<Asset> OfKind(const Scene& scene, AssetKind kind);
bool SameBytes(const std::vector<Asset>& a, const std::vector<Asset>& b);
int CountOf(const Scene& scene, AssetKind kind);

}  // namespace latticeworld

#endif  // LATTICEWORLD_TESTS_SCENE_TEST_WORLD_H_
