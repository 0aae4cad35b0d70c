#include "latticeworld/relief/elevation/elevation.h"

#include <cpl_error.h>
#include <cpl_string.h>
#include <cpl_vsi.h>
#include <gdal.h>
#include <gdal_frmts.h>
#include <gtest/gtest.h>
#include <ogr_srs_api.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

// A height field in the coordinates of the data.
using Land = std::function<double(double x, double y)>;

// A GeoTIFF that the test writes with GDAL.
struct TiffSpec {
  int cols = 100;
  int rows = 100;
  int bands = 1;
  GDALDataType type = GDT_Float32;
  std::array<double, 6> transform = {500000, 10, 0, 4400000, 0, -10};
  bool has_transform = true;
  std::string crs = "EPSG:32613";  // UTM, zone 13 north: its middle meridian is 105 degrees west
  std::vector<std::string> creation = {};
  std::string unit = "";
  double scale = 1.0;
  double offset = 0.0;
  double no_data = kNan;
  Land land = [](double, double) { return 100.0; };
  std::function<void(GDALDatasetH)> finish = [](GDALDatasetH) {};
};

std::string TakeMemoryFile(const char* name) {
  vsi_l_offset size = 0;
  GByte* data = VSIGetMemFileBuffer(name, &size, FALSE);
  std::string bytes(reinterpret_cast<char*>(data), size);
  VSIUnlink(name);
  return bytes;
}

std::string WriteTiff(const TiffSpec& spec) {
  GDALRegister_GTiff();
  constexpr char kName[] = "/vsimem/elevation_test.tif";
  CPLStringList creation;
  for (const std::string& option : spec.creation) creation.AddString(option.c_str());
  GDALDatasetH file = GDALCreate(GDALGetDriverByName("GTiff"), kName, spec.cols, spec.rows,
                                 spec.bands, spec.type, creation.List());
  const std::array<double, 6>& t = spec.transform;
  if (spec.has_transform) GDALSetGeoTransform(file, const_cast<double*>(t.data()));
  if (!spec.crs.empty()) {
    OGRSpatialReferenceH crs = OSRNewSpatialReference(nullptr);
    EXPECT_EQ(OSRSetFromUserInput(crs, spec.crs.c_str()), OGRERR_NONE) << spec.crs;
    GDALSetSpatialRef(file, crs);
    OSRDestroySpatialReference(crs);
  }
  for (int band = 1; band <= spec.bands; ++band) {
    GDALRasterBandH target = GDALGetRasterBand(file, band);
    if (!spec.unit.empty()) GDALSetRasterUnitType(target, spec.unit.c_str());
    if (spec.scale != 1.0) GDALSetRasterScale(target, spec.scale);
    if (spec.offset != 0.0) GDALSetRasterOffset(target, spec.offset);
    if (!std::isnan(spec.no_data)) GDALSetRasterNoDataValue(target, spec.no_data);
    std::vector<double> row(spec.cols);
    for (int r = 0; r < spec.rows; ++r) {
      for (int c = 0; c < spec.cols; ++c) {
        row[c] = spec.land(t[0] + t[1] * (c + 0.5) + t[2] * (r + 0.5),
                           t[3] + t[4] * (c + 0.5) + t[5] * (r + 0.5));
      }
      EXPECT_EQ(GDALRasterIO(target, GF_Write, 0, r, spec.cols, 1, row.data(), spec.cols, 1,
                             GDT_Float64, 0, 0),
                CE_None);
    }
  }
  spec.finish(file);
  GDALClose(file);
  return TakeMemoryFile(kName);
}

std::string WriteAscii(int cols, int rows, const std::string& rest_of_header, const Land& land) {
  std::string text =
      "ncols " + std::to_string(cols) + "\nnrows " + std::to_string(rows) + "\n" + rest_of_header;
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < cols; ++c) text += FormatDouble(land(c, r)) + " ";
    text += "\n";
  }
  return text;
}

// An SRTM tile: whole metres, big endian, the first row north.
std::string WriteSrtm(int cols, int rows, const std::function<int(int row, int col)>& land) {
  std::string bytes;
  bytes.reserve(std::size_t{2} * cols * rows);
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < cols; ++c) {
      const int value = land(r, c);
      bytes.push_back(static_cast<char>((value >> 8) & 0xff));
      bytes.push_back(static_cast<char>(value & 0xff));
    }
  }
  return bytes;
}

ElevationOptions Options(double size_m, double resolution_m) {
  ElevationOptions options;
  options.size_m = size_m;
  options.resolution_m = resolution_m;
  options.keep_altitude = true;
  return options;
}

ElevationOptions At(double latitude_deg, double longitude_deg, ElevationOptions options) {
  options.centered = false;
  options.latitude_deg = latitude_deg;
  options.longitude_deg = longitude_deg;
  return options;
}

// Reads it; fails the test when it is refused.
Relief Read(const std::string& bytes, const ElevationOptions& options,
            const std::string& name = "data.tif") {
  Result<Relief> relief = ReadElevation(bytes, name, options);
  EXPECT_TRUE(relief.ok()) << relief.status().ToString();
  if (!relief.ok()) return MakeRelief(Grid<float>(33, 33));
  for (const float height : relief->height_m) {
    if (!std::isfinite(height)) {
      ADD_FAILURE() << "a height is " << height;
      break;
    }
  }
  return *std::move(relief);
}

void ExpectRefused(const std::string& bytes, const std::vector<std::string>& words,
                   const ElevationOptions& options = Options(512, 4),
                   const std::string& name = "data.tif") {
  const Result<Relief> relief = ReadElevation(bytes, name, options);
  ASSERT_FALSE(relief.ok()) << "read what should be refused: " << words.front();
  EXPECT_EQ(relief.status().code(), StatusCode::kInvalidArgument) << relief.status().ToString();
  for (const std::string& word : words) {
    EXPECT_NE(relief.status().message().find(word), std::string::npos)
        << word << " | " << relief.status().message();
  }
  EXPECT_EQ(relief.status().message().find("/vsimem"), std::string::npos)
      << relief.status().message();
}

