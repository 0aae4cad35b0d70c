#include "latticeworld/simulation/agents/ways/path_layers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "latticeworld/common/random.h"
#include "latticeworld/scene/props/props.h"
#include "latticeworld/scene/props/standing_props.h"
#include "latticeworld/simulation/agents/ways/path_finder.h"
#include "latticeworld/species/species_catalogue.h"
#include "simulation/test_scene.h"

namespace latticeworld {
namespace {

const Species& Of(const std::string& name) { return *SpeciesCatalogue::BuiltIn()->Find(name); }

FallenTree Lying(const Scene& scene, std::uint32_t asset, double heading_rad, double lift_m = 0.0) {
  const Asset& tree = scene.assets[asset];
  const Eigen::Vector3d foot(tree.x_m, tree.y_m, tree.z_m + tree.trunk_radius_m + lift_m);
  const Eigen::Vector3d way(std::cos(heading_rad), std::sin(heading_rad), 0.0);
  return {asset, foot, foot + tree.height_m * way};
}

Grid<std::uint8_t> All(PathLayer* layer) {
  Grid<std::uint8_t> ease(layer->cells(), layer->cells());
  for (int row = 0; row < ease.rows(); ++row) {
    for (int col = 0; col < ease.cols(); ++col) ease(row, col) = layer->Ease({row, col});
  }
  return ease;
}

TEST(PathLayersTest, SpeciesAlikeShareALayer) {
  const auto scene = TestScene().Build();
  PathLayers layers(*scene);
  Species other = Of("goblin");
  other.top_speed_mps = 9.0;
  EXPECT_EQ(&layers.Of(Of("goblin")), &layers.Of(other));
  other.radius_m = 3.0;
  EXPECT_NE(&layers.Of(Of("goblin")), &layers.Of(other));
}

TEST(PathLayersTest, CellsAreNoLargerThanAMetreUnlessTheSceneIsCoarser) {
  const auto cell_m = [](int cells, double size_m) {
    TestScene made;
    made.cells = cells;
    made.size_m = size_m;
    const auto scene = made.Build();
    PathLayers layers(*scene);
    return layers.Of(Of("goblin")).cell_m();
  };
  EXPECT_DOUBLE_EQ(cell_m(128, 64.0), 1.0);
  EXPECT_DOUBLE_EQ(cell_m(100, 30.0), 0.9);
  EXPECT_DOUBLE_EQ(cell_m(128, 96.0), 0.75);
  EXPECT_DOUBLE_EQ(cell_m(64, 128.0), 2.0);
}

TEST(PathLayersTest, ACellIsFreeWhereAllOfItIs) {
  TestScene made;
  made.AddTree(10.3, 10.2, 0.3);
  const auto scene = made.Build();
  PathLayers layers(*scene);
  PathLayer& layer = layers.Of(Of("goblin"));
  RobotLimits limits;
  limits.radius_m = ClassOf(Of("goblin")).radius_m;
  limits.clearance_m = 0.0;
  limits.grip = ClassOf(Of("goblin")).grip;
  limits.on_wheels = false;
  const Grid<float> map = BuildTraversability(*scene, limits);
  int blocked = 0;
  for (int row = 0; row < layer.cells(); ++row) {
    for (int col = 0; col < layer.cells(); ++col) {
      const bool free = std::min({map(2 * row, 2 * col), map(2 * row + 1, 2 * col),
                                  map(2 * row, 2 * col + 1), map(2 * row + 1, 2 * col + 1)}) > 0.0f;
      EXPECT_EQ(layer.IsFree({row, col}), free) << row << " " << col;
      blocked += free ? 0 : 1;
    }
  }
  EXPECT_GT(blocked, 3);
}

TEST(PathLayersTest, BelowAStemThatHangsOnlyTheLowPass) {
  TestScene made;
  made.AddTree(-4.0, 0.3, 0.2);
  const auto scene = made.Build();
  PathLayers layers(*scene);
  layers.Update({{Lying(*scene, 0, 0.0, 1.5)}, {}});
  PathLayer& dog = layers.Of(Of("robotic dog"));
  PathLayer& warrior = layers.Of(Of("ancient warrior"));
  EXPECT_TRUE(dog.IsFree(dog.CellAt({-1.5, 0.3})));
  EXPECT_FALSE(warrior.IsFree(warrior.CellAt({-1.5, 0.3})));
}

// Each change alone: one tree falls, rolls on, goes or stands again, wherever tiles meet.
TEST(PathLayersTest, AfterEveryChangeTheyAreAsIfMadeWithIt) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    TestScene made;
    made.size_m = 128.0;
    RandomStream random(seed, "layers");
    for (int i = 0; i < 60; ++i)
      made.AddTree(random.Uniform(-60.0, 60.0), random.Uniform(-60.0, 60.0), 0.3);
    const auto scene = made.Build();
    PathLayers used(*scene);
    SceneChanges changes;
    for (int round = 0; round < 40; ++round) {
      All(&used.Of(Of("goblin")));  // every tile is made
      const auto tree = static_cast<std::uint32_t>(random.UniformInt(0, 59));
      const auto same = [&](const FallenTree& other) { return other.asset == tree; };
      changes.fallen.erase(std::remove_if(changes.fallen.begin(), changes.fallen.end(), same),
                           changes.fallen.end());
      changes.gone.erase(std::remove(changes.gone.begin(), changes.gone.end(), tree),
                         changes.gone.end());
      const int fate = random.UniformInt(0, 3);
      if (fate == 0) changes.gone.push_back(tree);
      if (fate >= 2) changes.fallen.push_back(Lying(*scene, tree, random.Uniform(-3.0, 3.0)));
      std::sort(changes.gone.begin(), changes.gone.end());
      std::sort(changes.fallen.begin(), changes.fallen.end(),
                [](const FallenTree& a, const FallenTree& b) { return a.asset < b.asset; });
      used.Update(changes);
      PathLayers fresh(*scene);
      fresh.Update(changes);
      ASSERT_EQ(All(&used.Of(Of("goblin"))), All(&fresh.Of(Of("goblin"))))
          << "seed " << seed << ", round " << round;
    }
  }
}

