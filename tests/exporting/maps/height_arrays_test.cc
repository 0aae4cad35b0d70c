#include "latticeworld/exporting/maps/height_arrays.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>

#include "generation/test_world.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {
namespace {

// A .npy as numpy.lib.format describes it, of little-endian machines' bytes.
template <typename T>
class Npy {
 public:
  explicit Npy(const std::string& bytes) : bytes_(bytes) {
    EXPECT_EQ(bytes.substr(0, 8), std::string("\x93NUMPY\x01\x00", 8));
    const std::size_t header =
        static_cast<unsigned char>(bytes[8]) + 256u * static_cast<unsigned char>(bytes[9]);
    begin_ = 10 + header;
    EXPECT_EQ(begin_ % 64, 0u);
    EXPECT_EQ(bytes[begin_ - 1], '\n');
    const std::regex text(
        R"(\{'descr': '(...)', 'fortran_order': False, 'shape': \((\d+), (\d+)\), \} *\n)");
    std::smatch match;
    const std::string all = bytes.substr(10, header);
    const bool fits = std::regex_match(all, match, text);
    EXPECT_TRUE(fits) << all;
    if (!fits) return;
    type = match[1];
    rows = std::stoi(match[2]);
    cols = std::stoi(match[3]);
    EXPECT_EQ(bytes.size(), begin_ + sizeof(T) * static_cast<std::size_t>(rows) * cols);
  }
  T At(int row, int col) const {
    T value;
    const std::size_t number = static_cast<std::size_t>(row) * cols + col;
    std::memcpy(&value, bytes_.data() + begin_ + sizeof(T) * number, sizeof(T));
    return value;
  }

  std::string type;
  int rows = 0, cols = 0;

 private:
  std::string bytes_;
  std::size_t begin_ = 0;
};

class HeightArraysTest : public ::testing::Test {
 protected:
  const std::shared_ptr<World> world_ = MakeTestWorld();
  const Scene& scene_ = *world_->scene;
  const Terrain& terrain_ = *scene_.terrain;