// The relief is that land, given in metres from the world's middle, everywhere.
void ExpectLand(const Relief& relief, double size_m, double tolerance_m, const Land& land) {
  const int rows = relief.height_m.rows(), cols = relief.height_m.cols();
  double worst_m = 0.0;
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < cols; ++c) {
      const double expected =
          land(((c + 0.5) / cols - 0.5) * size_m, (0.5 - (r + 0.5) / rows) * size_m);
      worst_m = std::max(worst_m, std::abs(relief.height_m(r, c) - expected));
    }
  }
  EXPECT_LE(worst_m, tolerance_m);
}

// Metres a degree of latitude and of longitude on the WGS 84 ellipsoid.
struct DegreeLengths {
  double latitude_m;
  double longitude_m;
};
DegreeLengths DegreesAt(double latitude_deg) {
  constexpr double kA = 6378137.0, kE2 = 0.00669437999014;
  const double s = std::sin(latitude_deg * kPi / 180.0);
  const double w = std::sqrt(1.0 - kE2 * s * s);
  return {kPi / 180.0 * kA * (1.0 - kE2) / (w * w * w),
          kPi / 180.0 * kA / w * std::cos(latitude_deg * kPi / 180.0)};
}

TEST(ElevationTest, ATiltedPlaneInUtmKeepsItsHeightsSlopeAndPlace) {
  TiffSpec spec;
  // Around (500500, 4399500), on the middle meridian of zone 13, where UTM's scale is 0.9996.
  spec.land = [](double x, double y) { return 2000 + 0.1 * (x - 500500) - 0.25 * (y - 4399500); };
  spec.transform = {500000, 10, 0, 4400000, 0, -10};
  const std::string bytes = WriteTiff(spec);
  for (const double resolution_m : {0.5, 4.0, 10.0, 16.0}) {
    const Relief relief = Read(bytes, Options(800, resolution_m));
    ExpectLand(relief, 800, 0.03, [](double east_m, double north_m) {
      return 2000 + 0.9996 * (0.1 * east_m - 0.25 * north_m);
    });
    EXPECT_TRUE(relief.warnings.empty());
    ASSERT_TRUE(relief.geo.has_value());
    EXPECT_EQ(relief.geo->altitude_m, 0.0);
    // 500 m east of the middle meridian.
    EXPECT_NEAR((relief.geo->longitude_deg + 105.0) * DegreesAt(39.74).longitude_m, 500 / 0.9996,
                1.0);
  }
}

TEST(ElevationTest, HasNoMoreSamplesThanTheWorldOrTwiceTheDataCarry) {
  const std::string bytes = WriteTiff(TiffSpec());
  EXPECT_EQ(Read(bytes, Options(800, 0.5)).height_m.rows(), 160);  // the data: 10 m
  EXPECT_EQ(Read(bytes, Options(800, 16.0)).height_m.rows(), 50);  // the world
  EXPECT_EQ(Read(bytes, Options(64, 0.1)).height_m.rows(), 33);    // the least that a relief has
}

TEST(ElevationTest, ATiltedPlaneInDegreesBecomesMetres) {
  // 1 arc second around 40.5 north, 105.25 west, as SRTM has it.
  constexpr double kStep = 1.0 / 3600.0;
  TiffSpec spec;
  spec.cols = 200, spec.rows = 160;
  spec.crs = "EPSG:4326";
  spec.transform = {-105.25 - 100 * kStep, kStep, 0, 40.5 + 80 * kStep, 0, -kStep};
  const DegreeLengths degree = DegreesAt(40.5);
  spec.land = [&](double lon, double lat) {
    return 1500 + 0.2 * (lat - 40.5) * degree.latitude_m -
           0.1 * (lon + 105.25) * degree.longitude_m;
  };
  const Relief relief = Read(WriteTiff(spec), Options(4000, 10));
  ExpectLand(relief, 4000, 0.15,
             [](double east_m, double north_m) { return 1500 + 0.2 * north_m - 0.1 * east_m; });
  ASSERT_TRUE(relief.geo.has_value());
  EXPECT_NEAR(relief.geo->latitude_deg, 40.5, 1e-6);
  EXPECT_NEAR(relief.geo->longitude_deg, -105.25, 1e-6);
}

TEST(ElevationTest, FindsAPlaceByItsLatitudeAndLongitude) {
  TiffSpec spec;
  spec.cols = 200, spec.rows = 160;
  spec.crs = "EPSG:4326";
  spec.transform = {10.0, 0.0005, 0, 47.0, 0, -0.0005};
  const DegreeLengths degree = DegreesAt(46.95);
  spec.land = [&](double lon, double) { return (lon - 10.0) * degree.longitude_m; };
  const Relief relief = Read(WriteTiff(spec), At(46.95, 10.03, Options(1024, 8)));
  // East of the western edge by 0.03 degrees.
  const double there_m = 0.03 * degree.longitude_m;
  ExpectLand(relief, 1024, 0.6, [&](double east_m, double) { return there_m + east_m; });
  ASSERT_TRUE(relief.geo.has_value());
  EXPECT_NEAR(relief.geo->latitude_deg, 46.95, 1e-9);
  EXPECT_NEAR(relief.geo->longitude_deg, 10.03, 1e-9);
}

TEST(ElevationTest, ConvertsFeetOfPlaceAndOfHeight) {
  // Colorado north in US survey feet; heights once in metres, once in feet.
  constexpr double kFoot = 1200.0 / 3937.0;
  TiffSpec spec;
  spec.crs = "EPSG:2231";
  spec.transform = {3000000, 20, 0, 1300000, 0, -20};
  spec.land = [](double x, double) { return 5000.0 + 0.1 * (x - 3001000); };
  spec.unit = "US survey foot";
  // The middle meridian is 105.5 degrees west at x = 3,000,000 feet: north is up within 0.001.
  ExpectLand(Read(WriteTiff(spec), Options(400, 4)), 400, 0.05,
             [](double east_m, double) { return 5000.0 * kFoot + 0.1 * east_m; });
  spec.unit = "m";
  ExpectLand(Read(WriteTiff(spec), Options(400, 4)), 400, 0.15,
             [](double east_m, double) { return 5000.0 + 0.1 * east_m / kFoot; });
  spec.unit = "ft";
  ExpectLand(Read(WriteTiff(spec), Options(400, 4)), 400, 0.05,
             [](double east_m, double) { return 0.3048 * (5000.0 + 0.1 * east_m / kFoot); });
  spec.unit = "";
  spec.crs = "EPSG:2231+6360";  // heights by the vertical system: NAVD 88 in US survey feet
  ExpectLand(Read(WriteTiff(spec), Options(400, 4)), 400, 0.05,
             [](double east_m, double) { return 5000.0 * kFoot + 0.1 * east_m; });
  spec.crs = "EPSG:2231";
  spec.unit = "fathom";
  ExpectRefused(WriteTiff(spec), {"fathom", "US survey foot"}, Options(400, 4));
}

