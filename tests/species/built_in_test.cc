// The species that ship.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "latticeworld/species/species_catalogue.h"

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
                                          {C::kWhale, 3.0},      {C::kWheeledRobot, 0.6}};
  for (const auto& [category, radius_m] : radii_m) {
    EXPECT_EQ(BuiltIn().Of(category).radius_m, radius_m) << NameOf(category);
  }
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
