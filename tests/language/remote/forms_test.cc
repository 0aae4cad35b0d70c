#include "latticeworld/language/remote/forms.h"

#include <gtest/gtest.h>
#include <regex.h>

#include <nlohmann/json.hpp>
#include <string>
#include <tuple>

#include "language/remote/fake_chat_server.h"
#include "language/remote/form_checkers.h"
#include "latticeworld/common/text.h"
#include "latticeworld/environment/environment_config.h"
#include "latticeworld/language/chat/kept_form.h"
#include "latticeworld/layout/symbolic_layout.h"

namespace latticeworld {
namespace {

using Json = nlohmann::ordered_json;

// POSIX extended syntax agrees with every server's for what the form uses, but for "\n".
bool MatchesRegex(std::string pattern, const std::string& text) {
  for (std::size_t at; (at = pattern.find("\\n")) != std::string::npos;) {
    pattern.replace(at, 2, "\n");
  }
  regex_t compiled;
  EXPECT_EQ(regcomp(&compiled, ("^(" + pattern + ")$").c_str(), REG_EXTENDED | REG_NOSUB), 0);
  const bool matches = regexec(&compiled, text.c_str(), 0, nullptr, 0) == 0;
  regfree(&compiled);
  return matches;
}

std::string AsRows(const std::string& matrix) {
  Json rows = Json::array();
  for (const std::string& line : Split(matrix, '\n')) rows.push_back(line);
  return Json{{"rows", rows}}.dump();
}

// A legal matrix without its last newline, as the forms want it.
std::string RandomMatrix(Vocabulary vocabulary, RandomStream* random) {
  const auto& classes = ClassesOf(vocabulary);
  std::string text;
  for (int i = 0; i < 32 * 33 - 1; ++i) {
    text += i % 33 == 32 ? '\n'
                         : classes[static_cast<std::size_t>(
                                       random->UniformInt(0, static_cast<int>(classes.size()) - 1))]
                               .letter;
  }
  return text;
}

TEST(LayoutFormTest, EveryLanguageAcceptsLegalLayoutsAndTheyParse) {
  for (const auto vocabulary : {Vocabulary::kSuburb, Vocabulary::kWild}) {
    const AnswerForm form = LayoutForm(vocabulary);
    EXPECT_EQ(form.name, "layout");
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      RandomStream random(seed, "legal matrix");
      const std::string matrix = RandomMatrix(vocabulary, &random);
      ASSERT_EQ(matrix.size(), 1055u);
      EXPECT_TRUE(MatchesGbnf(form.gbnf, matrix));
      EXPECT_TRUE(MatchesRegex(form.regex, matrix));
      EXPECT_EQ(KeepsForm(matrix, /*whole=*/true, form, FormLanguage::kGbnf), KeptForm::kYes);
      EXPECT_TRUE(MatchesSchema(form.json_schema, AsRows(matrix)));
      EXPECT_TRUE(ParseLayout(matrix, vocabulary).ok());
    }
  }
}

TEST(LayoutFormTest, EveryLanguageRefusesWhatTheCodecRefuses) {
  const AnswerForm form = LayoutForm(Vocabulary::kWild);
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    RandomStream random(seed, "illegal matrix");
    std::string matrix = RandomMatrix(Vocabulary::kWild, &random);
    const auto at = static_cast<std::size_t>(random.UniformInt(0, 1054));
    switch (random.UniformInt(0, 3)) {
      case 0:
        matrix[at] = matrix[at] == '\n' ? 'B' : 'A';  // one letter or newline that is wrong
        break;
      case 1:
        matrix.erase(at, 1);
        break;
      case 2:
        matrix.insert(at, "W");
        break;
      default:
        matrix += "\n" + std::string(32, 'F');
    }
    ASSERT_FALSE(ParseLayout(matrix, Vocabulary::kWild).ok());
    EXPECT_FALSE(MatchesGbnf(form.gbnf, matrix)) << seed;
    EXPECT_FALSE(MatchesRegex(form.regex, matrix)) << seed;
    EXPECT_EQ(KeepsForm(matrix, /*whole=*/true, form, FormLanguage::kGbnf), KeptForm::kNo) << seed;
    EXPECT_FALSE(MatchesSchema(form.json_schema, AsRows(matrix))) << seed;
  }
}