TEST(ElevationTest, AppliesScaleAndOffsetOfWholeNumbers) {
  TiffSpec spec;
  spec.type = GDT_Int16;
  spec.scale = 0.1;
  spec.offset = 500.0;
  spec.land = [](double x, double) { return std::round(x - 500500); };
  const Relief relief = Read(WriteTiff(spec), Options(800, 10));
  ExpectLand(relief, 800, 0.06,
             [](double east_m, double) { return 500.0 + 0.1 * 0.9996 * east_m; });
  EXPECT_NEAR(relief.height_step_m, 0.1, 1e-12) << "so that terraces are smoothed";
  EXPECT_EQ(Read(WriteTiff(spec), Options(800, 16)).height_step_m, 0.0) << "means of two samples";
  spec.type = GDT_Float32;
  EXPECT_EQ(Read(WriteTiff(spec), Options(800, 10)).height_step_m, 0.0);
}

TEST(ElevationTest, TurnsARotatedPictureNorthUp) {
  // Rows run to the south-west, columns to the south-east.
  const double side = 10.0, turn = 35.0 * kPi / 180.0;
  TiffSpec spec;
  spec.cols = spec.rows = 200;
  spec.transform = {500500,  side * std::cos(turn),  -side * std::sin(turn),
                    4399500, -side * std::sin(turn), -side * std::cos(turn)};
  spec.land = [](double x, double y) { return 800 + 0.3 * (y - 4399500) + 0.05 * (x - 500500); };
  const Relief relief = Read(WriteTiff(spec), Options(1000, 5));
  // The middle of the data, in the data's coordinates.
  const double x = 500500 + 100 * (spec.transform[1] + spec.transform[2]) - 500500;
  const double y = 100 * (spec.transform[4] + spec.transform[5]);
  ExpectLand(relief, 1000, 0.3, [&](double east_m, double north_m) {
    return 800 + 0.3 * (y + 0.9996 * north_m) + 0.05 * (x + 0.9996 * east_m);
  });
}

TEST(ElevationTest, TakesAveragesWhereTheWorldIsCoarser) {
  // Stripes of single samples: their mean is 50, whatever falls together along that direction.
  for (const bool columns : {false, true}) {
    TiffSpec spec;
    spec.cols = spec.rows = 600;
    spec.transform = {500000, 1, 0, 4400000, 0, -1};
    spec.land = [columns](double x, double y) {
      return static_cast<int>(std::floor(columns ? x : y)) % 2 == 0 ? 0.0 : 100.0;
    };
    ExpectLand(Read(WriteTiff(spec), Options(512, 8)), 512, 2.0,
               [](double, double) { return 50.0; });
  }
}

TEST(ElevationTest, LetsTheLowestBeZeroUnlessTheAltitudeIsKept) {
  TiffSpec spec;
  spec.land = [](double x, double) { return 1234.5 + 0.1 * (x - 500000); };
  ElevationOptions options = Options(400, 10);
  const Relief high = Read(WriteTiff(spec), options);
  options.keep_altitude = false;
  const Relief low = Read(WriteTiff(spec), options);
  ASSERT_TRUE(low.geo && high.geo);
  const float lowest_m = *std::min_element(high.height_m.begin(), high.height_m.end());
  EXPECT_NEAR(low.geo->altitude_m, lowest_m, 1e-3);
  EXPECT_EQ(*std::min_element(low.height_m.begin(), low.height_m.end()), 0.0f);
  for (int i = 0; i < 33; ++i) {
    EXPECT_NEAR(low.height_m(i, i) + low.geo->altitude_m, high.height_m(i, i), 1e-3);
  }
}

TEST(ElevationTest, FillsHolesFromAroundThem) {
  const Land plane = [](double x, double y) {
    return 300 + 0.2 * (x - 500500) + 0.1 * (y - 4399500);
  };
  // In the middle and at a corner of the world; every kind of nothing.
  for (const double nothing : {-9999.0, -32768.0, 1e30, -3.4e38, static_cast<double>(kNan),
                               static_cast<double>(INFINITY), -static_cast<double>(INFINITY)}) {
    for (const bool told : {false, true}) {
      if (told && !std::isfinite(nothing)) continue;
      TiffSpec spec;
      if (told) spec.no_data = nothing;
      spec.land = [&](double x, double y) {
        const bool hole =
            std::hypot(x - 500450, y - 4399550) < 120 || std::hypot(x - 500200, y - 4399200) < 60;
        return hole ? nothing : plane(x, y);
      };
      const Relief relief = Read(WriteTiff(spec), Options(600, 5));
      ExpectLand(relief, 600, 1.0, [](double east_m, double north_m) {
        return 300 + 0.9996 * (0.2 * east_m + 0.1 * north_m);
      });
      ASSERT_EQ(relief.warnings.size(), 1u);
      EXPECT_NE(relief.warnings[0].find("% of the elevation was no-data"), std::string::npos);
    }
  }
}

TEST(ElevationTest, AHoleInAPlaneIsFilledWithThePlane) {
  TiffSpec spec;
  spec.land = [](double x, double y) {
    return std::hypot(x - 500500, y - 4399500) < 150 ? -9999.0 : 300 + 0.2 * (x - 500500);
  };
  ExpectLand(Read(WriteTiff(spec), Options(600, 5)), 600, 0.1,
             [](double east_m, double) { return 300 + 0.9996 * 0.2 * east_m; });
}

