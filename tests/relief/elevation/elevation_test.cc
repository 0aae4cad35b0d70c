#include "latticeworld/relief/elevation/elevation.h"

#include <cpl_string.h>
#include <cpl_vsi.h>
#include <gdal.h>
#include <gdal_frmts.h>
#include <gtest/gtest.h>
#include <ogr_srs_api.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <thread>
#include <vector>

#include "relief/elevation/elevation_files.h"

namespace latticeworld {
namespace {

TEST(ElevationTest, HasNoMoreSamplesThanTheWorldOrTwiceTheDataCarry) {
  const std::string bytes = WriteTiff(TiffSpec());
  EXPECT_EQ(ReadRelief(bytes, WorldOptions(800, 0.5)).height_m.rows(), 160);  // the data: 10 m
  EXPECT_EQ(ReadRelief(bytes, WorldOptions(800, 16.0)).height_m.rows(), 50);  // the world
  EXPECT_EQ(ReadRelief(bytes, WorldOptions(64, 0.1)).height_m.rows(),
            33);  // the least that a relief has
}

TEST(ElevationTest, LetsTheLowestBeZeroUnlessTheAltitudeIsKept) {
  TiffSpec spec;
  spec.land = [](double x, double) { return 1234.5 + 0.1 * (x - 500000); };
  ElevationOptions options = WorldOptions(400, 10);
  const Relief high = ReadRelief(WriteTiff(spec), options);
  options.keep_altitude = false;
  const Relief low = ReadRelief(WriteTiff(spec), options);
  ASSERT_TRUE(low.geo && high.geo);
  const float lowest_m = *std::min_element(high.height_m.begin(), high.height_m.end());
  EXPECT_NEAR(low.geo->altitude_m, lowest_m, 1e-3);
  EXPECT_EQ(*std::min_element(low.height_m.begin(), low.height_m.end()), 0.0f);
  for (int i = 0; i < 33; ++i) {
    EXPECT_NEAR(low.height_m(i, i) + low.geo->altitude_m, high.height_m(i, i), 1e-3);
  }
}

TEST(ElevationTest, RefusesNothingButNoData) {
  TiffSpec spec;
  spec.no_data = -5;
  spec.land = [](double, double) { return -5.0; };
  ExpectRefused(WriteTiff(spec), {"nothing but no-data"});
  spec.no_data = kNoData;
  spec.land = [](double, double) { return kNoData; };
  ExpectRefused(WriteTiff(spec), {"nothing but no-data"});
  spec.land = [](double, double) { return INFINITY; };
  ExpectRefused(WriteTiff(spec), {"nothing but no-data"});
  ExpectRefused(WriteSrtm(1201, 1201, [](int, int) { return -32768; }), {"nothing but no-data"},
                WorldOptions(512, 4), "N40W106.hgt");
}

TEST(ElevationTest, RefusesAWorldLargerThanTheDataAndNamesTheLargest) {
  TiffSpec spec;
  spec.rows = 60;  // 1000 m x 600 m
  const std::string bytes = WriteTiff(spec);
  ExpectRefused(bytes, {"1024 m", "100 x 60 samples", "1000 m x 600 m", "at most 600 m"},
                WorldOptions(1024, 4));
  EXPECT_TRUE(ReadElevation(bytes, "x.tif", WorldOptions(600, 4)).ok());
  // A place 200 m from the southern edge.
  const auto relief = ReadElevation(bytes, "x.tif", WorldOptions(200, 4));
  ASSERT_TRUE(relief.ok());
  const double south = relief->geo->latitude_deg - 101 / DegreesAt(39.7).latitude_m;
  ExpectRefused(bytes, {"at most 39"},
                OptionsAt(south, relief->geo->longitude_deg, WorldOptions(512, 4)));
}

TEST(ElevationTest, RefusesAPlaceOutsideTheData) {
  const std::string bytes = WriteTiff(TiffSpec());
  ExpectRefused(bytes,
                {"latitude 51.00000", "outside", "x 500000 to 501000", "middle at latitude 39.74"},
                OptionsAt(51.0, 7.0, WorldOptions(64, 1)));
  // The other side of the earth cannot be projected at all.
  ExpectRefused(bytes, {"outside"}, OptionsAt(-39.7, 75.0, WorldOptions(64, 1)));
}

TEST(ElevationTest, RefusesWhatIsNoElevation) {
  ExpectRefused("", {"empty"});
  ExpectRefused("this is a text", {"this is", "GeoTIFF", ".hgt"});
  ExpectRefused(std::string("PK\x03\x04 zipped"), {"ZIP"}, WorldOptions(512, 4), "N40W106.hgt.zip");
  ExpectRefused("<VRTDataset rasterXSize=\"20\" rasterYSize=\"20\"></VRTDataset>", {"virtual"});
  ExpectRefused("<GDAL_WMS><Service name=\"TMS\"></Service></GDAL_WMS>", {"XML"});
}

TEST(ElevationTest, RefusesFilesThatAreCutOff) {
  TiffSpec spec;
  spec.land = [](double x, double y) { return std::fmod(x + 7 * y, 311.0); };
  for (const char* option : {"COMPRESS=NONE", "COMPRESS=DEFLATE"}) {
    spec.creation = {option};
    const std::string whole = WriteTiff(spec);
    const Grid<float> expected = ReadRelief(whole, WorldOptions(900, 10)).height_m;
    for (std::size_t size = 0; size < whole.size(); size += 1 + whole.size() / 61) {
      const auto relief = ReadElevation(whole.substr(0, size), "x.tif", WorldOptions(900, 10));
      // What the world does not lie on may be missing.
      if (relief.ok()) {
        EXPECT_EQ(relief->height_m, expected) << option << " cut to " << size;
      } else {
        EXPECT_EQ(relief.status().code(), StatusCode::kInvalidArgument);
      }
    }
    ExpectRefused(whole.substr(0, whole.size() / 2), {"cut off or damaged"}, WorldOptions(900, 10));
  }
}

TEST(ElevationTest, SurvivesDamagedBytes) {
  TiffSpec spec;
  spec.cols = spec.rows = 40;
  spec.creation = {"COMPRESS=DEFLATE"};
  const std::string whole = WriteTiff(spec);
  int refused = 0;
  for (std::size_t at = 0; at < whole.size(); ++at) {
    for (const int flip : {0x01, 0x80, 0xff}) {
      std::string damaged = whole;
      damaged[at] = static_cast<char>(damaged[at] ^ flip);
      const auto relief = ReadElevation(damaged, "x.tif", WorldOptions(200, 5));
      if (relief.ok()) continue;
      ++refused;
      EXPECT_FALSE(relief.status().message().empty());
    }
  }
  EXPECT_GT(refused, 0);
}

TEST(ElevationTest, RefusesHostileSizesBeforeSamplesAreRead) {
  const auto sparse = [](int cols, int rows, const std::vector<std::string>& creation) {
    TiffSpec empty;
    CPLStringList options;
    for (const std::string& option : creation) options.AddString(option.c_str());
    GDALRegister_GTiff();
    constexpr char kName[] = "/vsimem/elevation_sparse.tif";
    GDALDatasetH file =
        GDALCreate(GDALGetDriverByName("GTiff"), kName, cols, rows, 1, GDT_Float32, options.List());
    GDALSetGeoTransform(file, empty.transform.data());
    OGRSpatialReferenceH crs = OSRNewSpatialReference(nullptr);
    OSRSetFromUserInput(crs, empty.crs.c_str());
    GDALSetSpatialRef(file, crs);
    OSRDestroySpatialReference(crs);
    GDALClose(file);
    return TakeMemoryFile(kName);
  };
  const std::vector<std::string> tiled = {"SPARSE_OK=YES", "TILED=YES", "COMPRESS=DEFLATE",
                                          "BIGTIFF=YES"};
  ExpectRefused(sparse(70000, 100, tiled), {"70000 x 100", "2 to 65536"});
  ExpectRefused(sparse(100, 1, tiled), {"100 x 1 samples"});
  // Large, but only what the world lies on is read.
  ExpectLand(ReadRelief(sparse(60000, 60000, tiled), OptionsAt(39.0, -104.5, WorldOptions(512, 4))),
             512, 0.0, [](double, double) { return 0.0; });
  // A strip that swells to gigabytes.
  ExpectRefused(sparse(40000, 40000, {"SPARSE_OK=YES", "COMPRESS=DEFLATE", "BLOCKYSIZE=40000"}),
                {"blocks of 40000 x 40000", "at most 268435456"});
  ExpectRefused(sparse(40000, 40000,
                       {"SPARSE_OK=YES", "TILED=YES", "COMPRESS=DEFLATE", "BLOCKXSIZE=16384",
                        "BLOCKYSIZE=16384"}),
                {"blocks of 16384 x 16384"});
}

TEST(ElevationTest, NamesEveryIllegalOption) {
  ElevationOptions options = OptionsAt(91.0, std::nan(""), WorldOptions(1e6, 0.0));
  const auto relief = ReadElevation(WriteTiff(TiffSpec()), "x.tif", options);
  ASSERT_FALSE(relief.ok());
  EXPECT_EQ(relief.status().violations().size(), 4u) << relief.status().ToString();
  options.centered = true;
  EXPECT_EQ(Validate(options).size(), 2u);
  EXPECT_TRUE(Validate(ElevationOptions()).empty());
}

TEST(ElevationTest, IsTheSameEveryTimeAndFromManyThreads) {
  TiffSpec spec;
  spec.land = [](double x, double y) {
    return x < 500300 ? -9999.0 : 50 * std::sin(x / 40.0) * std::cos(y / 70.0);
  };
  const std::string good = WriteTiff(spec);
  const std::string bad = good.substr(0, good.size() / 2);
  const Relief expected = ReadRelief(good, WorldOptions(900, 2));
  std::vector<std::thread> threads;
  std::array<bool, 8> same{};
  for (std::size_t i = 0; i < same.size(); ++i) {
    threads.emplace_back([&, i] {
      bool all = true;
      for (int k = 0; k < 5; ++k) {
        const auto relief = ReadElevation(good, "x.tif", WorldOptions(900, 2));
        all = all && relief.ok() && relief->height_m == expected.height_m &&
              relief->caption == expected.caption &&
              !ReadElevation(bad, "x.tif", WorldOptions(900, 2)).ok();
      }
      same[i] = all;
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const bool one : same) EXPECT_TRUE(one);
}

TEST(ElevationTest, LeavesNothingBehindAndSaysNothingOnTheSide) {
  const std::string good = WriteTiff(TiffSpec());
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  static_cast<void>(ReadElevation(good, "x.tif", WorldOptions(512, 4)));
  for (std::size_t size = 0; size < good.size(); size += 1 + good.size() / 23) {
    static_cast<void>(ReadElevation(good.substr(0, size), "x.tif", WorldOptions(512, 4)));
  }
  static_cast<void>(ReadElevation(good, "x.tif", OptionsAt(-39.7, 75.0, WorldOptions(512, 4))));
  static_cast<void>(ReadElevation("II*", "x.tif", WorldOptions(512, 4)));
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  char** left = VSIReadDirRecursive("/vsimem/");
  for (char** name = left; name != nullptr && *name != nullptr; ++name) {
    EXPECT_EQ(std::string(*name).find("data."), std::string::npos) << *name;
  }
  CSLDestroy(left);
}

}  // namespace
}  // namespace latticeworld
