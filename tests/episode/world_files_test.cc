#include "latticeworld/episode/world_files.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "generation/test_world.h"

namespace latticeworld {
namespace {

TEST(WorldFilesTest, AWorldComesBackFromItsFiles) {
  const auto world = MakeTestWorld();
  const auto files = PackWorld(*world);
  ASSERT_TRUE(files.ok()) << files.status().ToString();
  EXPECT_TRUE(std::is_sorted(files->begin(), files->end(),
                             [](const auto& a, const auto& b) { return a.path < b.path; }));
  EXPECT_TRUE(std::any_of(files->begin(), files->end(), [](const WorldFile& file) {
    return file.path.rfind("weights/", 0) == 0;
  }));
  const auto back = UnpackWorld(*files);
  ASSERT_TRUE(back.ok()) << back.status().ToString();
  ExpectSameWorld(*world, **back);
}

TEST(WorldFilesTest, ADamagedFileIsNamed) {
  auto files = *PackWorld(*MakeTestWorld());
  for (WorldFile& file : files) {
    if (file.path == "terrain.bin") file.data[file.data.size() / 2] ^= 1;
  }
  const auto world = UnpackWorld(files);
  EXPECT_EQ(world.status().code(), StatusCode::kDataLoss);
  EXPECT_NE(world.status().message().find("terrain.bin"), std::string::npos);
  EXPECT_EQ(UnpackWorld({}).status().code(), StatusCode::kDataLoss);
}

TEST(WorldFilesTest, NoPathLeadsOutside) {
  const auto whole = *PackWorld(*MakeTestWorld());
  for (const char* path : {"../evil", "/etc/evil", "a/../../evil", "a//b", "", "a/", ".hidden",
                           "a/.b", "back\\slash", "nul\n"}) {
    auto files = whole;
    files.push_back({path, "x"});
    const auto world = UnpackWorld(files);
    EXPECT_EQ(world.status().code(), StatusCode::kDataLoss) << path;
    EXPECT_NE(world.status().message().find("no file of a world"), std::string::npos)
        << world.status().message();
  }
}

}  // namespace
}  // namespace latticeworld
