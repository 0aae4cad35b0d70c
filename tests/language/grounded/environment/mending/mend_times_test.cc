#include "latticeworld/language/grounded/environment/mending/mend_times.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/language/grounded/environment/mending/mend_compounds.h"
#include "latticeworld/language/grounded/environment/mending/mend_fields.h"
#include "latticeworld/language/grounded/environment/mending/mend_speakers.h"

namespace latticeworld {
namespace {

std::string MendedBy(void (*mend)(const EnvironmentWords&, std::vector<Token>*),
                     std::string_view text) {
  std::vector<Token> tokens = Tokenize(text);
  mend(GetEnvironmentWords(), &tokens);
  return JoinWords(tokens, 0, tokens.size());
}

std::string Compounded(std::string_view text) {
  std::vector<Token> tokens = Tokenize(text);
  MendCompounds(GetEnvironmentWords(), text, &tokens);
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
                         "three horses were in the rain , now they graze",
                         "it was quiet at dawn . meanwhile two horses sleep",
                         "it was warm all day ; now they sleep",
                         "rain is likely tonight . now six drones patrol"});
}

TEST(MendTimesTest, OnlyWhatIsReplacedIsDropped) {
  EXPECT_EQ(MendedBy(MendTimes, "I had wanted snow, but fog is better"), "fog is better");
  EXPECT_EQ(MendedBy(MendTimes, "We were thinking of goblins, but knights instead"),
            "knights instead");
  ExpectKept(
      MendTimes,
      {"i was thinking of snow , but add horses", "i was thinking of fog , but also some goats",
       "we wanted a village , but the lake should not be frozen",
       "i was thinking of a foggy dawn , but nobody lives there",
       "i had planned six horses , but the horses should be asleep",
       "i was thinking of a meadow , but a dense one", "i thought of a world of nothing but snow",
       "i was thinking of a world where all but two horses sleep"});
}

TEST(MendTimesTest, TheSunTellsTheTime) {
  EXPECT_EQ(MendedBy(MendTimes, "the sun has already gone down"), "the dusk");
  EXPECT_EQ(MendedBy(MendTimes, "the sun is not yet up"), "the dawn");
  EXPECT_EQ(MendedBy(MendTimes, "the sun will set soon"), "the dusk");
  ExpectKept(MendTimes, {"the sun is out", "the sun is high", "the sun has not set"});
}

TEST(MendTimesTest, PlainWeatherIsNoPlain) {
  EXPECT_EQ(MendedBy(MendTimes, "a plain foggy morning"), "a foggy morning");
  EXPECT_EQ(MendedBy(MendTimes, "just plain rain"), "just rain");
  EXPECT_EQ(MendedBy(MendTimes, "some plain old fog"), "some fog");
  ExpectKept(MendTimes, {"a plain with sun", "an open plain under a cloudy sky", "a plain at dawn",
                         "a great plain at night with two wolves", "a plain clear of rocks",
                         "on a plain snow falls", "on the wide plain mist drifts",
                         "flat plain clear sky", "a wide plain cloudy and cold"});
}

TEST(MendCompoundsTest, APartOfAWordIsNoAgent) {
  EXPECT_EQ(Compounded("ten hawk-eyed archers"), "ten archers");
  EXPECT_EQ(Compounded("eagle-eyed guards wait"), "some guards wait");
  EXPECT_EQ(Compounded("a kid-friendly look"), "a look");
  EXPECT_EQ(Compounded("horse chestnuts lie under the trees"), "chestnuts lie under the trees");
  EXPECT_EQ(Compounded("it rains cats and dogs"), "it rains");
  EXPECT_EQ(Compounded("a rooster crows"), "a dawn");
  EXPECT_EQ(Compounded("the goose is in the oven"), "the");
  EXPECT_EQ(Compounded("the park is dog friendly"), "the park is");
  for (const char* kept :
       {"cats and dogs play in the rain", "crows fly over the fields", "the dogs are friendly",
        "a wolf howls at the moon", "a goose by the lake", "horses under chestnuts",
        "a fox headed into the village", "an eagle headed south", "a wolf faced six knights",
        "the horse flies over the lake", "a dog rose and barked", "a dog friendly and calm",
        "in the rain cats and dogs hide"})
    EXPECT_EQ(Compounded(kept), kept);
}

TEST(MendCompoundsTest, PeopleFlyKitesAndDrones) {
  EXPECT_EQ(Compounded("a girl flies her red kite"), "a girl");
  EXPECT_EQ(Compounded("two men are flying a drone over the lake"),
            "two men . a drone flying over the lake");
  for (const char* kept : {"three kites fly over the lake", "two drones fly over the lake",
                           "over the village fly kites", "above the fields flies a red kite"})
    EXPECT_EQ(Compounded(kept), kept);
}

TEST(MendFieldsTest, FieldsAreReadAsWords) {
  EXPECT_EQ(MendedBy(MendFields, "season = fall"), "season = autumn");
  EXPECT_EQ(MendedBy(MendFields, "hour: 1800"), "hour : 1800 hours");
  EXPECT_EQ(MendedBy(MendFields, "goblins x 12, activity: attack, zone: village"),
            "goblins x 12 , attacking , location : village");
  ExpectKept(MendFields,
             {"leaves fall in this season", "time : noon", "state : good",
              "time : 1850 , a medieval village", "area : 200 m", "the state of the road is bad"});
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
