#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/common/random.h"
#include "latticeworld/language/drawn/grounded.h"
#include "latticeworld/layout/claims/claims.h"
#include "latticeworld/layout/measures.h"
#include "latticeworld/layout/zone.h"

namespace latticeworld {
namespace {

using Kind = ClaimKind;
constexpr int kSeeds = 20;

Claim Says(Kind kind, char subject, std::string_view zone = "anywhere") {
  Claim claim;
  claim.kind = kind;
  claim.subject = subject;
  claim.zone = FindZone(zone).value();
  return claim;
}
Claim Few(char subject, std::string_view zone) {
  Claim claim = Says(Kind::kAmount, subject, zone);
  claim.least = 0.002;
  claim.most = 0.25;
  return claim;
}
Claim Ties(Kind kind, char subject, char object) {
  Claim claim = Says(kind, subject);
  claim.object = object;
  if (kind == Kind::kAdjacent) claim.most = 2.0;
  return claim;
}
Claim LiesBetween(char subject, char object, char second_object) {
  Claim claim = Ties(Kind::kBetween, subject, object);
  claim.second_object = second_object;
  return claim;
}
Claim Runs(char subject, std::string_view from, std::string_view to) {
  Claim claim = Says(Kind::kCourse, subject);
  claim.from = FindZone(from).value();
  claim.to = FindZone(to).value();
  return claim;
}

struct Sample {
  std::string instruction;
  Vocabulary vocabulary;
  std::vector<Claim> claims;  // by hand, not from the parser
};

void PrintTo(const Sample& sample, std::ostream* os) { *os << sample.instruction; }

const Vocabulary kSuburb = Vocabulary::kSuburb;
const Vocabulary kWild = Vocabulary::kWild;

std::vector<Sample> Samples() {
  return {
      {"A river winds from the north to the south between dense forest in the upper left and "
       "farmland on the right. A road runs from the west to the east, with a small village in the "
       "center.",
       kSuburb,
       {Runs('W', "northern edge", "southern edge"), Runs('R', "western edge", "eastern edge"),
        Says(Kind::kPresent, 'F', "upper left"), Says(Kind::kDominant, 'A', "eastern third"),
        Says(Kind::kPresent, 'B', "center"), LiesBetween('W', 'F', 'A')}},
      {"The map is mostly forest with a lake in the center.",
       kSuburb,
       {Says(Kind::kDominant, 'F'), Says(Kind::kPresent, 'W', "center"),
        Says(Kind::kClustered, 'W')}},
      {"FARMLAND COVERS THE SOUTHERN HALF; WOODS IN THE NORTH-EAST CORNER!",
       kSuburb,
       {Says(Kind::kDominant, 'A', "southern half"), Says(Kind::kPresent, 'F', "upper right")}},
      {"In the upper left there is a lake and in the lower right a town. No roads.",
       kSuburb,
       {Says(Kind::kPresent, 'W', "upper left"), Says(Kind::kPresent, 'B', "lower right"),
        Says(Kind::kAbsent, 'R')}},
      {"three ponds scattered across a meadow, without any buildings or trees",
       kSuburb,
       {Says(Kind::kPresent, 'W'), Says(Kind::kAbsent, 'B'), Says(Kind::kAbsent, 'F'),
        Says(Kind::kDominant, 'G')}},
      {"A lake in the middle of the map is surrounded by forest. The rest is farmland.",
       kSuburb,
       {Says(Kind::kPresent, 'W', "center"), Ties(Kind::kSurrounds, 'F', 'W'),
        Says(Kind::kDominant, 'A')}},
      {"Forest and farmland in the west, a village next to a lake in the east",
       kSuburb,
       {Says(Kind::kPresent, 'F', "western third"), Says(Kind::kPresent, 'A', "western third"),
        Ties(Kind::kAdjacent, 'B', 'W')}},
      {"Please draw a treeless plain crossed by a highway from the lower left to the upper right",
       kSuburb,
       {Says(Kind::kAbsent, 'F'), Runs('R', "south-west corner", "north-east corner"),
        Says(Kind::kDominant, 'G')}},
      {"More forest than farmland, please. A stream flows from east to west.",
       kSuburb,
       {Ties(Kind::kMoreThan, 'F', 'A'), Runs('W', "eastern edge", "western edge")}},
      {"Scattered houses in the southern part and an apple orchard in the top right corner",
       kSuburb,
       {Says(Kind::kScattered, 'B'), Says(Kind::kPresent, 'B', "southern third"),
        Says(Kind::kPresent, 'A', "upper right")}},
      {"A gravel road connects the top left with the bottom right. Row houses stand in the middle "
       "left.",
       kSuburb,
       {Runs('R', "north-west corner", "south-east corner"),
        Says(Kind::kPresent, 'B', "western third")}},
      {"The left half is dense woodland and the right half is cropland; there is no water.",
       kSuburb,
       {Says(Kind::kDominant, 'F', "western half"), Says(Kind::kDominant, 'A', "eastern half"),
        Says(Kind::kAbsent, 'W')}},
      {"A few trees in the north. Barren land dominates the south.",
       kSuburb,
       {Few('F', "northern third"), Says(Kind::kDominant, 'D', "southern third")}},
      {"A river crosses the map from west to east and a road crosses it from north to south.",
       kSuburb,
       {Runs('W', "western edge", "eastern edge"), Runs('R', "northern edge", "southern edge")}},
      {"A town in the south-west, and a forest north of the town.",
       kSuburb,
       {Says(Kind::kPresent, 'B', "lower left"), Says(Kind::kPresent, 'F', "western third")}},
      {"Along the southern edge runs a road. Houses are clustered in the lower left.",
       kSuburb,
       {Says(Kind::kPresent, 'R', "southern third"), Says(Kind::kPresent, 'B', "lower left"),
        Says(Kind::kClustered, 'B')}},
      {"Everything is grassland, except for a small pond at the top right.",
       kSuburb,
       {Says(Kind::kDominant, 'G'), Says(Kind::kPresent, 'W', "upper right")}},
      {"Snow-capped peaks in the north, rocky slopes below them in the middle, pine forest in the "
       "south.",
       kWild,
       {Says(Kind::kPresent, 'S', "northern third"), Says(Kind::kPresent, 'R', "center"),
        Says(Kind::kDominant, 'F', "southern third")}},
      {"A vast lake lies in the lower right, bordered by low bushes; mountains in the upper left.",
       kWild,
       {Says(Kind::kPresent, 'W', "lower right"), Ties(Kind::kAdjacent, 'W', 'B'),
        Says(Kind::kPresent, 'R', "upper left")}},
      {"mostly rocky land with sparse bushes, snow only in the upper right corner, no water",
       kWild,
       {Says(Kind::kDominant, 'R'), Says(Kind::kPresent, 'S', "upper right"),
        Says(Kind::kAbsent, 'W')}},
      {"a creek meanders from the upper left to the lower right through woodland",
       kWild,
       {Runs('W', "north-west corner", "south-east corner"), Ties(Kind::kAdjacent, 'W', 'F')}},
      {"Forest covers most of the land. A glacier sits in the north-west and two lakes in the "
       "south.",
       kWild,
       {Says(Kind::kDominant, 'F'), Says(Kind::kPresent, 'S', "upper left"),
        Says(Kind::kPresent, 'W', "southern third")}},
      {"Mostly farmland. A river enters in the north-west and leaves in the south-east. There are "
       "two "
       "villages, one in the north-east and one in the south-west, connected by a road.",
       kSuburb,
       {Says(Kind::kDominant, 'A'), Runs('W', "north-west corner", "south-east corner"),
        Says(Kind::kPresent, 'B', "upper right"), Says(Kind::kPresent, 'B', "lower left"),
        Runs('R', "upper right", "lower left")}},
      {"Give me a desert with an oasis.",
       kSuburb,
       {Says(Kind::kDominant, 'D'), Says(Kind::kPresent, 'W')}},
      {"vineyards on the left half", kSuburb, {Says(Kind::kDominant, 'A', "western half")}},
      {"coastline along the western edge, town in the east",
       kSuburb,
       {Says(Kind::kPresent, 'W', "western third"), Says(Kind::kPresent, 'B', "eastern third")}},
      {"forest everywhere except a clearing in the middle",
       kSuburb,
       {Says(Kind::kDominant, 'F'), Says(Kind::kPresent, 'G', "center")}},
      {"In the center there is a village; around it are fields. Woods lie in all four corners.",
       kSuburb,
       {Says(Kind::kPresent, 'B', "center"), Says(Kind::kPresent, 'F', "north-west corner"),
        Says(Kind::kPresent, 'F', "north-east corner"),
        Says(Kind::kPresent, 'F', "south-west corner"),
        Says(Kind::kPresent, 'F', "south-east corner")}},
  };
}

LayoutAnswer Generate(const std::string& instruction, Vocabulary vocabulary, std::uint64_t seed,
                      const Relief* relief = nullptr) {
  LayoutRequest request;
  request.instruction = instruction;
  request.vocabulary = vocabulary;
  request.seed = seed;
  request.relief = relief;
  Result<LayoutAnswer> answer = MakeGroundedLayoutGenerator()->Generate(request, Progress());
  EXPECT_TRUE(answer.ok()) << answer.status().ToString();
  return std::move(answer).value();
}

bool IsLegal(const SymbolicLayout& layout) {
  return ParseLayout(ToText(layout), layout.vocabulary).ok();
}

// Pieces of at most two cells, over all letters.
int TinyPieces(const SymbolicLayout& layout) {
  int tiny = 0;
  for (const LayoutClass& entry : ClassesOf(layout.vocabulary)) {
    for (const LayoutComponent& component : ComponentsOf(layout, entry.letter)) {
      tiny += component.cells.size() <= 2 ? 1 : 0;
    }
  }
  return tiny;
}

class GroundedLayoutSamples : public testing::TestWithParam<Sample> {};

TEST_P(GroundedLayoutSamples, SatisfiesWhatTheWordsSayForEverySeed) {
  const Sample& sample = GetParam();
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const LayoutAnswer answer = Generate(sample.instruction, sample.vocabulary, seed);
    ASSERT_TRUE(IsLegal(answer.layout));
    for (const Claim& claim : sample.claims) {
      const ClaimMeasure measure = Measure(claim, answer.layout);
      EXPECT_TRUE(measure.holds) << sample.instruction << "\nseed " << seed << ": "
                                 << NameOf(claim.kind) << " " << measure.explanation << "\n"
                                 << ToText(answer.layout);
    }
    EXPECT_LE(TinyPieces(answer.layout), 6) << seed << "\n" << ToText(answer.layout);
    for (const std::string& warning : answer.warnings) {
      ADD_FAILURE() << sample.instruction << ": " << warning;
    }
  }
}

TEST_P(GroundedLayoutSamples, TheSeedChangesTheLayoutAndRepeatsIt) {
  const Sample& sample = GetParam();
  const auto text = [&](std::uint64_t seed) {
    return ToText(Generate(sample.instruction, sample.vocabulary, seed).layout);
  };
  EXPECT_EQ(text(3), text(3));
  EXPECT_NE(text(3), text(4));
}

INSTANTIATE_TEST_SUITE_P(Voices, GroundedLayoutSamples, testing::ValuesIn(Samples()));

Relief HillInTheNorth() {
  Grid<float> height(65, 65);
  for (int row = 0; row < 65; ++row) {
    for (int col = 0; col < 65; ++col) height(row, col) = static_cast<float>(64 - row);
  }
  return MakeRelief(std::move(height));
}

TEST(GroundedLayoutTest, FollowsTheReliefAloneWithoutWords) {
  const Relief relief = HillInTheNorth();
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const SymbolicLayout layout = Generate("", kWild, seed, &relief).layout;
    EXPECT_GT(ShareIn(layout, 'S', Region::kUpper), 0.2);
    EXPECT_GT(ShareIn(layout, 'W', Region::kLower), 0.1);
    EXPECT_EQ(ShareIn(layout, 'S', Region::kLower), 0.0);
    EXPECT_EQ(ShareIn(layout, 'W', Region::kUpper), 0.0);
  }
}

