#include "latticeworld/terrain/surface.h"

#include <gtest/gtest.h>

#include <vector>

namespace latticeworld {
namespace {

bool StaysAsItIs(SurfaceClass surface) {
  return surface == SurfaceClass::kSnow || surface == SurfaceClass::kWaterBed;
}

std::vector<GroundState> ManyStates() {
  std::vector<GroundState> states;
  for (const double wetness : {0.0, 0.3, 1.0}) {
    for (const double snow_depth_m : {0.0, 0.01, 0.1, 1.0}) {
      for (const double sand : {0.0, 1.0}) states.push_back({wetness, snow_depth_m, sand});
    }
  }
  return states;
}

TEST(SurfaceTest, EveryFrictionIsPlausibleInEveryState) {
  for (const auto& surface : EnumNames(SurfaceClass{})) {
    for (const GroundState& state : ManyStates()) {
      const SurfaceProperties properties =
          Weathered(surface.value, DryPropertiesOf(surface.value), state);
      EXPECT_GE(properties.friction, 0.1) << surface.name;
      EXPECT_LE(properties.friction, 0.9) << surface.name;
      EXPECT_GT(properties.rolling_resistance, 0.0) << surface.name;
      EXPECT_LE(properties.rolling_resistance, 0.3) << surface.name;
      EXPECT_GT(properties.cone_index_kpa, 0.0) << surface.name;
      EXPECT_LE(properties.cone_index_kpa, kHardConeIndex_kPa) << surface.name;
    }
  }
}

TEST(SurfaceTest, MoreWaterOrSnowNeverHelps) {
  for (const auto& surface : EnumNames(SurfaceClass{})) {
    const bool stays = StaysAsItIs(surface.value);
    for (const GroundState& state : ManyStates()) {
      for (GroundState more :
           {GroundState{state.wetness + 0.2, state.snow_depth_m, state.blown_sand},
            GroundState{state.wetness, state.snow_depth_m + 0.02, state.blown_sand}}) {
        const SurfaceProperties here =
            Weathered(surface.value, DryPropertiesOf(surface.value), state);
        const SurfaceProperties there =
            Weathered(surface.value, DryPropertiesOf(surface.value), more);
        EXPECT_LE(there.friction, here.friction + 1e-12) << surface.name;
        EXPECT_GE(there.rolling_resistance, here.rolling_resistance - 1e-12) << surface.name;
        EXPECT_LE(there.cone_index_kpa, here.cone_index_kpa + 1e-9) << surface.name;
      }
    }
    const double dry = Weathered(surface.value, DryPropertiesOf(surface.value), {}).friction;
    const double wet =
        Weathered(surface.value, DryPropertiesOf(surface.value), {1.0, 0.0, 0.0}).friction;
    const double snowy =
        Weathered(surface.value, DryPropertiesOf(surface.value), {1.0, 0.1, 0.0}).friction;
    EXPECT_EQ(wet < dry, !stays) << surface.name;
    EXPECT_EQ(snowy < wet, !stays) << surface.name;
  }
}

TEST(SurfaceTest, NothingJumpsAsTheGroundGetsWetterOrSnowCovered) {
  for (const auto& surface : EnumNames(SurfaceClass{})) {
    SurfaceProperties before = Weathered(surface.value, DryPropertiesOf(surface.value), {});
    for (int i = 1; i <= 2000; ++i) {
      const double share = i / 2000.0;
      const SurfaceProperties now =
          Weathered(surface.value, DryPropertiesOf(surface.value), {share, 0.5 * share, share});
      EXPECT_NEAR(now.friction, before.friction, 0.01) << surface.name;
      EXPECT_NEAR(now.rolling_resistance, before.rolling_resistance, 0.001) << surface.name;
      EXPECT_NEAR(now.cone_index_kpa, before.cone_index_kpa, 15.0) << surface.name;
      before = now;
    }
  }
}

TEST(SurfaceTest, RoadsRollEasiestAndGripBest) {
  const SurfaceProperties road = DryPropertiesOf(SurfaceClass::kRoad);
  for (const auto& surface : EnumNames(SurfaceClass{})) {
    const SurfaceProperties other = DryPropertiesOf(surface.value);
    EXPECT_LE(other.friction, road.friction) << surface.name;
    EXPECT_GE(other.rolling_resistance, road.rolling_resistance) << surface.name;
  }
}

TEST(SurfaceTest, SoilSoftensWhenWetAndPavingDoesNot) {
  for (const auto& surface : EnumNames(SurfaceClass{})) {
    const double dry = Weathered(surface.value, DryPropertiesOf(surface.value), {}).cone_index_kpa;
    const double wet =
        Weathered(surface.value, DryPropertiesOf(surface.value), {1.0, 0.0, 0.0}).cone_index_kpa;
    EXPECT_GE(dry, 50.0) << surface.name;  // carries a light robot
    EXPECT_LE(dry, kHardConeIndex_kPa) << surface.name;
    const bool stays = dry == kHardConeIndex_kPa || StaysAsItIs(surface.value);
    EXPECT_EQ(wet == dry, stays) << surface.name;
    EXPECT_LE(wet, dry) << surface.name;
  }
}

TEST(SurfaceTest, ThinSnowTakesTheGripAndLeavesTheGroundFirm) {
  const SurfaceProperties bare = DryPropertiesOf(SurfaceClass::kRoad);
  const SurfaceProperties covered =
      Weathered(SurfaceClass::kRoad, DryPropertiesOf(SurfaceClass::kRoad), {0.0, 0.05, 0.0});
  EXPECT_LT(covered.friction, 0.4 * bare.friction);
  EXPECT_GT(covered.cone_index_kpa, 1000.0);
  EXPECT_NEAR(
      Weathered(SurfaceClass::kGrass, DryPropertiesOf(SurfaceClass::kGrass), {0.0, 0.5, 0.0})
          .friction,
      0.2, 1e-6);
}

TEST(SurfaceTest, WhatIsSlipperierThanSnowStaysSo) {
  // Ice on a road: snow on it gives no grip back.
  const SurfaceProperties ice = {0.12, 0.01, kHardConeIndex_kPa};
  EXPECT_LE(Weathered(SurfaceClass::kRoad, ice, {0.0, 0.2, 0.0}).friction, ice.friction);
}

TEST(SurfaceTest, NoEffectMakesPropertiesIllegal) {
  const SurfaceProperties odd = {1e-4, 50.0, 1.0};
  const SurfaceProperties limited = Weathered(SurfaceClass::kGrass, odd, {1.0, 1.0, 1.0});
  EXPECT_GE(limited.friction, 0.05);
  EXPECT_LE(limited.rolling_resistance, 0.6);
  EXPECT_GT(limited.cone_index_kpa, 0.0);
}

}  // namespace
}  // namespace latticeworld
