#include "latticeworld/dataset/sources/given_instructions.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>

#include "dataset/scratch_dataset.h"
#include "latticeworld/layout/claims/claims.h"

namespace latticeworld {
namespace {

std::vector<GivenInstruction> Lakes() {
  return {{"north", Vocabulary::kSuburb, "A lake in the north."},
          {"south", Vocabulary::kWild, "A lake in the south, and forest everywhere else."},
          {"east", Vocabulary::kSuburb, "Houses in the east, no water."}};
}

TEST(GivenInstructionsTest, EveryAnswerHasWhatWasAskedFor) {
  GivenInstructionsOptions options;
  options.answers = 5;
  const auto source = MakeGivenSource(Lakes(), "Lakes", options).value();
  const auto annotator = MakeGivenAnnotator(Lakes(), 512.0);
  ASSERT_EQ(source->group_count(), 3u);
  for (std::size_t group = 0; group < 3; ++group) {
    EXPECT_EQ(source->GroupName(group), Lakes()[group].id);
    const std::vector<Instance> instances = source->ReadGroup(group).value();
    EXPECT_EQ(instances.size(), 5u);
    std::set<std::string> layouts, ids;
    for (const Instance& instance : instances) {
      EXPECT_EQ(instance.group, Lakes()[group].id);
      ids.insert(instance.id);
      layouts.insert(ToText(instance.layout));
      const LayoutCaption caption = annotator->DescribeLayout(instance, 1, Progress()).value();
      EXPECT_EQ(caption.text, Lakes()[group].words);
      EXPECT_FALSE(caption.claims.empty());
      for (const Claim& claim : caption.claims)
        EXPECT_TRUE(Measure(claim, instance.layout).holds) << instance.id;
    }
    EXPECT_EQ(ids.size(), 5u);
    EXPECT_GE(layouts.size(), 4u) << "answers differ";
  }
}

TEST(GivenInstructionsTest, EveryNthIsLeftOut) {
  GivenInstructionsOptions options;
  options.leave_out = 2;
  const auto source = MakeGivenSource(Lakes(), "Lakes", options).value();
  ASSERT_EQ(source->group_count(), 1u);
  EXPECT_EQ(source->GroupName(0), "south");
  options.leave_out = 1;
  EXPECT_EQ(MakeGivenSource(Lakes(), "Lakes", options).status().code(),
            StatusCode::kInvalidArgument);
}

TEST(GivenInstructionsTest, WhatSaysNothingIsToldAsAFailureOfItsGroup) {
  const auto source = MakeGivenSource({{"a", Vocabulary::kSuburb, "Hm."}}, "Nothing", {}).value();
  EXPECT_EQ(source->ReadGroup(0).status().code(), StatusCode::kDataLoss);
}

TEST(GivenInstructionsTest, WhatCannotBeHadIsNoAnswer) {
  const auto source =
      MakeGivenSource(
          {{"a", Vocabulary::kSuburb, "The north half is a lake. The north half is forest."}},
          "Both", {})
          .value();
  EXPECT_EQ(source->ReadGroup(0).status().code(), StatusCode::kDataLoss);
}

class GivenFileTest : public ScratchDatasetTest {
 protected:
  Result<std::vector<GivenInstruction>> Read(const std::string& text) {
    const std::filesystem::path file = folder_ / "asked.json";
    std::ofstream(file) << text;
    return ReadGivenInstructions(file);
  }
};

TEST_F(GivenFileTest, IsReadAsABenchmarkIs) {
  const auto read = Read(
      R"([{"id": "a", "vocabulary": "wild", "voice": "terse", "instruction": "Snow.", "claims": []}])");
  ASSERT_TRUE(read.ok()) << read.status().ToString();
  ASSERT_EQ(read->size(), 1u);
  EXPECT_EQ((*read)[0].words, "Snow.");
  EXPECT_EQ((*read)[0].vocabulary, Vocabulary::kWild);
}

TEST_F(GivenFileTest, EveryBadEntryIsNamed) {
  const auto read = Read(
      R"([{"id": "a", "vocabulary": "sea", "instruction": "Snow."}, {"id": "../b", "vocabulary": "wild"},)"
      R"( {"id": "a", "vocabulary": "wild", "instruction": "Snow."}, 7])");
  ASSERT_FALSE(read.ok());
  EXPECT_EQ(read.status().code(), StatusCode::kInvalidArgument);
  EXPECT_EQ(read.status().violations().size(), 7u) << read.status().ToString();
  for (const char* bad : {"", "{}", "[", "[]", "\xff"}) EXPECT_FALSE(Read(bad).ok()) << bad;
  EXPECT_EQ(ReadGivenInstructions(folder_ / "none.json").status().code(), StatusCode::kNotFound);
}

}  // namespace
}  // namespace latticeworld