TEST(GroundedLayoutTest, WordsWithoutPlaceFollowTheRelief) {
  const Relief relief = HillInTheNorth();
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const SymbolicLayout layout = Generate("a lake and snow", kWild, seed, &relief).layout;
    EXPECT_GT(ShareIn(layout, 'W', Region::kAnywhere), 0.0);
    EXPECT_EQ(ShareIn(layout, 'W', Region::kUpper), 0.0) << ToText(layout);
    EXPECT_GT(ShareIn(layout, 'S', Region::kAnywhere), 0.0);
    EXPECT_EQ(ShareIn(layout, 'S', Region::kLower), 0.0) << ToText(layout);
  }
}

TEST(GroundedLayoutTest, WarnsOfWordsAgainstTheRelief) {
  const Relief relief = HillInTheNorth();
  const LayoutAnswer against =
      Generate("Snow in the south. A lake in the north.", kWild, 1, &relief);
  EXPECT_GT(ShareIn(against.layout, 'S', Region::kLower), 0.0);
  ASSERT_EQ(against.warnings.size(), 2u);
  EXPECT_NE(against.warnings[0].find("Snow in the south"), std::string::npos);
  EXPECT_NE(against.warnings[1].find("lake in the north"), std::string::npos);
  EXPECT_TRUE(
      Generate("Snow in the north. A lake in the south.", kWild, 1, &relief).warnings.empty());
}

