#include "latticeworld/mapping/octree/ground_voxels.h"

#include <gtest/gtest.h>

#include <vector>

#include "latticeworld/common/random.h"
#include "mapping/hand_made_scene.h"

namespace latticeworld {
namespace {

TEST(GroundVoxelsTest, AreTheVoxelsOfHeightAtToTheBit) {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    RandomStream random(seed, "ground_voxels");
    const int cells = random.UniformInt(32, 70);
    const double cell_m = seed % 3 == 0 ? 0.5 : random.Uniform(0.1, 2.0);
    const double voxel_m = seed % 2 == 0 ? cell_m : random.Uniform(0.05, 3.0);
    const HeightField ground = MakeScene(cells, cells * cell_m, [&](double, double) {
                                 return random.Chance(0.1) ? 0.0 : random.Uniform(-5.0, 5.0);
                               }).terrain->ground;
    const int half = static_cast<int>(0.5 * cells * cell_m / voxel_m);
    const VoxelBox box = {-half - 2, half + 2, -half - 1, half + 1, 0, 0};  // beyond the edge too
    const GroundVoxels voxels(ground, voxel_m, box);
    for (int y = box.y_low; y <= box.y_high; ++y) {
      const int x_low = random.UniformInt(box.x_low, box.x_high);
      std::vector<std::int16_t> surface(box.x_high - x_low + 1);
      voxels.SampleRow(y, x_low, box.x_high, surface.data());
      for (int x = x_low; x <= box.x_high; ++x) {
        const double height_m =
            ground.HeightAt({VoxelCenter_m(x, voxel_m), VoxelCenter_m(y, voxel_m)});
        ASSERT_EQ(surface[x - x_low], VoxelIndexOf(height_m, voxel_m)) << x << " " << y;
      }
    }
  }
}

}  // namespace
}  // namespace latticeworld
