#include "latticeworld/dataset/sources/scenes_source.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <string>

#include "dataset/source_pictures.h"
#include "latticeworld/common/random.h"
#include "latticeworld/dataset/sources/downsample.h"

namespace latticeworld {
namespace {

namespace fs = std::filesystem;

constexpr int kRows = 530, kCols = 1060;  // two tiles

Grid<char> WildMask(int rows = kRows, int cols = kCols, std::uint64_t seed = 0) {
  RandomStream random(seed, "wild mask");
  Grid<char> mask(rows, cols, 'B');
  for (const char letter : std::string("FRSF")) DrawBlot(letter, 150.0, &random, &mask);
  DrawCurve('W', 4.0, false, &random, &mask);
  return mask;
}

// Rising to the east by a metre a sample, with hills.
Grid<float> Land(int rows = kRows, int cols = kCols) {
  Grid<float> height_m(rows, cols);
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < cols; ++c) {
      height_m(r, c) = static_cast<float>(300.0 + c + 40.0 * std::sin(0.02 * r + 0.01 * c));
    }
  }
  return height_m;
}

void WriteScene(const ScratchFolder& folder, const std::string& name) {
  folder.Write("scenes/" + name + "/segmentation.png", PalettePng(WildMask(), Vocabulary::kWild));
  folder.Write("scenes/" + name + "/elevation.tif", ElevationTiff(Land()));
}

std::unique_ptr<InstanceSource> Open(const fs::path& folder, double erosion = 0.05) {
  auto source = MakeScenesSource({folder, erosion});
  EXPECT_TRUE(source.ok()) << source.status().ToString();
  return source.ok() ? *std::move(source) : nullptr;
}

void ExpectSays(const Status& status, StatusCode code, const std::vector<std::string>& words) {
  EXPECT_EQ(status.code(), code) << status.ToString();
  for (const std::string& word : words) {
    EXPECT_NE(status.message().find(word), std::string::npos) << word << ": " << status.ToString();
  }
}

// Two scenes, "bad" with one file replaced: it fails as said, the other is read.
void ExpectBadScene(const std::string& file, const std::string& bytes, StatusCode code,
                    std::vector<std::string> words) {
  const ScratchFolder folder;
  WriteScene(folder, "bad");
  WriteScene(folder, "good");
  folder.Write("scenes/bad/" + file, bytes);
  const auto source = Open(folder.path());
  ASSERT_EQ(source->group_count(), 2u);
  words.push_back("scenes/bad/" + file);
  ExpectSays(source->ReadGroup(0).status(), code, words);
  EXPECT_TRUE(source->ReadGroup(1).ok());
}

TEST(ScenesSourceTest, CutsScenesIntoTilesAndCountsTheRest) {
  const ScratchFolder folder;
  WriteScene(folder, "north rim");
  const auto source = Open(folder.path(), 0.0);
  ASSERT_EQ(source->group_count(), 1u);
  EXPECT_EQ(source->GroupName(0), "scene-north_rim");
  const auto group = source->ReadGroup(0);
  ASSERT_TRUE(group.ok()) << group.status().ToString();
  ASSERT_EQ(group->size(), 2u);
  const Grid<char> mask = WildMask();
  for (int i = 0; i < 2; ++i) {
    const Instance& instance = (*group)[i];
    EXPECT_EQ(instance.id, "scene-north_rim-y0-x" + std::to_string(i));
    EXPECT_EQ(instance.group, "scene-north_rim");
    Grid<char> tile(kTileSize, kTileSize);
    for (int r = 0; r < kTileSize; ++r) std::copy_n(mask.row(r) + 512 * i, 512, tile.row(r));
    EXPECT_EQ(ToText(instance.layout), ToText(*Downsample(tile, Vocabulary::kWild)));
    ASSERT_NE(instance.relief, nullptr);
    ASSERT_EQ(instance.relief->height_m.rows(), kTileSize);
    const Grid<float>& height_m = instance.relief->height_m;
    EXPECT_EQ(*std::min_element(height_m.begin(), height_m.end()), 0.0f);
    // The same land, set down: differences stay.
    const Grid<float> land = Land();
    EXPECT_NEAR(height_m(17, 400) - height_m(300, 20),
                land(17, 512 * i + 400) - land(300, 512 * i + 20), 1e-3);
  }
  EXPECT_NE(source->card().title.find("2 tiles"), std::string::npos) << source->card().title;
  EXPECT_NE(source->card().title.find(std::to_string(kRows * kCols - 2 * 512 * 512) + " of " +
                                      std::to_string(kRows * kCols)),
            std::string::npos)
      << source->card().title;
}

