#include "latticeworld/scene/props/props.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "latticeworld/scene/props/footbridges.h"
#include "latticeworld/scene/road_finder.h"
#include "scene/test_world.h"

namespace latticeworld {
namespace {

// A suburb of houses on two sides of a road, with a river of that width across it.
std::shared_ptr<const Terrain> Village(double river_m = 6.0) {
  TestGround ground;
  ground.size_m = 512.0;
  ground.cells = 1024;
  const auto is_river = [=](WorldPoint at) { return std::abs(at.y_m - 180.0) < 0.5 * river_m; };
  ground.letter_at = [=](WorldPoint at) {
    if (is_river(at)) return 'W';
    const double across_m = std::abs(std::remainder(at.x_m, 128.0));
    if (across_m < 3.0) return 'R';
    return at.y_m < 60.0 ? 'B' : 'G';
  };
  // Banks that rise from just above the water to a metre, and a bed of 0.7 m of water.
  ground.height_at_m = [=](WorldPoint at) {
    const double beyond_m = std::abs(at.y_m - 180.0) - 0.5 * river_m;
    return beyond_m < 0.0 ? -0.6 : std::min(1.0, 0.2 + 0.5 * beyond_m);
  };
  ground.water_at_m = [=](WorldPoint at) { return is_river(at) ? 0.1 : NAN; };
  return MakeTerrain(ground);
}

// Made once: two seeds.
const Scene& VillageScene(std::uint64_t seed) {
  static const auto one = Build(Village(), MakeEnvironment(0.2), 1).scene;
  static const auto two = Build(Village(), MakeEnvironment(0.2), 2).scene;
  return seed == 1 ? *one : *two;
}

std::map<PropKind, int> CountsOf(const Scene& scene) {
  std::map<PropKind, int> counts;
  for (const Prop& prop : scene.props) ++counts[prop.kind];
  return counts;
}

TEST(PropsTest, UsualPropsAreLegal) {
  for (const auto& entry : EnumNames(PropKind{})) {
    const Prop prop = UsualProp(entry.value);
    EXPECT_EQ(prop.kind, entry.value);
    EXPECT_TRUE(Validate(prop).empty()) << entry.name;
    EXPECT_DOUBLE_EQ(prop.mass_kg, UsualMass(entry.value, prop.size_m));
    // Twice the size, eight times the mass.
    EXPECT_NEAR(UsualMass(entry.value, 2.0 * prop.size_m), 8.0 * prop.mass_kg, 1e-9);
  }
}

TEST(PropsTest, NamesEveryIllegalNumberOnce) {
  const double nan = std::nan("");
  for (const auto& entry : EnumNames(PropKind{})) {
    for (const double bad : {0.0, -1.0, nan, 1e12, double{INFINITY}}) {
      Prop prop = UsualProp(entry.value);
      prop.mass_kg = bad;
      EXPECT_EQ(Validate(prop).size(), 1u) << entry.name << " " << bad;
      prop = UsualProp(entry.value);
      prop.size_m = {bad, bad, bad};
      // A loose stone has one diameter.
      const std::size_t sizes = entry.value == PropKind::kLooseStone ? 1 : 3;
      EXPECT_EQ(Validate(prop).size(), sizes) << entry.name << " " << bad;
    }
    Prop prop = UsualProp(entry.value);
    prop.position.x_m = nan;
    prop.yaw_rad = nan;
    EXPECT_EQ(Validate(prop).size(), 2u);
  }
  Prop egg = UsualProp(PropKind::kLooseStone);
  egg.size_m.z() *= 1.5;
  EXPECT_EQ(Validate(egg).size(), 1u);
}

TEST(PropsTest, WhatIsLeftOpenIsUsual) {
  for (const auto& entry : EnumNames(PropKind{})) {
    const Prop usual = UsualProp(entry.value);
    const Prop open = PropOf(entry.value, Eigen::Vector3d::Zero());
    EXPECT_EQ(open.size_m, usual.size_m) << entry.name;
    EXPECT_EQ(open.mass_kg, usual.mass_kg) << entry.name;
    EXPECT_EQ(open.strength, usual.strength) << entry.name;
    const Prop given = PropOf(entry.value, usual.size_m, 7.0, 11.0);
    EXPECT_EQ(given.mass_kg, 7.0);
    EXPECT_EQ(given.strength, 11.0);
  }
  const Prop post = PropOf(PropKind::kPost, {0.2, 0.0, 0.0});
  EXPECT_EQ(post.size_m, Eigen::Vector3d(0.2, 0.1, 1.2));
  EXPECT_EQ(post.mass_kg, UsualMass(PropKind::kPost, post.size_m));
  EXPECT_EQ(post.strength, UsualStrength(PropKind::kPost, post.size_m));
  EXPECT_EQ(PropOf(PropKind::kLooseStone, {0.5, 0.7, 0.0}).size_m, Eigen::Vector3d(0.5, 0.5, 0.5));
}

TEST(PropsTest, WhatFollowsFromAnIllegalSizeIsNotHeldAgainstIt) {
  for (const double bad : {-1.0, 1e6, std::nan("")}) {
    const std::vector<Violation> violations = Validate(PropOf(PropKind::kBridge, {bad, 0.0, 0.0}));
    ASSERT_EQ(violations.size(), 1u) << bad;
    EXPECT_EQ(violations[0].pointer, "size.x");
  }
  EXPECT_EQ(Validate(PropOf(PropKind::kBridge, {-1.0, 0.0, 99.0}, -1.0, -1.0)).size(), 4u);
}

TEST(PropsTest, AWorldHasPropsThatStandClear) {
  for (const std::uint64_t seed : {1, 2}) {
    const Scene& scene = VillageScene(seed);
    EXPECT_GT(scene.props.size(), 10u);
    EXPECT_LT(scene.props.size(), 400u);
    std::set<std::string> names;
    for (const AgentStart& agent : scene.agents) names.insert(agent.name);
    for (std::size_t i = 0; i < scene.props.size(); ++i) {
      const Prop& prop = scene.props[i];
      EXPECT_TRUE(names.insert(prop.name).second) << prop.name;
      if (i > 0) {
        EXPECT_LT(scene.props[i - 1].name, prop.name);
      }
      ASSERT_TRUE(Validate(prop).empty()) << prop.name;
      EXPECT_NEAR(prop.z_m, GroundUnder(*scene.terrain, prop), 1e-9);
      const Footprint footprint = FootprintOf(prop);
      for (const WorldPoint& corner : footprint.Corners()) {
        EXPECT_TRUE(scene.geometry().Contains(corner));
        if (prop.kind == PropKind::kBridge) continue;
        EXPECT_EQ(scene.terrain->WaterDepthAt(corner), 0.0) << prop.name;
        EXPECT_NE(scene.terrain->SurfaceAt(corner), SurfaceClass::kRoad) << prop.name;
      }
      scene.index.ForEachNear(footprint.centre, footprint.radius_m(), [&](std::uint32_t index) {
        const Asset& asset = scene.assets[index];
        if (asset.kind == AssetKind::kBuilding) {
          EXPECT_GT(GapBetween(footprint, FootprintOf(asset)), 0.0) << prop.name;
        } else {
          EXPECT_GT(GapTo(footprint, asset.position()), SolidRadius(asset)) << prop.name;
        }
      });
      for (std::size_t j = 0; j < i; ++j) {
        EXPECT_GT(GapBetween(footprint, FootprintOf(scene.props[j])), 0.0)
            << prop.name << " " << scene.props[j].name;
      }
      for (const AgentStart& agent : scene.agents) {
        EXPECT_GE(GapTo(footprint, agent.position), 4.0) << prop.name << " " << agent.name;
      }
    }
  }
}

TEST(PropsTest, EveryKindIsFoundInAVillageByARiver) {
  std::map<PropKind, int> sums;
  for (const std::uint64_t seed : {1, 2}) {
    for (const auto& [kind, count] : CountsOf(VillageScene(seed))) sums[kind] += count;
  }
  for (const auto& entry : EnumNames(PropKind{})) EXPECT_GT(sums[entry.value], 0) << entry.name;
}

TEST(PropsTest, AGateHangsBetweenItsTwoPosts) {
  const Scene& scene = VillageScene(2);
  int gates = 0;
  for (const Prop& gate : scene.props) {
    if (gate.kind != PropKind::kGate) continue;
    ++gates;
    const Footprint panel = FootprintOf(gate);
    int beside = 0;
    for (const Prop& post : scene.props) {
      if (post.kind != PropKind::kPost) continue;
      const double away_m =
          std::hypot(post.position.x_m - panel.centre.x_m, post.position.y_m - panel.centre.y_m);
      if (std::abs(away_m - 0.5 * gate.size_m.x() - 0.1) < 0.01) ++beside;
    }
    EXPECT_EQ(beside, 2) << gate.name;
  }
  EXPECT_GT(gates, 0);
}

TEST(PropsTest, FootbridgesSpanNarrowWaterLevelWithTheirBanks) {
  for (const double river_m : {2.0, 4.0, 8.0, 30.0}) {
    const auto terrain = Village(river_m);
    const std::vector<Prop> bridges = FindFootbridges(*terrain, RoadFinder(*terrain), 3);
    if (river_m < 3.0 || river_m > 12.0) {
      EXPECT_TRUE(bridges.empty()) << river_m;
      continue;
    }
    ASSERT_FALSE(bridges.empty()) << river_m;
    for (const Prop& bridge : bridges) {
      EXPECT_TRUE(Validate(bridge).empty());
      EXPECT_GT(bridge.size_m.x(), river_m);
      EXPECT_LT(bridge.size_m.x(), river_m + 8.0);
      EXPECT_GT(terrain->WaterDepthAt(bridge.position), 0.2);
      const Footprint deck = FootprintOf(bridge);
      const double top_m = GroundUnder(*terrain, bridge) + bridge.size_m.z();
      for (const double end : {-1.0, 1.0}) {
        const WorldPoint at = deck.At(end * deck.half_length_m, 0.0);
        EXPECT_EQ(terrain->WaterDepthAt(at), 0.0);
        EXPECT_NEAR(terrain->ground.HeightAt(at), top_m, 0.08) << river_m;
      }
    }
  }
}

TEST(PropsTest, AreTheSameForTheSameSeed) {
  const Scene& a = VillageScene(1);
  const auto b = Build(Village(), MakeEnvironment(0.2), 1).scene;
  ASSERT_EQ(a.props.size(), b->props.size());
  for (std::size_t i = 0; i < a.props.size(); ++i) {
    EXPECT_EQ(a.props[i].name, b->props[i].name);
    EXPECT_EQ(a.props[i].position.x_m, b->props[i].position.x_m);
    EXPECT_EQ(a.props[i].yaw_rad, b->props[i].yaw_rad);
  }
}

}  // namespace
}  // namespace latticeworld
