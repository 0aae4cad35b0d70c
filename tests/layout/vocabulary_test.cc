#include "latticeworld/layout/vocabulary.h"

#include <gtest/gtest.h>

#include <string>

#include "latticeworld/layout/class_letters.h"

namespace latticeworld {
namespace {

std::string Letters(Vocabulary vocabulary) {
  std::string letters;
  for (const LayoutClass& entry : ClassesOf(vocabulary)) letters += entry.letter;
  return letters;
}

TEST(VocabularyTest, HasTheLettersOfTheMethod) {
  EXPECT_EQ(Letters(Vocabulary::kSuburb), "ABDFGRW");
  EXPECT_EQ(Letters(Vocabulary::kWild), "BFRSW");
}

TEST(VocabularyTest, HasTheColorsOfTheMethod) {
  EXPECT_EQ(FindClass(Vocabulary::kSuburb, 'A')->color, (Rgb{0xFF, 0xC2, 0x80}));
  EXPECT_EQ(FindClass(Vocabulary::kSuburb, 'D')->color, (Rgb{0x9D, 0x7F, 0xB7}));
  EXPECT_EQ(FindClass(Vocabulary::kWild, 'R')->color, (Rgb{0x80, 0x80, 0x80}));
  EXPECT_EQ(FindClass(Vocabulary::kWild, 'W')->color, (Rgb{0x00, 0x00, 0xFF}));
}

TEST(VocabularyTest, LegalLettersNamesThemAll) {
  for (const auto& vocabulary : EnumNames(Vocabulary{})) {
    std::string joined;
    for (const char letter : Letters(vocabulary.value)) {
      joined += (joined.empty() ? "" : ", ") + std::string(1, letter);
    }
    EXPECT_EQ(LegalLetters(vocabulary.value), joined);
  }
}

TEST(VocabularyTest, ALetterMeansNothingInTheOtherVocabulary) {
  EXPECT_EQ(FindClass(Vocabulary::kSuburb, 'S'), nullptr);
  EXPECT_EQ(FindClass(Vocabulary::kWild, 'A'), nullptr);
  EXPECT_EQ(FindClass(Vocabulary::kWild, 'b'), nullptr);
}

TEST(ClassLettersTest, OnlySuburbHasWhatPeopleMade) {
  const auto made = [](Vocabulary vocabulary) {
    std::string names;
    for (const LayoutClass& entry : ClassesOf(vocabulary)) {
      if (IsManMade(vocabulary, entry.letter)) names += std::string(entry.name) + ". ";
    }
    return names;
  };
  EXPECT_EQ(made(Vocabulary::kSuburb), "farmland. building. road. ");
  EXPECT_EQ(made(Vocabulary::kWild), "");
}

TEST(ClassLettersTest, RoadsAndBuildingsAreNoRocksAndGrass) {
  EXPECT_TRUE(IsRoad(Vocabulary::kSuburb, 'R'));
  EXPECT_FALSE(IsRoad(Vocabulary::kWild, 'R'));
  EXPECT_TRUE(IsBuilding(Vocabulary::kSuburb, 'B'));
  EXPECT_FALSE(IsBuilding(Vocabulary::kWild, 'B'));
}

}  // namespace
}  // namespace latticeworld