// Crates, posts, stones, gates and bridges anywhere.
StandingProps SomeProps(int count, RandomStream* random) {
  StandingProps props;
  for (int i = 0; i < count; ++i) {
    Prop prop = UsualProp(static_cast<PropKind>(random->UniformInt(0, 4)));
    prop.position = {random->Uniform(-60.0, 60.0), random->Uniform(-60.0, 60.0)};
    prop.yaw_rad = random->Uniform(-3.0, 3.0);
    prop.z_m = prop.kind == PropKind::kBridge ? 1.0 : 0.0;
    const StandingProps one = StandingAtBegin({prop});
    props.blocks.insert(props.blocks.end(), one.blocks.begin(), one.blocks.end());
    props.decks.insert(props.decks.end(), one.decks.begin(), one.decks.end());
  }
  return props;
}

TEST(PathLayersTest, AfterEveryMoveOfAnPropTheyAreAsIfMadeWithIt) {
  TestScene made;
  made.size_m = 128.0;
  const auto scene = made.Build();
  RandomStream random(4, "elements");
  PathLayers used(*scene);
  StandingProps props;
  for (int round = 0; round < 30; ++round) {
    All(&used.Of(Of("goblin")));  // every tile is made
    if (round % 3 == 0) {
      props = SomeProps(8, &random);
    } else if (!props.blocks.empty() && round % 3 == 1) {
      props.blocks.erase(props.blocks.begin());
    } else if (!props.decks.empty()) {
      props.decks.back().carries_kg = 1.0;
    }
    SceneChanges changes;
    changes.props = std::make_shared<const StandingProps>(props);
    used.Update(changes);
    PathLayers fresh(*scene);
    fresh.Update(changes);
    ASSERT_EQ(All(&used.Of(Of("goblin"))), All(&fresh.Of(Of("goblin")))) << round;
  }
}

// A channel too deep to wade from north to south, in cells of that size, and a bridge over it.
TestScene Bridged(double cell_m, double yaw_rad, double y_m) {
  TestScene made;
  made.cells = static_cast<int>(64.0 / cell_m);
  made.height_m = [](double x, double) { return std::abs(x) < 3.0 ? -2.5 : 0.0; };
  made.water_depth_m = [](double x, double) { return std::abs(x) < 3.0 ? 2.0 : 0.0; };
  Prop& bridge = made.AddProp("bridge", PropKind::kBridge, 0.0, y_m);
  bridge.size_m = {(6.0 + 1.5 * 2.0) / std::cos(yaw_rad), 2.0, 0.15};
  bridge.yaw_rad = yaw_rad;
  bridge.z_m = 0.01 - bridge.size_m.z();
  bridge.strength = 700.0;
  return made;
}