TEST(GroundedLayoutTest, WarnsOfWhatItDoesNotUnderstand) {
  const LayoutAnswer answer = Generate("a forest with purple spaceships", kSuburb, 1);
  ASSERT_EQ(answer.warnings.size(), 1u);
  EXPECT_NE(answer.warnings[0].find("purple spaceships"), std::string::npos);
}

TEST(GroundedLayoutTest, WarnsOfClassesThatTheVocabularyLacks) {
  const LayoutAnswer answer = Generate("a forest and a castle", kWild, 1);
  ASSERT_EQ(answer.warnings.size(), 1u);
  EXPECT_NE(answer.warnings[0].find("castle"), std::string::npos);
}

TEST(GroundedLayoutTest, WarnsOfWhatCannotHoldTogether) {
  const LayoutAnswer answer = Generate("a lake in the center, but no water", kSuburb, 1);
  ASSERT_FALSE(answer.warnings.empty());
  EXPECT_NE(answer.warnings[0].find("lake"), std::string::npos) << answer.warnings[0];
}

// Pieces of land that water shuts in on all sides.
int Islands(const SymbolicLayout& layout, char letter) {
  int islands = 0;
  for (const LayoutComponent& component : ComponentsOf(layout, letter)) {
    bool shut_in = true;
    for (const CellIndex cell : component.cells) {
      for (int i = 0; i < 9; ++i) {
        const CellIndex next{cell.row + i / 3 - 1, cell.col + i % 3 - 1};
        const bool inside = layout.cells.Contains(next);
        shut_in = shut_in && inside && (layout.cells[next] == letter || layout.cells[next] == 'W');
      }
    }
    islands += shut_in ? 1 : 0;
  }
  return islands;
}

