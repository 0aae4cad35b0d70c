// A user's catalogue: its values are heard by their names, and what the rules refuse is told.

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "catalogue/larch.h"
#include "language/grounded/environment/environment_country.h"
#include "latticeworld/environment/rules.h"
#include "latticeworld/language/drawn/grounded.h"
#include "latticeworld/language/grounded/environment/attributes/added_values.h"

namespace latticeworld {
namespace {

// Forest variants "green larch", "golden larch" and "bare larch" of a model "larch", and a
// material.
std::shared_ptr<const Catalogue> WithLarch() {
  static const auto catalogue = Catalogue::Extended({{"larch.json", LarchFile()}}).value();
  return catalogue;
}

EnvironmentAnswer Generate(const std::string& instruction,
                           const std::shared_ptr<const Catalogue>& catalogue) {
  const SymbolicLayout layout = Country();
  EnvironmentRequest request;
  request.instruction = instruction;
  request.layout = &layout;
  request.catalogue = catalogue;
  Result<EnvironmentAnswer> answer =
      MakeGroundedEnvironmentGenerator()->Generate(request, Progress());
  EXPECT_TRUE(answer.ok()) << answer.status().ToString();
  EXPECT_TRUE(Validate(answer->environment, *catalogue).empty());
  return std::move(answer).value();
}

FineAttribute ForestOf(const std::string& instruction) {
  EnvironmentAnswer answer = Generate(instruction, WithLarch());
  for (const std::string& warning : answer.warnings) ADD_FAILURE() << warning;
  return answer.environment.fine_of(AssetType::kForest);
}

TEST(UserCatalogueTest, AddedValuesAreHeardByTheirNames) {
  EXPECT_EQ(ForestOf("An autumn day, golden larch in the forest.").season_variant, "golden larch");
  EXPECT_EQ(ForestOf("Golden larches cover the hills.").season_variant, "golden larch");
  EXPECT_EQ(ForestOf("The trees have larch bark.").material, "larch bark");
}

TEST(UserCatalogueTest, AModelsNameStandsForWhatItWearsInTheSeason) {
  EXPECT_EQ(ForestOf("A summer day. The forest is larch.").season_variant, "green larch");
  EXPECT_EQ(ForestOf("An autumn day in a forest of larches.").season_variant, "golden larch");
  EXPECT_EQ(ForestOf("Larches in winter.").season_variant, "bare larch");
}

TEST(UserCatalogueTest, TheSeasonFollowsFromAnAddedVariant) {
  const EnvironmentAnswer answer = Generate("Golden larch forests.", WithLarch());
  EXPECT_EQ(answer.environment.coarse.season, Season::kAutumn);
}

TEST(UserCatalogueTest, AddedVariantsObeyTheRuleOfTheirSeasons) {
  const EnvironmentAnswer answer =
      Generate("It is winter. Golden larches cover the hills.", WithLarch());
  EXPECT_EQ(answer.environment.coarse.season, Season::kWinter);
  EXPECT_NE(answer.environment.fine_of(AssetType::kForest).season_variant, "golden larch");
  ASSERT_FALSE(answer.warnings.empty());
  EXPECT_NE(answer.warnings[0].find("own-season"), std::string::npos) << answer.warnings[0];
}

TEST(UserCatalogueTest, ClaimsSpeakOfAddedValues) {
  const EnvironmentClaims reading =
      ReadEnvironmentInstruction("golden larch", nullptr, *WithLarch());
  EXPECT_TRUE(reading.not_understood.empty());
  ASSERT_EQ(reading.claims.size(), 1u);
  EXPECT_EQ(reading.claims[0].values, std::vector<std::string>{"golden larch"});
}

TEST(UserCatalogueTest, WithoutItALarchIsTheNearestThatThereIs) {
  EXPECT_EQ(Generate("Larches in winter.", Catalogue::BuiltIn())
                .environment.fine_of(AssetType::kForest)
                .season_variant,
            "winter pine");
  EXPECT_FALSE(AddedValueWordsOf(*Catalogue::BuiltIn()).words.has_value());
}

TEST(UserCatalogueTest, NamesOfOneOrTwoLettersTakeNoTextOver) {
  for (const std::string& name : {std::string("a"), std::string("in")}) {
    const auto catalogue =
        Catalogue::Extended({{"user.json", R"({"type": "forest", "materials": [{"name": ")" + name +
                                               R"(", "color": ["#7d5a48", "#94705c"],
         "density_kgpm3": 780, "elastic_modulus_pa": 1e10, "bending_strength_pa": 5e7,
         "lidar_reflectance": 0.36, "radar_sigma0_db": -10}]})"}})
            .value();
    for (const char* text : {"A summer day in a forest.", "Sheep graze in a meadow."}) {
      const EnvironmentClaims built_in =
          ReadEnvironmentInstruction(text, nullptr, *Catalogue::BuiltIn());
      const EnvironmentClaims added = ReadEnvironmentInstruction(text, nullptr, *catalogue);
      EXPECT_EQ(added.claims.size(), built_in.claims.size()) << name << ": " << text;
    }
  }
}

