#include "latticeworld/language/numbers.h"

#include <gtest/gtest.h>

#include <string>

#include "latticeworld/language/tokens.h"

namespace latticeworld {
namespace {

TEST(NumbersTest, ReadWordsAndDigits) {
  const auto value = [](std::string_view text) { return MatchNumber(Tokenize(text), 0).value; };
  EXPECT_EQ(value("9 sheep"), 9);
  EXPECT_EQ(value("forty-two"), 42);
  EXPECT_EQ(value("ninety nine"), 99);
  EXPECT_EQ(value("a pair of horses"), 2);
  EXPECT_EQ(value("half a dozen eggs"), 6);
  EXPECT_EQ(value("two dozen"), 24);
  EXPECT_EQ(value("two hundred and five"), 205);
  EXPECT_EQ(value("99999999999999999999"), 1000000);
  EXPECT_EQ(MatchNumber(Tokenize("a lake"), 0).tokens, 0u);
}

}  // namespace
}  // namespace latticeworld
