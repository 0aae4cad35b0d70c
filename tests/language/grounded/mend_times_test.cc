#include "latticeworld/language/grounded/environment/mend_times.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/language/grounded/environment/mend_compounds.h"
#include "latticeworld/language/grounded/environment/mend_fields.h"
#include "latticeworld/language/grounded/environment/mend_speakers.h"

namespace latticeworld {
namespace {

std::string MendedBy(void (*mend)(const EnvironmentWords&, std::vector<Token>*),
                     std::string_view text) {
  std::vector<Token> tokens = Tokenize(text);
  mend(GetEnvironmentWords(), &tokens);
  return JoinWords(tokens, 0, tokens.size());
}

void ExpectKept(void (*mend)(const EnvironmentWords&, std::vector<Token>*),
                std::initializer_list<const char*> texts) {
  for (const char* text : texts) EXPECT_EQ(MendedBy(mend, text), text);
}

TEST(MendTimesTest, WhatIsOverIsNotAskedFor) {
  EXPECT_EQ(MendedBy(MendTimes, "It was snowing last night, but now it is clear"),
            "but now it is clear");
  EXPECT_EQ(MendedBy(MendTimes, "the fog of last night is gone"), "the fog is gone");
  EXPECT_EQ(MendedBy(MendTimes, "We thought of winter, but summer it is"), "summer it is");
  EXPECT_EQ(MendedBy(MendTimes, "Snow is forecast for tomorrow, right now it is cloudy"),
            ", right now it is cloudy");
  ExpectKept(MendTimes, {"this morning it is raining", "it was sunny . now add ten sheep",
                         "i was thinking of a desert with sheep", "fog is expected",
                         "three horses were in the rain , now they graze"});
}

TEST(MendTimesTest, TheSunTellsTheTime) {
  EXPECT_EQ(MendedBy(MendTimes, "the sun has already gone down"), "the dusk");
  EXPECT_EQ(MendedBy(MendTimes, "the sun is not yet up"), "the dawn");
  EXPECT_EQ(MendedBy(MendTimes, "the sun will set soon"), "the dusk");
  ExpectKept(MendTimes, {"the sun is out", "the sun is high", "the sun has not set"});
}

TEST(MendTimesTest, PlainWeatherIsNoPlain) {
  EXPECT_EQ(MendedBy(MendTimes, "a plain foggy morning"), "a foggy morning");
  ExpectKept(MendTimes, {"a plain with sun", "an open plain under a cloudy sky"});
}

TEST(MendCompoundsTest, APartOfAWordIsNoAgent) {
  EXPECT_EQ(MendedBy(MendCompounds, "ten hawk-eyed archers"), "ten archers");
  EXPECT_EQ(MendedBy(MendCompounds, "eagle-eyed guards wait"), "some guards wait");
  EXPECT_EQ(MendedBy(MendCompounds, "a kid-friendly look"), "a look");
  EXPECT_EQ(MendedBy(MendCompounds, "horse chestnuts lie under the trees"),
            "chestnuts lie under the trees");
  EXPECT_EQ(MendedBy(MendCompounds, "it rains cats and dogs"), "it rains");
  EXPECT_EQ(MendedBy(MendCompounds, "a rooster crows"), "a dawn");
  EXPECT_EQ(MendedBy(MendCompounds, "the goose is in the oven"), "the");
  ExpectKept(MendCompounds, {"cats and dogs play in the rain", "crows fly over the fields",
                             "the dogs are friendly", "a wolf howls at the moon",
                             "a goose by the lake", "horses under chestnuts"});
}

TEST(MendCompoundsTest, PeopleFlyKitesAndDrones) {
  EXPECT_EQ(MendedBy(MendCompounds, "a girl flies her red kite"), "a girl");
  EXPECT_EQ(MendedBy(MendCompounds, "two men are flying a drone over the lake"),
            "two men . a drone flying over the lake");
  ExpectKept(MendCompounds, {"three kites fly over the lake", "two drones fly over the lake"});
}

TEST(MendFieldsTest, FieldsAreReadAsWords) {
  EXPECT_EQ(MendedBy(MendFields, "season = fall"), "season = autumn");
  EXPECT_EQ(MendedBy(MendFields, "hour: 1800"), "hour : 1800 hours");
  EXPECT_EQ(MendedBy(MendFields, "goblins x 12, activity: attack, zone: village"),
            "goblins x 12 , attacking , location : village");
  ExpectKept(MendFields, {"leaves fall in this season", "time : noon", "state : good",
                          "area : 200 m", "the state of the road is bad"});
}

TEST(MendSpeakersTest, WhatSomebodyWorksOnIsNotAskedFor) {
  const auto mended = [](std::string_view text) {
    std::vector<Token> tokens = Tokenize(text);
    MendSpeakers(&tokens);
    return JoinWords(tokens, 0, tokens.size());
  };
  EXPECT_EQ(mended("I am a student in robotics. Ten rovers."), ". ten rovers .");
  EXPECT_EQ(mended("We are two engineers, ten drones please"), "ten drones please");
  EXPECT_EQ(mended("I'm an artist with three horses"), "with three horses");
  EXPECT_EQ(mended("I am writing a novel about goblins and need sheep"),
            "i am writing a novel and need sheep");
  for (const char* kept : {"i want a teacher and five students", "a student walks",
                           "i am at the lake with two dogs", "i am watching three horses"})
    EXPECT_EQ(mended(kept), kept);
}

}  // namespace
}  // namespace latticeworld
