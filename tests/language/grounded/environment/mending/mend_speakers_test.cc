#include "latticeworld/language/grounded/environment/mending/mend_speakers.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/language/drawn/grounded.h"

namespace latticeworld {
namespace {

std::string Mended(std::string_view text) {
  std::vector<Token> tokens = Tokenize(text);
  MendSpeakers(&tokens);
  return JoinWords(tokens, 0, tokens.size());
}

TEST(MendSpeakersTest, WhoAsksIsNoAgent) {
  EXPECT_EQ(Mended("I'm a park ranger and I want six horses."), "i want six horses .");
  EXPECT_EQ(Mended("I am a teacher, so we need sheep"), "we need sheep");
  EXPECT_EQ(Mended("As a farmer I would like rain"), "i would like rain");
  for (const char* kept : {"i saw a warrior and two goblins", "as a storm rolls in , goblins flee",
                           "i want a warrior and i want a goblin"})
    EXPECT_EQ(Mended(kept), kept);
}

TEST(MendSpeakersTest, AMonthIsNoMarching) {
  EXPECT_EQ(Mended("the lambs came early , it is only March"),
            "the lambs came early , it is only spring");
  EXPECT_EQ(Mended("five warriors march south"), "five warriors march south");
}

TEST(MendSpeakersTest, AnApostropheMayBeLeftOut) {
  EXPECT_EQ(Mended("its May, nine in the morning"), "it is may , nine in the morning");
  EXPECT_EQ(Mended("its not night yet"), "it is not night yet");
  EXPECT_EQ(Mended("the lake and its water"), "the lake and its water");
  EXPECT_EQ(Mended("its winter coat"), "its winter coat");
}

// What people who do not know the reader have written, in the words that it did not know.
TEST(MendSpeakersTest, WordsOfOtherPeopleAreRead) {
  const auto says = [](const char* text, const char* value) {
    const EnvironmentClaims reading = ReadEnvironmentInstruction(text);
    for (const EnvironmentClaim& claim : reading.claims)
      for (const std::string& legal : claim.values)
        if (claim.kind == EnvironmentClaimKind::kCoarse && legal == value) return true;
    return false;
  };
  EXPECT_TRUE(says("Sand blowing so hard you can barely see.", "sandstorm"));
  EXPECT_TRUE(says("Drizzle, light fading.", "dusk"));
  EXPECT_TRUE(says("The sun just came up.", "dawn"));
  EXPECT_TRUE(says("Make it look like an oil painting.", "cartoon"));
}

}  // namespace
}  // namespace latticeworld
