#include "latticeworld/interchange/chosen_assets.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace latticeworld
