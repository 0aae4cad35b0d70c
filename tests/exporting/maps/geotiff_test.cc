#include "latticeworld/exporting/maps/geotiff.h"

#include <cpl_vsi.h>
#include <gdal.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "generation/test_world.h"
#include "latticeworld/mapping/traversability.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {
namespace {

// A GeoTIFF as GDAL reads it again.
class Raster {
 public:
  Raster(const std::vector<ExportFile>& files, const std::string& name) {
    GDALAllRegister();
    for (const ExportFile& file : files) {
      if (file.name == name) bytes_ = Put(kPath, file.content);
      if (file.name == name + ".aux.xml") beside_ = Put(kBeside, file.content);
    }
    dataset_ = GDALOpen(kPath, GA_ReadOnly);
    EXPECT_NE(dataset_, nullptr) << name;
    GDALGetGeoTransform(dataset_, transform_);
  }
  ~Raster() {
    GDALClose(dataset_);
    VSIUnlink(kPath);
    VSIUnlink(kBeside);
  }
  Raster(const Raster&) = delete;
  Raster& operator=(const Raster&) = delete;

  int cols() const { return GDALGetRasterXSize(dataset_); }
  int rows() const { return GDALGetRasterYSize(dataset_); }
  std::string projection() const { return GDALGetProjectionRef(dataset_); }
  std::string Metadata(const char* key) const {
    const char* text = GDALGetMetadataItem(dataset_, key, nullptr);
    return text == nullptr ? "" : text;
  }
  double NoData() const {
    int has = 0;
    const double value = GDALGetRasterNoDataValue(GDALGetRasterBand(dataset_, 1), &has);
    EXPECT_EQ(has, 1);
    return value;
  }
  // How a map names a value.
  std::string NameOf(int value) const {
    char** names = GDALGetRasterCategoryNames(GDALGetRasterBand(dataset_, 1));
    return names == nullptr ? "" : names[value];
  }
  // Red, green and blue of a value as one number; -1: it has no colour.
  int ColorOf(int value) const {
    const GDALColorTableH table = GDALGetRasterColorTable(GDALGetRasterBand(dataset_, 1));
    GDALColorEntry color;
    if (table == nullptr || !GDALGetColorEntryAsRGB(table, value, &color)) return -1;
    return color.c1 << 16 | color.c2 << 8 | color.c3;
  }
  // Of the pixel that covers a place.
  float At(WorldPoint point) const {
    float value = 0.0f;
    const int col = static_cast<int>(std::floor((point.x_m - transform_[0]) / transform_[1]));
    const int row = static_cast<int>(std::floor((point.y_m - transform_[3]) / transform_[5]));
    EXPECT_EQ(GDALRasterIO(GDALGetRasterBand(dataset_, 1), GF_Read, col, row, 1, 1, &value, 1, 1,
                           GDT_Float32, 0, 0),
              CE_None);
    return value;
  }

 private:
  static constexpr char kPath[] = "/vsimem/geotiff_test.tif";
  static constexpr char kBeside[] = "/vsimem/geotiff_test.tif.aux.xml";

  // A file in memory, which lasts as long as its bytes.
  static std::unique_ptr<std::string> Put(const char* path, const std::string& content) {
    auto bytes = std::make_unique<std::string>(content);
    VSIFCloseL(
        VSIFileFromMemBuffer(path, reinterpret_cast<GByte*>(bytes->data()), bytes->size(), FALSE));
    return bytes;
  }

  std::unique_ptr<std::string> bytes_, beside_;
  GDALDatasetH dataset_ = nullptr;
  double transform_[6] = {};
};

// A whole number of the first directory of a TIFF of this machine's byte order (TIFF 6.0); 0: there
// is no such tag.
std::uint16_t TagOf(const std::string& tiff, std::uint16_t tag) {
  std::uint32_t at = 0;
  std::memcpy(&at, tiff.data() + 4, sizeof at);
  std::uint16_t entries = 0;
  std::memcpy(&entries, tiff.data() + at, sizeof entries);
  EXPECT_GT(entries, 0);
  for (int i = 0; i < entries; ++i) {
    const char* const entry = tiff.data() + at + 2 + 12 * i;
    std::uint16_t number = 0, value = 0;
    std::memcpy(&number, entry, sizeof number);
    std::memcpy(&value, entry + 8, sizeof value);
    if (number == tag) return value;
  }
  return 0;
}

class GeoTiffTest : public ::testing::Test {
 protected:
  const std::shared_ptr<World> world_ = MakeTestWorld();
  const Scene& scene_ = *world_->scene;

