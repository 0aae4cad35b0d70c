#include "latticeworld/mapping/octree/octree.h"

#include <gtest/gtest.h>
#include <octomap/OcTree.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "latticeworld/common/random.h"
#include "mapping/octree/tree_data.h"
#include "mapping/scene_of_everything.h"
#include "mapping/voxels_of.h"

namespace latticeworld {
namespace {

std::shared_ptr<const octomap::OcTree> Build(const Scene& scene, const OctreeOptions& options) {
  const Progress progress;
  auto tree = BuildOctree(scene, options, progress);
  EXPECT_TRUE(tree.ok()) << tree.status().ToString();
  return *tree;
}

std::string TextOf(const OctreeData& data) { return {data.bytes.begin(), data.bytes.end()}; }

// The same map voxel by voxel, as the header describes it: the plain way that BuildOctree avoids.
class ReferenceMap {
 public:
  ReferenceMap(const Scene& scene, const OctreeOptions& options)
      : scene_(scene), options_(options), tree_(options.resolution_m) {
    const int first = KeyOf(-scene.geometry().half_size_m());
    const int last = -first - 1;
    for (int y = first; y <= last; ++y)
      for (int x = first; x <= last; ++x) AddColumn(x, y);
    tree_.updateInnerOccupancy();
    tree_.prune();
  }
  const octomap::OcTree& tree() const { return tree_; }

 private:
  int KeyOf(double coordinate_m) const {
    return static_cast<int>(std::floor(coordinate_m / options_.resolution_m));
  }
  double CenterOf(int key) const { return (key + 0.5) * options_.resolution_m; }
  int SurfaceOf(int x, int y) const {
    return KeyOf(scene_.terrain->ground.HeightAt({CenterOf(x), CenterOf(y)}));
  }
  void Occupy(int x, int y, int low, int high) {
    for (int z = low; z <= high; ++z)
      tree_.setNodeValue(CenterOf(x), CenterOf(y), CenterOf(z), tree_.getClampingThresMaxLog(),
                         true);
  }

  void AddColumn(int x, int y) {
    const int surface = SurfaceOf(x, y);
    int low = static_cast<int>(std::floor(surface - options_.thickness_m / options_.resolution_m));
    const int edge = -KeyOf(-scene_.geometry().half_size_m());
    for (int ny = std::max(y - 1, -edge); ny <= std::min(y + 1, edge - 1); ++ny)
      for (int nx = std::max(x - 1, -edge); nx <= std::min(x + 1, edge - 1); ++nx)
        low = std::min(low, SurfaceOf(nx, ny));
    Occupy(x, y, low, surface);
    for (const Asset& asset : scene_.assets) AddAsset(asset, x, y, surface);
  }

  void AddAsset(const Asset& asset, int x, int y, int surface) {
    const bool own = x == KeyOf(asset.x_m) && y == KeyOf(asset.y_m);
    const double dx = own ? 0.0 : CenterOf(x) - asset.x_m;
    const double dy = own ? 0.0 : CenterOf(y) - asset.y_m;
    const double distance = std::hypot(dx, dy);
    const auto stand = [&](double top_m) {
      Occupy(x, y, std::min(surface, KeyOf(asset.z_m)), KeyOf(asset.z_m + top_m));
    };
    const auto ellipsoid = [&](double bottom_m) {
      if (distance > asset.half_length_m) return;
      const double half_m = 0.5 * (asset.height_m - bottom_m);
      const double chord_m = half_m * std::sqrt(1.0 - std::pow(distance / asset.half_length_m, 2));
      const double middle_m = asset.z_m + bottom_m + half_m;
      Occupy(x, y, KeyOf(middle_m - chord_m), KeyOf(middle_m + chord_m));
    };
    switch (asset.kind) {
      case AssetKind::kTree:
        if (distance <= asset.trunk_radius_m) stand(0.65 * asset.height_m);
        ellipsoid(0.3 * asset.height_m);
        break;
      case AssetKind::kBush:
        ellipsoid(0.0);
        break;
      case AssetKind::kStone:
        if (distance <= asset.half_length_m) stand(asset.height_m);
        break;
      case AssetKind::kBuilding: {
        const double c = std::cos(asset.yaw_rad), s = std::sin(asset.yaw_rad);
        if (std::abs(c * dx + s * dy) <= asset.half_length_m &&
            std::abs(c * dy - s * dx) <= asset.half_width_m)
          stand(asset.height_m);
        break;
      }
      default:
        break;
    }
  }