TEST(PathLayersTest, UnderOtherWeatherTheyAreAsIfMadeUnderIt) {
  TestScene made;
  made.AddTree(10.0, 10.0, 0.3);
  made.height_m = [](double x, double y) { return 2.0 * std::sin(x / 6.0) * std::cos(y / 9.0); };
  made.water_depth_m = [](double x, double) { return x > 24.0 ? 3.0 : 0.0; };
  const auto scene = made.Build();
  PathLayers used(*scene);
  Grid<std::uint8_t> dry;
  for (const double snow_m : {0.0, 0.02, 0.4, 0.0}) {
    SceneChanges changes;
    if (snow_m > 0.0) changes.ground = GroundState{0.3, snow_m, 0.0};
    used.Update(changes);
    PathLayers fresh(*scene);
    fresh.Update(changes);
    for (const char* const species : {"wheeled robot", "goblin", "whale"}) {
      const Grid<std::uint8_t> ease = All(&used.Of(Of(species)));
      EXPECT_EQ(ease, All(&fresh.Of(Of(species)))) << species << " " << snow_m;
      const bool drives = std::string(species) == "wheeled robot";
      if (drives && snow_m == 0.0) dry = ease;
      if (drives && snow_m == 0.4) {
        EXPECT_NE(ease, dry);
      }
    }
  }
}

TEST(PathLayersTest, AWayLeadsOverABridgeForWhatItCarries) {
  RandomStream random(9, "bridges");
  for (int i = 0; i < 24; ++i) {
    const double cell_m = i % 3 == 0 ? 0.25 : i % 3 == 1 ? 0.5 : 1.0;
    const double yaw_rad = random.Uniform(-0.7, 0.7), y_m = random.Uniform(-15.0, 15.0);
    const auto scene = Bridged(cell_m, yaw_rad, y_m).Build();
    PathFinder paths(*scene);
    for (const char* const species : {"goblin", "robotic dog", "wheeled robot", "horse"}) {
      const FoundPath path = paths.Find(Of(species), {-20.0, -20.0}, {20.0, 20.0}, 20000);
      EXPECT_TRUE(path.complete) << species << " " << cell_m << " " << yaw_rad << " " << y_m;
      // Over the water only on the deck.
      const Footprint deck = FootprintOf(scene->props[0]);
      WorldPoint from{-20.0, -20.0};
      for (const WorldPoint& to : path.points) {
        for (double share = 0.0; share <= 1.0; share += 0.01) {
          const WorldPoint at{from.x_m + share * (to.x_m - from.x_m),
                              from.y_m + share * (to.y_m - from.y_m)};
          if (std::abs(at.x_m) > 2.9) continue;
          EXPECT_LT(GapTo(deck, at), 0.0) << species << " " << at.x_m << " " << at.y_m;
        }
        from = to;
      }
    }
    EXPECT_FALSE(paths.Find(Of("tractor"), {-20.0, -20.0}, {20.0, 20.0}, 20000).complete);
    SceneChanges broken;
    broken.props = std::make_shared<const StandingProps>();
    paths.Update(broken);
    EXPECT_FALSE(paths.Find(Of("goblin"), {-20.0, -20.0}, {20.0, 20.0}, 20000).complete);
  }
}

TEST(PathLayersTest, AChangeMakesFewTilesAnew) {
  TestScene made;
  made.size_m = 128.0;
  made.AddTree(10.0, 10.0, 0.3);
  const auto scene = made.Build();
  PathLayers layers(*scene);
  PathLayer& layer = layers.Of(Of("goblin"));
  All(&layer);
  const std::size_t all = layer.tiles_made();
  layers.Update({{Lying(*scene, 0, 0.5)}, {}});
  All(&layer);
  EXPECT_LE(layer.tiles_made() - all, 4u);
  EXPECT_GE(layer.tiles_made() - all, 1u);
  layers.Update({{Lying(*scene, 0, 0.5)}, {}});
  All(&layer);
  EXPECT_LE(layer.tiles_made() - all, 4u);  // nothing is different
}

}  // namespace
}  // namespace latticeworld
