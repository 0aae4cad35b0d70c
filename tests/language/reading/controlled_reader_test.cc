#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "latticeworld/language/drawn/drawn.h"
#include "latticeworld/language/reading/instruction_reader.h"

namespace latticeworld {
namespace {

TEST(ControlledReaderTest, TheTextIsTheSentences) {
  std::vector<ModelReply> replies;
  LayoutRequest request;
  request.instruction = "A lake in the north. Forest surrounds the lake.";
  const auto reading = MakeControlledReader()->ReadLayout(request, Progress(), &replies);
  ASSERT_TRUE(reading.ok());
  EXPECT_EQ(reading->sentences,
            (std::vector<std::string>{"A lake in the north", "Forest surrounds the lake"}));
  EXPECT_EQ(reading->plan.features.size(), 2u);
  EXPECT_TRUE(replies.empty());
}

TEST(ControlledReaderTest, AGivenReadingIsDrawnAndNotReadAgain) {
  std::vector<ModelReply> replies;
  LayoutRequest request;
  request.instruction = "Water fills the northern half.";
  LayoutRequest other = request;
  other.instruction = "Forest fills the northern half.";
  const auto reading = MakeControlledReader()->ReadLayout(other, Progress(), &replies);
  ASSERT_TRUE(reading.ok());
  request.reading = &*reading;
  const auto answer =
      MakeDrawnLayoutGenerator("controlled", MakeControlledReader())->Generate(request, Progress());
  ASSERT_TRUE(answer.ok());
  EXPECT_EQ(answer->layout.cells(2, 16), 'F');
}

TEST(ControlledReaderTest, EnvironmentsAreDrawn) {
  const SymbolicLayout layout =
      MakeDrawnLayoutGenerator("controlled", MakeControlledReader())
          ->Generate({"Mostly grassland. A lake in the center.", Vocabulary::kSuburb}, Progress())
          ->layout;
  EnvironmentRequest request;
  request.instruction = "Weather: fog. 7 sheep grazing by the lake.";
  request.layout = &layout;
  const auto answer = MakeDrawnEnvironmentGenerator("controlled", MakeControlledReader())
                          ->Generate(request, Progress());
  ASSERT_TRUE(answer.ok());
  EXPECT_EQ(answer->environment.coarse.weather, Weather::kFog);
  ASSERT_FALSE(answer->environment.agents.empty());
  EXPECT_EQ(answer->environment.agents[0].category, AgentCategory::kSheep);
}

}  // namespace
}  // namespace latticeworld