TEST(LayoutFormTest, SchemaWantsRowsAndNothingElse) {
  const std::string schema = LayoutForm(Vocabulary::kSuburb).json_schema;
  EXPECT_FALSE(MatchesSchema(schema, "{}"));
  EXPECT_FALSE(MatchesSchema(schema, "[]"));
  RandomStream random(1, "matrix");
  Json json = Json::parse(AsRows(RandomMatrix(Vocabulary::kSuburb, &random)));
  EXPECT_TRUE(MatchesSchema(schema, json.dump()));
  json["note"] = "";
  EXPECT_FALSE(MatchesSchema(schema, json.dump()));
}

TEST(EnvironmentFormTest, WhatItAcceptsIsLegalUpToTheRulesThatNoSchemaCanSay) {
  const std::string schema = EnvironmentForm().json_schema;
  int legal = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    RandomStream random(seed, "environment");
    const std::string json = RandomInstance(schema, &random);
    ASSERT_TRUE(MatchesSchema(schema, json)) << json;
    const auto environment = ParseEnvironment(json);
    legal += environment.ok() ? 1 : 0;
    for (const Violation& violation : environment.status().violations()) {
      EXPECT_TRUE(violation.code == "conflict" || violation.pointer == "/agents")
          << violation.code << " " << violation.pointer << " " << violation.message;
    }
  }
  EXPECT_LT(legal, 200) << "no schema can say which variant goes with which season";
}

TEST(EnvironmentFormTest, ReachesEveryNameOfTheFullSchema) {
  const std::string schema = EnvironmentForm().json_schema;
  for (const auto& type : EnumNames(AssetType{})) {
    for (const auto& name : ValuesOf(type.value).season_variants) {
      EXPECT_NE(schema.find('"' + std::string(name) + '"'), std::string::npos) << name;
    }
    for (const auto& name : ValuesOf(type.value).materials) {
      EXPECT_NE(schema.find('"' + std::string(name) + '"'), std::string::npos) << name;
    }
  }
  const Json json = Json::parse(schema);
  EXPECT_EQ(json["properties"]["coarse"]["properties"]["terrain_type"]["enum"].size(), 9u);
  EXPECT_EQ(json["properties"]["agents"]["items"]["properties"]["category"]["enum"].size(), 10u);
}

TEST(EnvironmentFormTest, SaysRangesInStepsThatGrammarsCanSpell) {
  const Json fine = Json::parse(EnvironmentForm().json_schema)["properties"]["fine"]["properties"];
  EXPECT_EQ(fine["grass"]["properties"]["density"].dump(),
            R"({"type":"number","enum":[0.0,0.1,0.2,0.3,0.4,0.5,0.6,0.7,0.8,0.9,1.0]})");
  const auto ends = [](const Json& schema) {
    return std::make_tuple(schema["enum"].front(), schema["enum"].back(), schema["enum"].size());
  };
  EXPECT_EQ(ends(fine["forest"]["properties"]["rotation"]["items"]), std::make_tuple(0, 345, 24u));
  EXPECT_EQ(ends(fine["architecture"]["properties"]["scale"]), std::make_tuple(0.25, 4.0, 16u));
  EXPECT_EQ(ends(fine["lake"]["properties"]["height"]), std::make_tuple(-5.0, 5.0, 21u));
  EXPECT_EQ(ends(fine["desert"]["properties"]["wind"]), std::make_tuple(0, 40, 21u));
  EXPECT_EQ(ends(fine["snow_mountain"]["properties"]["slope"]), std::make_tuple(0, 90, 19u));
}

}  // namespace
}  // namespace latticeworld
