#include "latticeworld/language/reading/things/things_of_sentences.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "latticeworld/language/reading/layout_of_sentences.h"
#include "latticeworld/language/sentences/sentence_tables.h"

namespace latticeworld {
namespace {

std::vector<ThingWish> Read(const std::string& text) {
  return LayoutOfSentences(SplitSentences(text), Vocabulary::kSuburb).things;
}

TEST(ThingsOfSentencesTest, ARowOfTreesIsOneWishWithItsSpacing) {
  const std::vector<ThingWish> things =
      Read("3 trees are in a row every 9 m. The trees are near the village.");
  ASSERT_EQ(things.size(), 1u);
  EXPECT_EQ(things[0].count, 3);
  EXPECT_EQ(things[0].arrangement, ThingArrangement::kRow);
  EXPECT_EQ(things[0].spacing_m, 9.0);
  EXPECT_EQ(things[0].relation, ThingRelation::kNear);
  EXPECT_EQ(things[0].target.letter, 'B');
}

TEST(ThingsOfSentencesTest, RelationsNameThingsAndLand) {
  const std::vector<ThingWish> things = Read(
      "A church in the west. A well is in front of the church. The church faces the lake. "
      "4 benches surround the well. 5 lamps are along the road. A barn is 20 m from the well.");
  ASSERT_EQ(things.size(), 5u);
  EXPECT_EQ(things[0].facing.letter, 'W');
  EXPECT_EQ(things[1].relation, ThingRelation::kInFront);
  EXPECT_EQ(things[1].target.wish, 0);
  EXPECT_EQ(things[2].relation, ThingRelation::kAround);
  EXPECT_EQ(things[2].target.wish, 1);
  EXPECT_EQ(things[3].relation, ThingRelation::kAlong);
  EXPECT_EQ(things[3].target.letter, 'R');
  EXPECT_EQ(things[4].distance_m, 20.0);
}

TEST(ThingsOfSentencesTest, SidesAndWhatLiesBetweenAreHeard) {
  const std::vector<ThingWish> things = Read(
      "A tower is north-east of the lake. A hut is between the lake and the forest. "
      "A well is west of the tower. A tent is between the lakes.");
  ASSERT_EQ(things.size(), 4u);
  EXPECT_EQ(things[3].target.letter, 'W');
  EXPECT_EQ(things[3].second.letter, 'W');
  EXPECT_EQ(things[0].side, ThingSide::kNorthEast);
  EXPECT_EQ(things[0].target.letter, 'W');
  EXPECT_EQ(things[1].relation, ThingRelation::kBetween);
  EXPECT_EQ(things[1].second.letter, 'F');
  EXPECT_EQ(things[2].side, ThingSide::kWest);
  EXPECT_EQ(things[2].target.wish, 0);
}

TEST(ThingsOfSentencesTest, AHouseIsASingleThingWhereThereIsNoLandForIt) {
  const auto read = [](Vocabulary vocabulary) {
    return LayoutOfSentences({"Rock", "A lake in the north", "A house is south of the lake"},
                             vocabulary)
        .things;
  };
  EXPECT_TRUE(read(Vocabulary::kSuburb).empty());
  const std::vector<ThingWish> things = read(Vocabulary::kWild);
  ASSERT_EQ(things.size(), 1u);
  EXPECT_EQ(things[0].kind, "house");
  EXPECT_EQ(things[0].side, ThingSide::kSouth);
}

TEST(ThingsOfSentencesTest, WhatStandsByAPlaceOfTheMapHasNoTarget) {
  const std::vector<ThingWish> things =
      Read("A bench is along the southern edge. The bench faces the north.");
  ASSERT_EQ(things.size(), 1u);
  EXPECT_TRUE(things[0].target.is_nothing());
  EXPECT_FALSE(things[0].zone.is_anywhere());
  EXPECT_TRUE(things[0].heading_rad.has_value());
}

// With "a tower" in the place of any of the nouns of its example, in either vocabulary.
TEST(ThingsOfSentencesTest, EveryFormMaySpeakOfSingleThings) {
  int heard = 0;
  for (const SentenceForm& form : SentenceForms(SentenceKind::kLayout)) {
    for (const std::string noun : {"lake", "lakes", "village", "river", "forest", "road", "hill"}) {
      std::string example = form.example;
      const std::size_t at = example.find(noun);
      if (at == std::string::npos) continue;
      example.replace(at, noun.size(), "tower");
      for (const Vocabulary vocabulary : {Vocabulary::kSuburb, Vocabulary::kWild}) {
        SCOPED_TRACE(example);
        const LayoutPlan plan = LayoutOfSentences(SplitSentences(example), vocabulary);
        heard += static_cast<int>(plan.things.size());
      }
    }
  }
  EXPECT_GT(heard, 20);
}

TEST(ThingsOfSentencesTest, WhatIsNewOnBothSidesIsMadeOnce) {
  const std::vector<ThingWish> things = Read("A well is 20 m from a barn.");
  ASSERT_EQ(things.size(), 2u);
  EXPECT_EQ(things[0].kind, "barn");
  EXPECT_EQ(things[1].target.wish, 0);
  EXPECT_EQ(things[1].distance_m, 20.0);
}

TEST(ThingsOfSentencesTest, WhatStandsByWhatIsSaidLaterStandsBehindIt) {
  const std::vector<ThingWish> things =
      Read("A bench. 3 tents are in a row. The tents surround a well. The bench faces the tower.");
  ASSERT_EQ(things.size(), 4u);
  for (std::size_t i = 0; i < things.size(); ++i) {
    EXPECT_LT(things[i].target.wish, static_cast<int>(i));
    EXPECT_LT(things[i].facing.wish, static_cast<int>(i));
  }
  EXPECT_EQ(things[static_cast<std::size_t>(things[3].target.wish)].kind, "well");
  EXPECT_EQ(things[static_cast<std::size_t>(things[1].facing.wish)].kind, "tower");
  const std::string in_a_circle = "A well is near the tower. The tower is near the well.";
  const LayoutPlan plan = LayoutOfSentences(SplitSentences(in_a_circle), Vocabulary::kSuburb);
  EXPECT_EQ(plan.things.size(), 2u);
  ASSERT_EQ(plan.warnings.size(), 1u);
  EXPECT_NE(plan.warnings[0].find("stands by it already"), std::string::npos) << plan.warnings[0];
}

// Each thing stands by the one before it and faces it: two ways lead on from each.
TEST(ThingsOfSentencesTest, LongChainsOfThingsAreReadAtOnce) {
  std::string text = "A tower. ";
  const char* const kinds[] = {"tower", "well"};
  for (int i = 1; i < kMostThingWishes; ++i) {
    const std::string kind = kinds[i % 2], before = kinds[(i + 1) % 2];
    text +=
        "A " + kind + " is near the " + before + ". The " + kind + " faces the " + before + ". ";
  }
  const std::vector<ThingWish> things = Read(text);
  ASSERT_EQ(things.size(), static_cast<std::size_t>(kMostThingWishes));
  EXPECT_EQ(things.back().target.wish, kMostThingWishes - 2);
  EXPECT_EQ(things.back().facing.wish, kMostThingWishes - 2);
}

TEST(ThingsOfSentencesTest, WhatIsOnBothSidesOfAThingIsAroundIt) {
  const std::vector<ThingWish> things =
      Read("A gate. Towers are on both sides of the gate. A lamp is on both sides of the road.");
  ASSERT_EQ(things.size(), 2u) << "towers without a number are buildings";
  const std::vector<ThingWish> counted = Read("A gate. 2 towers are on both sides of the gate.");
  ASSERT_EQ(counted.size(), 2u);
  EXPECT_EQ(counted[1].relation, ThingRelation::kAround);
  EXPECT_EQ(counted[1].target.wish, 0);
  EXPECT_EQ(things[1].relation, ThingRelation::kAlong);
}

TEST(ThingsOfSentencesTest, WhatFacesSomethingAndHasNoOtherPlaceIsNearIt) {
  const std::vector<ThingWish> things =
      Read("2 benches face the lake. A church in the west. The church faces the lake.");
  ASSERT_EQ(things.size(), 2u);
  EXPECT_EQ(things[0].relation, ThingRelation::kNear);
  EXPECT_EQ(things[0].target.letter, 'W');
  EXPECT_EQ(things[1].relation, ThingRelation::kNone);
}

TEST(ThingsOfSentencesTest, AThingStandsByOneThingRatherThanByLand) {
  const auto target_of = [](const std::string& text) {
    const LayoutPlan plan = LayoutOfSentences(SplitSentences(text), Vocabulary::kSuburb);
    return std::pair(plan.things.back().target, plan.warnings.size());
  };
  const auto [first, told] =
      target_of("A well. A crate is near the well. The crate is near the road.");
  EXPECT_EQ(first.wish, 0);
  EXPECT_EQ(told, 1u) << "that it is near the road is lost";
  const auto [second, none] =
      target_of("A well. A crate is inside the village. The crate is near the well.");
  EXPECT_EQ(second.wish, 0);
  EXPECT_EQ(none, 0u);
  EXPECT_EQ(target_of("A crate is near the lake. The crate is near the road.").first.letter, 'W');
}

TEST(ThingsOfSentencesTest, ThingsMayBeBetweenThingsOfOneSentence) {
  const std::vector<ThingWish> things = Read("3 lamps. A bench is between the lamps.");
  ASSERT_EQ(things.size(), 2u);
  EXPECT_EQ(things[1].relation, ThingRelation::kBetween);
  EXPECT_EQ(things[1].target.wish, 0);
  EXPECT_EQ(things[1].second.wish, 0);
}

TEST(ThingsOfSentencesTest, BenchesOfAPondAreOnItsShore) {
  const std::vector<ThingWish> things =
      Read("2 benches are inside the pond. A boulder is inside the pond.");
  ASSERT_EQ(things.size(), 2u);
  EXPECT_EQ(things[0].relation, ThingRelation::kNear);
  EXPECT_EQ(things[1].relation, ThingRelation::kIn);
}

TEST(ThingsOfSentencesTest, PluralsThatAreNoLandAreSeveralThings) {
  const std::vector<ThingWish> things = Read("Lamps are along the road. The lamps are in a row.");
  ASSERT_EQ(things.size(), 1u);
  EXPECT_EQ(things[0].kind, "lamp");
  EXPECT_GE(things[0].count, 2);
  EXPECT_EQ(things[0].relation, ThingRelation::kAlong);
  EXPECT_EQ(things[0].arrangement, ThingArrangement::kRow);
}

TEST(ThingsOfSentencesTest, BarePluralsAndBridgesAreLand) {
  EXPECT_TRUE(Read("Trees are on both sides of the river. A bridge is over the river.").empty());
}

}  // namespace
}  // namespace latticeworld
