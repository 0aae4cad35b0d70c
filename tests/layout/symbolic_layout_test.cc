#include "latticeworld/layout/symbolic_layout.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "latticeworld/common/random.h"
#include "layout/layouts.h"

namespace latticeworld {
namespace {

TEST(LayoutCodecTest, ReadsBackWhatItWrites) {
  for (const auto& vocabulary : EnumNames(Vocabulary{})) {
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
      const SymbolicLayout layout = Random(vocabulary.value, seed);
      const Result<SymbolicLayout> read = ParseLayout(ToText(layout), vocabulary.value);
      ASSERT_TRUE(read.ok()) << read.status().ToString();
      ASSERT_EQ(read->cells, layout.cells);
    }
  }
}

TEST(LayoutCodecTest, RowOneIsTheUpperEdge) {
  SymbolicLayout layout = Uniform(Vocabulary::kSuburb, 'G');
  layout.cells(0, 31) = 'W';
  EXPECT_EQ(ToText(layout).find('W'), 31u);
}

TEST(LayoutCodecTest, CarriageReturnsAndAMissingLastNewlineAreRead) {
  std::string text;
  for (int row = 0; row < 32; ++row) text += std::string(32, 'F') + (row < 31 ? "\r\n" : "");
  EXPECT_TRUE(ParseLayout(text, Vocabulary::kWild).ok());
}

TEST(LayoutCodecTest, EveryViolationIsReportedAtOnceWithItsPlace) {
  std::string text = ToText(Uniform(Vocabulary::kSuburb, 'G'));
  text[2 * 33 + 6] = 'S';               // row 3, column 7: a letter of the other vocabulary
  text.erase(4 * 33, 2);                // row 5 is short
  text += std::string(32, 'G') + "\n";  // 33 lines
  const Status status = ParseLayout(text, Vocabulary::kSuburb).status();
  ASSERT_EQ(status.violations().size(), 3u) << status.ToString();
  const auto find = [&](const std::string& code) {
    return *std::find_if(status.violations().begin(), status.violations().end(),
                         [&](const Violation& violation) { return violation.code == code; });
  };
  EXPECT_EQ(find("wrong_line_count").given, "33");
  EXPECT_EQ(find("foreign_letter").pointer, "row 3, column 7");
  EXPECT_NE(find("foreign_letter").message.find("A, B, D, F, G, R, W"), std::string::npos);
  EXPECT_EQ(find("wrong_line_length").pointer, "row 5");
}

TEST(LayoutCodecTest, HostileTextEndsInABoundedAnswer) {
  EXPECT_FALSE(ParseLayout("", Vocabulary::kWild).ok());
  EXPECT_FALSE(ParseLayout(std::string(1 << 20, '\n'), Vocabulary::kWild).ok());
  EXPECT_FALSE(ParseLayout(std::string(1 << 20, '\xff'), Vocabulary::kWild).ok());
  EXPECT_LT(ParseLayout(std::string(1 << 20, 'x'), Vocabulary::kWild).status().message().size(),
            100000u);
}

TEST(LayoutCodecTest, ColoredTextHoldsTheSameLetters) {
  const SymbolicLayout layout = Random(Vocabulary::kWild, 3);
  const std::string colored = ToColoredText(layout);
  std::string letters;
  for (std::size_t i = 0; i < colored.size(); ++i) {
    if (colored[i] == '\033') {
      i = colored.find('m', i);
    } else if (colored[i] != '\n') {
      letters += colored[i];
    }
  }
  ASSERT_EQ(letters.size(), 2u * 32 * 32);
  for (std::size_t i = 0; i < 32 * 32; ++i) ASSERT_EQ(letters[2 * i], *(layout.cells.data() + i));
}

TEST(LayoutCodecTest, DamagedTextIsRefusedOrReadBackAsItStands) {
  RandomStream random(1, "damage");
  for (int i = 0; i < 2000; ++i) {
    std::string text = ToText(Random(Vocabulary::kSuburb, static_cast<std::uint64_t>(i)));
    for (int k = random.UniformInt(1, 3); k > 0; --k) {
      const int at = random.UniformInt(0, static_cast<int>(text.size()) - 1);
      switch (random.UniformInt(0, 3)) {
        case 0:
          text[at] = static_cast<char>(random.UniformInt(0, 255));
          break;
        case 1:
          text[at] = 'W';
          break;
        case 2:
          text.erase(at, random.UniformInt(1, 40));
          break;
        default:
          text.insert(at, text.substr(0, random.UniformInt(1, 40)));
      }
      if (text.empty()) text = "\n";
    }
    const Result<SymbolicLayout> read = ParseLayout(text, Vocabulary::kSuburb);
    if (read.ok()) {
      std::string written = ToText(*read);
      text.erase(std::remove(text.begin(), text.end(), '\r'), text.end());
      if (text.back() != '\n') written.pop_back();
      ASSERT_EQ(written, text) << i;
    } else {
      ASSERT_FALSE(read.status().violations().empty()) << i;
    }
  }
}

}  // namespace
}  // namespace latticeworld
