#include "latticeworld/exporting/chosen_assets.h"

#include <gtest/gtest.h>

#include <set>

#include "latticeworld/scene/scene.h"

namespace latticeworld {
namespace {

TEST(ChosenAssetsTest, WhoHasTooManyThingsIsToldWhatHelpsAndNothingElse) {
  const Status with = TooMany(9, "things", 5, /*small_plants=*/true);
  const Status without = TooMany(9, "things", 5, /*small_plants=*/false);
  for (const Status& status : {with, without}) {
    for (const char* word : {"9 things", "legal are 5", "region"})
      EXPECT_NE(status.ToString().find(word), std::string::npos) << status.ToString();
  }
  EXPECT_NE(with.ToString().find("no small plants"), std::string::npos);
  EXPECT_EQ(without.ToString().find("plants"), std::string::npos);
}

TEST(PartNamesTest, SingleThingsKeepTheirNamesAndTheRestHaveNumbers) {
  Scene scene;
  scene.assets.resize(4);
  scene.things = {{"old_well", "well", 0, 2, {0.0, 0.0}, 0.0},
                  {"ground", "bench", 1, 1, {0.0, 0.0}, 0.0},
                  {"box", "crate", 2, -1, {0.0, 0.0}, 0.0}};
  const PartNames names(scene);
  EXPECT_EQ(names.Of(2), "old_well");
  EXPECT_EQ(names.Of(1), "asset_1");  // files have a ground already
  EXPECT_EQ(names.Of(0), "asset_0");
}

TEST(PartNamesTest, NoTwoPartsHaveOneNameWhateverThingsAreCalled) {
  Scene scene;
  scene.assets.resize(4);
  for (const char* name :
       {"ground", "element_ground", "asset_1", "road_bridge_1", "world", "box"}) {
    Prop prop;
    prop.name = name;
    scene.props.push_back(prop);
  }
  scene.things = {{"box", "well", 0, 0, {0.0, 0.0}, 0.0},
                  {"well", "well", 0, 2, {0.0, 0.0}, 0.0},
                  {"well_solid", "well", 0, 3, {0.0, 0.0}, 0.0}};
  const PartNames names(scene);
  std::set<std::string> used = {"ground", "water", "road_bridge_1", "world"};
  for (const Prop& prop : scene.props) EXPECT_TRUE(used.insert(names.Of(prop)).second) << prop.name;
  for (std::uint32_t asset = 0; asset < scene.assets.size(); ++asset) {
    EXPECT_TRUE(used.insert(names.Of(asset)).second) << asset;
    EXPECT_TRUE(used.insert(names.Of(asset) + "_solid").second) << asset;
  }
  EXPECT_EQ(names.Of(scene.props.back()), "box");
  EXPECT_TRUE(used.insert(names.Unlike("box")).second);
  EXPECT_EQ(names.Unlike("oak"), "oak");
}

}  // namespace
}  // namespace latticeworld