// Whether there is such land, and no dry way from it to the edge.
bool WaterShutsIn(const SymbolicLayout& layout, char letter) {
  Grid<char> seen(kLayoutSize, kLayoutSize, 0);
  std::vector<CellIndex> open;
  for (const LayoutComponent& component : ComponentsOf(layout, letter))
    open.insert(open.end(), component.cells.begin(), component.cells.end());
  const bool found = !open.empty();
  while (!open.empty()) {
    const CellIndex cell = open.back();
    open.pop_back();
    if (!layout.cells.Contains(cell)) return false;
    if (layout.cells[cell] == 'W' || seen[cell] != 0) continue;
    seen[cell] = 1;
    for (const CellIndex next :
         {CellIndex{cell.row + 1, cell.col}, CellIndex{cell.row - 1, cell.col},
          CellIndex{cell.row, cell.col + 1}, CellIndex{cell.row, cell.col - 1}})
      open.push_back(next);
  }
  return found;
}

TEST(GroundedLayoutTest, PutsIslandsIntoTheirWater) {
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    for (const std::string text : {"an island in the lake", "A lake with an island in it.",
                                   "A small island in the middle of a large lake."}) {
      const LayoutAnswer answer = Generate(text, kSuburb, seed);
      EXPECT_EQ(Islands(answer.layout, 'G'), 1) << text << "\n" << ToText(answer.layout);
      EXPECT_TRUE(answer.warnings.empty()) << text;
    }
    const LayoutAnswer wooded = Generate("a wooded island in a lake", kSuburb, seed);
    EXPECT_EQ(Islands(wooded.layout, 'F'), 1);
    EXPECT_TRUE(wooded.warnings.empty());
  }
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const LayoutAnswer answer = Generate("A castle on an island.", kSuburb, seed);
    EXPECT_TRUE(WaterShutsIn(answer.layout, 'B')) << ToText(answer.layout);
  }
  const LayoutAnswer dry = Generate("A field and an island, and no water at all.", kSuburb, 1);
  ASSERT_EQ(dry.warnings.size(), 1u);
  EXPECT_NE(dry.warnings[0].find("island"), std::string::npos);
}

TEST(GroundedLayoutTest, CountsSeparatePieces) {
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const SymbolicLayout layout = Generate("five ponds in the grass", kSuburb, seed).layout;
    EXPECT_EQ(ComponentsOf(layout, 'W').size(), 5u) << ToText(layout);
  }
}