TEST(ElevationTest, HonoursAnAlphaBand) {
  TiffSpec spec;
  spec.bands = 2;
  spec.type = GDT_UInt16;
  spec.creation = {"ALPHA=YES"};
  spec.land = [](double, double) { return 120.0; };
  spec.finish = [](GDALDatasetH file) {
    std::vector<std::uint16_t> height(100 * 100, 120), alpha(100 * 100, 65535);
    for (int i = 4000; i < 5000; ++i) height[i] = 8000, alpha[i] = 0;
    for (int band = 1; band <= 2; ++band) {
      ASSERT_EQ(GDALRasterIO(GDALGetRasterBand(file, band), GF_Write, 0, 0, 100, 100,
                             band == 1 ? height.data() : alpha.data(), 100, 100, GDT_UInt16, 0, 0),
                CE_None);
    }
  };
  ExpectLand(Read(WriteTiff(spec), Options(600, 5)), 600, 1e-3,
             [](double, double) { return 120.0; });
}

TEST(ElevationTest, RefusesNothingButNoData) {
  TiffSpec spec;
  spec.no_data = -5;
  spec.land = [](double, double) { return -5.0; };
  ExpectRefused(WriteTiff(spec), {"nothing but no-data"});
  spec.no_data = kNan;
  spec.land = [](double, double) { return kNan; };
  ExpectRefused(WriteTiff(spec), {"nothing but no-data"});
  spec.land = [](double, double) { return INFINITY; };
  ExpectRefused(WriteTiff(spec), {"nothing but no-data"});
  ExpectRefused(WriteSrtm(1201, 1201, [](int, int) { return -32768; }), {"nothing but no-data"},
                Options(512, 4), "N40W106.hgt");
}

TEST(ElevationTest, RefusesAWorldLargerThanTheDataAndNamesTheLargest) {
  TiffSpec spec;
  spec.rows = 60;  // 1000 m x 600 m
  const std::string bytes = WriteTiff(spec);
  ExpectRefused(bytes, {"1024 m", "100 x 60 samples", "1000 m x 600 m", "at most 600 m"},
                Options(1024, 4));
  EXPECT_TRUE(ReadElevation(bytes, "x.tif", Options(600, 4)).ok());
  // A place 200 m from the southern edge.
  const auto relief = ReadElevation(bytes, "x.tif", Options(200, 4));
  ASSERT_TRUE(relief.ok());
  const double south = relief->geo->latitude_deg - 101 / DegreesAt(39.7).latitude_m;
  ExpectRefused(bytes, {"at most 39"}, At(south, relief->geo->longitude_deg, Options(512, 4)));
}

TEST(ElevationTest, RefusesAPlaceOutsideTheData) {
  const std::string bytes = WriteTiff(TiffSpec());
  ExpectRefused(bytes,
                {"latitude 51.00000", "outside", "x 500000 to 501000", "middle at latitude 39.74"},
                At(51.0, 7.0, Options(64, 1)));
  // The other side of the earth cannot be projected at all.
  ExpectRefused(bytes, {"outside"}, At(-39.7, 75.0, Options(64, 1)));
}

TEST(ElevationTest, ReadsDegreesThatCountTo360) {
  TiffSpec spec;
  spec.crs = "EPSG:4326";
  spec.transform = {254.0, 0.001, 0, 40.0, 0, -0.001};
  const Relief relief = Read(WriteTiff(spec), At(39.95, -105.95, Options(512, 8)));
  ASSERT_TRUE(relief.geo.has_value());
  EXPECT_NEAR(relief.geo->longitude_deg, -105.95, 1e-9);
  EXPECT_NEAR(Read(WriteTiff(spec), Options(512, 8)).geo->longitude_deg, -105.95, 1e-6);
}

TEST(ElevationTest, ReadsAcrossTheDateLine) {
  TiffSpec spec;
  spec.crs = "EPSG:4326";
  spec.transform = {179.95, 0.001, 0, -16.95, 0, -0.001};
  const DegreeLengths degree = DegreesAt(-17.0);
  spec.land = [&](double lon, double) { return 50 + 0.01 * (lon - 180.0) * degree.longitude_m; };
  const Relief relief = Read(WriteTiff(spec), At(-17.0, -180.0, Options(4096, 16)));
  ExpectLand(relief, 4096, 0.1, [](double east_m, double) { return 50 + 0.01 * east_m; });
}

TEST(ElevationTest, ReadsSrtmTilesOfThreeResolutions) {
  for (const int side : {1201, 3601, 7201}) {
    const std::string bytes = WriteSrtm(
        side, side, [side](int row, int col) { return col * 1200 / (side - 1) + (row == 0); });
    // The samples stand on the lines of the degrees: the tile's middle is the middle sample.
    for (const char* name : {"N40W106.hgt", "n40w106.HGT", "a/b/N40W106.SRTMGL1.hgt"}) {
      const Relief relief = Read(bytes, Options(2048, 16), name);
      ASSERT_TRUE(relief.geo.has_value());
      EXPECT_NEAR(relief.geo->latitude_deg, 40.5, 1e-9);
      EXPECT_NEAR(relief.geo->longitude_deg, -105.5, 1e-9);
      const double slope = 1200.0 / DegreesAt(40.5).longitude_m;
      ExpectLand(relief, 2048, 1.2, [&](double east_m, double) { return 600 + slope * east_m; });
    }
    EXPECT_NEAR(Read(bytes, Options(2048, 16), "S01E000.hgt").geo->latitude_deg, -0.5, 1e-9);
    ExpectRefused(bytes, {"srtm.hgt", "N40W106.hgt"}, Options(512, 4), "srtm.hgt");
    ExpectRefused(bytes, {"N40W106.hgt"}, Options(512, 4), "N91W106.hgt");
    ExpectRefused(bytes, {"N40W106.hgt"}, Options(512, 4), "");
    ExpectRefused(bytes.substr(0, bytes.size() - 2), {"3601 x 3601", "1201 x 1201", "cut off"},
                  Options(512, 4), "N40W106.hgt");
  }
}

