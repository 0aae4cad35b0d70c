#include "latticeworld/language/remote/answer_in_form.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

#include "language/remote/form_checkers.h"
#include "latticeworld/common/random.h"
#include "latticeworld/environment/environment_config.h"
#include "latticeworld/environment/fine_parameter.h"
#include "latticeworld/environment/rules.h"
#include "latticeworld/language/remote/forms.h"

namespace latticeworld {
namespace {

template <typename Enum>
Enum DrawAny(RandomStream* random) {
  const auto& entries = EnumNames(Enum{});
  return entries[static_cast<std::size_t>(
                     random->UniformInt(0, static_cast<int>(entries.size()) - 1))]
      .value;
}

// A legal environment with numbers in hundredths.
EnvironmentConfig Drawn(std::uint64_t seed) {
  RandomStream random(seed, "answer in form");
  EnvironmentConfig environment;
  environment.coarse.terrain_type = DrawAny<TerrainType>(&random);
  environment.coarse.season = DrawAny<Season>(&random);
  environment.coarse.artistic_style = DrawAny<ArtisticStyle>(&random);
  environment.coarse.weather = DrawAny<Weather>(&random);
  environment.coarse.time_of_day = DrawAny<TimeOfDay>(&random);
  environment.fine = SampleFineAttributes(environment.coarse, *Catalogue::BuiltIn(), &random);
  environment.agents = {
      {AgentCategory::kSheep, random.UniformInt(1, 20), AgentState::kGrazing, Region::kUpper}};
  return environment;
}

TEST(AnswerInFormTest, RoundedEnvironmentsMatchTheFormAndKeepToTheRules) {
  const std::string schema = EnvironmentForm().json_schema;
  int in_form_before = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    EnvironmentConfig environment = Drawn(seed);
    in_form_before += MatchesSchema(schema, AnswerInForm(environment)) ? 1 : 0;
    RoundToForm(&environment);
    const std::string answer = AnswerInForm(environment);
    EXPECT_TRUE(MatchesSchema(schema, answer)) << seed << " " << answer;
    const auto back = ParseEnvironment(answer);
    ASSERT_TRUE(back.ok()) << back.status().ToString();
    EXPECT_EQ(ToJson(*back), ToJson(environment));
  }
  EXPECT_LT(in_form_before, 10) << "what is drawn has numbers between the steps";
}

TEST(AnswerInFormTest, NumbersGoToTheNearestStepThatIsLegal) {
  const EnvironmentConfig drawn = Drawn(7);
  EnvironmentConfig rounded = drawn;
  RoundToForm(&rounded);
  for (const auto& type : EnumNames(AssetType{})) {
    const FineBounds bounds = BoundsOf(drawn.coarse, type.value);
    const double before = drawn.fine_of(type.value).density;
    const double after = rounded.fine_of(type.value).density;
    EXPECT_EQ(BreachOf(*bounds.number(FineParameter::kDensity), after), "");
    for (int tenths = 0; tenths <= 10; ++tenths) {
      if (!BreachOf(*bounds.number(FineParameter::kDensity), tenths / 10.0).empty()) continue;
      EXPECT_LE(std::abs(after - before), std::abs(tenths / 10.0 - before)) << type.name;
    }
  }
}

// The grammar of answers knows 345 and 0.5, and neither 345.0 nor a blank.
TEST(AnswerInFormTest, SpellsNumbersAsTheFormDoes) {
  EnvironmentConfig environment = Drawn(1);
  environment.fine_of(AssetType::kForest).rotation_deg = {0.0, 0.0, 341.0};
  environment.fine_of(AssetType::kForest).scale = 1.0;
  RoundToForm(&environment);
  const std::string answer = AnswerInForm(environment);
  EXPECT_NE(answer.find(R"("rotation":[0,0,345])"), std::string::npos) << answer;
  EXPECT_NE(answer.find(R"("scale":1.0)"), std::string::npos) << answer;
  EXPECT_EQ(nlohmann::ordered_json::parse(answer).dump(), answer) << "no blanks between tokens";
}

}  // namespace
}  // namespace latticeworld
