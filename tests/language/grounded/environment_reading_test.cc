// What environment instructions are read as, in many voices, and that the word tables are sound.

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <ostream>
#include <set>
#include <string>
#include <vector>

#include "latticeworld/common/random.h"
#include "latticeworld/environment/environment_claims.h"
#include "latticeworld/language/grounded/environment/coarse_reader.h"
#include "latticeworld/language/grounded/environment/environment_parser.h"
#include "latticeworld/language/grounded/environment/inflection.h"
#include "latticeworld/language/grounded/environment/word_tables.h"
#include "latticeworld/language/grounded/grounded.h"

namespace latticeworld {
namespace {

// Grassland; a lake in the upper left, forest in the lower right, a village in the center, a road
// along the west edge, fields in the upper right.
SymbolicLayout Country() {
  SymbolicLayout layout{Vocabulary::kSuburb, Grid<char>(kLayoutSize, kLayoutSize, 'G')};
  for (int row = 0; row < 10; ++row) {
    for (int col = 0; col < 10; ++col) {
      layout.cells(row, col) = 'W';
      layout.cells(31 - row, 31 - col) = 'F';
      layout.cells(row, 31 - col) = 'A';
    }
  }
  for (int row = 14; row < 18; ++row) {
    for (int col = 14; col < 18; ++col) layout.cells(row, col) = 'B';
  }
  for (int row = 22; row < 32; ++row) layout.cells(row, 2) = 'R';
  return layout;
}

EnvironmentAnswer Generate(const std::string& instruction, double size_m = 512.0) {
  const SymbolicLayout layout = Country();
  EnvironmentRequest request;
  request.instruction = instruction;
  request.layout = &layout;
  request.size_m = size_m;
  Result<EnvironmentAnswer> answer =
      MakeGroundedEnvironmentGenerator()->Generate(request, Progress());
  EXPECT_TRUE(answer.ok()) << answer.status().ToString();
  return answer.ok() ? std::move(answer).value() : EnvironmentAnswer();
}

struct Sample {
  std::string instruction;
  std::string expected;
};
void PrintTo(const Sample& sample, std::ostream* os) { *os << sample.instruction; }

class AgentVoices : public testing::TestWithParam<Sample> {};

TEST_P(AgentVoices, AreReadAsMeant) {
  const EnvironmentAnswer answer = Generate(GetParam().instruction);
  std::string text;
  for (const AgentGroup& group : answer.environment.agents) {
    text += std::to_string(group.quantity) + " " + std::string(NameOf(group.category)) + " " +
            std::string(NameOf(group.state)) + " " + std::string(NameOf(group.position)) + "; ";
  }
  EXPECT_EQ(text, GetParam().expected);
}

INSTANTIATE_TEST_SUITE_P(Counts, AgentVoices,
                         testing::ValuesIn(std::vector<Sample>{
                             {"half a dozen sheep", "6 sheep grazing anywhere; "},
                             {"a score of horses", "20 horse grazing anywhere; "},
                             {"between five and nine goblins", "7 goblin patrolling anywhere; "},
                             {"no more than four eagles", "4 eagle flying anywhere; "},
                             {"two flocks of ten sheep", "20 sheep grazing anywhere; "},
                             {"a herd of thirty horses", "30 horse grazing anywhere; "},
                             {"six hundred sheep",
                              "500 sheep grazing anywhere; 100 sheep grazing anywhere; "},
                             {"a goblin warband of 25", "25 goblin patrolling anywhere; "},
                             {"a trio of drones", "3 aerial robot flying anywhere; "},
                             {"3-5 goblins", "4 goblin patrolling anywhere; "},
                         }));

INSTANTIATE_TEST_SUITE_P(
    References, AgentVoices,
    testing::ValuesIn(std::vector<Sample>{
        {"Three goblins in the north. No, make it five.", "5 goblin patrolling upper; "},
        {"Two knights guard the east. Sorry, four knights.",
         "4 ancient warrior patrolling middle right; "},
        {"Eight horses graze. Three of them are in the west, the rest sleep in the east.",
         "5 horse idle middle right; 3 horse grazing middle left; "},
        {"Six drones: two in the west, three in the north and one in the south.",
         "2 aerial robot flying middle left; 3 aerial robot flying upper; "
         "1 aerial robot flying lower; "},
        {"two goblins in the north and three in the south",
         "2 goblin patrolling upper; 3 goblin patrolling lower; "},
        {"Ten sheep. Half of them rest.", "5 sheep grazing anywhere; 5 sheep idle anywhere; "},
        {"Five sheep. They sleep in the south.", "5 sheep idle lower; "},
        {"Two goblins chase the sheep in the west. The goblins are green.",
         "2 goblin pursuing middle left; 3 sheep grazing middle left; "},
        {"Sheep are guarded by two knights.",
         "3 sheep grazing anywhere; 2 ancient warrior patrolling anywhere; "},
        {"Three goblins here, no goblins after all.", ""},
        {"Sheep, horses and goblins rest in the east.",
         "3 sheep idle middle right; 3 horse idle middle right; 3 goblin idle middle right; "},
        {"one knight in each corner",
         "1 ancient warrior patrolling upper left; 1 ancient warrior patrolling upper right; "
         "1 ancient warrior patrolling lower left; 1 ancient warrior patrolling lower right; "},
        {"Three knights and two goblins. The former sleep in the east, the latter walk in the "
         "west.",
         "3 ancient warrior idle middle right; 2 goblin patrolling middle left; "},
        {"Four knights in the north, six goblins in the south, all asleep.",
         "4 ancient warrior idle upper; 6 goblin idle lower; "},
        {"25 agents: 20 sheep in the west and the rest are goblins.",
         "20 sheep grazing middle left; 5 goblin patrolling anywhere; "},
        {"Let goblins attack the village. Nine goblins.", "9 goblin attacking center; "},
        {"This is for my robot. One rover waits in the east.",
         "1 wheeled robot idle middle right; "},
        {"Three of the eight sheep are in the west, the others rest in the east.",
         "5 sheep idle middle right; 3 sheep grazing middle left; "},
        {"Half of the ten knights sleep in the north, the other half march in the south.",
         "5 ancient warrior patrolling lower; 5 ancient warrior idle upper; "},
        {"Two goblins march to the village, where five knights wait.",
         "2 goblin patrolling center; 5 ancient warrior idle center; "},
        {"Nobody except a shepherd, in the west.", "1 humanoid robot idle middle left; "},
        {"Four rovers on the road, none of them parked.",
         "4 wheeled robot patrolling lower left; "},
        {"The robots stand in the village, three of them, charging.",
         "3 wheeled robot idle center; "},
        {"Mist lies over the road, and three mares doze in the fields.",
         "3 horse idle upper right; "},
        {"A rover - a robot - waits in the east.", "1 wheeled robot idle middle right; "},
        {"A goblin gathering near the village, nine of them sleeping.", "9 goblin idle center; "},
        {"In the north stands a knight, in the south another.",
         "1 ancient warrior idle upper; 1 ancient warrior idle lower; "},
    }));

INSTANTIATE_TEST_SUITE_P(
    PlacesAndNegations, AgentVoices,
    testing::ValuesIn(std::vector<Sample>{
        {"a whale swims in the lake", "1 whale swimming upper left; "},
        {"three knights guard the village", "3 ancient warrior patrolling center; "},
        {"a rover drives along the road", "1 wheeled robot patrolling lower left; "},
        {"an android rests at the forest edge", "1 humanoid robot idle lower right; "},
        {"four goblins lurk in the fields", "4 goblin patrolling upper right; "},
        {"no animals, no robots, just one knight", "1 ancient warrior patrolling anywhere; "},
        {"Not a soul, neither man nor beast.", ""},
        {"two rovers parked by the lake", "2 wheeled robot idle upper left; "},
        {"No goblins in the north, but four goblins in the south.", "4 goblin patrolling lower; "},
        {"agents: 3 horses (idle, NE)", "3 horse idle upper right; "},
        {"goblins everywhere! like 40 of them, attacking", "40 goblin attacking anywhere; "},
        {"instead of goblins, two knights", "2 ancient warrior patrolling anywhere; "},
        {"robots fly over the village", "3 aerial robot flying center; "},
        {"the statue of a knight and the eagle's nest", ""},
        {"The goblins do not attack, they sleep.", "3 goblin idle anywhere; "},
        {"No sheep in the village, but two knights stand there.",
         "2 ancient warrior idle center; "},
        {"3 goblins attacking @ village", "3 goblin attacking center; "},
        {"Two robots on wheels wait by the lake.", "2 wheeled robot idle upper left; "},
        {"a sheepdog robot in the fields", "1 robotic dog patrolling upper right; "},
        {"What I do not want: sheep or horses.", ""},
        {"a shepherd and his flock of sixty",
         "1 humanoid robot idle anywhere; 60 sheep grazing anywhere; "},
        {"Instead of sheep I want nine horses.", "9 horse grazing anywhere; "},
        {"a dozen swans drift over the lake", "12 eagle flying upper left; "},
        {"In the village five goblins, in the fields seven.",
         "5 goblin patrolling center; 7 goblin patrolling upper right; "},
        {"Two knights guard the fields. Nobody is in the village.",
         "2 ancient warrior patrolling upper right; "},
        {"Leave the animals out. One knight in the east.",
         "1 ancient warrior patrolling middle right; "},
        {"the village is full of goblins", "3 goblin patrolling center; "},
        {"two knights on the southern shore", "2 ancient warrior patrolling upper left; "},
        {"a goblin sits on a stone in the south", "1 goblin idle lower; "},
        {"a knight in the middle of the forest", "1 ancient warrior patrolling lower right; "},
        {"drones x4 over the fields", "4 aerial robot flying upper right; "},
        {"a pack mule by the road", "1 horse grazing lower left; "},
        {"drone footage of three horses", "3 horse grazing anywhere; "},
    }));

INSTANTIATE_TEST_SUITE_P(
    AsidesAndFragments, AgentVoices,
    testing::ValuesIn(std::vector<Sample>{
        {"Nine sheep graze. Make it a foggy night, with one eagle over the village.",
         "9 sheep grazing anywhere; 1 eagle flying center; "},
        {"one rover (patrolling) in the village, two knights by the lake",
         "1 wheeled robot patrolling center; 2 ancient warrior patrolling upper left; "},
        {"Six horses trotting... okay, only resting, in the east.", "6 horse idle middle right; "},
        {"four robots with wheels, parked in the south", "4 wheeled robot idle lower; "},
        {"Snow on the fields, and one eagle soars over the village.", "1 eagle flying center; "},
        {"two dozen goats south of the village", "24 sheep grazing lower; "},
        {"three delivery robots (six wheels each) wait in the village",
         "3 wheeled robot idle center; "},
        {"One drone and two rovers, all three parked in the village.",
         "1 aerial robot idle center; 2 wheeled robot idle center; "},
        {"Two horses rest in the east, the third grazes in the south.",
         "2 horse idle middle right; 1 horse grazing lower; "},
        {"Six horses graze in the east and another eight in the south.",
         "6 horse grazing middle right; 8 horse grazing lower; "},
        {"Four knights guard the village, with one eagle above them.",
         "4 ancient warrior patrolling center; 1 eagle flying center; "},
        {"two more groups of four goblins in the south", "8 goblin patrolling lower; "},
        {"five rovers in the corner down left", "5 wheeled robot idle lower left; "},
        {"two horses in the part down left", "2 horse grazing lower left; "},
        {"five humanoid courier robots in the east", "5 humanoid robot idle middle right; "},
        {"We want to test how robots cope with rain, so put two rovers in the south.",
         "2 wheeled robot idle lower; "},
        {"a dozen o' goblins", "12 goblin patrolling anywhere; "},
        {"four drons patroll", "4 aerial robot patrolling anywhere; "},
    }));

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
      Measure(claim, Generate(GetParam().instruction).environment);
  EXPECT_TRUE(measure.holds) << measure.explanation;
}

INSTANTIATE_TEST_SUITE_P(Voices, CoarseVoices,
                         testing::ValuesIn(std::vector<CoarseSample>{
                             {"the pumpkins glow, it is Halloween", CoarseKey::kSeason, "autumn"},
                             {"Diwali lamps everywhere", CoarseKey::kSeason, "autumn"},
                             {"the cherry trees are white with cherry blossom", CoarseKey::kSeason,
                              "spring"},
                             {"-12 \xC2\xB0"
                              "C and icicles",
                              CoarseKey::kSeason, "winter"},
                             {"95 degrees Fahrenheit in the shade", CoarseKey::kSeason, "summer"},
                             {"a frozen lake", CoarseKey::kSeason, "winter"},
                             {"everyone wears mittens", CoarseKey::kSeason, "winter"},
                             {"May.", CoarseKey::kSeason, "spring"},
                             {"it may be hot", CoarseKey::kSeason, "summer"},
                             {"goblins march through a cold January", CoarseKey::kSeason, "winter"},
                             {"half past nine in the evening", CoarseKey::kTimeOfDay, "night"},
                             {"it is 18:30", CoarseKey::kTimeOfDay, "dusk"},
                             {"at 6 am", CoarseKey::kTimeOfDay, "dawn"},
                             {"at three in the afternoon", CoarseKey::kTimeOfDay, "afternoon"},
                             {"the sun is directly overhead", CoarseKey::kTimeOfDay, "noon"},
                             {"long shadows", CoarseKey::kTimeOfDay, "dusk"},
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

TEST(EnvironmentReadingTest, EveryVariantAndMaterialHasWordsOfItsOwn) {
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

TEST(EnvironmentReadingTest, EveryPhraseOfAVariantIsHeardWithItsNoun) {
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

TEST(EnvironmentReadingTest, EverySpeciesIsHeard) {
  const EnvironmentWords& words = GetEnvironmentWords();
  for (const std::string_view phrase : words.species.index.Phrases()) {
    const HeardEnvironment heard =
        ParseEnvironmentInstruction("There are exactly two " + std::string(phrase) + ".");
    ASSERT_EQ(heard.agents.size(), 1u) << phrase;
    EXPECT_EQ(heard.agents.front().quantity, 2) << phrase;
  }
}

TEST(EnvironmentReadingTest, EveryStateIsHeard) {
  const EnvironmentWords& words = GetEnvironmentWords();
  for (const std::string_view phrase : words.states.index.Phrases()) {
    const HeardEnvironment heard =
        ParseEnvironmentInstruction("Two androids " + std::string(phrase) + ".");
    ASSERT_FALSE(heard.agents.empty()) << phrase;
    EXPECT_TRUE(heard.agents.front().state.has_value()) << phrase;
  }
}

TEST(EnvironmentReadingTest, EveryCoarsePhraseIsHeard) {
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

TEST(EnvironmentReadingTest, BadLinesAreNamed) {
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

TEST(EnvironmentReadingTest, FineWishesAreHeard) {
  const EnvironmentAnswer answer = Generate(
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

TEST(EnvironmentReadingTest, ASmallWorldHasNoLakeForAWhale) {
  EXPECT_EQ(Generate("a whale swims", 512.0).environment.agents.size(), 1u);
  const EnvironmentAnswer small = Generate("a whale swims", 32.0);
  EXPECT_TRUE(small.environment.agents.empty());
  ASSERT_EQ(small.warnings.size(), 1u);
  EXPECT_NE(small.warnings.front().find("whale"), std::string::npos);
}

TEST(EnvironmentReadingTest, SaysWhatItReadAnewAndWhatItDidNot) {
  const EnvironmentAnswer answer = Generate("two gobblins and a zorblax");
  ASSERT_EQ(answer.environment.agents.size(), 1u);
  ASSERT_EQ(answer.warnings.size(), 2u);
  EXPECT_EQ(answer.warnings[0], "read \"gobblins\" as \"goblins\"");
  EXPECT_NE(answer.warnings[1].find("zorblax"), std::string::npos);
  const EnvironmentReading reading = ReadEnvironmentInstruction("two gobblins and a zorblax");
  EXPECT_EQ(reading.not_understood, std::vector<std::string>{"zorblax"});
}

TEST(EnvironmentReadingTest, FeaturesAreClaimedWhereTheLandIsKnown) {
  const SymbolicLayout layout = Country();
  const EnvironmentReading blind = ReadEnvironmentInstruction("ten sheep by the village");
  ASSERT_EQ(blind.claims.size(), 2u);
  EXPECT_TRUE(blind.claims.back().positions.empty());
  const EnvironmentReading seen = ReadEnvironmentInstruction("ten sheep by the village", &layout);
  EXPECT_EQ(seen.claims.back().positions, std::vector<Region>{Region::kCenter});
}

// The answer satisfies the claims that were read from the same words, or a warning quotes them.
TEST(EnvironmentReadingTest, WordSaladGivesValidAnswersThatKeepTheirOwnClaims) {
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
    const EnvironmentAnswer answer = Generate(text);
    ASSERT_TRUE(Validate(answer.environment).empty()) << text;
    const SymbolicLayout layout = Country();
    for (const EnvironmentClaim& claim : ReadEnvironmentInstruction(text, &layout).claims) {
      EXPECT_TRUE(Validate(claim).empty()) << text;
    }
  }
}

TEST(EnvironmentReadingTest, InflectsRegularVerbsAndNouns) {
  EXPECT_EQ(FormsOf("swim"), (std::vector<std::string>{"swim", "swims", "swimming", "swam"}));
  EXPECT_EQ(FormsOf("keep watch"),
            (std::vector<std::string>{"keep watch", "keeps watch", "keeping watch", "kept watch"}));
  EXPECT_EQ(FormsOf("graze")[2], "grazing");
  EXPECT_EQ(PluralOf("wild pony"), "wild ponies");
  EXPECT_EQ(PluralOf("fox"), "foxes");
}

TEST(EnvironmentReadingTest, EveryHourHasItsName) {
  EXPECT_EQ(TimeAt(0.0), TimeOfDay::kNight);
  EXPECT_EQ(TimeAt(5.5), TimeOfDay::kDawn);
  EXPECT_EQ(TimeAt(9.0), TimeOfDay::kMorning);
  EXPECT_EQ(TimeAt(12.0), TimeOfDay::kNoon);
  EXPECT_EQ(TimeAt(15.0), TimeOfDay::kAfternoon);
  EXPECT_EQ(TimeAt(19.0), TimeOfDay::kDusk);
  EXPECT_EQ(TimeAt(23.9), TimeOfDay::kNight);
}

}  // namespace
}  // namespace latticeworld
