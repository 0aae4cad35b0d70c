#include "latticeworld/generation/fidelity/crossing_words.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>

#include "latticeworld/generation/world_generator.h"

namespace latticeworld {
namespace {

TEST(CrossingWordsTest, TheWordAsksForFordsAndADenialDoesNot) {
  EXPECT_TRUE(AsksForFords("A road fords the river."));
  EXPECT_TRUE(AsksForFords("A river with a ford, and a road over it."));
  EXPECT_TRUE(AsksForFords("The river is FORDED by a road"));
  EXPECT_FALSE(AsksForFords("A road crosses the river."));
  EXPECT_FALSE(AsksForFords("A road leads over the river without a ford."));
  EXPECT_FALSE(AsksForFords("There are no fords over the river."));
  EXPECT_FALSE(AsksForFords("A road through Oxford and a ride in the Fordham woods."));
  EXPECT_FALSE(AsksForFords(""));
}

TEST(CrossingWordsTest, TheWordAsksForBridgesAndADenialDoesNot) {
  EXPECT_TRUE(AsksForBridges("A stone bridge crosses the river."));
  EXPECT_TRUE(AsksForBridges("Two roads with BRIDGES over the lake"));
  EXPECT_FALSE(AsksForBridges("A road crosses the river without a bridge."));
  EXPECT_FALSE(AsksForBridges("There are no bridges, and Cambridge is far."));
}

TEST(CrossingWordsTest, ShallowRiversAreFordedUnlessTheWordsAskForABridge) {
  constexpr double kSmall_m = 100.0, kLarge_m = 512.0;
  EXPECT_TRUE(FordsRivers("A road crosses the river.", kSmall_m));
  EXPECT_FALSE(FordsRivers("A road crosses the river on a bridge.", kSmall_m));
  EXPECT_FALSE(FordsRivers("A road crosses the river.", kLarge_m));
  EXPECT_TRUE(FordsRivers("A road fords the river.", kLarge_m));
}

std::shared_ptr<const World> WorldOf(const std::string& layout, double size_m) {
  GenerationRequest request;
  request.layout_instruction = layout;
  request.environment_instruction = "A sunny summer noon.";
  request.seed = 3;
  request.size_m = size_m;
  return MakeDefaultWorldGenerator().Generate(request, Progress()).value();
}

bool Warns(const World& world, const std::string& of) {
  return std::any_of(world.warnings.begin(), world.warnings.end(), [&](const std::string& warning) {
    return warning.find(of) != std::string::npos;
  });
}

TEST(CrossingWordsTest, TheWordBeforeABridgeIsItsKind) {
  EXPECT_EQ(BridgeKindAskedFor("A stone bridge crosses the river."), BridgeKind::kStoneArch);
  EXPECT_EQ(BridgeKindAskedFor("Wooden bridges over the stream"), BridgeKind::kPlank);
  EXPECT_EQ(BridgeKindAskedFor("a bridge of the old kind, then a STEEL bridge"),
            BridgeKind::kGirder);
  EXPECT_EQ(BridgeKindAskedFor("A stone wall beside a bridge."), std::nullopt);
  EXPECT_EQ(BridgeKindAskedFor("A road crosses the river."), std::nullopt);
}

TEST(CrossingWordsTest, BridgesAreOfTheKindThatIsAskedForWhateverTheirWidthAndSetting) {
  for (const auto& entry : EnumNames(BridgeKind{})) {
    const auto world = WorldOf(
        "A river winds from the north to the south. A road runs from the "
        "west to the east over a " +
            std::string(entry.name) + ".",
        256.0);
    ASSERT_FALSE(world->scene->terrain->bridges.empty()) << entry.name;
    for (const Bridge& bridge : world->scene->terrain->bridges) {
      EXPECT_EQ(bridge.kind, entry.value) << entry.name;
      EXPECT_GT(bridge.supports_m.size(), 1u) << entry.name;
    }
  }
}

TEST(CrossingWordsTest, ABridgeWhereNoWaterIsIsToldToBeMissing) {
  const auto world = WorldOf("A bridge in the center. Grassland everywhere. A road.", 64.0);
  EXPECT_TRUE(world->scene->terrain->bridges.empty());
  EXPECT_TRUE(Warns(*world, "a bridge is asked for, and there is none"));
  EXPECT_FALSE(Warns(*world, "a ford is asked for"));
}

TEST(CrossingWordsTest, ABridgeThatIsAskedForIsBuiltOverAShallowStreamToo) {
  const std::string ways =
      "A river runs from the north to the south. A road from the west to the "
      "east";
  const auto plain = WorldOf(ways + ".", 96.0);
  EXPECT_TRUE(plain->scene->terrain->bridges.empty()) << "a ford";
  const auto bridged = WorldOf(ways + " with a bridge over the river.", 96.0);
  EXPECT_FALSE(bridged->scene->terrain->bridges.empty());
  EXPECT_FALSE(Warns(*bridged, "is asked for"));
}

TEST(CrossingWordsTest, AFordWhereNoRiverIsIsToldToBeMissing) {
  EXPECT_TRUE(Warns(*WorldOf("A road with a ford from the west to the east.", 64.0),
                    "a ford is asked for, and there is none"));
}

}  // namespace
}  // namespace latticeworld
