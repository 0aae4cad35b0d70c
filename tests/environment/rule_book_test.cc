// The engine on small rule files of its own, and rule files that are wrong.

#include "latticeworld/environment/rule_book.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <ostream>
#include <set>
#include <string>
#include <vector>

#include "environment/bounds_text.h"
#include "environment/coarse_combinations.h"

namespace latticeworld {
namespace {

using Json = nlohmann::ordered_json;

// A rule file of rules that are written without id and why.
Result<RuleBook> Parse(const std::vector<std::string>& rules) {
  Json json = {{"rules", Json::array()}};
  for (std::size_t i = 0; i < rules.size(); ++i) {
    Json rule = {{"id", "rule-" + std::to_string(i)}, {"why", "reason " + std::to_string(i)}};
    rule.update(Json::parse(rules[i]));
    json["rules"].push_back(rule);
  }
  return RuleBook::Parse(json.dump());
}

RuleBook Book(const std::vector<std::string>& rules) {
  Result<RuleBook> book = Parse(rules);
  EXPECT_TRUE(book.ok()) << book.status().ToString();
  return std::move(book).value();
}

FineBounds Bounds(const RuleBook& book, AssetType type,
                  const CoarseAttributes& coarse = CoarseAttributes()) {
  return book.BoundsOf(coarse, type, *Catalogue::BuiltIn());
}

NumberBound Density(const RuleBook& book) {
  return *Bounds(book, AssetType::kGrass).number(FineParameter::kDensity);
}

std::string LegalOf(const std::vector<ValueBound>& values) {
  std::string legal;
  for (const ValueBound& value : values) {
    if (value.legal()) legal += (legal.empty() ? "" : ", ") + std::string(value.name);
  }
  return legal;
}

TEST(RuleBookTest, LaterRulesNarrowAndNeverWiden) {
  const RuleBook book =
      Book({R"({"then": [{"of": ["grass"], "density": {"min": 0.2, "max": 0.7}}]})",
            R"({"then": [{"of": ["grass"], "density": {"min": 0.1, "max": 0.5}}]})",
            R"({"then": [{"of": ["grass"], "density": {"max": 0.9}}]})"});
  const NumberBound density = Density(book);
  EXPECT_EQ(density.range.low, 0.2);
  EXPECT_EQ(density.range.high, 0.5);
  EXPECT_EQ(density.lowest->id, "rule-0");
  EXPECT_EQ(density.highest->id, "rule-1");
  EXPECT_EQ(density.highest->why, "reason 1");
}

TEST(RuleBookTest, LimitsThatMeetLeaveOneValue) {
  const RuleBook book = Book({R"({"then": [{"of": ["grass"], "density": {"max": 0.3}}]})",
                              R"({"then": [{"of": ["grass"], "density": {"min": 0.6}}]})"});
  const NumberBound density = Density(book);
  EXPECT_EQ(density.range.low, 0.3);
  EXPECT_EQ(density.range.high, 0.3);
  EXPECT_EQ(density.typical, 0.3);
  EXPECT_EQ(BreachOf(density, 0.4), "the rule rule-0 allows 0.3 at most (reason 0)");
  EXPECT_EQ(BreachOf(density, 0.2), "the rule rule-1 allows 0.3 at least (reason 1)");
  EXPECT_EQ(BreachOf(density, 0.3), "");
}

TEST(RuleBookTest, TypicalValuesAreSetThenScaledThenKeptWithinTheRange) {
  const auto typical = [](const std::string& number) {
    return Density(Book({R"({"then": [{"of": ["grass"], "density": {"typical": 0.8}}]})",
                         R"({"then": [{"of": ["grass"], "density": )" + number + "}]}"}))
        .typical;
  };
  EXPECT_DOUBLE_EQ(typical(R"({"factor": 0.5})"), 0.4);
  EXPECT_DOUBLE_EQ(typical(R"({"factor": 3})"), 1.0);
  EXPECT_DOUBLE_EQ(typical(R"({"typical": 0.6, "factor": 0.5})"), 0.3);
  EXPECT_DOUBLE_EQ(typical(R"({"max": 0.25})"), 0.25);
  EXPECT_DOUBLE_EQ(typical(R"({"min": 0.9})"), 0.9);
}

TEST(RuleBookTest, DrawsAreKeptWithinTheRange) {
  const NumberBound density = Density(Book(
      {R"({"then": [{"of": ["grass"], "density": {"draw": [0.1, 0.9]}}]})",
       R"({"then": [{"of": ["grass"], "density": {"min": 0.3, "max": 0.6, "evenly": true}}]})"}));
  EXPECT_EQ(density.draw_low, 0.3);
  EXPECT_EQ(density.draw_high, 0.6);
  EXPECT_TRUE(density.draw_evenly);
}

TEST(RuleBookTest, WithoutRulesEverythingOfTheCatalogueIsLegal) {
  const RuleBook book(std::vector<Rule>{});
  for (const auto& type : EnumNames(AssetType{})) {
    const FineBounds bounds = Bounds(book, type.value);
    for (const ValueBound& value : bounds.season_variants) EXPECT_TRUE(value.legal());
    EXPECT_EQ(bounds.materials.size(), ValuesOf(type.value).materials.size());
    EXPECT_EQ(bounds.number(FineParameter::kDensity)->range.high, 1.0);
  }
}

TEST(RuleBookTest, SelectorsMeanNamesSeasonsAndSnow) {
  const auto legal = [](const std::string& selector, AssetType type, Season season) {
    CoarseAttributes coarse;
    coarse.season = season;
    return LegalOf(Bounds(Book({R"({"then": [{"of": ["grass", "lake"], "season_variants": )"
                                R"({"exclude": [)" +
                                selector + "]}}]}"}),
                          type, coarse)
                       .season_variants);
  };
  const std::string out = R"({"out_of_season": true})", snow = R"({"snow_above": 0.5})";
  EXPECT_EQ(legal(out, AssetType::kGrass, Season::kWinter), "dry, snow-covered");
  EXPECT_EQ(legal(out, AssetType::kGrass, Season::kSummer), "lush, dry, snow-covered");
  EXPECT_EQ(legal(snow, AssetType::kGrass, Season::kSummer), "lush, dry");
  EXPECT_EQ(legal(R"({"snow_above": 0.9})", AssetType::kGrass, Season::kSummer),
            "lush, dry, snow-covered");
  // All that a selector names must be true of a variant; one of several selectors is enough.
  EXPECT_EQ(
      legal(R"({"snow_above": 0.1, "out_of_season": true})", AssetType::kLake, Season::kSummer),
      "open");
  EXPECT_EQ(
      legal(R"({"snow_above": 0.1, "out_of_season": true})", AssetType::kLake, Season::kWinter),
      "open, frozen");
  EXPECT_EQ(legal(out + ", " + snow, AssetType::kGrass, Season::kWinter), "dry");
}

TEST(RuleBookTest, WordsAreWholeWords) {
  EXPECT_TRUE(HasWords("summer pine", "pine"));
  EXPECT_TRUE(HasWords("summer pine", "summer pine"));
  EXPECT_TRUE(HasWords("pine", "pine"));
  EXPECT_TRUE(HasWords("anything", ""));
  EXPECT_TRUE(HasWords("alpine pine", "pine"));
  EXPECT_FALSE(HasWords("alpine", "pine"));
  EXPECT_FALSE(HasWords("pineapple", "pine"));
  EXPECT_FALSE(HasWords("summer pine", "winter pine"));
  EXPECT_FALSE(HasWords("", "pine"));
}

TEST(RuleBookTest, AnExclusionThatWouldLeaveNothingIsNotApplied) {
  const RuleBook book = Book(
      {R"({"then": [{"of": ["lake"], "season_variants": {"exclude": [{"words": "open"}]}}]})",
       R"({"then": [{"of": ["lake"], "season_variants": {"exclude": [{"words": "frozen"}]}}]})",
       R"({"then": [{"of": ["lake"], "materials": {"exclude": [{"words": "clear"}]}}]})"});
  const FineBounds lake = Bounds(book, AssetType::kLake);
  EXPECT_EQ(LegalOf(lake.season_variants), "frozen");
  EXPECT_EQ(lake.season_variants[0].excluded->id, "rule-0");
  EXPECT_EQ(LegalOf(lake.materials), "silty");
  EXPECT_EQ(BreachOf(lake.materials, "clear"),
            "the rule rule-2 excludes it (reason 2); legal are silty");
  EXPECT_EQ(BreachOf(lake.materials, "silty"), "");
  EXPECT_EQ(BreachOf(lake.materials, "milky"), "there is no such value; legal are silty");
}

TEST(RuleBookTest, TheFirstRuleThatExcludesAValueIsNamed) {
  const std::string rule =
      R"({"then": [{"of": ["grass"], "season_variants": {"exclude": [{"words": "dry"}]}}]})";
  EXPECT_EQ(Bounds(Book({rule, rule}), AssetType::kGrass).season_variants[1].excluded->id,
            "rule-0");
}

TEST(RuleBookTest, WeightsMultiply) {
  const FineBounds forest = Bounds(
      Book(
          {R"({"then": [{"of": ["forest"], "season_variants": {"weights": {"oak": 2, "summer": 3}}}]})",
           R"({"then": [{"of": ["forest"], "season_variants": {"weights": {"summer oak": 0.5}}}]})"}),
      AssetType::kForest);
  for (const ValueBound& variant : forest.season_variants) {
    const double expected = variant.name == "summer oak"       ? 3.0
                            : HasWords(variant.name, "summer") ? 3.0
                            : HasWords(variant.name, "oak")    ? 2.0
                                                               : 1.0;
    EXPECT_EQ(variant.weight, expected) << variant.name;
  }
}

TEST(RuleBookTest, ARuleHoldsWhereOneOfItsConditionsHoldsWhole) {
  const RuleBook book = Book({R"({"when": [{"season": ["winter"], "weather": ["fog", "rain"]},)"
                              R"({"terrain_type": ["coast"], "time_of_day": ["night"]}],)"
                              R"("then": [{"of": ["grass"], "density": {"max": 0.5}}]})"});
  ForEveryPhysicalCoarse([&](const CoarseAttributes& coarse) {
    const bool expected =
        (coarse.season == Season::kWinter &&
         (coarse.weather == Weather::kFog || coarse.weather == Weather::kRain)) ||
        (coarse.terrain_type == TerrainType::kCoast && coarse.time_of_day == TimeOfDay::kNight);
    ASSERT_EQ(book.rules()[0].Holds(coarse), expected);
    const double high =
        Bounds(book, AssetType::kGrass, coarse).number(FineParameter::kDensity)->range.high;
    ASSERT_EQ(high, expected ? 0.5 : 1.0);
  });
}

TEST(RuleBookTest, ARuleBindsOnlyTheTypesThatItNames) {
  const RuleBook book = Book({R"({"then": [{"of": ["grass"], "density": {"max": 0.5}}]})"});
  EXPECT_EQ(Bounds(book, AssetType::kCrops).number(FineParameter::kDensity)->range.high, 1.0);
  const RuleBook all = Book({R"({"then": [{"of": ["all"], "density": {"max": 0.5}}]})"});
  for (const auto& type : EnumNames(AssetType{})) {
    EXPECT_EQ(Bounds(all, type.value).number(FineParameter::kDensity)->range.high, 0.5);
  }
}

struct Slip {
  std::string rule;
  std::string code;
  std::string pointer;
};
void PrintTo(const Slip& slip, std::ostream* os) { *os << slip.rule; }

class WrongRule : public testing::TestWithParam<Slip> {};

TEST_P(WrongRule, IsRefusedWithItsPlace) {
  const Result<RuleBook> book = Parse({GetParam().rule});
  ASSERT_FALSE(book.ok());
  EXPECT_EQ(book.status().code(), StatusCode::kInvalidArgument);
  ASSERT_EQ(book.status().violations().size(), 1u) << book.status().ToString();
  const Violation& violation = book.status().violations()[0];
  EXPECT_EQ(violation.code, GetParam().code) << violation.message;
  EXPECT_EQ(violation.pointer, "/rules/0" + GetParam().pointer);
}

INSTANTIATE_TEST_SUITE_P(
    Slips, WrongRule,
    testing::ValuesIn(std::vector<Slip>{
        {R"({})", "missing_key", "/then"},
        {R"({"then": []})", "wrong_count", "/then"},
        {R"({"then": [{"of": ["grass"]}]})", "wrong_count", "/then/0"},
        {R"({"then": [{"density": {"max": 1}, "wind": {"max": 1}}]})", "missing_key", "/then/0/of"},
        {R"({"then": [{"of": "all", "density": {"max": 1}}]})", "wrong_type", "/then/0/of"},
        {R"({"then": [{"of": ["grass", "grass"], "density": {"max": 1}}]})", "duplicate_value",
         "/then/0/of"},
        {R"({"then": [{"of": ["grass"], "colour": 1}]})", "unknown_key", "/then/0/colour"},
        {R"({"then": [{"of": ["grass"], "density": {"most": 1}}]})", "unknown_key",
         "/then/0/density/most"},
        {R"({"then": [{"of": ["grass"], "density": {"max": "1"}}]})", "wrong_type",
         "/then/0/density/max"},
        {R"({"then": [{"of": ["grass"], "density": {"factor": 0}}]})", "out_of_range",
         "/then/0/density/factor"},
        {R"({"then": [{"of": ["grass"], "density": {"evenly": 1}}]})", "wrong_type",
         "/then/0/density/evenly"},
        {R"({"then": [{"of": ["grass"], "density": {"draw": [0]}}]})", "wrong_count",
         "/then/0/density/draw"},
        {R"({"then": [{"of": ["grass"], "season_variants": {"weights": {"lush": 0}}}]})",
         "out_of_range", "/then/0/season_variants/weights/lush"},
        {R"({"then": [{"of": ["grass"], "season_variants": {"exclude": [{"out_of_season": false}]}}]})",
         "unknown_value", "/then/0/season_variants/exclude/0/out_of_season"},
        {R"({"then": [{"of": ["grass"], "materials": {"exclude": [{"words": "reed", "snow_above": 0}]}}]})",
         "unknown_key", "/then/0/materials/exclude/0/snow_above"},
        {R"({"when": {"season": ["winter"]}, "then": [{"of": ["all"], "density": {"max": 1}}]})",
         "wrong_type", "/when"},
        {R"({"when": [{}], "then": [{"of": ["all"], "density": {"max": 1}}]})", "wrong_count",
         "/when/0"},
        // The artistic style binds nothing physical.
        {R"({"when": [{"artistic_style": ["cartoon"]}], "then": [{"of": ["all"], "density": {"max": 1}}]})",
         "unknown_key", "/when/0/artistic_style"},
        {R"({"id": "No id", "then": [{"of": ["all"], "density": {"max": 1}}]})", "bad_format",
         "/id"},
        {R"({"when": [{"season": ["monsoon"]}], "then": [{"of": ["all"], "density": {"max": 1}}]})",
         "unknown_value", "/when/0/season/0"},
        {R"({"when": [{"season": ["winter"]}, {"weather": ["rain", "hail"]}], "then": [{"of": ["all"], "density": {"max": 1}}]})",
         "unknown_value", "/when/1/weather/1"},
        {R"({"then": [{"of": ["grass", "sea"], "density": {"max": 1}}]})", "unknown_value",
         "/then/0/of/1"},
        {R"({"then": [{"of": ["grass", "all"], "density": {"max": 1}}]})", "unknown_value",
         "/then/0/of/1"},
        {R"({"then": [{"of": ["grass"], "season_variants": {"weights": {"lsh": 2}}}]})",
         "unknown_value", "/then/0/season_variants/weights/lsh"},
        {R"({"then": [{"of": ["grass", "road"], "season_variants": {"exclude": [{"words": "lush"}]}}]})",
         "unknown_value", "/then/0/season_variants/exclude/0/words"},
        {R"({"then": [{"of": ["lake"], "materials": {"weights": {"open": 2}}}]})", "unknown_value",
         "/then/0/materials/weights/open"},
        {R"({"then": [{"of": ["grass"], "wind": {"max": 3}}]})", "unknown_key", "/then/0/wind"},
        {R"({"then": [{"of": ["grass"], "density": {"max": 1.5}}]})", "out_of_range",
         "/then/0/density/max"},
        {R"({"then": [{"of": ["grass"], "density": {"typical": -0.1}}]})", "out_of_range",
         "/then/0/density/typical"},
        {R"({"then": [{"of": ["grass"], "density": {"min": 0.6, "max": 0.5}}]})", "out_of_range",
         "/then/0/density/max"},
        {R"({"then": [{"of": ["grass"], "density": {"draw": [0.6, 0.5]}}]})", "out_of_range",
         "/then/0/density/draw/1"},
        {R"({"then": [{"of": ["desert"], "wind": {"draw": [-1, 5]}}]})", "out_of_range",
         "/then/0/wind/draw/0"},
    }));

TEST(RuleFileTest, AllSlipsComeAtOnce) {
  const std::string rule = R"({"id": "twice", "when": [{"season": ["monsoon"]}],)"
                           R"("then": [{"of": ["sea", "grass"], "density": {"max": 2}}]})";
  const Status status = Parse({rule, rule}).status();
  std::multiset<std::string> codes;
  for (const Violation& violation : status.violations()) codes.insert(violation.code);
  EXPECT_EQ(codes.count("unknown_value"), 4u);
  EXPECT_EQ(codes.count("out_of_range"), 2u);
  EXPECT_EQ(codes.count("duplicate_name"), 1u);
}

TEST(RuleFileTest, WhatIsNoRuleFileIsRefused) {
  for (const std::string& text :
       {std::string(), std::string("{"), std::string("[]"), std::string("null"),
        std::string("{\"rules\": []}"), std::string("{\"rules\": {}}"), std::string("\xff"),
        std::string("{\"rules\": ") + std::string(50000, '[') + std::string(50000, ']') + "}"}) {
    const Result<RuleBook> book = RuleBook::Parse(text);
    ASSERT_FALSE(book.ok()) << text.substr(0, 20);
    EXPECT_EQ(book.status().code(), StatusCode::kInvalidArgument);
    EXPECT_LT(book.status().message().size(), 2000u);
  }
}

TEST(RuleFileTest, AKeyTwiceIsRefused) {
  std::string text(RuleText());
  text.insert(text.find("\"id\""), "\"why\": \"twice\", ");
  const Status status = RuleBook::Parse(text).status();
  ASSERT_EQ(status.violations().size(), 1u) << status.ToString();
  EXPECT_EQ(status.violations()[0].code, "duplicate_key");
  EXPECT_EQ(status.violations()[0].pointer, "/rules/0/why");
}

TEST(RuleFileTest, TheOneThatIsCompiledInObeysTheSchemaAndIsTheOneInUse) {
  const Result<RuleBook> book = RuleBook::Parse(RuleText());
  ASSERT_TRUE(book.ok()) << book.status().ToString();
  CoarseAttributes coarse;
  coarse.season = Season::kWinter;
  EXPECT_EQ(ToText(Bounds(*book, AssetType::kForest, coarse)),
            ToText(BoundsOf(coarse, AssetType::kForest)));
}

// Each value of the shipped file, replaced by what the schema forbids, makes the file illegal.
TEST(RuleFileTest, NoValueOfTheFileEscapesTheCheck) {
  const Json whole = Json::parse(RuleText());
  const Json flat = whole.flatten();
  int broken = 0;
  for (const auto& [path, value] : flat.items()) {
    if (++broken % 5 != 0) continue;  // every path of every kind is hit by some
    Json json = whole;
    json[Json::json_pointer(path)] = value.is_boolean() ? Json(3) : Json(Json::object());
    EXPECT_FALSE(RuleBook::Parse(json.dump()).ok()) << path;
  }
  EXPECT_GT(broken, 200);
}

}  // namespace
}  // namespace latticeworld