TEST(ScenesSourceTest, RiversCutIntoTheLandAndTheMoreTheLonger) {
  const ScratchFolder folder;
  WriteScene(folder, "a");
  double before = 0.0;
  const auto land = Open(folder.path(), 0.0)->ReadGroup(0);
  for (const double erosion : {0.02, 0.2}) {
    const auto eroded = Open(folder.path(), erosion)->ReadGroup(0);
    ASSERT_TRUE(eroded.ok()) << eroded.status().ToString();
    const Grid<float>& a = (*eroded)[1].relief->height_m;
    const Grid<float>& b = (*land)[1].relief->height_m;
    double change_m = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      EXPECT_TRUE(std::isfinite(a.data()[i]));
      change_m += std::abs(a.data()[i] - b.data()[i]) / static_cast<double>(a.size());
    }
    EXPECT_GT(change_m, before);
    before = change_m;
  }
  EXPECT_LT(before, 0.5 * 512.0);  // the land is still there
}

TEST(ScenesSourceTest, ReadsClassesFromAFile) {
  const ScratchFolder folder;
  folder.Write("classes.json",
               R"({"vocabulary": "suburb", "values": {"3": "A", "200": "W", "0": ""},
                   "licence": "CC0-1.0", "citation": "somebody"})");
  Grid<std::uint8_t> values(512, 512, 3);
  for (int r = 0; r < 512; ++r) {
    for (int c = 0; c < 100; ++c) values(r, c) = r < 200 ? 0 : 200;
  }
  folder.Write("scenes/a/segmentation.png", GreyPng(values));
  folder.Write("scenes/a/elevation.tif", ElevationTiff(Land(512, 512)));
  const auto source = Open(folder.path());
  EXPECT_EQ(source->card().licence, "CC0-1.0");
  EXPECT_EQ(source->card().citation, "somebody");
  const auto group = source->ReadGroup(0);
  ASSERT_TRUE(group.ok()) << group.status().ToString();
  EXPECT_EQ(group->front().layout.vocabulary, Vocabulary::kSuburb);
  EXPECT_EQ(group->front().layout.cells(31, 0), 'W');
  EXPECT_EQ(group->front().layout.cells(31, 31), 'A');
}

TEST(ScenesSourceTest, RefusesClassesThatAreNotLegal) {
  const ScratchFolder folder;
  WriteScene(folder, "a");
  for (const std::string json :
       {"", "[]", "{", R"({"vocabulary": "wild"})",
        R"({"vocabulary": "sea", "values": {"1": "W"}})",
        R"({"vocabulary": "wild", "values": {"1": "A"}})",
        R"({"vocabulary": "wild", "values": {"256": "W"}})",
        R"({"vocabulary": "wild", "values": {"1": 7}})", R"({"vocabulary": "wild", "values": {}})",
        R"({"vocabulary": "wild", "values": [1]})",
        R"({"vocabulary": "wild", "colors": {"0000ff": "W"}})",
        R"({"vocabulary": "wild", "colors": {"#00ff": "W"}})",
        R"({"vocabulary": "wild", "values": {"1": "W"}, "colors": {"#0000ff": "W"}})",
        R"({"vocabulary": "wild", "values": {"1": "W", "1": "F"}})",
        R"({"vocabulary": "wild", "values": {"1": "W"}, "license": "CC0-1.0"})"}) {
    folder.Write("classes.json", json);
    ExpectSays(MakeScenesSource({folder.path()}).status(), StatusCode::kInvalidArgument,
               {"classes.json"});
  }
}

TEST(ScenesSourceTest, AMissingHalfFailsItsSceneAlone) {
  const ScratchFolder folder;
  for (const std::string name : {"a", "b", "c", "d"}) WriteScene(folder, name);
  fs::remove(folder.path() / "scenes/a/elevation.tif");
  fs::remove(folder.path() / "scenes/b/segmentation.png");
  fs::remove(folder.path() / "scenes/c/segmentation.png");
  fs::remove(folder.path() / "scenes/c/elevation.tif");
  const auto source = Open(folder.path());
  ExpectSays(source->ReadGroup(0).status(), StatusCode::kNotFound,
             {"a/elevation.tif is missing", "a/segmentation.png is there"});
  ExpectSays(source->ReadGroup(1).status(), StatusCode::kNotFound,
             {"b/segmentation.png is missing", "b/elevation.tif is there"});
  ExpectSays(source->ReadGroup(2).status(), StatusCode::kNotFound, {"and so is"});
  EXPECT_TRUE(source->ReadGroup(3).ok());
}

TEST(ScenesSourceTest, SizesThatDifferFailTheirSceneAlone) {
  ExpectBadScene("elevation.tif", ElevationTiff(Land(kRows, kCols - 1)),
                 StatusCode::kInvalidArgument, {"1059 x 530 samples", "1060 x 530 pixels"});
}

