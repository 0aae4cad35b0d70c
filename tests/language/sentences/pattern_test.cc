#include "latticeworld/language/sentences/pattern.h"

#include <gtest/gtest.h>

#include <string>

namespace latticeworld {
namespace {

TEST(PatternTest, HasTheStructureThatIsWritten) {
  const auto pattern = ParsePattern("the {x} is|are ({size} / {shape})* [in {zone}]");
  ASSERT_TRUE(pattern.ok()) << pattern.status().ToString();
  ASSERT_EQ(pattern->parts.size(), 5u);
  EXPECT_EQ(pattern->parts[0].words, std::vector<std::string>{"the"});
  EXPECT_EQ(pattern->parts[1].kind, Pattern::Kind::kSlot);
  EXPECT_EQ(pattern->parts[1].name, "x");
  EXPECT_EQ(pattern->parts[2].words, (std::vector<std::string>{"is", "are"}));
  EXPECT_EQ(pattern->parts[3].kind, Pattern::Kind::kRepeat);
  EXPECT_EQ(pattern->parts[3].parts[0].kind, Pattern::Kind::kChoice);
  EXPECT_EQ(pattern->parts[4].kind, Pattern::Kind::kOptional);
}

TEST(PatternTest, ColonsAndCommasAreWordsOfTheirOwn) {
  const auto pattern = ParsePattern("season: {season} , m/s");
  ASSERT_TRUE(pattern.ok());
  ASSERT_EQ(pattern->parts.size(), 5u);
  EXPECT_EQ(pattern->parts[1].words, std::vector<std::string>{":"});
  EXPECT_EQ(pattern->parts[4].words, std::vector<std::string>{"m/s"});
}

TEST(PatternTest, ErrorsQuoteThePatternAndNameWhatIsWrong) {
  for (const std::string text : {"a [b", "a b]", "(a", "a / ", "[]", "{}", "a {x"}) {
    const auto pattern = ParsePattern(text);
    ASSERT_FALSE(pattern.ok()) << text;
    EXPECT_EQ(pattern.status().code(), StatusCode::kInvalidArgument);
    EXPECT_NE(pattern.status().message().find(text), std::string::npos)
        << pattern.status().message();
  }
}

}  // namespace
}  // namespace latticeworld
