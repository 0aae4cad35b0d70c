#include "latticeworld/sensing/line_of_sight.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "latticeworld/common/random.h"
#include "latticeworld/scene/props/standing_props.h"
#include "latticeworld/scene/scene_changes.h"
#include "mapping/hand_made_scene.h"

namespace latticeworld {
namespace {

// Before anything has changed.
bool HasLineOfSight(const Scene& scene, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  return HasLineOfSight(scene, SceneChanges(), from, to);
}

using Eigen::Vector3d;

Scene Flat() {
  return MakeScene(128, 64.0, [](double, double) { return 0.0; });
}

TEST(LineOfSightTest, NothingHidesOnOpenGround) {
  const Scene scene = Flat();
  EXPECT_TRUE(HasLineOfSight(scene, {-30, -20, 0.5}, {30, 25, 0.5}));
  EXPECT_TRUE(HasLineOfSight(scene, {1, 1, 5}, {1, 1, 0.5}));
  EXPECT_TRUE(HasLineOfSight(scene, {1, 1, 5}, {1, 1, 5}));
}

TEST(LineOfSightTest, GroundThatIsOnlyTouchedDoesNotHide) {
  EXPECT_TRUE(HasLineOfSight(Flat(), {-30, -20, 0.0}, {30, 25, 0.0}));
  EXPECT_FALSE(HasLineOfSight(Flat(), {-30, -20, 1.0}, {30, 25, -0.01}));
}

TEST(LineOfSightTest, AHillHidesWhatLiesBelowTheTangentOverItsTop) {
  // A ridge of 10 m at x = 0.25 (a column of vertices), 1:1 on both sides.
  const Scene scene = MakeScene(
      128, 64.0, [](double x_m, double) { return std::max(0.0, 10.0 - std::abs(x_m - 0.25)); });
  // From 20 m before the ridge at 5 m, the line over the top is at 15 m 20 m behind it.
  EXPECT_FALSE(HasLineOfSight(scene, {-19.75, 3, 5}, {20.25, -7, 14.95}));
  EXPECT_TRUE(HasLineOfSight(scene, {-19.75, 3, 5}, {20.25, -7, 15.05}));
}

TEST(LineOfSightTest, ASpikeBetweenTwoSamplesOfTheGroundStillHides) {
  // One vertex of 4 m; the line passes 0.2 m beside it, where the triangles are still 2.4 m high.
  const Scene scene = MakeScene(
      128, 64.0, [](double x_m, double y_m) { return x_m == 0.25 && y_m == 0.25 ? 4.0 : 0.0; });
  EXPECT_FALSE(HasLineOfSight(scene, {-20, 0.45, 2.3}, {20, 0.45, 2.3}));
  EXPECT_TRUE(HasLineOfSight(scene, {-20, 0.45, 2.5}, {20, 0.45, 2.5}));
}

TEST(LineOfSightTest, AnEdgeAcrossACellHides) {
  // The two vertices that a cell's diagonal joins are 4 m high; the line crosses the ground's grid
  // only at vertices of 0 m.
  const Scene scene = MakeScene(128, 64.0, [](double x_m, double y_m) {
    return std::abs(x_m) == 0.25 && x_m == -y_m ? 4.0 : 0.0;
  });
  EXPECT_FALSE(HasLineOfSight(scene, {20.25, 20.25, 3.9}, {-20.25, -20.25, 3.9}));
  EXPECT_TRUE(HasLineOfSight(scene, {20.25, 20.25, 4.1}, {-20.25, -20.25, 4.1}));
}

TEST(LineOfSightTest, ATreeThatFellOrWentHidesNothing) {
  const Scene scene =
      WithAssets(Flat(), {MakeTree(-5.0f, 0.0f, 8.0f, 2.0f, 0.3f), MakeTree(0, 0, 8.0f, 2.0f, 0.3f),
                          MakeTree(5.0f, 0.0f, 8.0f, 2.0f, 0.3f)});
  SceneChanges changes;
  changes.fallen = {{0, {-5, 0, 0.3}, {-5, 8, 0.3}}};
  changes.gone = {2};
  for (const double x_m : {-5.0, 0.0, 5.0}) {
    EXPECT_FALSE(HasLineOfSight(scene, {x_m, -10, 1}, {x_m, 10, 1})) << x_m;
    EXPECT_EQ(HasLineOfSight(scene, changes, {x_m, -10, 1}, {x_m, 10, 1}), x_m != 0.0) << x_m;
  }
}

TEST(LineOfSightTest, AClosedGateHidesAndAnOpenOneDoesNot) {
  Scene scene = Flat();
  Prop gate;
  gate.kind = PropKind::kGate;
  gate.size_m = {4.0, 0.06, 1.5};
  gate.position = {-2.0, 0.0};
  gate.z_m = 0.0;
  scene.props = {gate};
  EXPECT_FALSE(HasLineOfSight(scene, {0, -10, 1}, {0, 10, 1}));
  EXPECT_TRUE(HasLineOfSight(scene, {0, -10, 1.6}, {0, 10, 1.6}));
  EXPECT_TRUE(HasLineOfSight(scene, {3, -10, 1}, {3, 10, 1}));
  EXPECT_TRUE(HasLineOfSight(scene, {0, -10, 1}, {0, -1, 1}));
  gate.yaw_rad = M_PI / 2.0;
  SceneChanges open;
  open.props = std::make_shared<const StandingProps>(StandingAtBegin({gate}));
  EXPECT_TRUE(HasLineOfSight(scene, open, {0, -10, 1}, {0, 10, 1}));
  EXPECT_FALSE(HasLineOfSight(scene, open, {-5, 1, 1}, {5, 1, 1}));
}

TEST(LineOfSightTest, AWallHidesBelowItsTopAndBetweenItsEnds) {
  // 3 m high, from (-8, -1) to (8, 1).
  const Scene scene = WithAssets(Flat(), {MakeBuilding(0, 0, 3.0f, 8.0f, 1.0f, 0.0f)});
  EXPECT_FALSE(HasLineOfSight(scene, {0, -20, 2.9}, {0, 20, 2.9}));
  EXPECT_TRUE(HasLineOfSight(scene, {0, -20, 3.1}, {0, 20, 3.1}));
  EXPECT_FALSE(HasLineOfSight(scene, {7.9, -20, 1}, {7.9, 20, 1}));
  EXPECT_TRUE(HasLineOfSight(scene, {8.1, -20, 1}, {8.1, 20, 1}));
  // Sloping down behind the wall: at y = 1 the line is at 3.05 m, 2.95 m.
  EXPECT_TRUE(HasLineOfSight(scene, {0, -9, 4.05}, {0, 11, 2.05}));
  EXPECT_FALSE(HasLineOfSight(scene, {0, -9, 3.95}, {0, 11, 1.95}));
  // Straight down onto the roof.
  EXPECT_FALSE(HasLineOfSight(scene, {2, 0, 9}, {2, 0, 1}));
  EXPECT_TRUE(HasLineOfSight(scene, {2, 0, 9}, {2, 0, 3.1}));
}

TEST(LineOfSightTest, BoxesTurnWithTheirYaw) {
  const Scene scene =
      WithAssets(Flat(), {MakeBuilding(0, 0, 3.0f, 8.0f, 1.0f, static_cast<float>(M_PI / 2))});
  EXPECT_TRUE(HasLineOfSight(scene, {4, -20, 1}, {4, 20, 1}));
  EXPECT_FALSE(HasLineOfSight(scene, {-20, 7.9, 1}, {20, 7.9, 1}));
}

TEST(LineOfSightTest, ATrunkHidesWithinItsRadiusAndACrownDoesNot) {
  const Scene scene = WithAssets(Flat(), {MakeTree(5, 5, 8.0f, 3.0f, 0.3f)});
  EXPECT_FALSE(HasLineOfSight(scene, {5.29, -20, 1}, {5.29, 20, 1}));
  EXPECT_TRUE(HasLineOfSight(scene, {5.31, -20, 1}, {5.31, 20, 1}));
  EXPECT_FALSE(HasLineOfSight(scene, {5, -20, 7.9}, {5, 20, 7.9}));
  EXPECT_TRUE(HasLineOfSight(scene, {5, -20, 8.1}, {5, 20, 8.1}));
  // Too short to reach it.
  EXPECT_TRUE(HasLineOfSight(scene, {5, -20, 1}, {5, 4.6, 1}));
}

TEST(LineOfSightTest, FarAssetsOfALongSegmentAreFound) {
  for (float x_m = -30.0f; x_m <= 30.0f; x_m += 1.7f) {
    const Scene scene = WithAssets(Flat(), {MakeTree(x_m, 0.5f * x_m, 5.0f, 1.0f, 0.2f)});
    EXPECT_FALSE(HasLineOfSight(scene, {-31.5, -15.75, 1}, {31.5, 15.75, 1})) << x_m;
  }
}

TEST(LineOfSightTest, AssetsAtTheRimHideBesideALargeBuilding) {
  const Scene scene = WithAssets(Flat(), {MakeBuilding(-10, 0, 3.0f, 10.0f, 8.0f, 0.0f),
                                          MakeTree(31.0f, 0.0f, 6.0f, 2.0f, 0.5f)});
  EXPECT_FALSE(HasLineOfSight(scene, {31, -20, 1}, {31, 20, 1}));
}

TEST(LineOfSightTest, LinesThatGrazeATrunkAreTheSameInBothDirections) {
  const Scene scene = WithAssets(Flat(), {MakeTree(3.1f, -2.7f, 6.0f, 2.0f, 0.5f)});
  const Asset& tree = scene.assets[0];
  const double radius_m = SolidRadius(tree);
  int hidden = 0;
  for (int i = 0; i < 1000; ++i) {
    const double angle_rad = 2.0 * M_PI * i / 1000.0;
    const Vector3d out(std::cos(angle_rad), std::sin(angle_rad), 0.0);
    const Vector3d along(-out.y(), out.x(), 0.0);
    const Vector3d touch = Vector3d(tree.x_m, tree.y_m, 1.0) + radius_m * out;
    const Vector3d from = touch - 7.3 * along, to = touch + 11.9 * along;
    const bool seen = HasLineOfSight(scene, from, to);
    EXPECT_EQ(seen, HasLineOfSight(scene, to, from)) << i;
    hidden += !seen;
  }
  EXPECT_GT(hidden, 50);  // rounding decides, so both answers come
  EXPECT_LT(hidden, 950);
}

TEST(LineOfSightTest, EndsFarOutsideTheWorldAreLegal) {
  const Scene scene = WithAssets(Flat(), {MakeTree(5, 0, 5.0f, 1.0f, 0.2f)});
  EXPECT_FALSE(HasLineOfSight(scene, {-1e7, 0, 1}, {1e7, 0, 1}));
  EXPECT_TRUE(HasLineOfSight(scene, {-1e7, 3, 1}, {1e7, 3, 1}));
  EXPECT_TRUE(HasLineOfSight(scene, {1e7, 0, 1}, {2e7, 0, 1}));
}

TEST(LineOfSightTest, FlowersAndBushesHideNothing) {
  const Scene scene = WithAssets(Flat(), {MakeRound(AssetKind::kFlower, 0, 0, 2.0f, 2.0f),
                                          MakeRound(AssetKind::kBush, 5, 0, 2.0f, 2.0f)});
  EXPECT_TRUE(HasLineOfSight(scene, {-20, 0, 1}, {20, 0, 1}));
}

TEST(LineOfSightTest, IsTheSameInBothDirectionsAndAgreesWithFineSampling) {
  int visible = 0, hidden = 0;
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    RandomStream random(seed, "line_of_sight_test");
    const double a = random.Uniform(0.5, 3.0);
    std::vector<Asset> assets;
    for (int i = 0; i < 60; ++i)
      assets.push_back(MakeTree(static_cast<float>(random.Uniform(-32, 32)),
                                static_cast<float>(random.Uniform(-32, 32)), 6.0f, 2.0f, 0.5f));
    const Scene scene = WithAssets(MakeScene(128, 64.0,
                                             [a](double x_m, double y_m) {
                                               return a * std::sin(x_m / 4.0) * std::cos(y_m / 5.0);
                                             }),
                                   assets);
    for (int i = 0; i < 300; ++i) {
      const auto point = [&] {
        const WorldPoint p = {random.Uniform(-32, 32), random.Uniform(-32, 32)};
        return Vector3d(p.x_m, p.y_m, scene.terrain->ground.HeightAt(p) + random.Uniform(0.2, 3.0));
      };
      const Vector3d from = point(), to = point();
      const bool seen = HasLineOfSight(scene, from, to);
      EXPECT_EQ(seen, HasLineOfSight(scene, to, from));
      (seen ? visible : hidden) += 1;
      // What fine sampling finds in the way must hide.
      bool blocked = false;
      for (int step = 0; step <= 2000 && !blocked; ++step) {
        const Vector3d p = from + (to - from) * (step / 2000.0);
        blocked = p.z() < scene.terrain->ground.HeightAt({p.x(), p.y()}) - 1e-3;
        for (const Asset& asset : assets)
          blocked = blocked || (std::hypot(p.x() - asset.x_m, p.y() - asset.y_m) < 0.499 &&
                                p.z() < scene.terrain->ground.HeightAt(asset.position()) + 5.99);
      }
      EXPECT_FALSE(blocked && seen) << from.transpose() << " to " << to.transpose();
    }
  }
  EXPECT_GT(visible, 100);
  EXPECT_GT(hidden, 100);
}

}  // namespace
}  // namespace latticeworld