TEST(ScenesSourceTest, AnUnknownColourIsNamedWithItsPlaceAndNumber) {
  Grid<char> mask = WildMask();
  std::fill(mask.begin(), mask.end(), 'B');
  mask(3, 9) = mask(400, 700) = 'A';  // farmland's colour, which wild layouts do not have
  std::string png = PalettePng(mask, Vocabulary::kSuburb);
  Grid<std::uint8_t> grey(kRows, kCols, 128);
  grey(3, 9) = grey(400, 700) = 77;
  ExpectBadScene("segmentation.png", GreyPng(grey), StatusCode::kInvalidArgument,
                 {"row 4, column 10", "value 77 (2 of 561800 pixels)", "colour #0000ff"});
  ExpectBadScene("segmentation.png", png, StatusCode::kInvalidArgument, {"colour #ffc280 (2 of"});
}

TEST(ScenesSourceTest, BrokenFilesFailTheirSceneAlone) {
  const std::string picture = PalettePng(WildMask(), Vocabulary::kWild);
  const std::string land = ElevationTiff(Land());
  ExpectBadScene("segmentation.png", picture.substr(0, picture.size() / 2), StatusCode::kDataLoss,
                 {});
  ExpectBadScene("segmentation.png", "", StatusCode::kDataLoss, {});
  ExpectBadScene("elevation.tif", land.substr(0, land.size() / 2), StatusCode::kDataLoss, {});
  ExpectBadScene("elevation.tif", "heights", StatusCode::kInvalidArgument, {});
}

TEST(ScenesSourceTest, AnElevationInDegreesIsRefusedWithWhatToDo) {
  TiffLook look;
  look.crs = "EPSG:4326";
  look.sample = 0.0001;
  ExpectBadScene("elevation.tif", ElevationTiff(Land(), look), StatusCode::kInvalidArgument,
                 {"degree", "gdalwarp -t_srs"});
}

TEST(ScenesSourceTest, SamplesThatAreNoSquaresAreRefused) {
  TiffLook look;
  look.tallness = 1.5;
  ExpectBadScene("elevation.tif", ElevationTiff(Land(), look), StatusCode::kInvalidArgument,
                 {"legal are squares"});
}

TEST(ScenesSourceTest, AnElevationThatIsMostlyMissingIsRefused) {
  Grid<float> land = Land();
  std::fill(land.begin(), land.begin() + static_cast<std::ptrdiff_t>(land.size() * 6 / 10), NAN);
  ExpectBadScene("elevation.tif", ElevationTiff(land), StatusCode::kInvalidArgument,
                 {"60 % of the elevation is no data"});
  std::fill(land.begin(), land.end(), NAN);
  ExpectBadScene("elevation.tif", ElevationTiff(land), StatusCode::kInvalidArgument,
                 {"100 % of the elevation is no data"});
}

TEST(ScenesSourceTest, AFewVoidsAreFilled) {
  const ScratchFolder folder;
  WriteScene(folder, "a");
  Grid<float> land = Land();
  for (int i = 0; i < 50; ++i) land(200 + i / 10, 100 + i % 10) = NAN;
  folder.Write("scenes/a/elevation.tif", ElevationTiff(land));
  const auto group = Open(folder.path(), 0.0)->ReadGroup(0);
  ASSERT_TRUE(group.ok()) << group.status().ToString();
  const Grid<float>& height_m = group->front().relief->height_m;
  EXPECT_NEAR(height_m(202, 105) - height_m(202, 90), Land()(202, 105) - Land()(202, 90), 3.0);
}

TEST(ScenesSourceTest, ASceneWithoutRoomForATileIsRefused) {
  ExpectBadScene("segmentation.png", PalettePng(WildMask(511, 900), Vocabulary::kWild),
                 StatusCode::kInvalidArgument, {"900 x 511 pixels", "at least 512"});
}

TEST(ScenesSourceTest, RefusesFoldersThatHoldNoScenes) {
  const ScratchFolder folder;
  ExpectSays(MakeScenesSource({folder.path() / "absent"}).status(), StatusCode::kNotFound,
             {"absent"});
  ExpectSays(MakeScenesSource({folder.path()}).status(), StatusCode::kInvalidArgument,
             {"it holds no folders", "segmentation.png"});
  folder.Write("holidays/1.png", "x");
  ExpectSays(MakeScenesSource({folder.path()}).status(), StatusCode::kInvalidArgument,
             {"it holds \"holidays\""});
  fs::create_directories(folder.path() / "scenes");
  ExpectSays(MakeScenesSource({folder.path()}).status(), StatusCode::kInvalidArgument,
             {"scenes is empty"});
  WriteScene(folder, "a");
  ExpectSays(MakeScenesSource({folder.path(), 0.6}).status(), StatusCode::kInvalidArgument,
             {"erosion"});
}

}  // namespace
}  // namespace latticeworld