TEST(GroundedLayoutTest, WordSaladGivesALegalLayout) {
  const std::vector<std::string> words = {"forest",     "no",
                                          "the",        "rest",
                                          "is",         "lake",
                                          "between",    "and",
                                          "north",      "of",
                                          "from",       "to",
                                          "river",      "surrounded by",
                                          "mostly",     "three",
                                          "ponds",      ",",
                                          ".",          "in",
                                          "upper left", "road",
                                          "runs",       "through",
                                          "connects",   "more",
                                          "than",       "without",
                                          "xyzzy",      "999999999999",
                                          "edges",      "snow",
                                          "village",    "around",
                                          "scattered",  "middle",
                                          "'",          "-",
                                          "(",          "everywhere",
                                          "the",        "treeless",
                                          "west",       "half",
                                          "a few",      "dozen",
                                          "next to",    "it",
                                          "winding",    "with",
                                          "but"};
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    RandomStream random(seed, "salad");
    std::string text = "a";
    const int length = random.UniformInt(1, 60);
    for (int i = 0; i < length; ++i) {
      text += " " + words[random.UniformInt(0, static_cast<int>(words.size()) - 1)];
    }
    const Vocabulary vocabulary = random.Chance(0.5) ? kSuburb : kWild;
    EXPECT_TRUE(IsLegal(Generate(text, vocabulary, seed).layout)) << text;
  }
}

// Random code points, encoded.
std::string RandomUtf8(RandomStream* random, int length) {
  std::string text = "x";
  for (int i = 0; i < length; ++i) {
    int code = random->Chance(0.5) ? random->UniformInt(1, 0x7F) : random->UniformInt(1, 0x10FFFF);
    if (code >= 0xD800 && code <= 0xDFFF) code = 0x20;
    const auto add = [&](int bits) { text += static_cast<char>(bits); };
    if (code < 0x80) {
      add(code);
    } else if (code < 0x800) {
      add(0xC0 | code >> 6), add(0x80 | (code & 0x3F));
    } else if (code < 0x10000) {
      add(0xE0 | code >> 12), add(0x80 | (code >> 6 & 0x3F)), add(0x80 | (code & 0x3F));
    } else {
      add(0xF0 | code >> 18), add(0x80 | (code >> 12 & 0x3F));
      add(0x80 | (code >> 6 & 0x3F)), add(0x80 | (code & 0x3F));
    }
  }
  return text;
}

TEST(GroundedLayoutTest, AnyUtf8GivesALegalLayout) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    RandomStream random(seed, "utf8");
    const std::string text = RandomUtf8(&random, random.UniformInt(0, 300));
    EXPECT_TRUE(IsLegal(Generate(text, kSuburb, seed).layout));
  }
}

TEST(GroundedLayoutTest, ReadsTheLongestInstruction) {
  std::string text;
  while (text.size() + 60 < kMaxInstructionBytes) {
    text += "A lake in the north, woods in the south, a road, no snow; ";
  }
  EXPECT_TRUE(IsLegal(Generate(text, kSuburb, 1).layout));
}

TEST(GroundedLayoutTest, WhatIsSaidAgainIsLaidOnce) {
  const std::string once =
      "A river winds from the north to the south between dense forest in the upper left and "
      "farmland on the right. A road runs from the west to the east, with a small village in the "
      "center. ";
  std::string often;
  for (int i = 0; i < 12; ++i) often += once;
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    const LayoutAnswer answer = Generate(often, kSuburb, seed);
    EXPECT_EQ(ToText(answer.layout), ToText(Generate(once, kSuburb, seed).layout));
    ASSERT_EQ(answer.warnings.size(), 1u);
    EXPECT_NE(answer.warnings[0].find("river winds"), std::string::npos) << answer.warnings[0];
  }
}

TEST(GroundedLayoutTest, WarnsOfWhatIsBeyondItsLimits) {
  std::string text;
  const std::vector<std::string> places = {"north",      "south",      "west",       "east",
                                           "north-east", "north-west", "south-east", "south-west"};
  for (const std::string& place : places) {
    for (const std::string thing : {"lake", "village", "forest", "field", "meadow"}) {
      text += "A " + thing + " in the " + place + ". ";
    }
  }
  const LayoutAnswer answer = Generate(text, kSuburb, 1);
  ASSERT_FALSE(answer.warnings.empty());
  EXPECT_NE(answer.warnings[0].find("too many things"), std::string::npos) << answer.warnings[0];
  EXPECT_NE(answer.warnings[0].find("nothing is laid from \"A"), std::string::npos)
      << answer.warnings[0];
}

TEST(GroundedLayoutTest, StopsWhenCancelled) {
  LayoutRequest request;
  request.instruction = "a lake";
  Progress progress;
  progress.Cancel();
  const auto answer = MakeGroundedLayoutGenerator()->Generate(request, progress);
  ASSERT_FALSE(answer.ok());
  EXPECT_EQ(answer.status().code(), StatusCode::kCancelled);
}

}  // namespace
}  // namespace latticeworld
