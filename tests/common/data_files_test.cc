#include "latticeworld/common/data_files.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "latticeworld/common/files.h"

namespace latticeworld {
namespace {

namespace fs = std::filesystem;

class DataFilesTest : public testing::Test {
 protected:
  DataFilesTest() {
    std::string pattern = (fs::temp_directory_path() / "latticeworld_data.XXXXXX").string();
    directory_ = ::mkdtemp(pattern.data());
  }
  ~DataFilesTest() override { fs::remove_all(directory_); }

  void Write(const std::string& name) { ASSERT_TRUE(WriteFile(directory_ / name, "{}").ok()); }

  fs::path directory_;
};

TEST_F(DataFilesTest, AFolderGivesItsJsonInOrder) {
  for (const char* name : {"b.json", "a.json", "c.txt"}) Write(name);
  const auto files = JsonFilesAt(directory_, 2);
  ASSERT_TRUE(files.ok()) << files.status().ToString();
  EXPECT_EQ(*files, (std::vector<fs::path>{directory_ / "a.json", directory_ / "b.json"}));
}

TEST_F(DataFilesTest, AnyOtherPathIsItself) {
  const fs::path absent = directory_ / "absent";
  EXPECT_EQ(*JsonFilesAt(absent, 1), std::vector<fs::path>{absent});
}

TEST_F(DataFilesTest, AFolderWithoutAnyIsNotFound) {
  Write("c.txt");
  EXPECT_EQ(JsonFilesAt(directory_, 1).status().code(), StatusCode::kNotFound);
}

TEST_F(DataFilesTest, TooManyAreRefused) {
  for (const char* name : {"a.json", "b.json", "c.json"}) Write(name);
  EXPECT_EQ(JsonFilesAt(directory_, 2).status().code(), StatusCode::kInvalidArgument);
}

TEST(IsSoundTest, AViolationOfAPartIsOneOfTheWhole) {
  const std::vector<Violation> violations{{"wrong_type", "f.json#/lidars/1/range", "", ""}};
  EXPECT_FALSE(IsSound("f.json#/lidars/1/range", violations));
  EXPECT_FALSE(IsSound("f.json#/lidars/1", violations));
  EXPECT_TRUE(IsSound("f.json#/lidars/1/range/min", violations));
  EXPECT_TRUE(IsSound("f.json#/lidars/10", violations));
  EXPECT_TRUE(IsSound("f.json#/lidars/1/rang", violations));
}

}  // namespace
}  // namespace latticeworld