// Tiles of 1 arc second beyond 50 degrees: 1801 samples from west to east, 3601 from north to south
// (as GDAL 3.6.2's driver SRTMHGT knows them).
TEST(ElevationTest, ReadsSrtmTilesOfHighLatitudes) {
  const std::string bytes = WriteSrtm(1801, 3601, [](int, int col) { return col * 1200 / 1800; });
  const Relief relief = Read(bytes, Options(2048, 16), "N60E010.hgt");
  ASSERT_TRUE(relief.geo.has_value());
  EXPECT_NEAR(relief.geo->latitude_deg, 60.5, 1e-9);
  EXPECT_NEAR(relief.geo->longitude_deg, 10.5, 1e-9);
  const double slope = 1200.0 / DegreesAt(60.5).longitude_m;
  ExpectLand(relief, 2048, 1.5, [&](double east_m, double) { return 600 + slope * east_m; });
}

// No tile's edge, byte order or sign is a matter of chance: GDAL 3.6.2 reads the same tile.
TEST(ElevationTest, ReadsSrtmTilesAsGdalDoes) {
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
  const ElevationOptions place = At(-32.25, -70.75, Options(1024, 8));
  const Relief ours = Read(bytes, place, "S33W071.hgt"), theirs = Read(tiff, place);
  ASSERT_EQ(ours.height_m.rows(), theirs.height_m.rows());
  EXPECT_TRUE(std::equal(ours.height_m.begin(), ours.height_m.end(), theirs.height_m.begin()));
}

TEST(ElevationTest, FillsTheVoidsOfSrtm) {
  const std::string bytes = WriteSrtm(1201, 1201, [](int row, int col) {
    return std::abs(row - 600) < 5 && std::abs(col - 600) < 9 ? -32768 : 700;
  });
  ExpectLand(Read(bytes, Options(2048, 16), "N40W106.hgt"), 2048, 0.01,
             [](double, double) { return 700.0; });
}

TEST(ElevationTest, ReadsArcAsciiGridsInMetresAndInDegrees) {
  const Land east = [](double col, double) { return 10 + col; };
  const Relief metric = Read(
      WriteAscii(100, 80, "xllcorner 0.0\nyllcorner 0.0\ncellsize 5\n", east), Options(350, 5));
  ExpectLand(metric, 350, 0.01, [](double east_m, double) { return 10 + 49.5 + east_m / 5.0; });
  EXPECT_FALSE(metric.geo.has_value());
  ASSERT_EQ(metric.warnings.size(), 1u);
  EXPECT_NE(metric.warnings[0].find("taken for metres"), std::string::npos);

  const Relief degrees =
      Read(WriteAscii(100, 80,
                      "XLLCORNER -105.05\nYLLCORNER 40.0\nCELLSIZE 0.001\nNODATA_value 0\n", east),
           Options(2000, 10));
  ASSERT_TRUE(degrees.geo.has_value());
  EXPECT_NEAR(degrees.geo->longitude_deg, -105.0, 1e-6);
  EXPECT_NEAR(degrees.geo->latitude_deg, 40.04, 1e-6);
  const double a_sample_m = 0.001 * DegreesAt(40.04).longitude_m;
  ExpectLand(degrees, 2000, 0.05,
             [&](double east_m, double) { return 10 + 49.5 + east_m / a_sample_m; });
  ASSERT_EQ(degrees.warnings.size(), 1u);
  EXPECT_NE(degrees.warnings[0].find("taken for degrees"), std::string::npos);

  ExpectRefused(WriteAscii(100, 80, "xllcorner 0\nyllcorner 0\ncellsize 5\n", east),
                {"no coordinate system", "middle"}, At(40.0, -105.0, Options(100, 1)));
}

TEST(ElevationTest, AnArcAsciiGridMayBeginWithAnyOfItsKeys) {
  const std::string given[] = {"ncols 60", "NROWS 60",  "xllcorner 500",   "yllcorner 500", "DX 5",
                               "dy\t5",    "nodata -1", "xllcenter 502.5", "yllcenter 500"};
  const auto grid_of = [](std::vector<std::string> lines, std::size_t first) {
    std::rotate(lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(first), lines.end());
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    for (int i = 0; i < 60 * 60; ++i) text += std::to_string(459 + i % 60) + " ";
    return text;
  };
  const std::vector<std::string> corners(given, given + 7);
  std::vector<std::string> centers(given + 4, given + 9);
  centers.insert(centers.end(), given, given + 2);
  for (const auto& lines : {corners, centers}) {
    for (std::size_t first = 0; first < lines.size(); ++first) {
      SCOPED_TRACE(lines[first]);
      ExpectLand(Read(grid_of(lines, first), Options(200, 5)), 200, 0.01,
                 [](double east_m, double) { return 459 + 29.5 + east_m / 5.0; });
    }
  }
  ExpectRefused("dxf drawing", {"\"dxf draw\"", "Arc/Info ASCII grid"});
}

TEST(ElevationTest, RefusesArcAsciiGridsThatAreNotWhole) {
  const std::string place = "xllcorner 0\nyllcorner 0\ncellsize 5\n";
  const std::string whole = WriteAscii(40, 40, place, [](double c, double) { return c; });
  ASSERT_TRUE(ReadElevation(whole, "", Options(100, 1)).ok());
  ExpectRefused(whole.substr(0, whole.size() / 2), {"1600 numbers", "cut off"});
  ExpectRefused(whole + "7", {"1600 numbers", "more"});
  std::string wrong = whole;
  wrong.replace(wrong.rfind("39"), 2, "ox");
  ExpectRefused(wrong, {"\"ox\"", "number 1600"});
  ExpectRefused("ncols 40\nnrows\n", {"nrows"});
  ExpectRefused("ncols 40\n" + place, {"no nrows"});
  ExpectRefused("ncols 1e9\nnrows 40\n" + place + "1 2 3", {"1e9"});
  ExpectRefused("ncols 999999999\nnrows 999999999\n" + place + "1 2 3", {"999999999", "65536"});
  ExpectRefused("ncols 60000\nnrows 60000\n" + place + "1 2 3", {"3600000000", "3: it is cut off"});
  ExpectRefused("ncols 1\nnrows 40\n" + place, {"1 x 40", "2 to 65536"});
  ExpectRefused("ncols", {"ncols"});
}

