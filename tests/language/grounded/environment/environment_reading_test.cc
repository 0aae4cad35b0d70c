// What environment instructions are read as, in many voices, and that the word tables are sound.

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <ostream>
#include <set>
#include <string>
#include <vector>

#include "language/grounded/environment/environment_country.h"
#include "latticeworld/common/random.h"
#include "latticeworld/environment/environment_claims.h"
#include "latticeworld/language/drawn/grounded.h"
#include "latticeworld/language/grounded/environment/attributes/coarse_reader.h"
#include "latticeworld/language/grounded/environment/environment_parser.h"
#include "latticeworld/language/grounded/environment/inflection.h"
#include "latticeworld/language/grounded/environment/word_tables.h"

namespace latticeworld {
namespace {

struct CoarseSample {
  std::string instruction;
  CoarseKey key;
  std::string value;
};
void PrintTo(const CoarseSample& sample, std::ostream* os) { *os << sample.instruction; }

class CoarseVoices : public testing::TestWithParam<CoarseSample> {};

TEST_P(CoarseVoices, GiveTheAttributeAway) {
  EnvironmentClaim claim;
  claim.coarse_key = GetParam().key;
  claim.values = {GetParam().value};
  const EnvironmentClaimMeasure measure =
      Measure(claim, GenerateInCountry(GetParam().instruction).environment);
  EXPECT_TRUE(measure.holds) << measure.explanation;
}

INSTANTIATE_TEST_SUITE_P(
    Voices, CoarseVoices,
    testing::ValuesIn(std::vector<CoarseSample>{
        {"the pumpkins glow, it is Halloween", CoarseKey::kSeason, "autumn"},
        {"the snow so deep on the mountains and the sky all blue", CoarseKey::kWeather, "sunny"},
        {"weather=rain -> no, change that to cloudy", CoarseKey::kWeather, "cloudy"},
        {"Rain. Canecl the rain.", CoarseKey::kWeather, "sunny"},
        {"sample 0093: noon", CoarseKey::kTimeOfDay, "noon"},
        {"its May, nine in the morning", CoarseKey::kSeason, "spring"},
        {"Diwali lamps everywhere", CoarseKey::kSeason, "autumn"},
        {"the cherry trees are white with cherry blossom", CoarseKey::kSeason, "spring"},
        {"-12 \xC2\xB0"
         "C and icicles",
         CoarseKey::kSeason, "winter"},
        {"95 degrees Fahrenheit in the shade", CoarseKey::kSeason, "summer"},
        {"a frozen lake", CoarseKey::kSeason, "winter"},
        {"everyone wears mittens", CoarseKey::kSeason, "winter"},
        {"May.", CoarseKey::kSeason, "spring"},
        {"it may be hot", CoarseKey::kSeason, "summer"},
        {"Rain. Sorry, the sun instead.", CoarseKey::kWeather, "sunny"},
        {"realistic, nothing cartoonish", CoarseKey::kArtisticStyle, "realistic"},
        {"goblins march through a cold January", CoarseKey::kSeason, "winter"},
        {"half past nine in the evening", CoarseKey::kTimeOfDay, "night"},
        {"it is 18:30", CoarseKey::kTimeOfDay, "dusk"},
        {"at 6 am", CoarseKey::kTimeOfDay, "dawn"},
        {"at three in the afternoon", CoarseKey::kTimeOfDay, "afternoon"},
        {"the sun is directly overhead", CoarseKey::kTimeOfDay, "noon"},
        {"long shadows", CoarseKey::kTimeOfDay, "dusk"},
        {"the sun has just gone down", CoarseKey::kTimeOfDay, "dusk"},
        {"the sun is about to rise", CoarseKey::kTimeOfDay, "dawn"},
        {"pitch dark", CoarseKey::kTimeOfDay, "night"},
        {"it never rains", CoarseKey::kWeather, "sunny"},
        {"no sun at all", CoarseKey::kWeather, "cloudy"},
        {"a storm of arrows flies", CoarseKey::kWeather, "sunny"},
        {"white flakes come down", CoarseKey::kWeather, "snow"},
        {"the mornign is fogyg", CoarseKey::kTimeOfDay, "morning"},
        {"not summer but autumn", CoarseKey::kSeason, "autumn"},
        {"heavy rain, dark clouds", CoarseKey::kWeather, "rain"},
        {"rain, no, just cloudy", CoarseKey::kWeather, "cloudy"},
        {"the sky, which is grey", CoarseKey::kWeather, "cloudy"},
        {"I prefer autumn to winter", CoarseKey::kSeason, "autumn"},
        {"eagles fly above the snow, no clouds", CoarseKey::kWeather, "sunny"},
        {"a gloomy autumn day", CoarseKey::kSeason, "autumn"},
        {"nobody is there, at dawn", CoarseKey::kTimeOfDay, "dawn"},
        {"make it like a cartoon", CoarseKey::kArtisticStyle, "cartoon"},
        {"rainny", CoarseKey::kWeather, "rain"},
        {"like a comic book", CoarseKey::kArtisticStyle, "cartoon"},
        {"the sun was just going down", CoarseKey::kTimeOfDay, "dusk"},
        {"any weather but sun", CoarseKey::kWeather, "cloudy"},
        {"a foggy day? no, keep the fog out", CoarseKey::kWeather, "sunny"},
        {"it poured", CoarseKey::kWeather, "rain"},
        {"holograms and neon", CoarseKey::kArtisticStyle, "cyberpunk"},
    }));

TEST(EnvironmentClaimsTest, EveryVariantAndMaterialHasWordsOfItsOwn) {
  const EnvironmentWords& words = GetEnvironmentWords();
  for (const auto& entry : EnumNames(AssetType{})) {
    for (const VariantKey key : {VariantKey::kSeasonVariant, VariantKey::kMaterial}) {
      const AssetTypeValues& values = ValuesOf(entry.value);
      for (const std::string_view value :
           key == VariantKey::kMaterial ? values.materials : values.season_variants) {
        const bool reachable = std::any_of(
            words.variants.rows.begin(), words.variants.rows.end(), [&](const VariantWord& word) {
              return word.asset == entry.value && word.key == key &&
                     std::find(word.values.begin(), word.values.end(), value) != word.values.end();
            });
        EXPECT_TRUE(reachable) << NameOf(entry.value) << " " << value;
      }
    }
  }
}

TEST(EnvironmentClaimsTest, EveryPhraseOfAVariantIsHeardWithItsNoun) {
  const EnvironmentWords& words = GetEnvironmentWords();
  for (std::size_t row = 0; row < words.variants.rows.size(); ++row) {
    const VariantWord& word = words.variants.rows[row];
    if (!word.alone) continue;
    for (const std::string_view phrase : words.variants.index.Phrases()) {
      const std::vector<Token> tokens = Tokenize(phrase);
      const auto match = words.variants.At(tokens, 0);
      if (match.rows.size() != 1 || match.rows.front() != &word) continue;
      const HeardEnvironment heard = ParseEnvironmentInstruction(phrase);
      const bool found =
          std::any_of(heard.fine.begin(), heard.fine.end(), [&](const FineWish& wish) {
            return wish.claim.kind == EnvironmentClaimKind::kVariant &&
                   wish.claim.asset == word.asset && wish.claim.variant_key == word.key;
          });
      EXPECT_TRUE(found) << phrase;
    }
  }
}

TEST(EnvironmentClaimsTest, EverySpeciesIsHeard) {
  const EnvironmentWords& words = GetEnvironmentWords();
  for (const std::string_view phrase : words.species.index.Phrases()) {
    const HeardEnvironment heard =
        ParseEnvironmentInstruction("There are exactly two " + std::string(phrase) + ".");
    ASSERT_EQ(heard.agents.size(), 1u) << phrase;
    EXPECT_EQ(heard.agents.front().quantity, 2) << phrase;
  }
}

TEST(EnvironmentClaimsTest, EveryStateIsHeard) {
  const EnvironmentWords& words = GetEnvironmentWords();
  for (const std::string_view phrase : words.states.index.Phrases()) {
    const HeardEnvironment heard =
        ParseEnvironmentInstruction("Two androids " + std::string(phrase) + ".");
    ASSERT_FALSE(heard.agents.empty()) << phrase;
    EXPECT_TRUE(heard.agents.front().state.has_value()) << phrase;
  }
}

TEST(EnvironmentClaimsTest, EveryCoarsePhraseIsHeard) {
  const EnvironmentWords& words = GetEnvironmentWords();
  for (const std::string_view phrase : words.coarse.index.Phrases()) {
    const HeardEnvironment heard = ParseEnvironmentInstruction(phrase);
    const bool any = std::any_of(heard.coarse.begin(), heard.coarse.end(),
                                 [](const HeardCoarse& coarse) { return !coarse.value.empty(); });
    EXPECT_TRUE(any) << phrase;
  }
}

std::string_view BadTables(std::string_view file) {
  if (file == "environment_kinds.txt") return "# no\nrobots\tgoblin, cow\trobots\n";
  if (file == "environment_states.txt") return "sleeping\tverb\tsleep\nidle\tnoun\tsleep\nidle\n";
  if (file == "environment_densities.txt") return "0.5\t0.4\t0.9\tdense\n0\tmuch\t1\tthick\n";
  return "";
}

TEST(EnvironmentClaimsTest, BadLinesAreNamed) {
  const auto words = ReadEnvironmentWords(&BadTables);
  ASSERT_FALSE(words.ok());
  std::set<std::string> places;
  for (const Violation& violation : words.status().violations()) places.insert(violation.pointer);
  for (const std::string place :
       {"environment_kinds.txt:2", "environment_states.txt:1", "environment_states.txt:2",
        "environment_states.txt:3", "environment_densities.txt:1", "environment_densities.txt:2",
        "environment_species.txt"}) {
    EXPECT_EQ(places.count(place), 1u) << place;
  }
}

TEST(EnvironmentClaimsTest, FineWishesAreHeard) {
  const EnvironmentAnswer answer = GenerateInCountry(
      "Thatched cottages facing south, twice as large as usual. Cobbled lanes, dense old oaks with "
      "mossy bark, hardly any flowers. Wind of 12 m/s. The lake is murky and 2 m below normal.");
  const EnvironmentConfig& environment = answer.environment;
  EXPECT_EQ(environment.fine_of(AssetType::kArchitecture).material, "timber");
  EXPECT_EQ(environment.fine_of(AssetType::kArchitecture).rotation_deg[2], 270.0);
  EXPECT_EQ(environment.fine_of(AssetType::kArchitecture).scale, 2.0);
  EXPECT_EQ(environment.fine_of(AssetType::kRoad).material, "gravel");
  EXPECT_EQ(environment.fine_of(AssetType::kForest).season_variant, "summer oak");
  EXPECT_EQ(environment.fine_of(AssetType::kForest).material, "mossy bark");
  EXPECT_GT(environment.fine_of(AssetType::kForest).density, 0.65);
  EXPECT_LT(environment.fine_of(AssetType::kFlower).density, 0.2);
  EXPECT_EQ(environment.fine_of(AssetType::kDesert).wind_mps, 12.0);
  EXPECT_EQ(environment.fine_of(AssetType::kLake).material, "silty");
  EXPECT_EQ(environment.fine_of(AssetType::kLake).height_m, -2.0);
}

TEST(EnvironmentClaimsTest, FineWishesAreHeardInOtherWords) {
  const EnvironmentConfig snowy =
      GenerateInCountry(
          "There is still snow on the road although the sky is clear. Moss grows on the trunks. "
          "The houses are half their usual size, and flowers grow far and wide, plenty of them.")
          .environment;
  EXPECT_EQ(snowy.fine_of(AssetType::kRoad).season_variant, "snow-covered");
  EXPECT_EQ(snowy.coarse.season, Season::kWinter);
  EXPECT_EQ(snowy.coarse.weather, Weather::kSunny);
  EXPECT_EQ(snowy.fine_of(AssetType::kForest).material, "mossy bark");
  EXPECT_EQ(snowy.fine_of(AssetType::kArchitecture).scale, 0.5);
  EXPECT_GT(snowy.fine_of(AssetType::kFlower).density, 0.6);
  const EnvironmentConfig listed =
      GenerateInCountry("Grass density at 80 percent, stones at 20, dead wood 40.").environment;
  EXPECT_EQ(listed.fine_of(AssetType::kGrass).density, 0.8);
  EXPECT_EQ(listed.fine_of(AssetType::kStone).density, 0.2);
  EXPECT_EQ(listed.fine_of(AssetType::kDeadBranch).density, 0.4);
  const EnvironmentConfig bare =
      GenerateInCountry(
          "stones 0.9; flowers 0; grass - none. Lake at plus two point five metres. "
          "Hardly a breath of wind.")
          .environment;
  EXPECT_EQ(bare.fine_of(AssetType::kStone).density, 0.9);
  EXPECT_EQ(bare.fine_of(AssetType::kFlower).density, 0.0);
  EXPECT_EQ(bare.fine_of(AssetType::kGrass).density, 0.0);
  EXPECT_EQ(bare.fine_of(AssetType::kLake).height_m, 2.5);
  EXPECT_LE(bare.fine_of(AssetType::kDesert).wind_mps, 1.0);
  const EnvironmentConfig keyed =
      GenerateInCountry(
          "season=winter | grass=0.2 | stones=0.7. Two goblins sleep in the village, "
          "flowers everywhere. Raise the lake by one and a half metres.")
          .environment;
  EXPECT_EQ(keyed.fine_of(AssetType::kGrass).density, 0.2);
  EXPECT_EQ(keyed.fine_of(AssetType::kStone).density, 0.7);
  EXPECT_GT(keyed.fine_of(AssetType::kFlower).density, 0.6);
  EXPECT_EQ(keyed.fine_of(AssetType::kLake).height_m, 1.5);
  EXPECT_EQ(GenerateInCountry("In autumn the heather is in full bloom.")
                .environment.fine_of(AssetType::kFlower)
                .season_variant,
            "blooming");
}

TEST(EnvironmentClaimsTest, WhatIsSaidOfOneThingIsSaidOfNoOther) {
  const auto bushes = GenerateInCountry("The grass is dense, the bushes sparse.").environment;
  EXPECT_GT(bushes.fine_of(AssetType::kGrass).density, 0.65);
  const auto flowers = GenerateInCountry("The grass is dense, no flowers.").environment;
  EXPECT_LT(flowers.fine_of(AssetType::kFlower).density, 0.1);
  const auto meadow = GenerateInCountry("Dense forest, sparse meadow.").environment;
  EXPECT_GT(meadow.fine_of(AssetType::kForest).density, 0.65);
  EXPECT_LT(meadow.fine_of(AssetType::kGrass).density, 0.4);
  const auto plain = GenerateInCountry("Ten sheep.").environment;
  const auto sheep = GenerateInCountry("Ten sheep are scattered all over the fields.").environment;
  EXPECT_EQ(sheep.fine_of(AssetType::kCrops).density, plain.fine_of(AssetType::kCrops).density);
}

TEST(EnvironmentClaimsTest, ASmallWorldHasNoLakeForAWhale) {
  EXPECT_EQ(GenerateInCountry("a whale swims", 512.0).environment.agents.size(), 1u);
  const EnvironmentAnswer small = GenerateInCountry("a whale swims", 32.0);
  EXPECT_TRUE(small.environment.agents.empty());
  ASSERT_EQ(small.warnings.size(), 1u);
  EXPECT_NE(small.warnings.front().find("whale"), std::string::npos);
}

TEST(EnvironmentClaimsTest, SaysWhatItReadAnewAndWhatItDidNot) {
  const EnvironmentAnswer answer = GenerateInCountry("two gobblins and a zorblax");
  ASSERT_EQ(answer.environment.agents.size(), 1u);
  ASSERT_EQ(answer.warnings.size(), 2u);
  EXPECT_EQ(answer.warnings[0], "read \"gobblins\" as \"goblins\"");
  EXPECT_NE(answer.warnings[1].find("zorblax"), std::string::npos);
  const EnvironmentClaims reading = ReadEnvironmentInstruction("two gobblins and a zorblax");
  EXPECT_EQ(reading.not_understood, std::vector<std::string>{"zorblax"});
}

TEST(EnvironmentClaimsTest, FeaturesAreClaimedWhereTheLandIsKnown) {
  const SymbolicLayout layout = Country();
  const EnvironmentClaims blind = ReadEnvironmentInstruction("ten sheep by the village");
  ASSERT_EQ(blind.claims.size(), 2u);
  EXPECT_TRUE(blind.claims.back().positions.empty());
  const EnvironmentClaims seen = ReadEnvironmentInstruction("ten sheep by the village", &layout);
  EXPECT_EQ(seen.claims.back().positions, std::vector<Region>{Region::kCenter});
}

// The answer satisfies the claims that were read from the same words, or a warning quotes them.
TEST(EnvironmentClaimsTest, WordSaladGivesValidAnswersThatKeepTheirOwnClaims) {
  const std::vector<std::string> pieces = {"sheep",
                                           "9999999",
                                           "whales",
                                           "no",
                                           "attack",
                                           "in the north",
                                           "and",
                                           ",",
                                           ".",
                                           "fog",
                                           "dense",
                                           "forest",
                                           "graze",
                                           "a pair of",
                                           "million",
                                           "robot",
                                           "fly",
                                           "three of them",
                                           "the others",
                                           "half of them",
                                           "no, make it",
                                           "five",
                                           "midnight",
                                           "snow",
                                           "summer",
                                           "herd of",
                                           "-",
                                           "goblins",
                                           "patrol",
                                           "frozen lake",
                                           "without",
                                           "instead of",
                                           "by the lake",
                                           "each corner",
                                           "18:30",
                                           "-5 degrees",
                                           "autumn oaks",
                                           "they",
                                           "another",
                                           "\xE2\x80\x99s",
                                           "\xC3\xA9t\xC3\xA9",
                                           "wind 80 km/h",
                                           "the goblins",
                                           "is",
                                           "not",
                                           "or",
                                           "between",
                                           "a second band",
                                           "of",
                                           "chased by",
                                           "bridge:",
                                           "%",
                                           "0.7",
                                           "density"};
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    RandomStream random(seed, "salad");
    std::string text;
    const int length = random.UniformInt(0, 60);
    for (int i = 0; i < length; ++i) {
      text += pieces[static_cast<std::size_t>(
                  random.UniformInt(0, static_cast<int>(pieces.size()) - 1))] +
              " ";
    }
    const EnvironmentAnswer answer = GenerateInCountry(text);
    ASSERT_TRUE(Validate(answer.environment).empty()) << text;
    const SymbolicLayout layout = Country();
    for (const EnvironmentClaim& claim : ReadEnvironmentInstruction(text, &layout).claims) {
      EXPECT_TRUE(Validate(claim).empty()) << text;
    }
  }
}

TEST(EnvironmentClaimsTest, InflectsRegularVerbsAndNouns) {
  // As people write it, too.
  EXPECT_EQ(FormsOf("swim"),
            (std::vector<std::string>{"swim", "swims", "swimming", "swam", "swiming"}));
  EXPECT_EQ(FormsOf("patrol").back(), "patroled");
  EXPECT_EQ(FormsOf("keep watch"),
            (std::vector<std::string>{"keep watch", "keeps watch", "keeping watch", "kept watch"}));
  EXPECT_EQ(FormsOf("graze")[2], "grazing");
  EXPECT_EQ(PluralOf("wild pony"), "wild ponies");
  EXPECT_EQ(PluralOf("fox"), "foxes");
}

TEST(EnvironmentClaimsTest, ClocksAreHeardHoweverTheyAreWritten) {
  const auto time_of = [](const std::string& text) {
    return GenerateInCountry(text).environment.coarse.time_of_day;
  };
  EXPECT_EQ(time_of("Local time 1640, five sheep."), TimeOfDay::kAfternoon);
  EXPECT_EQ(time_of("It is 2315 local time."), TimeOfDay::kNight);
  EXPECT_EQ(time_of("The watch begins at 22.45."), TimeOfDay::kNight);
  EXPECT_EQ(time_of("at 0530"), time_of("at half past five in the morning"));
  // Numbers that are no clocks.
  EXPECT_EQ(time_of("A sunny noon. Stones 22.45 m apart."), TimeOfDay::kNoon);
  EXPECT_EQ(time_of("A sunny noon in 1640."), TimeOfDay::kNoon);
}

TEST(EnvironmentClaimsTest, EveryHourHasItsName) {
  EXPECT_EQ(TimeAt(0.0), TimeOfDay::kNight);
  EXPECT_EQ(TimeAt(5.5), TimeOfDay::kDawn);
  EXPECT_EQ(TimeAt(9.0), TimeOfDay::kMorning);
  EXPECT_EQ(TimeAt(12.0), TimeOfDay::kNoon);
  EXPECT_EQ(TimeAt(15.0), TimeOfDay::kAfternoon);
  EXPECT_EQ(TimeAt(19.0), TimeOfDay::kDusk);
  EXPECT_EQ(TimeAt(23.9), TimeOfDay::kNight);
}

TEST(EnvironmentClaimsTest, SnowThatLiesDoesNotFall) {
  const auto weather_of = [](const std::string& text) {
    return GenerateInCountry(text).environment.coarse.weather;
  };
  EXPECT_EQ(weather_of("Spring, cloudy, and patches of snow."), Weather::kCloudy);
  EXPECT_EQ(weather_of("The roofs are white with snow, the sky is cloudy."), Weather::kCloudy);
  EXPECT_EQ(weather_of("Heavy snow is falling."), Weather::kSnow);
}

TEST(EnvironmentClaimsTest, WhatIsSaidOfANounIsSaidOfNoOther) {
  const auto variants_of = [](const std::string& text) {
    std::string said;
    for (const EnvironmentClaim& claim : ReadEnvironmentInstruction(text).claims) {
      if (claim.kind != EnvironmentClaimKind::kVariant) continue;
      said += std::string(NameOf(claim.asset)) + " " + claim.values.front() + "; ";
    }
    return said;
  };
  EXPECT_EQ(variants_of("Lots of birch branches."), "dead_branch birch; ");
  EXPECT_EQ(variants_of("The road is covered with snow."), "road snow-covered; ");
  EXPECT_EQ(variants_of("Reed instead of ordinary grass."), "grass reed; ");
}

}  // namespace
}  // namespace latticeworld
