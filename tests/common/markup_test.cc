#include "latticeworld/common/markup.h"

#include <gtest/gtest.h>

namespace latticeworld {
namespace {

TEST(EscapeMarkupTest, NothingOfATextIsTakenForMarkup) {
  EXPECT_EQ(EscapeMarkup("a < b && \"c\" > d"), "a &lt; b &amp;&amp; &quot;c&quot; &gt; d");
  EXPECT_EQ(EscapeMarkup("&lt;"), "&amp;lt;");
}

TEST(EscapeMarkupTest, LettersOfEveryLanguageAndLineEndsStay) {
  EXPECT_EQ(EscapeMarkup("G\xC3\xB6ttingen\n\tn\xC2\xB0 7"), "G\xC3\xB6ttingen\n\tn\xC2\xB0 7");
  EXPECT_EQ(EscapeMarkup(""), "");
}

TEST(EscapeMarkupTest, ControlCharactersAreShownAsQuestions) {
  EXPECT_EQ(EscapeMarkup(std::string_view("a\0b\x1B[0m", 7)), "a?b?[0m");
}

}  // namespace
}  // namespace latticeworld
