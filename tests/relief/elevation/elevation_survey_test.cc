#include "latticeworld/relief/elevation/elevation_survey.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <string>

namespace latticeworld {
namespace {

// An Arc/Info ASCII grid of a plane that rises by `east` a column and falls by `south` a row from
// 100.
std::string PlaneFile(int cols, int rows, double corner_x, double corner_y, double cell_size,
                      double east, double south, int missing_col = -1) {
  std::ostringstream file;
  file << "ncols " << cols << "\nnrows " << rows << "\nxllcorner " << corner_x << "\nyllcorner "
       << corner_y << "\ncellsize " << cell_size << "\nNODATA_value -9999\n";
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < cols; ++c) {
      file << (c == missing_col ? -9999.0 : 100.0 + east * c - south * r) << " ";
    }
    file << "\n";
  }
  return file.str();
}

TEST(ElevationSurveyTest, GivesEverySampleAsItIs) {
  const auto survey =
      SurveyElevation(PlaneFile(90, 70, 1000.0, 2000.0, 5.0, 0.5, 0.25, 7), "plane.asc");
  ASSERT_TRUE(survey.ok()) << survey.status().message();
  EXPECT_NEAR(survey->resolution_m, 5.0, 1e-6);
  ASSERT_EQ(survey->height_m.rows(), 70);
  ASSERT_EQ(survey->height_m.cols(), 90);
  for (int r = 0; r < 70; ++r) {
    for (int c = 0; c < 90; ++c) {
      EXPECT_EQ(survey->missing(r, c), c == 7 ? 1 : 0);
      EXPECT_TRUE(std::isfinite(survey->height_m(r, c)));
      if (c == 7) continue;
      EXPECT_NEAR(survey->height_m(r, c), 100.0 + 0.5 * c - 0.25 * r, 1e-4);
    }
  }
}

TEST(ElevationSurveyTest, MakesSquareCellsOfDegrees) {
  // At 60 degrees north a degree of longitude is half as wide as one of latitude.
  const auto survey =
      SurveyElevation(PlaneFile(80, 100, 10.0, 59.95, 0.001, 0.0, 1.0), "plane.asc");
  ASSERT_TRUE(survey.ok()) << survey.status().message();
  EXPECT_NEAR(survey->resolution_m, 55.8, 0.3);
  EXPECT_EQ(survey->height_m.cols(), 80);
  EXPECT_NEAR(survey->height_m.rows(), 200, 1);
  const double per_row = 100.0 / survey->height_m.rows();
  for (int r = 10; r < survey->height_m.rows() - 10; ++r) {
    EXPECT_NEAR(survey->height_m(r, 40), 100.0 - (per_row * (r + 0.5) - 0.5), 0.02);
  }
  EXPECT_EQ(survey->missing.rows(), survey->height_m.rows());
}

TEST(ElevationSurveyTest, SaysWhatIsWrong) {
  EXPECT_EQ(SurveyElevation("a letter to my aunt", "letter.asc").status().code(),
            StatusCode::kInvalidArgument);
  EXPECT_EQ(SurveyElevation("", "empty.hgt").status().code(), StatusCode::kInvalidArgument);
  std::string nothing = PlaneFile(3, 3, 0.0, 0.0, 1.0, 0.0, 0.0);
  for (std::size_t at; (at = nothing.find("100 ")) != std::string::npos;) {
    nothing.replace(at, 4, "-9999 ");
  }
  const auto survey = SurveyElevation(nothing, "nothing.asc");
  EXPECT_EQ(survey.status().code(), StatusCode::kInvalidArgument);
  EXPECT_NE(survey.status().message().find("no-data"), std::string::npos);
}

}  // namespace
}  // namespace latticeworld
