#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "latticeworld/common/text.h"
#include "latticeworld/relief/elevation/elevation.h"
#include "relief/elevation/elevation_files.h"

namespace latticeworld {
namespace {

TEST(ElevationAsciiTest, ReadsArcAsciiGridsInMetresAndInDegrees) {
  const Land east = [](double col, double) { return 10 + col; };
  const Relief metric =
      ReadRelief(WriteAscii(100, 80, "xllcorner 0.0\nyllcorner 0.0\ncellsize 5\n", east),
                 WorldOptions(350, 5));
  ExpectLand(metric, 350, 0.01, [](double east_m, double) { return 10 + 49.5 + east_m / 5.0; });
  EXPECT_FALSE(metric.geo.has_value());
  ASSERT_EQ(metric.warnings.size(), 1u);
  EXPECT_NE(metric.warnings[0].find("taken for metres"), std::string::npos);

  const Relief degrees = ReadRelief(
      WriteAscii(100, 80, "XLLCORNER -105.05\nYLLCORNER 40.0\nCELLSIZE 0.001\nNODATA_value 0\n",
                 east),
      WorldOptions(2000, 10));
  ASSERT_TRUE(degrees.geo.has_value());
  EXPECT_NEAR(degrees.geo->longitude_deg, -105.0, 1e-6);
  EXPECT_NEAR(degrees.geo->latitude_deg, 40.04, 1e-6);
  const double a_sample_m = 0.001 * DegreesAt(40.04).longitude_m;
  ExpectLand(degrees, 2000, 0.05,
             [&](double east_m, double) { return 10 + 49.5 + east_m / a_sample_m; });
  ASSERT_EQ(degrees.warnings.size(), 1u);
  EXPECT_NE(degrees.warnings[0].find("taken for degrees"), std::string::npos);

  ExpectRefused(WriteAscii(100, 80, "xllcorner 0\nyllcorner 0\ncellsize 5\n", east),
                {"no coordinate system", "middle"}, OptionsAt(40.0, -105.0, WorldOptions(100, 1)));
}

TEST(ElevationAsciiTest, AnArcAsciiGridMayBeginWithAnyOfItsKeys) {
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
      ExpectLand(ReadRelief(grid_of(lines, first), WorldOptions(200, 5)), 200, 0.01,
                 [](double east_m, double) { return 459 + 29.5 + east_m / 5.0; });
    }
  }
  ExpectRefused("dxf drawing", {"\"dxf draw\"", "Arc/Info ASCII grid"});
}

TEST(ElevationAsciiTest, RefusesArcAsciiGridsThatAreNotWhole) {
  const std::string place = "xllcorner 0\nyllcorner 0\ncellsize 5\n";
  const std::string whole = WriteAscii(40, 40, place, [](double c, double) { return c; });
  ASSERT_TRUE(ReadElevation(whole, "", WorldOptions(100, 1)).ok());
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

TEST(ElevationAsciiTest, WholeNumbersOfAnArcAsciiGridKeepTheirHeightsBesideWordsForNoData) {
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
    const Relief relief = ReadRelief(written(nothing, ""), WorldOptions(250, 5));
    ExpectLand(relief, 250, 0.1, [](double east_m, double) { return 488.5 + east_m / 5.0; });
    EXPECT_EQ(relief.height_step_m, 1.0) << "so that terraces are smoothed";
    ASSERT_EQ(relief.warnings.size(), 2u);
    EXPECT_NE(relief.warnings[1].find("% of the elevation was no-data"), std::string::npos);
  }
  // What the file declares, a height of the earth or a word; beside other words.
  for (const char* no_data : {"NODATA_value -5\n", "NODATA_value -5.0\n", "nodata -5\n"}) {
    ExpectLand(ReadRelief(written("-5", no_data), WorldOptions(250, 5)), 250, 0.1,
               [](double east_m, double) { return 488.5 + east_m / 5.0; });
  }
  for (const char* no_data : {"NODATA_value nan\n", "NODATA_value NULL\n", "NODATA_value -5\n"}) {
    ExpectLand(ReadRelief(written("nan", no_data), WorldOptions(250, 5)), 250, 0.1,
               [](double east_m, double) { return 488.5 + east_m / 5.0; });
  }
  ExpectRefused(written("none", ""), {"\"none\" in place of number", "nan, inf or null"});
  ExpectRefused(written("nan", "NODATA_value none\n"), {"\"none\"", "a number, null or nan"});
}

