#include "latticeworld_ros/node/descriptors.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <fstream>

namespace latticeworld {
namespace {

TEST(DescriptorsTest, TheSoftLimitIsRaisedToTheHardOneAndNeverLowered) {
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_NOFILE, &before), 0);
  rlimit low = before;
  low.rlim_cur = 256;
  ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &low), 0);
  const std::size_t wanted = std::min<rlim_t>(before.rlim_max, kMostDescriptors);
  EXPECT_EQ(RaiseDescriptorLimit(), wanted);
  EXPECT_EQ(CountDescriptors().limit, wanted);
  if (before.rlim_max > kMostDescriptors) {
    low.rlim_cur = kMostDescriptors + 1;
    ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &low), 0);
    EXPECT_EQ(RaiseDescriptorLimit(), kMostDescriptors + 1);
  }
  ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &before), 0);
}

TEST(DescriptorsTest, AnOpenFileCounts) {
  const std::size_t before = CountDescriptors().open;
  EXPECT_GT(before, 2u);
  const std::ifstream file("/dev/null");
  EXPECT_EQ(CountDescriptors().open, before + 1);
}

TEST(DescriptorsTest, TheyAreShortBeforeTheLastOneIsTaken) {
  EXPECT_FALSE((DescriptorUse{800, 1024}.is_short()));
  EXPECT_TRUE((DescriptorUse{1000, 1024}.is_short()));
  EXPECT_TRUE((DescriptorUse{1024, 1024}.is_short()));
  EXPECT_FALSE((DescriptorUse{1000, 0}.is_short())) << "of an unknown limit";
}

}  // namespace
}  // namespace latticeworld
