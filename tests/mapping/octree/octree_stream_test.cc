#include "latticeworld/mapping/octree/octree_stream.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "latticeworld/common/random.h"
#include "latticeworld/scene/props/props.h"
#include "latticeworld/scene/props/standing_props.h"
#include "mapping/scene_of_everything.h"

namespace latticeworld {
namespace {

// 3 x 3 tiles of 128 columns and a bit, with a hundred trees.
std::shared_ptr<const Scene> Forest(std::uint64_t seed) {
  RandomStream random(seed, "forest");
  std::vector<Asset> trees;
  for (int i = 0; i < 100; ++i)
    trees.push_back(MakeTree(static_cast<float>(random.Uniform(-50.0, 50.0)),
                             static_cast<float>(random.Uniform(-50.0, 50.0)),
                             static_cast<float>(random.Uniform(2.0, 9.0)), 1.5f, 0.2f));
  return std::make_shared<const Scene>(WithAssets(MakeScene(100, 100.0, Hills), trees));
}

// The tree, lying with its foot where it stood or, like a stem that slid, some metres off.
FallenTree Felled(const Scene& scene, std::uint32_t asset, double heading_rad,
                  double slid_m = 0.0) {
  const Asset& tree = scene.assets[asset];
  const Eigen::Vector3d way(std::cos(heading_rad), std::sin(heading_rad), 0.0);
  const Eigen::Vector3d foot = Eigen::Vector3d(tree.x_m, tree.y_m, tree.z_m) + slid_m * way;
  return {asset, foot, foot + tree.height_m * way};
}

TEST(OctreeStreamTest, IsAfterEveryChangeTheStreamOfTheWholeMap) {
  const Progress progress;
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    const auto scene = Forest(seed);
    OctreeOptions options = {0.25, 1.0};
    if (seed == 2) options.box = MapBox{10.0, -5.0, 0.0, 25.0, 30.0, 20.0};
    auto binary =
        OctreeStream::Create(scene, OctreeStream::Format::kBinary, options, progress).value();
    auto full = OctreeStream::Create(scene, OctreeStream::Format::kFull, options, progress).value();
    RandomStream random(seed, "falling");
    SceneChanges changes;
    for (std::uint32_t asset = 0; asset < 30; asset += 3) {
      const OctreeData data = binary.Update(changes, progress).value();
      const OctreeData whole = BuildBinaryData(*scene, options, progress, changes).value();
      EXPECT_EQ(data.bytes, whole.bytes) << seed << " " << asset;
      EXPECT_EQ(data.nodes, whole.nodes);
      EXPECT_EQ(full.Update(changes, progress).value().bytes,
                BuildFullData(*scene, options, progress, changes).value().bytes);
      if (asset > 0) {
        EXPECT_LE(binary.tiles_written(), 12);
      }
      // One falls, one goes, and of what fell before one is taken away.
      changes.fallen.push_back(
          Felled(*scene, asset, random.Uniform(0.0, 6.28), random.Uniform(0.0, 9.0)));
      changes.gone.push_back(asset + 1);
      if (changes.fallen.size() == 4) {
        changes.gone.push_back(changes.fallen.front().asset);
        std::sort(changes.gone.begin(), changes.gone.end());
        changes.fallen.erase(changes.fallen.begin());
      }
    }
    // And back to the start.
    EXPECT_EQ(binary.Update({}, progress).value().bytes,
              BuildBinaryData(*scene, options, progress).value().bytes);
  }
}

TEST(OctreeStreamTest, FollowsPropsThatMoveComeAndGo) {
  auto scene = std::make_shared<Scene>(*Forest(1));
  for (int i = 0; i < 6; ++i) {
    Prop crate = UsualProp(i == 0 ? PropKind::kBridge : PropKind::kCrate);
    crate.position = {-40.0 + 14.0 * i, 10.0};
    crate.z_m = scene->terrain->ground.HeightAt(crate.position);
    scene->props.push_back(crate);
  }
  const OctreeOptions options = {0.25, 1.0};
  auto stream =
      OctreeStream::Create(scene, OctreeStream::Format::kBinary, options, Progress()).value();
  auto props = StandingAtBegin(scene->props);
  SceneChanges changes;
  for (int round = 0; round < 6; ++round) {
    EXPECT_EQ(stream.Update(changes, Progress()).value().bytes,
              BuildBinaryData(*scene, options, Progress(), changes).value().bytes)
        << round;
    if (round > 0) {
      EXPECT_GE(stream.tiles_written(), 1) << round;
      EXPECT_LE(stream.tiles_written(), 4) << round;
    }
    if (round == 0) props.blocks[1].footprint.centre.y_m += 30.0;
    if (round == 1) props.blocks[2].top_m += 1.0;
    if (round == 2) props.decks.clear();
    if (round == 3) props.blocks.erase(props.blocks.begin());
    if (round == 4) props.blocks.push_back(props.blocks.back());
    if (round == 4) props.blocks.back().footprint.centre = {20.0, -20.0};
    changes.props = std::make_shared<const StandingProps>(props);
  }
  EXPECT_EQ(stream.Update({}, Progress()).value().bytes,
            BuildBinaryData(*scene, options, Progress()).value().bytes);
}

TEST(OctreeStreamTest, WithoutAChangeNothingIsWritten) {
  auto stream =
      OctreeStream::Create(Forest(1), OctreeStream::Format::kBinary, {0.25, 1.0}, Progress())
          .value();
  const OctreeData first = stream.Update({}, Progress()).value();
  EXPECT_GT(stream.tiles_written(), 9);
  EXPECT_EQ(stream.Update({}, Progress()).value().bytes, first.bytes);
  EXPECT_EQ(stream.tiles_written(), 0);
}

TEST(OctreeStreamTest, ACancelledOrRefusedUpdateLeavesNoTraceInTheNext) {
  const auto scene = Forest(2);
  const OctreeOptions options = {0.25, 1.0};
  auto stream =
      OctreeStream::Create(scene, OctreeStream::Format::kBinary, options, Progress()).value();
  Progress cancelled;
  cancelled.Cancel();
  const SceneChanges changes = {{Felled(*scene, 5, 1.0)}, {}};
  EXPECT_EQ(stream.Update(changes, cancelled).status().code(), StatusCode::kCancelled);
  const OctreeData expected = BuildBinaryData(*scene, options, Progress(), changes).value();
  EXPECT_EQ(stream.Update(changes, Progress()).value().bytes, expected.bytes);
  EXPECT_EQ(stream.Update({{Felled(*scene, 5, 2.0)}, {}}, cancelled).status().code(),
            StatusCode::kCancelled);
  EXPECT_EQ(stream.Update({{}, {5, 5}}, Progress()).status().code(), StatusCode::kInvalidArgument);
  EXPECT_EQ(stream.Update(changes, Progress()).value().bytes, expected.bytes);
}

TEST(OctreeStreamTest, RefusesWhatTheMapRefuses) {
  EXPECT_EQ(OctreeStream::Create(Forest(1), OctreeStream::Format::kFull, {0.0, 1.0}, Progress())
                .status()
                .code(),
            StatusCode::kInvalidArgument);
}

}  // namespace
}  // namespace latticeworld
