// Every combination of coarse values, every rule.

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "catalogue/larch.h"
#include "environment/bounds_text.h"
#include "environment/coarse_combinations.h"
#include "latticeworld/common/random.h"
#include "latticeworld/environment/environment_config.h"
#include "latticeworld/environment/rule_book.h"

namespace latticeworld {
namespace {

std::string Text(const CoarseAttributes& coarse) {
  return std::string(NameOf(coarse.terrain_type)) + " " + std::string(NameOf(coarse.season)) + " " +
         std::string(NameOf(coarse.weather)) + " " + std::string(NameOf(coarse.time_of_day));
}

TEST(RulePropertiesTest, EveryCombinationHasATypicalConfigurationWithoutConflict) {
  int combinations = 0;
  ForEveryCoarse([&](const CoarseAttributes& coarse) {
    ++combinations;
    EnvironmentConfig environment;
    environment.coarse = coarse;
    environment.fine = DeriveFineAttributes(coarse);
    const std::vector<Violation> violations = Validate(environment);
    ASSERT_TRUE(violations.empty()) << violations[0].pointer << " " << violations[0].message;
  });
  EXPECT_EQ(combinations, kCoarseCombinations);
}

TEST(RulePropertiesTest, EveryCombinationHasDrawnConfigurationsWithoutConflict) {
  const Catalogue& catalogue = *Catalogue::BuiltIn();
  ForEveryPhysicalCoarse([&](const CoarseAttributes& coarse) {
    for (std::uint64_t seed = 0; seed < 3; ++seed) {
      RandomStream random(seed, "fine attributes");
      EnvironmentConfig environment;
      environment.coarse = coarse;
      environment.fine = SampleFineAttributes(coarse, catalogue, &random);
      const std::vector<Violation> violations = Validate(environment);
      ASSERT_TRUE(violations.empty()) << violations[0].pointer << " " << violations[0].message;
    }
  });
}

// A user's own values need no rules: what they say of themselves is enough.
TEST(RulePropertiesTest, AUsersValuesObeyTheGenericRules) {
  const auto catalogue = Catalogue::Extended({{"larch.json", LarchFile()}}).value();
  const auto& variants = catalogue->season_variants(AssetType::kForest);
  ForEveryPhysicalCoarse([&](const CoarseAttributes& coarse) {
    const FineBounds bounds = BoundsOf(coarse, AssetType::kForest, *catalogue);
    for (std::size_t i = 18; i < variants.size(); ++i) {
      ASSERT_EQ(bounds.season_variants[i].legal(),
                variants[i].seasons[static_cast<std::size_t>(coarse.season)]);
    }
    RandomStream random(3, "fine attributes");
    EnvironmentConfig environment;
    environment.coarse = coarse;
    environment.fine = SampleFineAttributes(coarse, *catalogue, &random);
    ASSERT_TRUE(Validate(environment, *catalogue).empty());
    ASSERT_EQ(DeriveFineAttributes(coarse, *catalogue)[0].season_variant,
              DeriveFineAttributes(coarse)[0].season_variant);
  });
}

TEST(RulePropertiesTest, ThinnedCombinationsReadBackAsWritten) {
  int index = 0;
  ForEveryCoarse([&](const CoarseAttributes& coarse) {
    if (++index % 29 != 0) return;  // coprime to the numbers of values: every one comes up
    RandomStream random(static_cast<std::uint64_t>(index), "fine attributes");
    EnvironmentConfig environment;
    environment.coarse = coarse;
    environment.fine = SampleFineAttributes(coarse, *Catalogue::BuiltIn(), &random);
    const std::string json = ToJson(environment);
    const Result<EnvironmentConfig> read = ParseEnvironment(json);
    ASSERT_TRUE(read.ok()) << read.status().ToString();
    ASSERT_EQ(ToJson(*read), json);
  });
}

TEST(RulePropertiesTest, EveryCombinationLeavesEveryTypeRoom) {
  ForEveryPhysicalCoarse([](const CoarseAttributes& coarse) {
    for (const auto& type : EnumNames(AssetType{})) {
      const FineBounds bounds = BoundsOf(coarse, type.value);
      for (const auto* values : {&bounds.season_variants, &bounds.materials}) {
        bool any = false;
        for (const ValueBound& value : *values) {
          any = any || value.legal();
          ASSERT_GT(value.weight, 0.0) << value.name;
        }
        ASSERT_TRUE(any) << type.name << " in " << Text(coarse);
      }
      const NumberBound& density = *bounds.number(FineParameter::kDensity);
      ASSERT_GE(density.range.high - density.range.low, 0.3) << type.name;
      for (const auto& parameter : EnumNames(FineParameter{})) {
        const auto& bound = bounds.number(parameter.value);
        ASSERT_EQ(bound.has_value(), HasParameter(ValuesOf(type.value), parameter.value));
        if (!bound) continue;
        ASSERT_LT(bound->range.low, bound->range.high);
        ASSERT_TRUE(bound->range.Contains(bound->typical));
        ASSERT_LE(bound->range.low, bound->draw_low);
        ASSERT_LE(bound->draw_low, bound->draw_high);
        ASSERT_LE(bound->draw_high, bound->range.high);
      }
    }
  });
}

// No exclusion of the built-in rules had to be dropped because it would have left nothing: each of
// them alone leaves out the same values that it leaves out among the others or before them.
TEST(RulePropertiesTest, NoRuleExcludesAllThatTheOthersLeave) {
  const Catalogue& catalogue = *Catalogue::BuiltIn();
  ForEveryPhysicalCoarse([&](const CoarseAttributes& coarse) {
    for (const auto& type : EnumNames(AssetType{})) {
      const FineBounds all = BoundsOf(coarse, type.value);
      for (const Rule& rule : RuleBook::BuiltIn().rules()) {
        if (!rule.Holds(coarse)) continue;
        const FineBounds alone = RuleBook({rule}).BoundsOf(coarse, type.value, catalogue);
        for (std::size_t i = 0; i < all.season_variants.size(); ++i) {
          if (alone.season_variants[i].legal()) continue;
          ASSERT_FALSE(all.season_variants[i].legal()) << rule.label.id << " " << Text(coarse);
        }
      }
    }
  });
}

TEST(RulePropertiesTest, EveryLegalVariantAndMaterialComesUp) {
  const Catalogue& catalogue = *Catalogue::BuiltIn();
  using Value = std::pair<AssetType, std::string>;
  std::set<Value> variants, materials;
  std::vector<CoarseAttributes> few;
  for (const Season season : {Season::kSpring, Season::kSummer, Season::kAutumn, Season::kWinter}) {
    for (const Weather weather : {Weather::kSunny, Weather::kRain, Weather::kSnow}) {
      few.push_back(
          {TerrainType::kPlain, season, ArtisticStyle::kRealistic, weather, TimeOfDay::kNight});
    }
  }
  for (const CoarseAttributes& coarse : few) {
    std::set<Value> drawn, legal;
    for (std::uint64_t seed = 0; seed < 1500; ++seed) {
      RandomStream random(seed, "fine attributes");
      const FineAttributes fine = SampleFineAttributes(coarse, catalogue, &random);
      for (const auto& type : EnumNames(AssetType{})) {
        const FineAttribute& one = fine[static_cast<std::size_t>(type.value)];
        drawn.insert({type.value, "variant " + one.season_variant});
        drawn.insert({type.value, "material " + one.material});
      }
    }
    for (const auto& type : EnumNames(AssetType{})) {
      const FineBounds bounds = BoundsOf(coarse, type.value);
      for (const ValueBound& value : bounds.season_variants) {
        if (value.legal()) legal.insert({type.value, "variant " + std::string(value.name)});
      }
      for (const ValueBound& value : bounds.materials) {
        if (value.legal()) legal.insert({type.value, "material " + std::string(value.name)});
      }
    }
    EXPECT_EQ(drawn, legal) << Text(coarse);
  }
}

TEST(RulePropertiesTest, DrawsFillTheirSpanAroundWhatIsTypical) {
  CoarseAttributes coarse;
  const NumberBound bound = *BoundsOf(coarse, AssetType::kGrass).number(FineParameter::kDensity);
  double low = 1.0, high = 0.0, sum = 0.0;
  constexpr int kDraws = 4000;
  for (std::uint64_t seed = 0; seed < kDraws; ++seed) {
    RandomStream random(seed, "fine attributes");
    const double density = SampleFineAttributes(coarse, *Catalogue::BuiltIn(), &random)[0].density;
    low = std::min(low, density);
    high = std::max(high, density);
    sum += density;
  }
  EXPECT_GE(low, bound.draw_low);
  EXPECT_LE(high, bound.draw_high);
  EXPECT_NEAR(low, bound.draw_low, 0.03);
  EXPECT_NEAR(high, bound.draw_high, 0.03);
  // The mean of a triangular distribution; hundredths are cut.
  EXPECT_NEAR(sum / kDraws, (bound.draw_low + bound.typical + bound.draw_high) / 3.0 - 0.005, 0.01);
}

TEST(RulePropertiesTest, TheSameSeedDrawsTheSame) {
  const auto draw = [](std::uint64_t seed) {
    RandomStream random(seed, "fine attributes");
    EnvironmentConfig environment;
    environment.fine = SampleFineAttributes(environment.coarse, *Catalogue::BuiltIn(), &random);
    return ToJson(environment);
  };
  EXPECT_EQ(draw(7), draw(7));
  EXPECT_NE(draw(7), draw(8));
}

TEST(RulePropertiesTest, EveryRuleHasAnIdOfItsOwnAndAReason) {
  std::set<std::string> ids, reasons;
  for (const Rule& rule : RuleBook::BuiltIn().rules()) {
    EXPECT_TRUE(ids.insert(rule.label.id).second) << rule.label.id;
    EXPECT_TRUE(reasons.insert(rule.label.why).second) << rule.label.why;
  }
  EXPECT_GE(ids.size(), 20u);
}

TEST(RulePropertiesTest, EveryRuleHoldsForSomeCombination) {
  for (const Rule& rule : RuleBook::BuiltIn().rules()) {
    int holds = 0;
    ForEveryPhysicalCoarse([&](const CoarseAttributes& coarse) { holds += rule.Holds(coarse); });
    EXPECT_GT(holds, 0) << rule.label.id;
  }
}

// Each effect of each rule, taken away, changes what some combination allows or draws.
TEST(RulePropertiesTest, NoEffectOfARuleIsWithout) {
  const Catalogue& catalogue = *Catalogue::BuiltIn();
  const std::vector<Rule>& rules = RuleBook::BuiltIn().rules();
  for (std::size_t r = 0; r < rules.size(); ++r) {
    for (std::size_t e = 0; e < rules[r].then.size(); ++e) {
      for (const AssetType type : rules[r].then[e].types) {
        std::vector<Rule> others = rules;
        others[r].then.erase(others[r].then.begin() + static_cast<std::ptrdiff_t>(e));
        const RuleBook without(std::move(others));
        bool changes = false;
        ForEveryPhysicalCoarse([&](const CoarseAttributes& coarse) {
          if (changes || !rules[r].Holds(coarse)) return;
          changes = ToText(without.BoundsOf(coarse, type, catalogue)) !=
                    ToText(BoundsOf(coarse, type, catalogue));
        });
        const bool generic = rules[r].then[e].types.size() >= 10;
        EXPECT_TRUE(changes || generic)
            << rules[r].label.id << ", effect " << e << " on " << NameOf(type);
      }
    }
  }
}

}  // namespace
}  // namespace latticeworld