  const Scene& scene_;
  const OctreeOptions options_;
  octomap::OcTree tree_;
};

TEST(OctreeTest, IsTheTreeOfUpdatesVoxelByVoxelDownToEveryNode) {
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    for (const double resolution_m : {0.5, 0.31, 1.7, 0.25, 6.0}) {
      const Scene scene = SceneOfEverything(seed);
      const OctreeOptions options = {resolution_m, 1.0};
      const auto tree = Build(scene, options);
      const ReferenceMap reference(scene, options);
      EXPECT_EQ(VoxelsOf(*tree), VoxelsOf(reference.tree())) << seed << " at " << resolution_m;
      // Pruned alike, with the same values inside: the same bytes.
      EXPECT_EQ(FullData(*tree).bytes, FullData(reference.tree()).bytes)
          << seed << " at " << resolution_m;
      EXPECT_EQ(tree->size(), reference.tree().size());
      EXPECT_EQ(tree->size(), tree->calcNumNodes());
      const OctreeData binary = BuildBinaryData(scene, options, Progress()).value();
      EXPECT_EQ(binary.bytes, BinaryData(reference.tree()).bytes) << seed << " at " << resolution_m;
      EXPECT_EQ(binary.nodes, tree->size());
      const OctreeData full = BuildFullData(scene, options, Progress()).value();
      EXPECT_EQ(full.bytes, FullData(reference.tree()).bytes) << seed << " at " << resolution_m;
      EXPECT_EQ(full.nodes, tree->size());
    }
  }
}

// Worlds of several tiles of 128 columns, thin and thick ground, depths that fill whole tiles.
TEST(OctreeTest, StreamsAreThoseOfTheTreeOverManyTiles) {
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    RandomStream random(seed, "many_tiles");
    const int cells = random.UniformInt(33, 200);
    const double cell_m = random.Uniform(0.2, 1.1), steepness = random.Uniform(0.0, 3.0);
    std::vector<Asset> assets;
    for (int i = 0; i < 40; ++i) {
      const double half_m = 0.5 * cells * cell_m;
      assets.push_back(MakeTree(static_cast<float>(random.Uniform(-half_m, half_m)),
                                static_cast<float>(random.Uniform(-half_m, half_m)), 7.0f, 2.2f,
                                0.3f));
    }
    const Scene scene =
        WithAssets(MakeScene(cells, cells * cell_m,
                             [&](double x_m, double y_m) { return steepness * Hills(x_m, y_m); }),
                   assets);
    for (const double thickness_m : {0.0, 1.0, 90.0}) {
      const OctreeOptions options = {random.Uniform(0.2, 0.5), thickness_m};
      const auto tree = Build(scene, options);
      const OctreeData binary = BuildBinaryData(scene, options, Progress()).value();
      EXPECT_EQ(binary.bytes, BinaryData(*tree).bytes) << seed;
      EXPECT_EQ(binary.nodes, tree->calcNumNodes()) << seed;
      const OctreeData full = BuildFullData(scene, options, Progress()).value();
      EXPECT_EQ(full.bytes, FullData(*tree).bytes) << seed;
      EXPECT_EQ(full.nodes, tree->calcNumNodes()) << seed;
      octomap::OcTree pruned(*tree);
      pruned.prune();
      EXPECT_EQ(pruned.calcNumNodes(), tree->size()) << seed << ": not pruned";
    }
  }
}

TEST(OctreeTest, AnyNumberOfThreadsMakesTheSameBytes) {
  const Scene scene = SceneOfEverything(5);
  OctreeOptions options = {0.1, 1.0};
  options.threads = 1;
  const OctreeData one = BuildBinaryData(scene, options, Progress()).value();
  const auto tree = Build(scene, options);
  for (const int threads : {2, 3, 7}) {
    options.threads = threads;
    EXPECT_EQ(BuildBinaryData(scene, options, Progress()).value().bytes, one.bytes);
    EXPECT_EQ(FullData(*Build(scene, options)).bytes, FullData(*tree).bytes);
  }
}

TEST(OctreeTest, SurfaceAgreesWithHeightAtWithinOneVoxel) {
  const Scene scene = MakeScene(128, 64.0, Hills);
  const auto tree = Build(scene, {0.5, 1.0});
  RandomStream random(7, "points");
  for (int i = 0; i < 1000; ++i) {
    const WorldPoint point = {random.Uniform(-32.0, 32.0), random.Uniform(-32.0, 32.0)};
    double top_m = -1e9;
    for (double z_m = -8.25; z_m < 8.0; z_m += 0.5) {
      if (tree->search(point.x_m, point.y_m, z_m) != nullptr) top_m = z_m;
    }
    EXPECT_NEAR(top_m, scene.terrain->ground.HeightAt(point), 0.5) << point.x_m << " " << point.y_m;
  }
}

