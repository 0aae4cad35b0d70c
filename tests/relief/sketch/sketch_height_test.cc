#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "latticeworld/geomorphology/flow.h"
#include "latticeworld/relief/sketch/sketch.h"
#include "relief/sketch_pictures.h"

namespace latticeworld {
namespace {

Sketch TestSketch() { return DrawRiversAndRidges(200, 200, Inks()).strokes; }

SketchOptions Options(int samples, std::uint64_t seed = 1) {
  SketchOptions options;
  options.samples = samples;
  options.seed = seed;
  return options;
}

Grid<float> MakeLand(const Sketch& sketch, const SketchOptions& options) {
  return SketchToHeight(sketch, options, Progress()).value();
}

Sketch Only(Stroke stroke, Sketch sketch) {
  for (Stroke& s : sketch) s = s == stroke ? s : Stroke::kNone;
  return sketch;
}

// Mean height [of the whole range] along strokes of one kind, or off them.
double MeanAlong(Stroke stroke, const Sketch& sketch, const Grid<float>& height,
                 const SketchOptions& options) {
  double sum = 0.0;
  double count = 0.0;
  for (int r = 0; r < height.rows(); ++r) {
    for (int c = 0; c < height.cols(); ++c) {
      if (sketch(r * sketch.rows() / height.rows(), c * sketch.cols() / height.cols()) != stroke) {
        continue;
      }
      sum += (height(r, c) - options.height_offset_m) / options.height_scale_m;
      count += 1.0;
    }
  }
  return sum / count;
}

TEST(SketchHeightTest, HasTheAskedSizeAndHeights) {
  const Sketch sketch = DrawRiversAndRidges(150, 220, Inks()).strokes;
  for (const int samples : {64, 100, 257, 600}) {
    SketchOptions options = Options(samples);
    options.height_scale_m = 250.0;
    options.height_offset_m = -40.0;
    const Grid<float> height = MakeLand(sketch, options);
    ASSERT_EQ(height.rows(), samples);
    ASSERT_EQ(height.cols(), samples);
    const auto [low, high] = std::minmax_element(height.begin(), height.end());
    EXPECT_NEAR(*low, -40.0, 1e-3);
    EXPECT_NEAR(*high, 210.0, 1e-3);
    for (const float h : height) ASSERT_TRUE(std::isfinite(h));
  }
}

TEST(SketchHeightTest, IsTheSameWithAnyNumberOfThreads) {
  const Sketch sketch = TestSketch();
  for (const int samples : {300, 1024}) {
    SketchOptions options = Options(samples);
    options.threads = 1;
    const Grid<float> one = MakeLand(sketch, options);
    for (const int threads : {2, 3}) {
      options.threads = threads;
      EXPECT_TRUE(one == MakeLand(sketch, options)) << samples << " with " << threads;
    }
  }
}

TEST(SketchHeightTest, DiffersWithTheSeedButNotInTheRoleOfItsStrokes) {
  const Sketch sketch = TestSketch();
  const Grid<float> first = MakeLand(sketch, Options(256, 0));
  for (std::uint64_t seed = 1; seed < 6; ++seed) {
    const SketchOptions options = Options(256, seed);
    const Grid<float> height = MakeLand(sketch, options);
    EXPECT_TRUE(height != first);
    const double valley = MeanAlong(Stroke::kValley, sketch, height, options);
    const double land = MeanAlong(Stroke::kNone, sketch, height, options);
    const double ridge = MeanAlong(Stroke::kRidge, sketch, height, options);
    EXPECT_LT(valley + 0.1, land) << seed;
    EXPECT_LT(land + 0.1, ridge) << seed;
  }
}

TEST(SketchHeightTest, WorksWithValleysAloneAndWithRidgesAlone) {
  const Sketch sketch = TestSketch();
  for (const Stroke stroke : {Stroke::kValley, Stroke::kRidge}) {
    const Sketch alone = Only(stroke, sketch);
    const SketchOptions options = Options(256);
    const Grid<float> height = MakeLand(alone, options);
    const double difference = MeanAlong(stroke, alone, height, options) -
                              MeanAlong(Stroke::kNone, alone, height, options);
    EXPECT_GT(stroke == Stroke::kRidge ? difference : -difference, 0.1);
  }
}

// Water that starts in a drawn valley gets out of the land, or to where the valleys end, without
// ponds that matter: hardly any land along the strokes lies under the level to which it would fill.
TEST(SketchHeightTest, DrainsAlongItsValleys) {
  const Sketch sketch = TestSketch();
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    const int samples = seed < 2 ? 256 : 512;
    const SketchOptions options = Options(samples, seed);
    const Grid<float> height = MakeLand(sketch, options);
    const Grid<float> filled = FillDepressions(height, nullptr);
    double strokes = 0.0;
    double ponds = 0.0;
    for (int r = 0; r < samples; ++r) {
      for (int c = 0; c < samples; ++c) {
        if (sketch(r * 200 / samples, c * 200 / samples) != Stroke::kValley) continue;
        strokes += 1.0;
        ponds += filled(r, c) - height(r, c) > 0.02 * options.height_scale_m;
      }
    }
    EXPECT_LT(ponds / strokes, 0.02) << seed;
  }
}

TEST(SketchHeightTest, ARingOfRidgesStaysClosed) {
  Sketch sketch(200, 200, Stroke::kNone);
  for (int k = 0; k < 2000; ++k) {
    const double angle = 2.0 * M_PI * k / 2000;
    sketch(static_cast<int>(100 + 50 * std::cos(angle)),
           static_cast<int>(100 + 50 * std::sin(angle))) = Stroke::kRidge;
  }
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const SketchOptions options = Options(256, seed);
    const Grid<float> height = MakeLand(sketch, options);
    const Grid<float> filled = FillDepressions(height, nullptr);
    float deepest = 0.0f;
    for (int r = 100; r < 156; ++r) {
      for (int c = 100; c < 156; ++c) {
        deepest = std::max(deepest, filled(r, c) - height(r, c));
      }
    }
    EXPECT_GT(deepest, 0.1 * options.height_scale_m)
        << "the crater of seed " << seed << " runs out";
  }
}

