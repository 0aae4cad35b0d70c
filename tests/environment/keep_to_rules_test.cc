#include "latticeworld/environment/keep_to_rules.h"

#include <gtest/gtest.h>

#include <string>

#include "latticeworld/common/random.h"
#include "latticeworld/environment/fine_parameter.h"

namespace latticeworld {
namespace {

// Any values at all of the right names, as a model with no knowledge of the rules writes them.
EnvironmentConfig Anything(RandomStream* random) {
  const Catalogue& catalogue = *Catalogue::BuiltIn();
  const auto draw = [&](const auto& values) {
    return values[static_cast<std::size_t>(
        random->UniformInt(0, static_cast<int>(values.size()) - 1))];
  };
  EnvironmentConfig environment;
  environment.coarse.terrain_type = draw(EnumNames(TerrainType{})).value;
  environment.coarse.season = draw(EnumNames(Season{})).value;
  environment.coarse.weather = draw(EnumNames(Weather{})).value;
  environment.coarse.time_of_day = draw(EnumNames(TimeOfDay{})).value;
  for (const auto& entry : EnumNames(AssetType{})) {
    FineAttribute& fine = environment.fine_of(entry.value);
    const AssetTypeValues& values = catalogue.ValuesOf(entry.value);
    fine.season_variant = std::string(draw(values.season_variants));
    fine.material = std::string(draw(values.materials));
    for (const auto& parameter : EnumNames(FineParameter{}))
      SetValue(parameter.value, random->Uniform(-100.0, 1000.0), &fine);
  }
  for (int i = random->UniformInt(0, 6); i > 0; --i) {
    AgentGroup group;
    group.category = draw(EnumNames(AgentCategory{})).value;
    group.state = draw(EnumNames(AgentState{})).value;
    group.quantity = random->UniformInt(-5, 900);
    environment.agents.push_back(group);
  }
  return environment;
}

TEST(KeepToRulesTest, WhateverCameIsLegalAfterwards) {
  const Catalogue& catalogue = *Catalogue::BuiltIn();
  RandomStream random(5, "anything");
  int illegal = 0;
  for (int i = 0; i < 300; ++i) {
    EnvironmentConfig environment = Anything(&random);
    const bool was_legal = Validate(environment).empty();
    illegal += was_legal ? 0 : 1;
    const auto changes = KeepToRules(catalogue, &environment);
    EXPECT_EQ(changes.empty(), was_legal);
    const auto violations = Validate(environment);
    ASSERT_TRUE(violations.empty())
        << violations.front().pointer << ": " << violations.front().message;
  }
  EXPECT_GT(illegal, 290);
}

TEST(KeepToRulesTest, WhatIsLegalStaysAsItIs) {
  const Catalogue& catalogue = *Catalogue::BuiltIn();
  RandomStream random(6, "legal");
  for (int i = 0; i < 50; ++i) {
    EnvironmentConfig environment = Anything(&random);
    environment.fine = SampleFineAttributes(environment.coarse, catalogue, &random);
    environment.agents.clear();
    const std::string before = ToJson(environment);
    EXPECT_TRUE(KeepToRules(catalogue, &environment).empty());
    EXPECT_EQ(ToJson(environment), before);
  }
}

TEST(KeepToRulesTest, TellsWhatWasAndWhatIs) {
  EnvironmentConfig environment;
  environment.coarse.season = Season::kWinter;
  environment.fine = DeriveFineAttributes(environment.coarse);
  environment.fine_of(AssetType::kGrass).density = 7.0;
  AgentGroup sheep;
  sheep.category = AgentCategory::kSheep;
  sheep.state = AgentState::kFlying;
  environment.agents = {sheep};
  const auto changes = KeepToRules(*Catalogue::BuiltIn(), &environment);
  ASSERT_EQ(changes.size(), 2u);
  EXPECT_NE(changes[0].find("grass density cannot be 7"), std::string::npos) << changes[0];
  EXPECT_NE(changes[1].find("a sheep cannot be flying"), std::string::npos) << changes[1];
  EXPECT_EQ(environment.agents[0].state, AgentState::kIdle);
}

}  // namespace
}  // namespace latticeworld