TEST(ElevationAsciiTest, AnArcAsciiGridSaysForBothAxesWhereItLies) {
  const auto refused = [](const std::string& header, const std::vector<std::string>& words) {
    SCOPED_TRACE(header);
    ExpectRefused(WriteAscii(40, 40, header, [](double c, double) { return c; }), words,
                  WorldOptions(100, 1));
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

TEST(ElevationAsciiTest, CentersOfAnArcAsciiGridLieHalfACellWithinItsCorner) {
  const Land east = [](double col, double) { return 10 + 3 * col; };
  const Relief corner = ReadRelief(
      WriteAscii(100, 200, "xllcorner -105.05\nyllcorner 40\ndx 0.001\ndy 0.0005\n", east),
      WorldOptions(2000, 10));
  const Relief center = ReadRelief(
      WriteAscii(100, 200, "DX 0.001\nDY 0.0005\nXLLCENTER -105.0495\nYLLCENTER 40.00025\n", east),
      WorldOptions(2000, 10));
  ASSERT_TRUE(corner.geo && center.geo);
  EXPECT_NEAR(corner.geo->longitude_deg, -105.0, 1e-9);
  EXPECT_NEAR(corner.geo->latitude_deg, 40.05, 1e-9);
  EXPECT_NEAR(center.geo->longitude_deg, -105.0, 1e-9);
  EXPECT_NEAR(center.geo->latitude_deg, 40.05, 1e-9);
  const double a_sample_m = 0.001 * DegreesAt(40.05).longitude_m;
  ExpectLand(center, 2000, 0.1,
             [&](double east_m, double) { return 10 + 3 * (49.5 + east_m / a_sample_m); });
}

TEST(ElevationAsciiTest, DecimalCommasAreReadAsPointsWhereThereAreNoPoints) {
  const std::string points =
      WriteAscii(60, 60, "xllcorner 500.5\nyllcorner 700\ncellsize 2.5\nNODATA_value -9999\n",
                 [](double c, double r) { return 200 + 0.25 * c - 0.5 * r; });
  std::string commas = points;
  std::replace(commas.begin(), commas.end(), '.', ',');
  const Relief relief = ReadRelief(commas, WorldOptions(100, 2.5));
  EXPECT_EQ(relief.height_m, ReadRelief(points, WorldOptions(100, 2.5)).height_m);
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

TEST(ElevationAsciiTest, NamesKeysOfAnArcAsciiGridThatItDoesNotKnow) {
  const Relief relief =
      ReadRelief(WriteAscii(60, 60, "xllcorner 500\nyllcorner 700\ncellsize 5\nzfactor 3\n",
                            [](double c, double) { return c; }),
                 WorldOptions(100, 5));
  ASSERT_EQ(relief.warnings.size(), 2u);
  EXPECT_NE(relief.warnings[0].find("\"zfactor\" 3"), std::string::npos) << relief.warnings[0];
}

// A grid whose heights rise evenly from 459 m by that much.
std::string RisingGrid(int side, const std::string& place, double cell, double rise_m) {
  return WriteAscii(side, side, place + "cellsize " + FormatDouble(cell) + "\n",
                    [&](double c, double) { return 459.0 + rise_m * c / (side - 1); });
}

TEST(ElevationAsciiTest, HeightsTellSurveysInCentimetresFromDegrees) {
  // 400 cells of 5 cm, which rise by 3 m: as degrees they would span 2000 km.
  for (const char* place : {"xllcorner 0\nyllcorner 0\n", "xllcorner 10\nyllcorner 20\n",
                            "xllcenter 3.5\nyllcenter -2.25\n"}) {
    SCOPED_TRACE(place);
    const Relief survey = ReadRelief(RisingGrid(400, place, 0.05, 3.0), WorldOptions(16, 0.5));
    EXPECT_FALSE(survey.geo.has_value());
    ExpectLand(survey, 16, 0.02, [](double east_m, double) { return 460.5 + 3.0 / 20 * east_m; });
    ASSERT_EQ(survey.warnings.size(), 1u);
    for (const char* word : {"taken for metres", "cells of 0.05 x 0.05", "20 x 20 in all",
                             "differ by 3 m", "elevation unit degrees", "--elevation-unit"}) {
      EXPECT_NE(survey.warnings[0].find(word), std::string::npos) << survey.warnings[0];
    }
    // Where they rise by 2500 m they are no survey.
    EXPECT_TRUE(
        ReadRelief(RisingGrid(400, place, 0.05, 2500.0), WorldOptions(4096, 16)).geo.has_value());
  }
  // Level ground says nothing.
  EXPECT_FALSE(
      ReadRelief(RisingGrid(400, "xllcorner 0\nyllcorner 0\n", 0.05, 0.0), WorldOptions(16, 0.5))
          .geo.has_value());
  EXPECT_TRUE(
      ReadRelief(RisingGrid(400, "xllcorner 7\nyllcorner 50\n", 0.05, 0.0), WorldOptions(16, 0.5))
          .geo.has_value());
}

TEST(ElevationAsciiTest, CellsOfAHundredThousandthAreDegreesAndTheWarningSaysHowLargeTheyAre) {
  for (const char* place : {"xllcorner 11.5\nyllcorner 48.1\n", "xllcorner 0\nyllcorner 0\n"}) {
    const Relief relief = ReadRelief(RisingGrid(300, place, 0.00001, 0.002), WorldOptions(100, 1));
    ASSERT_TRUE(relief.geo.has_value()) << place;
    ASSERT_EQ(relief.warnings.size(), 1u);
    for (const char* word :
         {"taken for degrees", "about 1.1 m", "elevation unit metres", "--elevation-unit"}) {
      EXPECT_NE(relief.warnings[0].find(word), std::string::npos) << relief.warnings[0];
    }
  }
}

TEST(ElevationAsciiTest, TheUnitThatIsAskedForCountsWhateverTheNumbersSay) {
  const std::string survey = RisingGrid(400, "xllcorner 10\nyllcorner 20\n", 0.05, 3.0);
  ElevationOptions options = WorldOptions(16, 0.5);
  options.unit = ElevationUnit::kDegrees;
  const Relief degrees = ReadRelief(survey, options);
  ASSERT_TRUE(degrees.geo.has_value());
  EXPECT_NEAR(degrees.geo->latitude_deg, 30.0, 1e-6);
  EXPECT_TRUE(degrees.warnings.empty());
  options.unit = ElevationUnit::kMetres;
  const std::string steep = RisingGrid(400, "xllcorner 10\nyllcorner 20\n", 0.05, 2500.0);
  const Relief metres = ReadRelief(steep, options);
  EXPECT_FALSE(metres.geo.has_value());
  EXPECT_TRUE(metres.warnings.empty());
  options.unit = ElevationUnit::kDegrees;
  ExpectRefused(RisingGrid(40, "xllcorner 5000\nyllcorner 20\n", 5.0, 3.0),
                {"said to be in degrees", "-180 to 360"}, options);
}

TEST(ElevationAsciiTest, ARefusalSaysHowTheCoordinatesWereTaken) {
  ExpectRefused(RisingGrid(400, "xllcorner 10\nyllcorner 20\n", 0.05, 3.0),
                {"legal is a size of at most", "taken for metres", "--elevation-unit"});
}

}  // namespace
}  // namespace latticeworld