TEST(ElevationTest, WholeNumbersOfAnArcAsciiGridKeepTheirHeightsBesideWordsForNoData) {
  const auto written = [](const std::string& nothing, const std::string& no_data) {
    std::string text = "ncols 60\nnrows 60\nxllcorner 500\nyllcorner 500\ncellsize 5\n" + no_data;
    for (int r = 0; r < 60; ++r) {
      for (int c = 0; c < 60; ++c) {
        // Lines that begin with it, and a hole in the middle.
        const bool hole = (c == 0 && r % 3 == 0) || (std::abs(r - 30) < 3 && std::abs(c - 30) < 3);
        text += (hole ? nothing : std::to_string(459 + c)) + (c == 59 ? "\n" : " ");
      }
    }
    return text;
  };
  for (const char* nothing : {"nan", "NaN", "-nan", "inf", "-inf", "Infinity", "null", "NULL",
                              "-1.#IND", "-9999", "-9999.000", "1e39", "-32768"}) {
    SCOPED_TRACE(nothing);
    const Relief relief = Read(written(nothing, ""), Options(250, 5));
    ExpectLand(relief, 250, 0.1, [](double east_m, double) { return 488.5 + east_m / 5.0; });
    EXPECT_EQ(relief.height_step_m, 1.0) << "so that terraces are smoothed";
    ASSERT_EQ(relief.warnings.size(), 2u);
    EXPECT_NE(relief.warnings[1].find("% of the elevation was no-data"), std::string::npos);
  }
  // What the file declares, a height of the earth or a word; beside other words.
  for (const char* no_data : {"NODATA_value -5\n", "NODATA_value -5.0\n", "nodata -5\n"}) {
    ExpectLand(Read(written("-5", no_data), Options(250, 5)), 250, 0.1,
               [](double east_m, double) { return 488.5 + east_m / 5.0; });
  }
  for (const char* no_data : {"NODATA_value nan\n", "NODATA_value NULL\n", "NODATA_value -5\n"}) {
    ExpectLand(Read(written("nan", no_data), Options(250, 5)), 250, 0.1,
               [](double east_m, double) { return 488.5 + east_m / 5.0; });
  }
  ExpectRefused(written("none", ""), {"\"none\" in place of number", "nan, inf or null"});
  ExpectRefused(written("nan", "NODATA_value none\n"), {"\"none\"", "a number, null or nan"});
}

TEST(ElevationTest, AnArcAsciiGridSaysForBothAxesWhereItLies) {
  const auto refused = [](const std::string& header, const std::vector<std::string>& words) {
    SCOPED_TRACE(header);
    ExpectRefused(WriteAscii(40, 40, header, [](double c, double) { return c; }), words,
                  Options(100, 1));
  };
  const std::string legal = "legal are xllcorner with yllcorner, or xllcenter with yllcenter";
  refused("xllcorner 10\nyllcenter 20\ncellsize 5\n", {"has xllcorner, yllcenter in", legal});
  refused("xllcenter 10\nyllcorner 20\ncellsize 5\n", {"has xllcenter, yllcorner in", legal});
  refused("xllcorner 10\ncellsize 5\n", {"has xllcorner in", legal});
  refused("yllcenter 10\ncellsize 5\n", {"has yllcenter in", legal});
  refused("cellsize 5\n", {"neither a corner nor a center", legal});
  refused("xllcorner 1\nyllcorner 2\nxllcenter 3\nyllcenter 4\ncellsize 5\n",
          {"xllcorner, xllcenter, yllcorner, yllcenter", legal});
  refused("xllcorner 1\nxllcorner 1\nyllcorner 2\ncellsize 5\n", {"has xllcorner twice"});
  refused("xllcorner inf\nyllcorner 2\ncellsize 5\n", {"\"xllcorner\" \"inf\""});
  const std::string place = "xllcorner 1\nyllcorner 2\n";
  refused(place, {"has no cellsize", "legal is cellsize, or dx with dy"});
  refused(place + "dx 5\n", {"has dx in", "dx with dy"});
  refused(place + "cellsize 5\ndx 5\ndy 5\n", {"has cellsize, dx, dy in", "dx with dy"});
  refused(place + "cellsize 0\n", {"cellsize 0", "above 0"});
  refused(place + "dx 5\ndy -5\n", {"dy -5", "above 0"});
}

TEST(ElevationTest, CentersOfAnArcAsciiGridLieHalfACellWithinItsCorner) {
  const Land east = [](double col, double) { return 10 + 3 * col; };
  const Relief corner =
      Read(WriteAscii(100, 200, "xllcorner -105.05\nyllcorner 40\ndx 0.001\ndy 0.0005\n", east),
           Options(2000, 10));
  const Relief center = Read(
      WriteAscii(100, 200, "DX 0.001\nDY 0.0005\nXLLCENTER -105.0495\nYLLCENTER 40.00025\n", east),
      Options(2000, 10));
  ASSERT_TRUE(corner.geo && center.geo);
  EXPECT_NEAR(corner.geo->longitude_deg, -105.0, 1e-9);
  EXPECT_NEAR(corner.geo->latitude_deg, 40.05, 1e-9);
  EXPECT_NEAR(center.geo->longitude_deg, -105.0, 1e-9);
  EXPECT_NEAR(center.geo->latitude_deg, 40.05, 1e-9);
  const double a_sample_m = 0.001 * DegreesAt(40.05).longitude_m;
  ExpectLand(center, 2000, 0.1,
             [&](double east_m, double) { return 10 + 3 * (49.5 + east_m / a_sample_m); });
}

TEST(ElevationTest, DecimalCommasAreReadAsPointsWhereThereAreNoPoints) {
  const std::string points =
      WriteAscii(60, 60, "xllcorner 500.5\nyllcorner 700\ncellsize 2.5\nNODATA_value -9999\n",
                 [](double c, double r) { return 200 + 0.25 * c - 0.5 * r; });
  std::string commas = points;
  std::replace(commas.begin(), commas.end(), '.', ',');
  const Relief relief = Read(commas, Options(100, 2.5));
  EXPECT_EQ(relief.height_m, Read(points, Options(100, 2.5)).height_m);
  EXPECT_EQ(relief.height_step_m, 0.0);
  EXPECT_NE(relief.warnings[0].find("decimal commas"), std::string::npos) << relief.warnings[0];
  // Nobody knows what both mean, or more than one in a number.
  std::string mixed = commas;
  mixed.replace(mixed.find("500,5"), 5, "500.5");
  ExpectRefused(mixed, {"decimal points (\"500.5\")", "decimal commas (\"2,5\")", "throughout"});
  const std::string header = "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 5\n";
  ExpectRefused(header + "1 2 3 1,234,567", {"\"1,234,567\"", "number 4"});
  ExpectRefused(header + "1, 2, 3, 4", {"\"1,\"", "number 1"});
  ExpectRefused(header + "1 2 3 1.234,5", {"\"1.234,5\"", "number 4"});
}

