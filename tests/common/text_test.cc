#include "latticeworld/common/text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>

namespace latticeworld {
namespace {

TEST(TextTest, WellFormedUtf8Passes) {
  EXPECT_TRUE(ValidateText("text", "", 10).ok());
  EXPECT_TRUE(ValidateText("text", "a\u00e9\u4e2d\U0001F600", 10).ok());
  EXPECT_TRUE(ValidateText("text", "\U0010FFFF", 10).ok());
}

TEST(TextTest, MalformedUtf8IsRefusedWithItsPlace) {
  for (const std::string bad : {"\xff", "\xc0\xaf", "\xed\xa0\x80", "\xf4\x90\x80\x80", "\xe4\xb8",
                                "\x80", "\xf8\x88\x80\x80\x80"}) {
    const Status status = ValidateText("layout_instruction", "ab" + bad, 100);
    EXPECT_EQ(status.message(), "layout_instruction is not valid UTF-8 at byte 2") << Quote(bad);
  }
  EXPECT_FALSE(ValidateText("text", std::string("a\0b", 3), 100).ok());
}

TEST(TextTest, LengthIsBounded) {
  EXPECT_EQ(ValidateText("text", "123456", 5).message(),
            "text is 6 bytes long; at most 5 are legal");
}

TEST(TextTest, QuoteIsSafeToPrint) {
  EXPECT_EQ(Quote("plain"), "\"plain\"");
  EXPECT_EQ(Quote("a\nb\xff"), "\"a\\x0ab\\xff\"");
  EXPECT_EQ(Quote("\u00e9\u00e9\u00e9", 5), "\"\u00e9\u00e9...\"");
}

TEST(TextTest, DoublesReadBackExactly) {
  for (const double value : {0.1, 1.0 / 3.0, 1e300, -0.0, 5e-308}) {
    EXPECT_EQ(std::strtod(FormatDouble(value).c_str(), nullptr), value);
  }
  EXPECT_EQ(FormatDouble(0.5), "0.5");
  EXPECT_EQ(FormatDouble(std::nan("")), "nan");
  EXPECT_EQ(FormatDouble(-std::numeric_limits<double>::infinity()), "-inf");
}

TEST(TextTest, SplitAndJoinAreInverse) {
  EXPECT_EQ(Split("a,,b", ','), (std::vector<std::string>{"a", "", "b"}));
  EXPECT_EQ(Split("", ','), (std::vector<std::string>{""}));
  EXPECT_EQ(Join(Split("a,,b", ','), ","), "a,,b");
}

TEST(TextTest, StartsAndEndsAreFoundWhereTheyAreWhole) {
  EXPECT_TRUE(StartsWith("data: x", "data:"));
  EXPECT_FALSE(StartsWith("dat", "data:"));
  EXPECT_TRUE(EndsWith("houses", "es"));
  EXPECT_FALSE(EndsWith("s", "es"));
  EXPECT_TRUE(StartsWith("", "") && EndsWith("", ""));
}

}  // namespace
}  // namespace latticeworld
