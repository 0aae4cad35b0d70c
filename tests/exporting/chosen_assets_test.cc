#include "latticeworld/exporting/chosen_assets.h"

#include <gtest/gtest.h>

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

TEST(AssetNamesTest, SingleThingsKeepTheirNamesAndTheRestHaveNumbers) {
  Scene scene;
  scene.assets.resize(4);
  scene.things = {{"old_well", "well", 0, 2, {0.0, 0.0}, 0.0},
                  {"ground", "bench", 1, 1, {0.0, 0.0}, 0.0},
                  {"box", "crate", 2, -1, {0.0, 0.0}, 0.0}};
  const AssetNames names(scene);
  EXPECT_EQ(names.Of(2), "old_well");
  EXPECT_EQ(names.Of(1), "asset_1");  // files have a ground already
  EXPECT_EQ(names.Of(0), "asset_0");
}

}  // namespace
}  // namespace latticeworld