TEST(ElevationTest, NamesKeysOfAnArcAsciiGridThatItDoesNotKnow) {
  const Relief relief =
      Read(WriteAscii(60, 60, "xllcorner 500\nyllcorner 700\ncellsize 5\nzfactor 3\n",
                      [](double c, double) { return c; }),
           Options(100, 5));
  ASSERT_EQ(relief.warnings.size(), 2u);
  EXPECT_NE(relief.warnings[0].find("\"zfactor\" 3"), std::string::npos) << relief.warnings[0];
}

// A grid whose heights rise evenly from 459 m by that much.
std::string RisingGrid(int side, const std::string& place, double cell, double rise_m) {
  return WriteAscii(side, side, place + "cellsize " + FormatDouble(cell) + "\n",
                    [&](double c, double) { return 459.0 + rise_m * c / (side - 1); });
}

TEST(ElevationTest, HeightsTellSurveysInCentimetresFromDegrees) {
  // 400 cells of 5 cm, which rise by 3 m: as degrees they would span 2000 km.
  for (const char* place : {"xllcorner 0\nyllcorner 0\n", "xllcorner 10\nyllcorner 20\n",
                            "xllcenter 3.5\nyllcenter -2.25\n"}) {
    SCOPED_TRACE(place);
    const Relief survey = Read(RisingGrid(400, place, 0.05, 3.0), Options(16, 0.5));
    EXPECT_FALSE(survey.geo.has_value());
    ExpectLand(survey, 16, 0.02, [](double east_m, double) { return 460.5 + 3.0 / 20 * east_m; });
    ASSERT_EQ(survey.warnings.size(), 1u);
    for (const char* word : {"taken for metres", "cells of 0.05 x 0.05", "20 x 20 in all",
                             "differ by 3 m", "elevation unit degrees", "--elevation-unit"}) {
      EXPECT_NE(survey.warnings[0].find(word), std::string::npos) << survey.warnings[0];
    }
    // Where they rise by 2500 m they are no survey.
    EXPECT_TRUE(Read(RisingGrid(400, place, 0.05, 2500.0), Options(4096, 16)).geo.has_value());
  }
  // Level ground says nothing.
  EXPECT_FALSE(Read(RisingGrid(400, "xllcorner 0\nyllcorner 0\n", 0.05, 0.0), Options(16, 0.5))
                   .geo.has_value());
  EXPECT_TRUE(Read(RisingGrid(400, "xllcorner 7\nyllcorner 50\n", 0.05, 0.0), Options(16, 0.5))
                  .geo.has_value());
}

TEST(ElevationTest, CellsOfAHundredThousandthAreDegreesAndTheWarningSaysHowLargeTheyAre) {
  for (const char* place : {"xllcorner 11.5\nyllcorner 48.1\n", "xllcorner 0\nyllcorner 0\n"}) {
    const Relief relief = Read(RisingGrid(300, place, 0.00001, 0.002), Options(100, 1));
    ASSERT_TRUE(relief.geo.has_value()) << place;
    ASSERT_EQ(relief.warnings.size(), 1u);
    for (const char* word :
         {"taken for degrees", "about 1.1 m", "elevation unit metres", "--elevation-unit"}) {
      EXPECT_NE(relief.warnings[0].find(word), std::string::npos) << relief.warnings[0];
    }
  }
}

TEST(ElevationTest, TheUnitThatIsAskedForCountsWhateverTheNumbersSay) {
  const std::string survey = RisingGrid(400, "xllcorner 10\nyllcorner 20\n", 0.05, 3.0);
  ElevationOptions options = Options(16, 0.5);
  options.unit = ElevationUnit::kDegrees;
  const Relief degrees = Read(survey, options);
  ASSERT_TRUE(degrees.geo.has_value());
  EXPECT_NEAR(degrees.geo->latitude_deg, 30.0, 1e-6);
  EXPECT_TRUE(degrees.warnings.empty());
  options.unit = ElevationUnit::kMetres;
  const std::string steep = RisingGrid(400, "xllcorner 10\nyllcorner 20\n", 0.05, 2500.0);
  const Relief metres = Read(steep, options);
  EXPECT_FALSE(metres.geo.has_value());
  EXPECT_TRUE(metres.warnings.empty());
  options.unit = ElevationUnit::kDegrees;
  ExpectRefused(RisingGrid(40, "xllcorner 5000\nyllcorner 20\n", 5.0, 3.0),
                {"said to be in degrees", "-180 to 360"}, options);
}

TEST(ElevationTest, ARefusalSaysHowTheCoordinatesWereTaken) {
  ExpectRefused(RisingGrid(400, "xllcorner 10\nyllcorner 20\n", 0.05, 3.0),
                {"legal is a size of at most", "taken for metres", "--elevation-unit"});
}

TEST(ElevationTest, RefusesGeoTiffsThatAreNoPlaceOnTheEarth) {
  TiffSpec spec;
  spec.has_transform = false;
  spec.crs = "";
  ExpectRefused(WriteTiff(spec), {"no georeference", "height map"});
  spec.crs = "EPSG:32613";
  ExpectRefused(WriteTiff(spec), {"no georeference"});
  spec.has_transform = true;
  spec.crs = "";
  ExpectRefused(WriteTiff(spec), {"no coordinate system", "-a_srs"});
  spec.crs = "LOCAL_CS[\"a field\",UNIT[\"metre\",1]]";
  ExpectRefused(WriteTiff(spec), {"a field", "geographic", "projected"});
  spec.crs = "EPSG:32613";
  spec.transform = {500000, 0, 0, 4400000, 0, -10};
  ExpectRefused(WriteTiff(spec), {"georeference"});
  spec.transform = {500000, kNan, 0, 4400000, 0, -10};
  ExpectRefused(WriteTiff(spec), {"georeference"});
  spec.transform = {500000, 1e-9, 0, 4400000, 0, -1e-9};
  ExpectRefused(WriteTiff(spec), {"m large"});
  spec.transform = {1e30, 10, 0, -1e30, 0, -10};  // nowhere near zone 13
  ExpectRefused(WriteTiff(spec), {"elevation"});
  spec.crs = "EPSG:4326";
  spec.transform = {0, 0.001, 0, 4400000, 0, -0.001};  // metres called degrees
  ExpectRefused(WriteTiff(spec), {"elevation"});
}

