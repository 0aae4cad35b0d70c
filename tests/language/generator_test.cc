#include "latticeworld/language/generator.h"

#include <gtest/gtest.h>

namespace latticeworld {
namespace {

TEST(ChooseVocabularyTest, FollowsTheWords) {
  EXPECT_EQ(ChooseVocabulary("houses along a road, fields around"), Vocabulary::kSuburb);
  EXPECT_EQ(ChooseVocabulary("Snow-capped peaks above rocky slopes"), Vocabulary::kWild);
  EXPECT_EQ(ChooseVocabulary("a lake and a forest"), Vocabulary::kSuburb);
  EXPECT_EQ(ChooseVocabulary(""), Vocabulary::kSuburb);
  EXPECT_EQ(ChooseVocabulary("Snowy mountains; a cabin by the lake"), Vocabulary::kWild);
  EXPECT_EQ(ChooseVocabulary("A village below a cliff; a house on the cliff"), Vocabulary::kSuburb);
  EXPECT_EQ(ChooseVocabulary("Houses below a cliff"), Vocabulary::kSuburb);
  EXPECT_EQ(ChooseVocabulary("A road over a stone bridge"), Vocabulary::kSuburb);
}

TEST(LayoutRequestTest, RefusesWhatNoBackEndCanUse) {
  LayoutRequest request;
  EXPECT_FALSE(Validate(request).ok());
  request.instruction = " \n\t ";
  EXPECT_FALSE(Validate(request).ok());
  request.instruction = "a lake \xFF";
  EXPECT_EQ(Validate(request).code(), StatusCode::kInvalidArgument);
  request.instruction = std::string(kMaxInstructionBytes + 1, 'a');
  EXPECT_FALSE(Validate(request).ok());
  request.instruction = std::string(kMaxInstructionBytes, 'a');
  EXPECT_TRUE(Validate(request).ok());
}

}  // namespace
}  // namespace latticeworld