TEST(UserCatalogueTest, OtherWordsMeanWhatTheyMeant) {
  EXPECT_EQ(ForestOf("A summer day. The forest is oak.").season_variant, "summer oak");
  EXPECT_EQ(ForestOf("A winter pine forest.").season_variant, "winter pine");
}

TEST(UserCatalogueTest, NamesBegunByASeasonShareTheirRest) {
  // The same file with its variants called after seasons.
  std::string file = LarchFile();
  const auto rename = [&](const std::string& from, const std::string& to) {
    for (std::size_t at = file.find(from); at != file.npos; at = file.find(from, at + to.size())) {
      file.replace(at, from.size(), to);
    }
  };
  rename("golden larch", "autumn oak of fame");
  rename("bare larch", "winter oak of fame");
  const auto catalogue = Catalogue::Extended({{"fame.json", file}}).value();
  EXPECT_EQ(Generate("An autumn forest with an oak of fame.", catalogue)
                .environment.fine_of(AssetType::kForest)
                .season_variant,
            "autumn oak of fame");
  EXPECT_EQ(Generate("A winter forest with an oak of fame.", catalogue)
                .environment.fine_of(AssetType::kForest)
                .season_variant,
            "winter oak of fame");
}

// --------------------------------------------------------------------------- Refused wishes

// The one warning of an instruction.
std::string WarningOf(const std::string& instruction) {
  const EnvironmentAnswer answer = Generate(instruction, Catalogue::BuiltIn());
  EXPECT_EQ(answer.warnings.size(), 1u) << instruction;
  return answer.warnings.empty() ? "" : answer.warnings[0];
}

TEST(RefusedWishTest, AVariantOutOfSeasonNamesTheRule) {
  const std::string warning = WarningOf("A summer day at a frozen lake.");
  for (const char* part :
       {"frozen", "lake", "the rule own-season", "legal are open", "it is open"}) {
    EXPECT_NE(warning.find(part), std::string::npos) << warning;
  }
}

TEST(RefusedWishTest, AMaterialNamesTheRule) {
  const std::string warning = WarningOf("A summer day, powder snow on the mountain tops.");
  EXPECT_NE(warning.find("the rule summer-thaw"), std::string::npos) << warning;
}

TEST(RefusedWishTest, ANumberBecomesTheNearestLegalOneAndNamesTheRule) {
  const EnvironmentAnswer answer =
      Generate("A sandstorm with a wind of 3 m/s in the desert.", Catalogue::BuiltIn());
  EXPECT_EQ(answer.environment.coarse.weather, Weather::kSandstorm);
  EXPECT_EQ(answer.environment.fine_of(AssetType::kDesert).wind_mps, 8.0);
  ASSERT_EQ(answer.warnings.size(), 1u);
  for (const char* part : {"wind cannot be 3", "the rule sandstorm allows 8 at least", "it is 8"}) {
    EXPECT_NE(answer.warnings[0].find(part), std::string::npos) << answer.warnings[0];
  }
}

// Words allow a span: the densest that the rule leaves is dense still, and nothing is refused.
TEST(RefusedWishTest, WordsThatTheRulesCanMeetAreMetWithoutAWarning) {
  for (const char* text : {"A winter day with very dense grass.", "A winter day in a dense forest.",
                           "A desert with dense grass.", "A winter day with thick crops."}) {
    const EnvironmentAnswer answer = Generate(text, Catalogue::BuiltIn());
    for (const std::string& warning : answer.warnings) {
      EXPECT_EQ(warning.find("the rule"), std::string::npos) << warning;
    }
  }
  const FineAttribute grass = Generate("A winter day with very dense grass.", Catalogue::BuiltIn())
                                  .environment.fine_of(AssetType::kGrass);
  EXPECT_EQ(grass.density, 0.9);
}

TEST(RefusedWishTest, TheSeasonFitsTheWishesWhenNobodyNamesIt) {
  const EnvironmentAnswer answer = Generate("Powder snow on the tops.", Catalogue::BuiltIn());
  EXPECT_TRUE(answer.warnings.empty());
  EXPECT_EQ(answer.environment.fine_of(AssetType::kSnowMountain).material, "powder");
  EXPECT_NE(answer.environment.coarse.season, Season::kSummer);
}

}  // namespace
}  // namespace latticeworld
