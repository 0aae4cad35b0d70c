#include "latticeworld/dataset/sources/sketch_pairs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>

#include "latticeworld/common/files.h"
#include "latticeworld/relief/relief.h"
#include "latticeworld/relief/sketch/sketch.h"

namespace latticeworld {
namespace {

namespace fs = std::filesystem;

class SketchPairsTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "sketch_pairs_XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    root_ = pattern;
  }
  void TearDown() override { fs::remove_all(root_); }

  static std::map<std::string, std::string> Pictures(const fs::path& folder) {
    std::map<std::string, std::string> bytes;
    for (const auto& entry : fs::directory_iterator(folder)) {
      if (entry.path().extension() != ".png") continue;
      bytes[entry.path().filename().string()] = ReadFile(entry.path(), 1 << 24).value();
    }
    return bytes;
  }

  static SketchPairOptions Few(std::size_t count, int threads) {
    SketchPairOptions options;
    options.count = count;
    options.side = 64;
    options.seed = 5;
    options.threads = threads;
    return options;
  }

  fs::path root_;
};

TEST_F(SketchPairsTest, LandAndSketchAreReadAsUsersGiveThem) {
  ASSERT_EQ(WriteSketchPairs(Few(3, 2), root_ / "a", Progress()).value(), 3u);
  const auto pictures = Pictures(root_ / "a");
  ASSERT_EQ(pictures.size(), 6u);
  const Result<Relief> relief = ReadHeightMap(pictures.at("000001_height.png"), {});
  ASSERT_TRUE(relief.ok()) << relief.status().ToString();
  EXPECT_EQ(relief->height_m.rows(), 64);
  const auto [low, high] = std::minmax_element(relief->height_m.begin(), relief->height_m.end());
  EXPECT_FLOAT_EQ(*low, 0.0f);
  EXPECT_FLOAT_EQ(*high, 100.0f);
  const Result<Sketch> sketch = ReadSketch(pictures.at("000001_sketch.png"));
  ASSERT_TRUE(sketch.ok()) << sketch.status().ToString();
  // Ridges are higher than valleys.
  double ridge = 0.0, valley = 0.0;
  int ridges = 0, valleys = 0;
  for (std::size_t i = 0; i < sketch->size(); ++i) {
    const float height = relief->height_m.data()[i];
    if (sketch->data()[i] == Stroke::kRidge) ridge += height, ++ridges;
    if (sketch->data()[i] == Stroke::kValley) valley += height, ++valleys;
  }
  ASSERT_GT(ridges, 0);
  ASSERT_GT(valleys, 0);
  EXPECT_GT(ridge / ridges, valley / valleys + 10.0);
}

TEST_F(SketchPairsTest, GoesOnAfterAnInterruptionToTheSameBytesWithAnyNumberOfThreads) {
  ASSERT_TRUE(WriteSketchPairs(Few(5, 1), root_ / "a", Progress()).ok());
  ASSERT_TRUE(WriteSketchPairs(Few(2, 2), root_ / "b", Progress()).ok());
  fs::remove(root_ / "b" / "000000_sketch.png");  // a kill between the two pictures
  EXPECT_EQ(WriteSketchPairs(Few(5, 2), root_ / "b", Progress()).value(), 4u);
  EXPECT_EQ(Pictures(root_ / "a"), Pictures(root_ / "b"));
}

TEST_F(SketchPairsTest, LandsDiffer) {
  ASSERT_TRUE(WriteSketchPairs(Few(2, 1), root_ / "a", Progress()).ok());
  const auto pictures = Pictures(root_ / "a");
  EXPECT_NE(pictures.at("000000_height.png"), pictures.at("000001_height.png"));
}

TEST_F(SketchPairsTest, RefusesFoldersOfOtherThings) {
  ASSERT_TRUE(WriteSketchPairs(Few(1, 1), root_ / "a", Progress()).ok());
  SketchPairOptions other = Few(1, 1);
  other.seed = 6;
  EXPECT_EQ(WriteSketchPairs(other, root_ / "a", Progress()).status().code(),
            StatusCode::kInvalidArgument);
  fs::create_directory(root_ / "b");
  ASSERT_TRUE(WriteFile(root_ / "b" / "letter.txt", "dear").ok());
  EXPECT_EQ(WriteSketchPairs(Few(1, 1), root_ / "b", Progress()).status().code(),
            StatusCode::kFailedPrecondition);
  EXPECT_EQ(ReadFile(root_ / "b" / "letter.txt", 100).value(), "dear");
  EXPECT_FALSE(fs::exists(root_ / "b" / "pairs.lock"));
  SketchPairOptions bad;
  bad.side = 32;
  EXPECT_EQ(WriteSketchPairs(bad, root_ / "c", Progress()).status().code(),
            StatusCode::kInvalidArgument);
  EXPECT_FALSE(fs::exists(root_ / "c"));
}

TEST_F(SketchPairsTest, StopsWhenCancelled) {
  Progress progress;
  progress.Cancel();
  EXPECT_EQ(WriteSketchPairs(Few(1, 1), root_ / "a", progress).status().code(),
            StatusCode::kCancelled);
}

}  // namespace
}  // namespace latticeworld
