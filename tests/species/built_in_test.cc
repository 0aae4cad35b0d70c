// The species that ship.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "latticeworld/species/species_catalogue.h"
#include "latticeworld/species/vehicle_outline.h"

namespace latticeworld {
namespace {

const SpeciesCatalogue& BuiltIn() { return *SpeciesCatalogue::BuiltIn(); }

TEST(BuiltInSpeciesTest, EveryCategoryHasOneOfItsName) {
  for (const auto& category : EnumNames(AgentCategory{})) {
    const Species& species = BuiltIn().Of(category.value);
    EXPECT_EQ(species.name, category.name);
    EXPECT_EQ(species.category, category.value);
  }
}

TEST(BuiltInSpeciesTest, ThereIsEveryPlanAndEveryDrive) {
  std::set<BodyPlan> plans;
  std::set<DriveKind> drives;
  for (const Species& species : BuiltIn().all()) {
    plans.insert(species.plan);
    if (species.vehicle) drives.insert(species.vehicle->drive);
    EXPECT_EQ(species.vehicle.has_value(), species.plan == BodyPlan::kVehicle) << species.name;
    EXPECT_EQ(species.quadruped.has_value(), species.plan == BodyPlan::kQuadruped) << species.name;
  }
  EXPECT_EQ(plans.size(), EnumNames(BodyPlan{}).size());
  EXPECT_EQ(drives.size(), EnumNames(DriveKind{}).size());
}

// Scenes are laid out by these; another radius is another world for the same seed.
TEST(BuiltInSpeciesTest, RadiiOfTheCategoriesStayAsTheyAre) {
  using C = AgentCategory;
  const std::pair<C, double> radii_m[] = {{C::kGoblin, 0.4},     {C::kHumanoidRobot, 0.35},
                                          {C::kRoboticDog, 0.4}, {C::kAncientWarrior, 0.4},
                                          {C::kSheep, 0.6},      {C::kHorse, 1.2},
                                          {C::kEagle, 0.6},      {C::kAerialRobot, 0.4},
                                          {C::kWhale, 3.0},      {C::kWheeledRobot, 0.4}};
  for (const auto& [category, radius_m] : radii_m) {
    EXPECT_EQ(BuiltIn().Of(category).radius_m, radius_m) << NameOf(category);
  }
}

// One footprint: nothing of a vehicle lies outside of it, and it is no wider than that.
TEST(BuiltInSpeciesTest, TheRadiusOfAVehicleIsTheCircleAroundItsWheelsAndChassis) {
  for (const Species& species : BuiltIn().all()) {
    if (!species.vehicle) continue;
    const double circle_m = CircumscribedRadius(*species.vehicle);
    EXPECT_GE(species.radius_m, circle_m) << species.name;
    EXPECT_LT(species.radius_m, circle_m + 0.01) << species.name;
  }
}

// Two rectangles around one middle: the chassis of 0.56 x 0.36 m, the wheels' of 0.60 x 0.52 m.
TEST(BuiltInSpeciesTest, TheWheeledRobotReachesToTheCornersOfItsWheels) {
  EXPECT_NEAR(CircumscribedRadius(*BuiltIn().Of(AgentCategory::kWheeledRobot).vehicle),
              std::hypot(0.30, 0.26), 1e-12);
}

TEST(BuiltInSpeciesTest, AreSortedAndFoundByTheirNames) {
  const std::vector<Species>& all = BuiltIn().all();
  EXPECT_TRUE(std::is_sorted(all.begin(), all.end(),
                             [](const Species& a, const Species& b) { return a.name < b.name; }));
  for (const Species& species : all) EXPECT_EQ(BuiltIn().Find(species.name), &species);
  EXPECT_EQ(BuiltIn().Find("ackermann_car"), BuiltIn().Find("ackermann car"));
  EXPECT_EQ(BuiltIn().Find("unicorn"), nullptr);
  EXPECT_EQ(BuiltIn().Find(""), nullptr);
}

TEST(BuiltInSpeciesTest, WhatIsLeftOutIsNever) {
  EXPECT_TRUE(std::isinf(BuiltIn().Of(AgentCategory::kWhale).drowning_depth_m));
  EXPECT_TRUE(std::isinf(BuiltIn().Of(AgentCategory::kHorse).knock_over_mps));
  EXPECT_EQ(BuiltIn().Of(AgentCategory::kSheep).attack_reach_m, 0.0);
  EXPECT_FALSE(std::isinf(BuiltIn().Of(AgentCategory::kGoblin).knock_over_mps));
}

}  // namespace
}  // namespace latticeworld