  std::vector<ExportFile> Make(const std::optional<GeoOrigin>& origin,
                               const GeoTiffOptions& options = {}) const {
    auto files = GeoTiffFiles(scene_, origin, options, Progress());
    EXPECT_TRUE(files.ok()) << files.status().ToString();
    return *files;
  }
};

// pysheds 0.5 takes 0 where a file names no such value ("No `nodata` value detected. Defaulting to
// 0.").
TEST_F(GeoTiffTest, EveryLayerNamesAValueForNoDataThatNoCellHas) {
  const auto files = Make(std::nullopt);
  const GridGeometry& geometry = scene_.geometry();
  for (const char* name : {"elevation.tif", "classes.tif", "traversability.tif"}) {
    const Raster raster(files, name);
    const double none = raster.NoData();
    EXPECT_NE(none, 0.0) << name;
    for (int row = 0; row < geometry.rows(); ++row) {
      for (int col = 0; col < geometry.cols(); ++col)
        ASSERT_NE(raster.At(geometry.CenterOf({row, col})), none) << name;
    }
  }
  EXPECT_TRUE(std::isnan(Raster(files, "water.tif").NoData()));
}

// Whitebox Workflows 2.0.6 reads compressed files with a predictor (GDAL's 2 or 3) as if they had
// none, and gives noise for heights without a word (findings/whitebox-ignores-predictors.sh).
TEST_F(GeoTiffTest, NoLayerIsStoredWithAPredictor) {
  int layers = 0;
  for (const ExportFile& file : Make(std::nullopt)) {
    if (file.name.substr(file.name.size() - 4) != ".tif") continue;
    ++layers;
    EXPECT_LE(TagOf(file.content, 317), 1) << file.name;  // 1: none
  }
  EXPECT_EQ(layers, 4);
}

TEST_F(GeoTiffTest, LayersAreThoseOfTheWorldAtEveryPlace) {
  const auto files = Make(GeoOrigin{47.0, 8.0, 431.5});
  const Grid<float> traversability = BuildTraversability(scene_, RobotLimits());
  const GridGeometry& geometry = scene_.geometry();
  const Terrain& terrain = *scene_.terrain;
  int wet = 0;
  {
    const Raster elevation(files, "elevation.tif");
    ASSERT_EQ(elevation.cols(), geometry.cols());
    ASSERT_EQ(elevation.rows(), geometry.rows());
    EXPECT_EQ(elevation.Metadata("ZERO_ALTITUDE_M"), "431.500000");
    for (int row = 0; row < geometry.rows(); row += 5) {
      for (int col = 0; col < geometry.cols(); col += 7) {
        const WorldPoint point = geometry.CenterOf({row, col});
        EXPECT_NEAR(elevation.At(point), terrain.ground.HeightAt(point), 1e-5);
      }
    }
  }
  {
    const Raster water(files, "water.tif");
    for (int row = 0; row < geometry.rows(); ++row) {
      const WorldPoint point = geometry.CenterOf({row, row});
      const float level = terrain.water_level_m(row, row);
      wet += std::isnan(level) ? 0 : 1;
      EXPECT_EQ(std::isnan(water.At(point)), std::isnan(level));
      if (!std::isnan(level)) {
        EXPECT_EQ(water.At(point), level);
      }
    }
  }
  EXPECT_GT(wet, 0);
  {
    const Raster classes(files, "classes.tif");
    EXPECT_EQ(classes.Metadata("CLASS_8"), "water bed");
    for (int row = 0; row < geometry.rows(); ++row) {
      EXPECT_EQ(classes.At(geometry.CenterOf({row, row})),
                static_cast<float>(terrain.surface(row, row)));
    }
  }
  const Raster free(files, "traversability.tif");
  for (int row = 0; row < geometry.rows(); ++row)
    EXPECT_EQ(free.At(geometry.CenterOf({row, row})), traversability(row, row));
}

TEST_F(GeoTiffTest, ClassesHaveNamesAndColoursThatDiffer) {
  const Raster classes(Make(std::nullopt), "classes.tif");
  std::set<int> colors;
  for (const auto& entry : EnumNames(SurfaceClass())) {
    const int value = static_cast<int>(entry.value);
    EXPECT_EQ(classes.NameOf(value), entry.name);
    colors.insert(classes.ColorOf(value));
  }
  EXPECT_EQ(colors.size(), static_cast<std::size_t>(kSurfaceClassCount));
  EXPECT_EQ(colors.count(-1), 0u);
  EXPECT_EQ(colors.count(0), 0u);
}

TEST_F(GeoTiffTest, TheProjectionIsAroundTheOriginOrLocal) {
  EXPECT_NE(Raster(Make(GeoOrigin{47.25, 8.5, 0.0}), "elevation.tif").projection().find("47.25"),
            std::string::npos);
  EXPECT_EQ(Raster(Make(std::nullopt), "elevation.tif").projection().find("WGS"),
            std::string::npos);
}

TEST_F(GeoTiffTest, ARegionHoldsTheCellsWhoseCentresAreInIt) {
  GeoTiffOptions options;
  options.region = ExportRegion{-4.0, -2.0, 6.0, 3.0};
  const Raster elevation(Make(std::nullopt, options), "elevation.tif");
  EXPECT_EQ(elevation.cols(), 20);
  EXPECT_EQ(elevation.rows(), 10);
  const WorldPoint point = {-3.75, 2.75};
  EXPECT_NEAR(elevation.At(point), scene_.terrain->ground.HeightAt(point), 1e-5);
}

TEST_F(GeoTiffTest, TheSameWorldGivesTheSameBytes) {
  const auto once = Make(GeoOrigin{1.0, 2.0, 3.0}), again = Make(GeoOrigin{1.0, 2.0, 3.0});
  ASSERT_EQ(once.size(), 5u);
  for (std::size_t i = 0; i < once.size(); ++i) EXPECT_EQ(once[i].content, again[i].content);
}

}  // namespace
}  // namespace latticeworld
