#include "latticeworld/scene/scene_changes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mapping/hand_made_scene.h"

namespace latticeworld {
namespace {

// A meadow with one tree of 8 m.
Scene OneTree() {
  return WithAssets(MakeScene(64, 32.0, [](double, double) { return 0.1; }),
                    {MakeTree(0.25f, 0.25f, 8.0f, 2.0f, 0.3f)});
}

// The tree of that scene, lying on level ground with its foot where it stood.
FallenTree Lying(const Scene& scene) {
  const Asset& tree = scene.assets[0];
  const Eigen::Vector3d foot(tree.x_m, tree.y_m, tree.z_m + tree.trunk_radius_m);
  return {0, foot, foot + tree.height_m * Eigen::Vector3d(std::cos(1.0), std::sin(1.0), 0.0)};
}

TEST(SceneChangesTest, KnowsWhatStands) {
  SceneChanges changes;
  EXPECT_TRUE(changes.Stands(3));
  changes.fallen.resize(3);
  changes.fallen[0].asset = 1;
  changes.fallen[1].asset = 4;
  changes.fallen[2].asset = 9;
  changes.gone = {0, 5, 6};
  for (std::uint32_t asset = 0; asset < 12; ++asset) {
    const bool changed =
        asset == 0 || asset == 1 || asset == 4 || asset == 5 || asset == 6 || asset == 9;
    EXPECT_EQ(changes.Stands(asset), !changed) << asset;
  }
}

TEST(SceneChangesTest, NamesEverythingThatIsWrong) {
  const Scene scene = OneTree();
  const FallenTree good = Lying(scene);
  const auto violations = [&](const SceneChanges& changes) {
    return Validate(changes, scene).violations().size();
  };
  EXPECT_EQ(violations({{good}, {}}), 0u);
  FallenTree elsewhere = good;
  elsewhere.asset = 1;
  EXPECT_EQ(violations({{elsewhere}, {7}}), 2u);
  EXPECT_EQ(violations({{good}, {0}}), 1u);
  EXPECT_EQ(violations({{}, {0, 0}}), 1u);
  FallenTree broken = good;
  broken.tip_m.x() = std::nan("");
  EXPECT_EQ(violations({{broken}, {}}), 1u);
  broken.tip_m = good.tip_m;
  broken.foot_m.z() = 1e300;
  EXPECT_EQ(violations({{broken}, {}}), 1u);
  broken.foot_m = good.foot_m + 0.5 * (good.tip_m - good.foot_m);  // half as long as it was high
  EXPECT_EQ(violations({{broken}, {}}), 1u);
  Scene two = WithAssets(scene, {scene.assets[0], MakeTree(5.0f, 5.0f, 8.0f, 2.0f, 0.3f)});
  EXPECT_FALSE(Validate(SceneChanges{{}, {1, 0}}, two).ok());
  EXPECT_TRUE(Validate(SceneChanges{{}, {0, 1}}, two).ok());

  SceneChanges wet;
  wet.ground = GroundState{1.5, -0.1, std::nan("")};
  EXPECT_EQ(violations(wet), 3u);
  wet.ground = GroundState{1.0, 0.4, 0.2};
  EXPECT_EQ(violations(wet), 0u);

  const Scene bushes = WithAssets(OneTree(), {MakeRound(AssetKind::kBush, 0, 0, 1.0f, 1.0f)});
  const Status status = Validate(SceneChanges{{good}, {}}, bushes);
  EXPECT_NE(status.message().find("bush"), std::string::npos) << status.message();
}

}  // namespace
}  // namespace latticeworld
