#include <cpl_vsi.h>
#include <gdal.h>
#include <gdal_frmts.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/relief/elevation/elevation.h"
#include "relief/elevation/elevation_files.h"

namespace latticeworld {
namespace {

TEST(ElevationSrtmTest, ReadsSrtmTilesOfThreeResolutions) {
  for (const int side : {1201, 3601, 7201}) {
    const std::string bytes = WriteSrtm(
        side, side, [side](int row, int col) { return col * 1200 / (side - 1) + (row == 0); });
    // The samples stand on the lines of the degrees: the tile's middle is the middle sample.
    for (const char* name : {"N40W106.hgt", "n40w106.HGT", "a/b/N40W106.SRTMGL1.hgt"}) {
      const Relief relief = ReadRelief(bytes, WorldOptions(2048, 16), name);
      ASSERT_TRUE(relief.geo.has_value());
      EXPECT_NEAR(relief.geo->latitude_deg, 40.5, 1e-9);
      EXPECT_NEAR(relief.geo->longitude_deg, -105.5, 1e-9);
      const double slope = 1200.0 / DegreesAt(40.5).longitude_m;
      ExpectLand(relief, 2048, 1.2, [&](double east_m, double) { return 600 + slope * east_m; });
    }
    EXPECT_NEAR(ReadRelief(bytes, WorldOptions(2048, 16), "S01E000.hgt").geo->latitude_deg, -0.5,
                1e-9);
    ExpectRefused(bytes, {"srtm.hgt", "N40W106.hgt"}, WorldOptions(512, 4), "srtm.hgt");
    ExpectRefused(bytes, {"N40W106.hgt"}, WorldOptions(512, 4), "N91W106.hgt");
    ExpectRefused(bytes, {"N40W106.hgt"}, WorldOptions(512, 4), "");
    ExpectRefused(bytes.substr(0, bytes.size() - 2), {"3601 x 3601", "1201 x 1201", "cut off"},
                  WorldOptions(512, 4), "N40W106.hgt");
  }
}

// Tiles of 1 arc second beyond 50 degrees: 1801 samples from west to east, 3601 from north to south
// (as GDAL 3.6.2's driver SRTMHGT knows them).
TEST(ElevationSrtmTest, ReadsSrtmTilesOfHighLatitudes) {
  const std::string bytes = WriteSrtm(1801, 3601, [](int, int col) { return col * 1200 / 1800; });
  const Relief relief = ReadRelief(bytes, WorldOptions(2048, 16), "N60E010.hgt");
  ASSERT_TRUE(relief.geo.has_value());
  EXPECT_NEAR(relief.geo->latitude_deg, 60.5, 1e-9);
  EXPECT_NEAR(relief.geo->longitude_deg, 10.5, 1e-9);
  const double slope = 1200.0 / DegreesAt(60.5).longitude_m;
  ExpectLand(relief, 2048, 1.5, [&](double east_m, double) { return 600 + slope * east_m; });
}

// No tile's edge, byte order or sign is a matter of chance: GDAL 3.6.2 reads the same tile.
TEST(ElevationSrtmTest, ReadsSrtmTilesAsGdalDoes) {
  const std::string bytes =
      WriteSrtm(1201, 1201, [](int row, int col) { return (row * 31 + col * 17) % 6000 - 500; });
  GDALRegister_SRTMHGT();
  constexpr char kName[] = "/vsimem/elevation_test/S33W071.hgt";
  auto* data = reinterpret_cast<GByte*>(const_cast<char*>(bytes.data()));
  VSIFCloseL(VSIFileFromMemBuffer(kName, data, bytes.size(), FALSE));
  GDALDatasetH tile = GDALOpen(kName, GA_ReadOnly);
  ASSERT_NE(tile, nullptr);
  TiffSpec spec;
  spec.cols = spec.rows = 1201;
  spec.type = GDT_Int16;
  spec.crs = "EPSG:4326";
  GDALGetGeoTransform(tile, spec.transform.data());
  spec.finish = [tile](GDALDatasetH copy) {
    std::vector<std::int16_t> heights(std::size_t{1201} * 1201);
    for (const auto& [from, access] : {std::pair(tile, GF_Read), std::pair(copy, GF_Write)}) {
      EXPECT_EQ(GDALRasterIO(GDALGetRasterBand(from, 1), access, 0, 0, 1201, 1201, heights.data(),
                             1201, 1201, GDT_Int16, 0, 0),
                CE_None);
    }
  };
  const std::string tiff = WriteTiff(spec);
  GDALClose(tile);
  VSIUnlink(kName);
  const ElevationOptions place = OptionsAt(-32.25, -70.75, WorldOptions(1024, 8));
  const Relief ours = ReadRelief(bytes, place, "S33W071.hgt"), theirs = ReadRelief(tiff, place);
  ASSERT_EQ(ours.height_m.rows(), theirs.height_m.rows());
  EXPECT_TRUE(std::equal(ours.height_m.begin(), ours.height_m.end(), theirs.height_m.begin()));
}

TEST(ElevationSrtmTest, FillsTheVoidsOfSrtm) {
  const std::string bytes = WriteSrtm(1201, 1201, [](int row, int col) {
    return std::abs(row - 600) < 5 && std::abs(col - 600) < 9 ? -32768 : 700;
  });
  ExpectLand(ReadRelief(bytes, WorldOptions(2048, 16), "N40W106.hgt"), 2048, 0.01,
             [](double, double) { return 700.0; });
}

}  // namespace
}  // namespace latticeworld