  std::map<std::string, std::string> Make(
      const std::optional<ExportRegion>& region = std::nullopt,
      const std::optional<GeoOrigin>& origin = std::nullopt) const {
    HeightArraysOptions options;
    options.region = region;
    auto files = HeightFiles(scene_, "w", origin, options, Progress());
    EXPECT_TRUE(files.ok()) << files.status().ToString();
    std::map<std::string, std::string> by_name;
    for (const ExportFile& file : *files) by_name[file.name] = file.content;
    return by_name;
  }
};

TEST_F(HeightArraysTest, EveryLayerIsThatOfTheWorldRow0North) {
  auto files = Make();
  const Npy<float> heights(files["heights.npy"]), water(files["water.npy"]);
  const Npy<std::uint8_t> classes(files["classes.npy"]), letters(files["letters.npy"]);
  EXPECT_EQ(heights.type, "<f4");
  EXPECT_EQ(water.type, "<f4");
  EXPECT_EQ(classes.type, "|u1");
  EXPECT_EQ(letters.type, "|u1");
  const GridGeometry& geometry = scene_.geometry();
  ASSERT_EQ(heights.rows, geometry.rows());
  ASSERT_EQ(heights.cols, geometry.cols());
  ASSERT_EQ(letters.rows, geometry.rows());
  int wet = 0;
  for (int row = 0; row < geometry.rows(); ++row) {
    for (int col = 0; col < geometry.cols(); ++col) {
      const CellIndex cell = {row, col};
      EXPECT_EQ(heights.At(row, col), terrain_.ground.height_m()[cell]);
      EXPECT_EQ(classes.At(row, col), static_cast<int>(terrain_.surface[cell]));
      EXPECT_EQ(letters.At(row, col), terrain_.weights.DominantAt(cell));
      const float level_m = terrain_.water_level_m[cell];
      EXPECT_EQ(std::isnan(water.At(row, col)), std::isnan(level_m));
      if (std::isnan(level_m)) continue;
      EXPECT_EQ(water.At(row, col), level_m);
      ++wet;
    }
  }
  EXPECT_GT(wet, 0);
}

TEST_F(HeightArraysTest, TheDescriptionPlacesEveryValueInTheMap) {
  for (const auto& region : {std::optional<ExportRegion>(),
                             std::optional<ExportRegion>(ExportRegion{-4.0, -2.0, 6.1, 3.0})}) {
    auto files = Make(region);
    const auto json = nlohmann::json::parse(files["heights.json"]);
    const Npy<float> heights(files["heights.npy"]);
    ASSERT_EQ(json["rows"], heights.rows);
    ASSERT_EQ(json["cols"], heights.cols);
    EXPECT_EQ(json["row_0"], "north");
    const double west_m = json["origin"][0], north_m = json["origin"][1];
    const double step_m = json["resolution"];
    float low_m = heights.At(0, 0), high_m = low_m;
    for (int row = 0; row < heights.rows; ++row) {
      for (int col = 0; col < heights.cols; ++col) {
        const WorldPoint place = {west_m + col * step_m, north_m - row * step_m};
        EXPECT_TRUE(!region || region->Holds(place));
        EXPECT_NEAR(heights.At(row, col), terrain_.ground.HeightAt(place), 1e-5);
        low_m = std::min(low_m, heights.At(row, col));
        high_m = std::max(high_m, heights.At(row, col));
      }
    }
    EXPECT_EQ(json["lowest"], low_m);
    EXPECT_EQ(json["highest"], high_m);
    EXPECT_EQ(json["size"][0], step_m * (heights.cols - 1));
    EXPECT_EQ(json["center"][1], north_m - 0.5 * step_m * (heights.rows - 1));
  }
}

TEST_F(HeightArraysTest, TheDescriptionNamesItsFilesClassesAndLetters) {
  auto files = Make();
  const auto json = nlohmann::json::parse(files["heights.json"]);
  EXPECT_EQ(json["layers"].size() + 1, files.size());
  for (const auto& file : json["layers"]) EXPECT_EQ(files.count(file), 1u) << file;
  EXPECT_EQ(json["classes"].size(), static_cast<std::size_t>(kSurfaceClassCount));
  EXPECT_EQ(json["classes"][8]["name"], "water bed");
  EXPECT_GT(json["classes"][8]["friction"], 0.0);
  bool has_forest = false;
  for (const auto& entry : json["letters"])
    has_forest = has_forest || (entry["number"] == 'F' && entry["name"] == "forest");
  EXPECT_TRUE(has_forest) << json["letters"];
  EXPECT_TRUE(json["earth"].is_null());
  const auto earth =
      nlohmann::json::parse(Make(std::nullopt, GeoOrigin{47.0, 8.0, 400.0})["heights.json"]);
  EXPECT_EQ(earth["earth"]["latitude_deg"], 47.0);
  EXPECT_EQ(earth["earth"]["longitude_deg"], 8.0);
  EXPECT_EQ(earth["earth"]["altitude_m"], 400.0);
}

TEST_F(HeightArraysTest, WhereAllIsDryThereIsNoLayerOfWater) {
  auto files = Make(ExportRegion{-12.0, 2.0, -2.0, 12.0});
  EXPECT_EQ(files.count("water.npy"), 0u);
  EXPECT_FALSE(nlohmann::json::parse(files["heights.json"])["layers"].contains("water"));
}

TEST_F(HeightArraysTest, ARegionOutsideIsRefused) {
  HeightArraysOptions options;
  options.region = ExportRegion{-50.0, 0.0, 10.0, 10.0};
  EXPECT_EQ(HeightFiles(scene_, "w", std::nullopt, options, Progress()).status().code(),
            StatusCode::kInvalidArgument);
}

}  // namespace
}  // namespace latticeworld
