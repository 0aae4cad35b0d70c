#include "latticeworld/language/local/tokens/schema_grammar.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "language/remote/form_checkers.h"
#include "latticeworld/common/random.h"
#include "latticeworld/environment/environment_config.h"
#include "latticeworld/language/local/tokens/grammar.h"
#include "latticeworld/language/remote/answer_in_form.h"
#include "latticeworld/language/remote/forms.h"

namespace latticeworld {
namespace {

// A text of the grammar, its bytes drawn one by one.
std::string RandomText(const Grammar& grammar, RandomStream* random) {
  GrammarMatcher matcher(grammar);
  GrammarMatcher::State state = matcher.Begin();
  std::string text;
  for (int i = 0; i < 20000; ++i) {
    std::string next;
    for (int byte = 0; byte < 256; ++byte)
      if (!matcher.After(state, static_cast<unsigned char>(byte)).empty())
        next += static_cast<char>(byte);
    if (next.empty() || (matcher.Accepts(state) && random->Chance(0.5))) return text;
    const char c = next[random->UniformInt(0, static_cast<int>(next.size()) - 1)];
    state = matcher.After(state, static_cast<unsigned char>(c));
    text += c;
  }
  return text;
}

Grammar Of(const std::string& schema) {
  const auto gbnf = SchemaGrammar(schema);
  EXPECT_TRUE(gbnf.ok()) << gbnf.status().ToString();
  auto grammar = Grammar::FromGbnf(*gbnf);
  EXPECT_TRUE(grammar.ok()) << grammar.status().ToString() << "\n" << *gbnf;
  return *std::move(grammar);
}

bool Accepts(const Grammar& grammar, const std::string& text) {
  GrammarMatcher matcher(grammar);
  GrammarMatcher::State state = matcher.Begin();
  for (const char c : text) state = matcher.After(state, static_cast<unsigned char>(c));
  return matcher.Accepts(state);
}

TEST(SchemaGrammarTest, TextsOfTheEnvironmentsGrammarAreValid) {
  const std::string schema = EnvironmentForm().json_schema;
  const Grammar grammar = Of(schema);
  RandomStream random(4, "texts");
  for (int i = 0; i < 5; ++i) {
    const std::string text = RandomText(grammar, &random);
    EXPECT_TRUE(MatchesSchema(schema, text)) << text;
  }
}

TEST(SchemaGrammarTest, AcceptsEveryInstanceOfTheEnvironmentsSchema) {
  const std::string schema = EnvironmentForm().json_schema;
  const Grammar grammar = Of(schema);
  RandomStream random(5, "instances");
  for (int i = 0; i < 5; ++i) {
    // In the schema's order: nlohmann's ordered form of what the checker made.
    const std::string text = nlohmann::ordered_json::parse(RandomInstance(schema, &random)).dump();
    EXPECT_TRUE(Accepts(grammar, text)) << text;
  }
}

// What data sets teach is what can be said.
TEST(SchemaGrammarTest, AcceptsAnswersInForm) {
  const Grammar grammar = Of(EnvironmentForm().json_schema);
  for (const auto& season : EnumNames(Season{})) {
    for (const auto& weather : EnumNames(Weather{})) {
      EnvironmentConfig environment;
      environment.coarse.season = season.value;
      environment.coarse.weather = weather.value;
      environment.fine = DeriveFineAttributes(environment.coarse);
      environment.agents = {{AgentCategory::kEagle, 3, AgentState::kFlying, Region::kUpperLeft}};
      RoundToForm(&environment);
      EXPECT_TRUE(Accepts(grammar, AnswerInForm(environment))) << AnswerInForm(environment);
    }
  }
}

TEST(SchemaGrammarTest, IntegersAreExactlyThoseOfTheRange) {
  RandomStream random(6, "ranges");
  for (int i = 0; i < 40; ++i) {
    const int low = random.UniformInt(-30, 1200), high = low + random.UniformInt(0, 1500);
    const Grammar grammar = Of("{\"type\":\"integer\",\"minimum\":" + std::to_string(low) +
                               ",\"maximum\":" + std::to_string(high) + "}");
    for (int value = low - 15; value <= high + 15; value += 1 + (high - low) / 90)
      EXPECT_EQ(Accepts(grammar, std::to_string(value)), value >= low && value <= high)
          << value << " of " << low << " to " << high;
    EXPECT_FALSE(Accepts(grammar, "007"));
    EXPECT_FALSE(Accepts(grammar, ""));
  }
}

TEST(SchemaGrammarTest, NamesThePlaceOfWhatItDoesNotRead) {
  const auto refused = [](const std::string& schema) {
    const auto gbnf = SchemaGrammar(schema);
    return gbnf.ok() ? std::string("accepted") : gbnf.status().message();
  };
  EXPECT_NE(refused("{").find("no JSON"), std::string::npos);
  EXPECT_NE(refused(R"({"type":"array","items":{"anyOf":[]}})").find("'/items'"),
            std::string::npos);
  EXPECT_NE(refused(R"({"type":"string","pattern":"a"})").find("'pattern'"), std::string::npos);
  EXPECT_NE(refused(R"({"type":"object","properties":{"a":{"type":"null"}}})").find("all their"),
            std::string::npos);
  EXPECT_NE(refused(R"({"type":"integer","minimum":5,"maximum":1})").find("5 to 1"),
            std::string::npos);
  EXPECT_NE(refused(R"({"type":"array","items":{"type":"null"},"maxItems":5000})").find("1000"),
            std::string::npos);
}

// Once writing such a constant took more stack than there is.
TEST(SchemaGrammarTest, RefusesConstantsThatAreNestedTooDeep) {
  const std::string deep = std::string(1000, '[') + std::string(1000, ']');
  for (const std::string& schema : {"{\"const\":" + deep + "}", "{\"enum\":[" + deep + "]}",
                                    "{\"type\":\"object\",\"properties\":" + deep + "}"}) {
    const auto gbnf = SchemaGrammar(schema);
    ASSERT_FALSE(gbnf.ok());
    EXPECT_NE(gbnf.status().message().find("too deep"), std::string::npos);
  }
  EXPECT_TRUE(SchemaGrammar(R"({"const": [[[[{"a": [1]}]]]]})").ok());
}

}  // namespace
}  // namespace latticeworld
