#include "latticeworld/language/reading/things/laid_as_houses.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "latticeworld/language/reading/instruction_reader.h"

namespace latticeworld {
namespace {

// All that the reading warns of, joined.
std::string WarningsOf(const std::string& text) {
  LayoutRequest request;
  request.instruction = text;
  request.vocabulary = Vocabulary::kSuburb;
  std::vector<ModelReply> replies;
  const LayoutReading reading = MakeRuleReader()->ReadLayout(request, Progress(), &replies).value();
  std::string all;
  for (const std::string& warning : reading.plan.warnings) all += warning + "\n";
  return all;
}

TEST(LaidAsHousesTest, ABuildingOfAnUnknownKindIsToldWithTheNearest) {
  const std::string warnings = WarningsOf("A lighthouse in the north.");
  EXPECT_NE(warnings.find("a lighthouse is laid as houses, for there is no such kind of thing; the "
                          "nearest is a tower; \"a lone tower\""),
            std::string::npos)
      << warnings;
  EXPECT_NE(WarningsOf("A mosque beside the lake.").find("the nearest is a church"),
            std::string::npos);
}

TEST(LaidAsHousesTest, AKindThatStandsAloneOnlyWhenItIsSaidSoIsTold) {
  EXPECT_NE(WarningsOf("A barn in the south.").find("\"a lone barn\" stands there as one thing"),
            std::string::npos);
  EXPECT_EQ(WarningsOf("A lone barn in the south."), "");
}

TEST(LaidAsHousesTest, HousesAndPlacesAreWhatTheyAre) {
  for (const char* text : {"A village in the north.", "Three houses beside the lake.",
                           "A house in the center.", "Barns in the west.", "A forest."}) {
    EXPECT_EQ(WarningsOf(text), "") << text;
  }
}

TEST(LaidAsHousesTest, AHouseInALakeIsToldToGetAnIsland) {
  EXPECT_NE(WarningsOf("A barn in the lake.").find("no house stands in water; an island is laid"),
            std::string::npos)
      << WarningsOf("A barn in the lake.");
  EXPECT_EQ(WarningsOf("A village by the lake."), "");
}

}  // namespace
}  // namespace latticeworld