TEST(ElevationTest, RefusesPicturesAndComplexNumbers) {
  TiffSpec spec;
  spec.type = GDT_Byte;
  spec.bands = 3;
  ExpectRefused(WriteTiff(spec), {"3 bands", "one band"});
  spec.bands = 4;
  ExpectRefused(WriteTiff(spec), {"4 bands"});
  spec.bands = 1;
  spec.finish = [](GDALDatasetH file) {
    GDALColorTableH colors = GDALCreateColorTable(GPI_RGB);
    const GDALColorEntry red = {255, 0, 0, 255};
    GDALSetColorEntry(colors, 1, &red);
    GDALSetRasterColorTable(GDALGetRasterBand(file, 1), colors);
    GDALDestroyColorTable(colors);
  };
  ExpectRefused(WriteTiff(spec), {"palette"});
  spec.finish = [](GDALDatasetH) {};
  for (const GDALDataType type : {GDT_CInt16, GDT_CFloat32, GDT_CFloat64}) {
    spec.type = type;
    ExpectRefused(WriteTiff(spec), {"complex"});
  }
}

TEST(ElevationTest, ReadsEveryKindOfSampleAndCompression) {
  for (const GDALDataType type :
       {GDT_Byte, GDT_UInt16, GDT_Int16, GDT_UInt32, GDT_Int32, GDT_Float32, GDT_Float64}) {
    for (const char* option : {"COMPRESS=NONE", "COMPRESS=DEFLATE", "COMPRESS=LZW", "TILED=YES",
                               "BIGTIFF=YES", "ENDIANNESS=BIG", "INTERLEAVE=BAND"}) {
      TiffSpec spec;
      spec.type = type;
      spec.creation = {option};
      spec.land = [](double x, double) { return std::round(0.1 * (x - 500000)); };
      ExpectLand(Read(WriteTiff(spec), Options(640, 8)), 640, 0.6,
                 [](double east_m, double) { return 50.0 + 0.1 * 0.9996 * east_m; });
    }
  }
}

TEST(ElevationTest, RefusesWhatIsNoElevation) {
  ExpectRefused("", {"empty"});
  ExpectRefused("this is a text", {"this is", "GeoTIFF", ".hgt"});
  ExpectRefused(std::string("PK\x03\x04 zipped"), {"ZIP"}, Options(512, 4), "N40W106.hgt.zip");
  ExpectRefused("<VRTDataset rasterXSize=\"20\" rasterYSize=\"20\"></VRTDataset>", {"virtual"});
  ExpectRefused("<GDAL_WMS><Service name=\"TMS\"></Service></GDAL_WMS>", {"XML"});
}

TEST(ElevationTest, RefusesFilesThatAreCutOff) {
  TiffSpec spec;
  spec.land = [](double x, double y) { return std::fmod(x + 7 * y, 311.0); };
  for (const char* option : {"COMPRESS=NONE", "COMPRESS=DEFLATE"}) {
    spec.creation = {option};
    const std::string whole = WriteTiff(spec);
    const Grid<float> expected = Read(whole, Options(900, 10)).height_m;
    for (std::size_t size = 0; size < whole.size(); size += 1 + whole.size() / 61) {
      const auto relief = ReadElevation(whole.substr(0, size), "x.tif", Options(900, 10));
      // What the world does not lie on may be missing.
      if (relief.ok()) {
        EXPECT_EQ(relief->height_m, expected) << option << " cut to " << size;
      } else {
        EXPECT_EQ(relief.status().code(), StatusCode::kInvalidArgument);
      }
    }
    ExpectRefused(whole.substr(0, whole.size() / 2), {"cut off or damaged"}, Options(900, 10));
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
      const auto relief = ReadElevation(damaged, "x.tif", Options(200, 5));
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
  ExpectLand(Read(sparse(60000, 60000, tiled), At(39.0, -104.5, Options(512, 4))), 512, 0.0,
             [](double, double) { return 0.0; });
  // A strip that swells to gigabytes.
  ExpectRefused(sparse(40000, 40000, {"SPARSE_OK=YES", "COMPRESS=DEFLATE", "BLOCKYSIZE=40000"}),
                {"blocks of 40000 x 40000", "at most 268435456"});
  ExpectRefused(sparse(40000, 40000,
                       {"SPARSE_OK=YES", "TILED=YES", "COMPRESS=DEFLATE", "BLOCKXSIZE=16384",
                        "BLOCKYSIZE=16384"}),
                {"blocks of 16384 x 16384"});
}

TEST(ElevationTest, NamesEveryIllegalOption) {
  ElevationOptions options = At(91.0, std::nan(""), Options(1e6, 0.0));
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
  const Relief expected = Read(good, Options(900, 2));
  std::vector<std::thread> threads;
  std::array<bool, 8> same{};
  for (std::size_t i = 0; i < same.size(); ++i) {
    threads.emplace_back([&, i] {
      bool all = true;
      for (int k = 0; k < 5; ++k) {
        const auto relief = ReadElevation(good, "x.tif", Options(900, 2));
        all = all && relief.ok() && relief->height_m == expected.height_m &&
              relief->caption == expected.caption &&
              !ReadElevation(bad, "x.tif", Options(900, 2)).ok();
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
  static_cast<void>(ReadElevation(good, "x.tif", Options(512, 4)));
  for (std::size_t size = 0; size < good.size(); size += 1 + good.size() / 23) {
    static_cast<void>(ReadElevation(good.substr(0, size), "x.tif", Options(512, 4)));
  }
  static_cast<void>(ReadElevation(good, "x.tif", At(-39.7, 75.0, Options(512, 4))));
  static_cast<void>(ReadElevation("II*", "x.tif", Options(512, 4)));
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
