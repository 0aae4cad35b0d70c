#include "latticeworld/language/remote/thinking_filter.h"

#include <gtest/gtest.h>

namespace latticeworld {
namespace {

TEST(ThinkingFilterTest, TakesThinkingOutAndLeavesTheRest) {
  const std::pair<std::string_view, std::string_view> cases[] = {
      {"", ""},
      {"plain", "plain"},
      {"<think>hm</think>ABC", "ABC"},
      {"A<think>hm</think>B<think></think>C", "ABC"},
      {"<thinking>hm</thinking>A", "A"},
      {"<reasoning>x < y</reasoning>A", "A"},
      {"<thought>\n<b>x</b>\n</thought>\nA", "\nA"},
      {"A<think>never closed", "A"},
      {"no opening mark</think>ABC", "ABC"},
      {"<think>a</think>b</think>c", "c"},
      {"x < y <b>bold</b> << <", "x < y <b>bold</b> << <"},
      {"<thin", "<thin"},
      {"<<think>hm</think>>", "<>"},
      {"a<think>b</th", "a"},
      {"<think>a <think> b</think>c", "c"},
  };
  for (const auto& [given, wanted] : cases) EXPECT_EQ(WithoutThinking(given), wanted) << given;
}

TEST(ThinkingFilterTest, HoldsBackOnlyWhatMayBeAMark) {
  ThinkingFilter filter;
  std::string passed;
  filter.Push('a', &passed);
  EXPECT_EQ(passed, "a");
  filter.Push('<', &passed);
  EXPECT_EQ(passed, "");
  filter.Push('t', &passed);
  EXPECT_EQ(passed, "");
  filter.Push('o', &passed);
  EXPECT_EQ(passed, "<to");
}

}  // namespace
}  // namespace latticeworld
