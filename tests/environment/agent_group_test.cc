#include "latticeworld/environment/agent_group.h"

#include <gtest/gtest.h>

namespace latticeworld {
namespace {

TEST(AgentGroupTest, EveryCategoryCanBeIdleAndIsSomehowOnTheMove) {
  for (const auto& category : EnumNames(AgentCategory{})) {
    EXPECT_TRUE(CanBe(category.value, AgentState::kIdle)) << category.name;
  }
}

TEST(AgentGroupTest, StatesFitTheBody) {
  EXPECT_TRUE(CanBe(AgentCategory::kSheep, AgentState::kGrazing));
  EXPECT_TRUE(CanBe(AgentCategory::kEagle, AgentState::kFlying));
  EXPECT_TRUE(CanBe(AgentCategory::kWhale, AgentState::kSwimming));
  EXPECT_TRUE(CanBe(AgentCategory::kGoblin, AgentState::kPursuing));
  EXPECT_FALSE(CanBe(AgentCategory::kGoblin, AgentState::kGrazing));
  EXPECT_FALSE(CanBe(AgentCategory::kEagle, AgentState::kSwimming));
  EXPECT_FALSE(CanBe(AgentCategory::kSheep, AgentState::kAttacking));
  EXPECT_FALSE(CanBe(AgentCategory::kWheeledRobot, AgentState::kFlying));
}

}  // namespace
}  // namespace latticeworld
