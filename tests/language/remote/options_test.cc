#include <gtest/gtest.h>

#include "latticeworld/language/remote/remote.h"

namespace latticeworld {
namespace {

TEST(RemoteOptionsTest, DefaultsAreLegal) { EXPECT_TRUE(Validate(RemoteOptions{}).empty()); }

TEST(RemoteOptionsTest, EveryOptionOutOfRangeIsNamedAtOnce) {
  const auto violations = Validate(RemoteOptions{9, -0.1, 63, 65537});
  ASSERT_EQ(violations.size(), 4u);
  EXPECT_EQ(violations[0].pointer, "repair_turns");
  EXPECT_EQ(violations[1].pointer, "temperature");
  EXPECT_EQ(violations[2].pointer, "layout_max_tokens");
  EXPECT_EQ(violations[3].pointer, "environment_max_tokens");
}

}  // namespace
}  // namespace latticeworld
