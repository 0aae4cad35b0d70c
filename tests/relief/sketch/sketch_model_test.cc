#include "latticeworld/relief/sketch/sketch_model.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "latticeworld/common/files.h"
#include "latticeworld/relief/sketch/sketch.h"
#include "relief/sketch_pictures.h"

namespace latticeworld {
namespace {

// make_sketch_models.py wrote them when the tests were built.
const std::string kModels = LATTICEWORLD_SKETCH_MODELS;

SketchModel Load(const std::string& name) {
  Result<SketchModel> model = SketchModel::Load(kModels + "/" + name);
  EXPECT_TRUE(model.ok()) << model.status().ToString();
  return std::move(model).value();
}

void ExpectRefused(const std::string& path, StatusCode code, const std::string& words) {
  const Result<SketchModel> model = SketchModel::Load(path);
  ASSERT_FALSE(model.ok()) << path;
  EXPECT_EQ(model.status().code(), code) << model.status().ToString();
  EXPECT_NE(model.status().message().find(words), std::string::npos) << model.status().ToString();
}

template <typename T>
std::vector<T> ReadArray(const std::string& name) {
  const std::string bytes = ReadFile(kModels + "/" + name, 1 << 20).value();
  std::vector<T> values(bytes.size() / sizeof(T));
  std::copy(bytes.begin(), bytes.end(), reinterpret_cast<char*>(values.data()));
  return values;
}

Sketch TestSketch(int side) {
  const auto strokes = ReadArray<std::uint8_t>("sketch.u8");
  Sketch sketch(side, side);
  std::transform(strokes.begin(), strokes.end(), sketch.begin(),
                 [](std::uint8_t s) { return static_cast<Stroke>(s); });
  return sketch;
}

TEST(SketchModelTest, GivesWhatNumpyGivesForTheSameNetwork) {
  const SketchModel model = Load("unet.onnx");
  ASSERT_EQ(model.side(), 64);
  EXPECT_EQ(model.channels(), 3);
  const Result<Grid<float>> height = model.Run(TestSketch(64));
  ASSERT_TRUE(height.ok()) << height.status().ToString();
  const auto expected = ReadArray<float>("height.f32");
  ASSERT_EQ(height->size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    ASSERT_NEAR(height->data()[i], expected[i], 1e-5) << "cell " << i;
  }
}

TEST(SketchModelTest, ShowsValleysPaperAndRidgesToANetworkOfOneChannel) {
  const SketchModel model = Load("one_channel.onnx");  // input + 0.25
  EXPECT_EQ(model.channels(), 1);
  const Sketch sketch = TestSketch(64);
  const Grid<float> height = model.Run(sketch).value();
  for (std::size_t i = 0; i < sketch.size(); ++i) {
    const Stroke stroke = sketch.data()[i];
    const float shown = stroke == Stroke::kNone ? 0.5f : stroke == Stroke::kRidge ? 1.0f : 0.0f;
    ASSERT_FLOAT_EQ(height.data()[i], shown + 0.25f);
  }
}

TEST(SketchModelTest, MakesAReliefOfTheAskedSizeAndHeightsWhoseRidgesAreHigherThanItsValleys) {
  const SketchModel model = Load("unet.onnx");
  const DrawnSketch drawn = DrawRiversAndRidges(300, 400, Inks());
  SketchOptions options;
  options.samples = 200;
  options.height_scale_m = 80.0;
  options.height_offset_m = -20.0;
  const Result<Relief> relief =
      SketchToRelief(EncodePicture(".png", drawn.picture), options, Progress(), &model);
  ASSERT_TRUE(relief.ok()) << relief.status().ToString();
  ASSERT_EQ(relief->height_m.rows(), 200);
  const auto [low, high] = std::minmax_element(relief->height_m.begin(), relief->height_m.end());
  EXPECT_NEAR(*low, -20.0, 1e-3);
  EXPECT_NEAR(*high, 60.0, 1e-3);
  double sum[3] = {0.0, 0.0, 0.0};
  double count[3] = {0.0, 0.0, 0.0};
  for (int r = 0; r < 200; ++r) {
    for (int c = 0; c < 200; ++c) {
      const auto stroke = static_cast<int>(drawn.strokes(r * 300 / 200, 50 + c * 300 / 200));
      sum[stroke] += relief->height_m(r, c);
      count[stroke] += 1.0;
    }
  }
  const double paper = sum[0] / count[0];
  EXPECT_LT(sum[1] / count[1], paper - 5.0);
  EXPECT_GT(sum[2] / count[2], paper + 5.0);
}

// Mean height above that of the drawn valley in the middle, over columns [first, last).
double Above(const Grid<float>& height, int first, int last) {
  const int middle = height.cols() / 2;
  double above = 0.0;
  for (int r = 0; r < height.rows(); ++r)
    for (int c = first; c < last; ++c) above += height(r, c) - height(r, middle);
  return above / (height.rows() * (last - first));
}

TEST(SketchModelTest, TheLandBetweenStrokesIsAsHighAsTheModelSaysAndStrokesStayWhereTheyWereDrawn) {
  Sketch sketch(64, 64, Stroke::kNone);
  for (int r = 0; r < 64; ++r) sketch(r, 32) = Stroke::kValley;
  SketchOptions options;
  options.samples = 128;
  const SketchModel model = Load("slopes.onnx");  // twice as steep to the east
  for (const std::uint64_t seed : {1, 2, 3, 4, 5, 6}) {
    options.seed = seed;
    const Result<Grid<float>> height = SketchToHeight(sketch, model, options, Progress());
    ASSERT_TRUE(height.ok()) << height.status().ToString();
    const double west = Above(*height, 16, 48), east = Above(*height, 80, 112);
    EXPECT_GT(west, 0.0) << "seed " << seed;
    EXPECT_GT(east, 1.4 * west) << "seed " << seed;
  }
}

TEST(SketchModelTest, RefusesFilesThatAreNoSuchNetwork) {
  ExpectRefused(kModels + "/absent.onnx", StatusCode::kNotFound, "absent.onnx");
  ExpectRefused(kModels + "/sketch.u8", StatusCode::kInvalidArgument, "ONNX");
  ExpectRefused(kModels + "/two_channels_in.onnx", StatusCode::kInvalidArgument, "1 x 2 x 64 x 64");
  ExpectRefused(kModels + "/two_channels_out.onnx", StatusCode::kInvalidArgument,
                "1 x 2 x 64 x 64");
  const std::string whole = ReadFile(kModels + "/unet.onnx", 1 << 20).value();
  const std::string cut =
      ::testing::TempDir() + "/latticeworld_cut_" + std::to_string(getpid()) + ".onnx";
  ASSERT_TRUE(WriteFile(cut, whole.substr(0, whole.size() / 2)).ok());
  ExpectRefused(cut, StatusCode::kInvalidArgument, "latticeworld_cut");
  ASSERT_TRUE(WriteFile(cut, "").ok());
  ExpectRefused(cut, StatusCode::kInvalidArgument, "latticeworld_cut");
  std::filesystem::remove(cut);
}

TEST(SketchModelTest, SaysWhenANetworkGivesWhatIsNoLand) {
  const Result<Grid<float>> not_finite = Load("not_finite.onnx").Run(TestSketch(64));
  ASSERT_FALSE(not_finite.ok());
  EXPECT_EQ(not_finite.status().code(), StatusCode::kInternal);
  EXPECT_NE(not_finite.status().message().find("not finite"), std::string::npos);

  SketchOptions options;
  options.samples = 64;
  const Result<Grid<float>> level =
      SketchToHeight(TestSketch(64), Load("level.onnx"), options, Progress());
  ASSERT_FALSE(level.ok());
  EXPECT_NE(level.status().message().find("level"), std::string::npos);
}

}  // namespace
}  // namespace latticeworld