TEST(SketchHeightTest, HearsACancelAtEveryReport) {
  const Sketch sketch = TestSketch();
  int all_reports = 0;
  double last = 0.0;
  const Progress count([&](std::string_view stage, double fraction) {
    EXPECT_EQ(stage, "relief");
    EXPECT_GE(fraction, last);
    last = fraction;
    ++all_reports;
  });
  ASSERT_TRUE(SketchToHeight(sketch, Options(512), count).ok());
  EXPECT_EQ(last, 1.0);
  ASSERT_GE(all_reports, 4);
  // With the last one all is done.
  for (int k = 0; k + 1 < all_reports; ++k) {
    int reports = 0;
    Progress* handle = nullptr;
    Progress progress([&](std::string_view, double) {
      if (reports++ == k) handle->Cancel();
    });
    handle = &progress;
    const Result<Grid<float>> height = SketchToHeight(sketch, Options(512), progress);
    ASSERT_FALSE(height.ok()) << "report " << k;
    EXPECT_EQ(height.status().code(), StatusCode::kCancelled);
    EXPECT_EQ(reports, k + 1) << "went on after the cancel";
  }
}

TEST(SketchHeightTest, NamesEveryIllegalOption) {
  SketchOptions options;
  options.samples = 63;
  options.size_m = std::numeric_limits<double>::quiet_NaN();
  options.height_scale_m = 0.0;
  options.height_offset_m = 9001.0;
  options.threads = -1;
  const Result<Grid<float>> height = SketchToHeight(TestSketch(), options, Progress());
  ASSERT_FALSE(height.ok());
  EXPECT_EQ(height.status().code(), StatusCode::kInvalidArgument);
  std::vector<std::string> pointers;
  for (const Violation& violation : height.status().violations()) {
    pointers.push_back(violation.pointer);
  }
  EXPECT_EQ(pointers, (std::vector<std::string>{"samples", "size", "height_scale", "height_offset",
                                                "threads"}));
  EXPECT_TRUE(Validate(SketchOptions()).empty());
}

TEST(SketchHeightTest, MakesAReliefOfAPicture) {
  const DrawnSketch drawn = DrawRiversAndRidges(300, 300, Inks());
  const Result<Relief> relief =
      SketchToRelief(EncodePicture(".png", drawn.picture), Options(128), Progress());
  ASSERT_TRUE(relief.ok()) << relief.status().ToString();
  EXPECT_EQ(relief->height_m.rows(), 128);
  EXPECT_EQ(relief->summary.rows(), kReliefSummarySize);
  EXPECT_FALSE(relief->caption.empty());
  EXPECT_TRUE(relief->warnings.empty());
  EXPECT_FALSE(SketchToRelief("not a picture", Options(128), Progress()).ok());
}

// Upright strokes on a wide sheet, a ridge and a valley.
std::string WideSketch(int ridge_col, int valley_col) {
  cv::Mat sheet(200, 400, CV_8UC3, cv::Scalar(255, 255, 255));
  sheet.colRange(ridge_col - 2, ridge_col + 2).setTo(cv::Scalar(0, 0, 0));
  sheet.colRange(valley_col - 2, valley_col + 2).setTo(cv::Scalar(255, 40, 20));
  return EncodePicture(".png", sheet);
}

TEST(SketchHeightTest, ASketchThatIsNotSquareIsCutToItsMiddleAndNotStretched) {
  const Result<Relief> relief = SketchToRelief(WideSketch(150, 250), Options(128), Progress());
  ASSERT_TRUE(relief.ok()) << relief.status().ToString();
  const auto mean_m = [&](int col) {
    double sum_m = 0.0;
    for (int r = 0; r < 128; ++r) sum_m += relief->height_m(r, col);
    return sum_m / 128.0;
  };
  // A quarter and three quarters of the way across the square; stretched they would lie at 48, 80.
  EXPECT_GT(mean_m(32), mean_m(48));
  EXPECT_LT(mean_m(96), mean_m(80));
  ASSERT_EQ(relief->warnings.size(), 1u);
  EXPECT_NE(relief->warnings[0].find("the sketch has 400 x 200 pixels"), std::string::npos);
  EXPECT_NE(relief->warnings[0].find("columns 100 to 299 of 0 to 399"), std::string::npos);
}

TEST(SketchHeightTest, RefusesASketchWhoseStrokesAllLieOutsideItsMiddle) {
  const Result<Relief> relief = SketchToRelief(WideSketch(30, 370), Options(128), Progress());
  ASSERT_FALSE(relief.ok());
  EXPECT_EQ(relief.status().code(), StatusCode::kInvalidArgument);
  for (const char* word : {"no stroke", "columns 100 to 299", "a square sketch"}) {
    EXPECT_NE(relief.status().message().find(word), std::string::npos) << relief.status().message();
  }
}

}  // namespace
}  // namespace latticeworld
