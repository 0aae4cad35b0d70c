#include <gdal.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "latticeworld/relief/elevation/elevation.h"
#include "relief/elevation/elevation_files.h"

namespace latticeworld {
namespace {

TEST(ElevationGeoTiffTest, ATiltedPlaneInUtmKeepsItsHeightsSlopeAndPlace) {
  TiffSpec spec;
  // Around (500500, 4399500), on the middle meridian of zone 13, where UTM's scale is 0.9996.
  spec.land = [](double x, double y) { return 2000 + 0.1 * (x - 500500) - 0.25 * (y - 4399500); };
  spec.transform = {500000, 10, 0, 4400000, 0, -10};
  const std::string bytes = WriteTiff(spec);
  for (const double resolution_m : {0.5, 4.0, 10.0, 16.0}) {
    const Relief relief = ReadRelief(bytes, WorldOptions(800, resolution_m));
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

TEST(ElevationGeoTiffTest, ATiltedPlaneInDegreesBecomesMetres) {
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
  const Relief relief = ReadRelief(WriteTiff(spec), WorldOptions(4000, 10));
  ExpectLand(relief, 4000, 0.15,
             [](double east_m, double north_m) { return 1500 + 0.2 * north_m - 0.1 * east_m; });
  ASSERT_TRUE(relief.geo.has_value());
  EXPECT_NEAR(relief.geo->latitude_deg, 40.5, 1e-6);
  EXPECT_NEAR(relief.geo->longitude_deg, -105.25, 1e-6);
}

TEST(ElevationGeoTiffTest, FindsAPlaceByItsLatitudeAndLongitude) {
  TiffSpec spec;
  spec.cols = 200, spec.rows = 160;
  spec.crs = "EPSG:4326";
  spec.transform = {10.0, 0.0005, 0, 47.0, 0, -0.0005};
  const DegreeLengths degree = DegreesAt(46.95);
  spec.land = [&](double lon, double) { return (lon - 10.0) * degree.longitude_m; };
  const Relief relief = ReadRelief(WriteTiff(spec), OptionsAt(46.95, 10.03, WorldOptions(1024, 8)));
  // East of the western edge by 0.03 degrees.
  const double there_m = 0.03 * degree.longitude_m;
  ExpectLand(relief, 1024, 0.6, [&](double east_m, double) { return there_m + east_m; });
  ASSERT_TRUE(relief.geo.has_value());
  EXPECT_NEAR(relief.geo->latitude_deg, 46.95, 1e-9);
  EXPECT_NEAR(relief.geo->longitude_deg, 10.03, 1e-9);
}

TEST(ElevationGeoTiffTest, ConvertsFeetOfPlaceAndOfHeight) {
  // Colorado north in US survey feet; heights once in metres, once in feet.
  constexpr double kFoot = 1200.0 / 3937.0;
  TiffSpec spec;
  spec.crs = "EPSG:2231";
  spec.transform = {3000000, 20, 0, 1300000, 0, -20};
  spec.land = [](double x, double) { return 5000.0 + 0.1 * (x - 3001000); };
  spec.unit = "US survey foot";
  // The middle meridian is 105.5 degrees west at x = 3,000,000 feet: north is up within 0.001.
  ExpectLand(ReadRelief(WriteTiff(spec), WorldOptions(400, 4)), 400, 0.05,
             [](double east_m, double) { return 5000.0 * kFoot + 0.1 * east_m; });
  spec.unit = "m";
  ExpectLand(ReadRelief(WriteTiff(spec), WorldOptions(400, 4)), 400, 0.15,
             [](double east_m, double) { return 5000.0 + 0.1 * east_m / kFoot; });
  spec.unit = "ft";
  ExpectLand(ReadRelief(WriteTiff(spec), WorldOptions(400, 4)), 400, 0.05,
             [](double east_m, double) { return 0.3048 * (5000.0 + 0.1 * east_m / kFoot); });
  spec.unit = "";
  spec.crs = "EPSG:2231+6360";  // heights by the vertical system: NAVD 88 in US survey feet
  ExpectLand(ReadRelief(WriteTiff(spec), WorldOptions(400, 4)), 400, 0.05,
             [](double east_m, double) { return 5000.0 * kFoot + 0.1 * east_m; });
  spec.crs = "EPSG:2231";
  spec.unit = "fathom";
  ExpectRefused(WriteTiff(spec), {"fathom", "US survey foot"}, WorldOptions(400, 4));
}

TEST(ElevationGeoTiffTest, AppliesScaleAndOffsetOfWholeNumbers) {
  TiffSpec spec;
  spec.type = GDT_Int16;
  spec.scale = 0.1;
  spec.offset = 500.0;
  spec.land = [](double x, double) { return std::round(x - 500500); };
  const Relief relief = ReadRelief(WriteTiff(spec), WorldOptions(800, 10));
  ExpectLand(relief, 800, 0.06,
             [](double east_m, double) { return 500.0 + 0.1 * 0.9996 * east_m; });
  EXPECT_NEAR(relief.height_step_m, 0.1, 1e-12) << "so that terraces are smoothed";
  EXPECT_EQ(ReadRelief(WriteTiff(spec), WorldOptions(800, 16)).height_step_m, 0.0)
      << "means of two samples";
  spec.type = GDT_Float32;
  EXPECT_EQ(ReadRelief(WriteTiff(spec), WorldOptions(800, 10)).height_step_m, 0.0);
}

TEST(ElevationGeoTiffTest, TurnsARotatedPictureNorthUp) {
  // Rows run to the south-west, columns to the south-east.
  const double side = 10.0, turn = 35.0 * kPi / 180.0;
  TiffSpec spec;
  spec.cols = spec.rows = 200;
  spec.transform = {500500,  side * std::cos(turn),  -side * std::sin(turn),
                    4399500, -side * std::sin(turn), -side * std::cos(turn)};
  spec.land = [](double x, double y) { return 800 + 0.3 * (y - 4399500) + 0.05 * (x - 500500); };
  const Relief relief = ReadRelief(WriteTiff(spec), WorldOptions(1000, 5));
  // The middle of the data, in the data's coordinates.
  const double x = 500500 + 100 * (spec.transform[1] + spec.transform[2]) - 500500;
  const double y = 100 * (spec.transform[4] + spec.transform[5]);
  ExpectLand(relief, 1000, 0.3, [&](double east_m, double north_m) {
    return 800 + 0.3 * (y + 0.9996 * north_m) + 0.05 * (x + 0.9996 * east_m);
  });
}

TEST(ElevationGeoTiffTest, TakesAveragesWhereTheWorldIsCoarser) {
  // Stripes of single samples: their mean is 50, whatever falls together along that direction.
  for (const bool columns : {false, true}) {
    TiffSpec spec;
    spec.cols = spec.rows = 600;
    spec.transform = {500000, 1, 0, 4400000, 0, -1};
    spec.land = [columns](double x, double y) {
      return static_cast<int>(std::floor(columns ? x : y)) % 2 == 0 ? 0.0 : 100.0;
    };
    ExpectLand(ReadRelief(WriteTiff(spec), WorldOptions(512, 8)), 512, 2.0,
               [](double, double) { return 50.0; });
  }
}

TEST(ElevationGeoTiffTest, FillsHolesFromAroundThem) {
  const Land plane = [](double x, double y) {
    return 300 + 0.2 * (x - 500500) + 0.1 * (y - 4399500);
  };
  // In the middle and at a corner of the world; every kind of nothing.
  for (const double nothing : {-9999.0, -32768.0, 1e30, -3.4e38, static_cast<double>(kNoData),
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
      const Relief relief = ReadRelief(WriteTiff(spec), WorldOptions(600, 5));
      ExpectLand(relief, 600, 1.0, [](double east_m, double north_m) {
        return 300 + 0.9996 * (0.2 * east_m + 0.1 * north_m);
      });
      ASSERT_EQ(relief.warnings.size(), 1u);
      EXPECT_NE(relief.warnings[0].find("% of the elevation was no-data"), std::string::npos);
    }
  }
}

TEST(ElevationGeoTiffTest, AHoleInAPlaneIsFilledWithThePlane) {
  TiffSpec spec;
  spec.land = [](double x, double y) {
    return std::hypot(x - 500500, y - 4399500) < 150 ? -9999.0 : 300 + 0.2 * (x - 500500);
  };
  ExpectLand(ReadRelief(WriteTiff(spec), WorldOptions(600, 5)), 600, 0.1,
             [](double east_m, double) { return 300 + 0.9996 * 0.2 * east_m; });
}

TEST(ElevationGeoTiffTest, HonoursAnAlphaBand) {
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
  ExpectLand(ReadRelief(WriteTiff(spec), WorldOptions(600, 5)), 600, 1e-3,
             [](double, double) { return 120.0; });
}

TEST(ElevationGeoTiffTest, ReadsDegreesThatCountTo360) {
  TiffSpec spec;
  spec.crs = "EPSG:4326";
  spec.transform = {254.0, 0.001, 0, 40.0, 0, -0.001};
  const Relief relief =
      ReadRelief(WriteTiff(spec), OptionsAt(39.95, -105.95, WorldOptions(512, 8)));
  ASSERT_TRUE(relief.geo.has_value());
  EXPECT_NEAR(relief.geo->longitude_deg, -105.95, 1e-9);
  EXPECT_NEAR(ReadRelief(WriteTiff(spec), WorldOptions(512, 8)).geo->longitude_deg, -105.95, 1e-6);
}

TEST(ElevationGeoTiffTest, ReadsAcrossTheDateLine) {
  TiffSpec spec;
  spec.crs = "EPSG:4326";
  spec.transform = {179.95, 0.001, 0, -16.95, 0, -0.001};
  const DegreeLengths degree = DegreesAt(-17.0);
  spec.land = [&](double lon, double) { return 50 + 0.01 * (lon - 180.0) * degree.longitude_m; };
  const Relief relief =
      ReadRelief(WriteTiff(spec), OptionsAt(-17.0, -180.0, WorldOptions(4096, 16)));
  ExpectLand(relief, 4096, 0.1, [](double east_m, double) { return 50 + 0.01 * east_m; });
}

TEST(ElevationGeoTiffTest, RefusesGeoTiffsThatAreNoPlaceOnTheEarth) {
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
  spec.transform = {500000, kNoData, 0, 4400000, 0, -10};
  ExpectRefused(WriteTiff(spec), {"georeference"});
  spec.transform = {500000, 1e-9, 0, 4400000, 0, -1e-9};
  ExpectRefused(WriteTiff(spec), {"m large"});
  spec.transform = {1e30, 10, 0, -1e30, 0, -10};  // nowhere near zone 13
  ExpectRefused(WriteTiff(spec), {"elevation"});
  spec.crs = "EPSG:4326";
  spec.transform = {0, 0.001, 0, 4400000, 0, -0.001};  // metres called degrees
  ExpectRefused(WriteTiff(spec), {"elevation"});
}

TEST(ElevationGeoTiffTest, RefusesPicturesAndComplexNumbers) {
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

TEST(ElevationGeoTiffTest, ReadsEveryKindOfSampleAndCompression) {
  for (const GDALDataType type :
       {GDT_Byte, GDT_UInt16, GDT_Int16, GDT_UInt32, GDT_Int32, GDT_Float32, GDT_Float64}) {
    for (const char* option : {"COMPRESS=NONE", "COMPRESS=DEFLATE", "COMPRESS=LZW", "TILED=YES",
                               "BIGTIFF=YES", "ENDIANNESS=BIG", "INTERLEAVE=BAND"}) {
      TiffSpec spec;
      spec.type = type;
      spec.creation = {option};
      spec.land = [](double x, double) { return std::round(0.1 * (x - 500000)); };
      ExpectLand(ReadRelief(WriteTiff(spec), WorldOptions(640, 8)), 640, 0.6,
                 [](double east_m, double) { return 50.0 + 0.1 * 0.9996 * east_m; });
    }
  }
}

}  // namespace
}  // namespace latticeworld
