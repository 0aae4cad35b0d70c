#include "latticeworld/language/remote/prompt_template.h"

#include <gtest/gtest.h>

namespace latticeworld {
namespace {

TEST(PromptTemplateTest, PutsEachValueInThePlaceOfItsName) {
  const auto text = FillTemplate("{{a}} and {{b}}, {{a}} again {x}", {{"a", "one"}, {"b", "two"}});
  ASSERT_TRUE(text.ok()) << text.status().ToString();
  EXPECT_EQ(*text, "one and two, one again {x}");
}

TEST(PromptTemplateTest, DoesNotLookIntoValues) {
  const auto text = FillTemplate("[{{a}}][{{b}}]", {{"a", "{{b}} }} {{"}, {"b", "2"}});
  ASSERT_TRUE(text.ok()) << text.status().ToString();
  EXPECT_EQ(*text, "[{{b}} }} {{][2]");
}

TEST(PromptTemplateTest, RefusesEveryNameThatDoesNotFitAtOnce) {
  const auto text = FillTemplate("{{a}} {{c}} {{d", {{"a", "1"}, {"b", "2"}});
  ASSERT_FALSE(text.ok());
  EXPECT_EQ(text.status().code(), StatusCode::kInternal);
  ASSERT_EQ(text.status().violations().size(), 3u);
  EXPECT_EQ(text.status().violations()[0].code, "unknown_name");
  EXPECT_EQ(text.status().violations()[0].pointer, "c");
  EXPECT_EQ(text.status().violations()[1].code, "open_brace");
  EXPECT_EQ(text.status().violations()[2].code, "unused_value");
  EXPECT_EQ(text.status().violations()[2].pointer, "b");
}

}  // namespace
}  // namespace latticeworld