TEST(OctreeTest, SteepGroundHasNoHoles) {
  // A cliff of 20 m: each column reaches down to its lower neighbour's surface.
  const Scene scene =
      MakeScene(64, 32.0, [](double x_m, double) { return x_m < 0.0 ? 0.2 : 20.2; });
  const auto tree = Build(scene, {0.5, 0.0});
  for (double z_m = 0.75; z_m < 20.0; z_m += 0.5)
    EXPECT_NE(tree->search(0.25, 3.25, z_m), nullptr) << z_m;
}

TEST(OctreeTest, WaterIsNotOccupiedButItsBedIs) {
  const Scene scene = WithWater(MakeScene(32, 16.0, [](double, double) { return -3.1; }), 0.0f);
  const auto tree = Build(scene, {0.5, 1.0});
  EXPECT_NE(tree->search(1.0, 1.0, -3.1), nullptr);
  for (double z_m = -2.9; z_m < 1.0; z_m += 0.25)
    EXPECT_EQ(tree->search(1.0, 1.0, z_m), nullptr) << z_m;
}

TEST(OctreeTest, AboveTheGroundNothingIsKnown) {
  const auto tree = Build(MakeScene(32, 16.0, [](double, double) { return 1.1; }), {0.5, 1.0});
  EXPECT_EQ(tree->search(0.1, 0.1, 1.6), nullptr);
  EXPECT_EQ(tree->search(0.1, 0.1, -1.1), nullptr);
  EXPECT_EQ(tree->search(8.6, 0.1, 1.1), nullptr);
}

TEST(OctreeTest, BinaryDataReadsBackAsOctomapReadsIt) {
  const auto tree = Build(SceneOfEverything(11), {0.5, 1.0});
  std::istringstream stream(TextOf(BinaryData(*tree)));
  octomap::OcTree read(0.5);
  read.readBinaryData(stream);
  EXPECT_EQ(VoxelsOf(read), VoxelsOf(*tree));

  std::istringstream file(BinaryFile(BinaryData(*tree), 0.5));
  octomap::OcTree from_file(0.1);
  ASSERT_TRUE(from_file.readBinary(file));
  EXPECT_EQ(from_file.getResolution(), 0.5);
  EXPECT_EQ(VoxelsOf(from_file), VoxelsOf(*tree));

  std::istringstream full(TextOf(FullData(*tree)));
  octomap::OcTree from_full(0.5);
  from_full.readData(full);
  EXPECT_TRUE(from_full == *tree);
}

TEST(OctreeTest, RefusesIllegalOptionsAndNamesThemAll) {
  const Scene scene = MakeScene(32, 16.0, Hills);
  const Progress progress;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const OctreeOptions& options :
       {OctreeOptions{0.0, 1.0}, OctreeOptions{-0.5, 1.0}, OctreeOptions{nan, 1.0},
        OctreeOptions{17.0, 1.0}, OctreeOptions{0.5, -1.0}, OctreeOptions{0.5, nan}}) {
    const auto tree = BuildOctree(scene, options, progress);
    ASSERT_FALSE(tree.ok());
    EXPECT_EQ(tree.status().code(), StatusCode::kInvalidArgument);
    EXPECT_EQ(tree.status().violations().size(), 1u);
  }
  EXPECT_EQ(BuildOctree(scene, {nan, nan}, progress).status().violations().size(), 2u);
}

TEST(OctreeTest, RefusesVoxelsTooFineForTheWorld) {
  const Progress progress;
  const Scene wide = MakeScene(32, 4096.0, [](double, double) { return 0.0; });
  EXPECT_FALSE(BuildOctree(wide, {0.4, 1.0}, progress).ok());
  EXPECT_TRUE(BuildOctree(wide, {16.0, 1.0}, progress).ok());
  const Scene high = MakeScene(32, 16.0, [](double x_m, double) { return x_m * 1100.0; });
  EXPECT_FALSE(BuildOctree(high, {0.05, 1.0}, progress).ok());
}

TEST(OctreeTest, StopsWhenCancelled) {
  Progress progress;
  progress.Cancel();
  EXPECT_EQ(BuildOctree(SceneOfEverything(1), {}, progress).status().code(),
            StatusCode::kCancelled);
}

}  // namespace
}  // namespace latticeworld
