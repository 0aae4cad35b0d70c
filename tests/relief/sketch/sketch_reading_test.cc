#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "latticeworld/common/files.h"
#include "latticeworld/common/random.h"
#include "latticeworld/relief/sketch/sketch.h"
#include "relief/sketch_pictures.h"

namespace latticeworld {
namespace {

// Multiplies every pixel by light(x, y), x and y in [0, 1] from the upper left, a factor a channel.
using Light = std::function<cv::Vec3d(double x, double y)>;
cv::Mat LitBy(const Light& light, const cv::Mat& picture) {
  cv::Mat lit(picture.size(), CV_8UC3);
  for (int r = 0; r < picture.rows; ++r) {
    for (int c = 0; c < picture.cols; ++c) {
      const cv::Vec3d factor = light((c + 0.5) / picture.cols, (r + 0.5) / picture.rows);
      for (int i = 0; i < 3; ++i) {
        lit.at<cv::Vec3b>(r, c)[i] =
            cv::saturate_cast<std::uint8_t>(factor[i] * picture.at<cv::Vec3b>(r, c)[i]);
      }
    }
  }
  return lit;
}

cv::Mat WithNoise(double sigma, std::uint64_t seed, const cv::Mat& picture) {
  RandomStream random(seed, "camera");
  cv::Mat noisy = picture.clone();
  for (int r = 0; r < picture.rows; ++r) {
    for (int c = 0; c < picture.cols; ++c) {
      for (int i = 0; i < 3; ++i) {
        noisy.at<cv::Vec3b>(r, c)[i] = cv::saturate_cast<std::uint8_t>(
            picture.at<cv::Vec3b>(r, c)[i] + random.Normal(0.0, sigma));
      }
    }
  }
  return noisy;
}

cv::Mat Blurred(double sigma, const cv::Mat& picture) {
  cv::Mat blurred;
  cv::GaussianBlur(picture, blurred, cv::Size(), sigma);
  return blurred;
}

// What a camera and a lamp do to a drawing.
struct Distortion {
  std::string name;
  std::function<cv::Mat(const cv::Mat&)> apply;
  std::string extension = ".png";
};

std::vector<Distortion> Distortions() {
  const Light fading = [](double x, double y) {
    const double f = 1.0 - 0.55 * (0.7 * x + 0.3 * y);
    return cv::Vec3d(f, f, f);
  };
  const Light shadow = [](double x, double y) {
    const double f = x + 0.4 * y < 0.6 ? 0.6 : 1.0;
    return cv::Vec3d(f, f, f);
  };
  const Light yellowish = [](double, double) { return cv::Vec3d(0.78, 0.93, 1.0); };
  const Light bluish = [](double, double) { return cv::Vec3d(0.95, 0.85, 0.75); };
  return {
      {"nothing", [](const cv::Mat& p) { return p; }},
      {"fading light", [=](const cv::Mat& p) { return LitBy(fading, p); }},
      {"a shadow across", [=](const cv::Mat& p) { return LitBy(shadow, p); }},
      {"yellowish paper", [=](const cv::Mat& p) { return LitBy(yellowish, p); }},
      {"bluish light", [=](const cv::Mat& p) { return LitBy(bluish, p); }},
      {"a blurred picture", [](const cv::Mat& p) { return Blurred(1.0, p); }},
      {"noise", [](const cv::Mat& p) { return WithNoise(8.0, 1, p); }},
      {"JPEG 60", [](const cv::Mat& p) { return p; }, ".jpg"},
      {"a photograph",
       [=](const cv::Mat& p) {
         return WithNoise(4.0, 2, Blurred(0.8, LitBy(yellowish, LitBy(fading, p))));
       },
       ".jpg"},
  };
}

// Shares of the stroke pixels that got their class, and of the paper that was taken for a stroke.
struct Score {
  double right = 0.0;
  double false_strokes = 0.0;
};
Score Compare(const Sketch& truth, const Sketch& read) {
  double strokes = 0.0;
  double right = 0.0;
  double paper = 0.0;
  double wrong = 0.0;
  for (int r = 0; r < truth.rows(); ++r) {
    for (int c = 0; c < truth.cols(); ++c) {
      if (truth(r, c) == Stroke::kNone) {
        paper += 1.0;
        wrong += read(r, c) != Stroke::kNone;
      } else {
        strokes += 1.0;
        right += read(r, c) == truth(r, c);
      }
    }
  }
  return {right / strokes, wrong / paper};
}

// Each ink and width under one light, and each light for some inks.
TEST(SketchReadingTest, ClassifiesStrokesOfAllWidthsAndInksUnderAllLights) {
  const cv::Scalar blue(230, 60, 20);
  const cv::Scalar light_blue(250, 180, 110);
  const cv::Scalar navy(110, 20, 20);
  const cv::Scalar black(15, 15, 15);
  const cv::Scalar pencil(95, 90, 90);
  const Inks inks[] = {{blue, black, 2},   {light_blue, pencil, 4}, {navy, black, 3},
                       {blue, pencil, 20}, {navy, pencil, 8},       {light_blue, black, 12}};
  int round = 0;
  for (const Distortion& distortion : Distortions()) {
    for (int i = 0; i < 3; ++i) {
      const Inks& ink = inks[(round + 2 * i) % 6];
      const DrawnSketch drawn = DrawRiversAndRidges(360, 480, ink);
      const std::string bytes = EncodePicture(distortion.extension, distortion.apply(drawn.picture),
                                              distortion.extension == ".jpg"
                                                  ? std::vector<int>{cv::IMWRITE_JPEG_QUALITY, 60}
                                                  : std::vector<int>{});
      const Result<Sketch> sketch = ReadSketch(bytes);
      ASSERT_TRUE(sketch.ok()) << distortion.name << ": " << sketch.status().ToString();
      const Score score = Compare(drawn.strokes, *sketch);
      EXPECT_GE(score.right, 0.95) << distortion.name << ", width " << ink.thickness;
      EXPECT_LT(score.false_strokes, 0.01) << distortion.name << ", width " << ink.thickness;
    }
    ++round;
  }
}

TEST(SketchReadingTest, ReadsLinesOfOnePixelAndWithGaps) {
  Inks thin;
  thin.thickness = 1;
  DrawnSketch drawn = DrawRiversAndRidges(360, 480, thin);
  for (int r = 0; r < 360; ++r) {
    for (int c = 0; c < 480; ++c) {
      if (c % 60 > 5) continue;
      drawn.picture.at<cv::Vec3b>(r, c) = {255, 255, 255};
      drawn.strokes(r, c) = Stroke::kNone;
    }
  }
  const Result<Sketch> sketch = ReadSketch(EncodePicture(".png", drawn.picture));
  ASSERT_TRUE(sketch.ok()) << sketch.status().ToString();
  const Score score = Compare(drawn.strokes, *sketch);
  EXPECT_GE(score.right, 0.95);
  EXPECT_LT(score.false_strokes, 0.01);
}

TEST(SketchReadingTest, ReadsPaintedAreasAsWellAsLines) {
  cv::Mat picture(400, 400, CV_8UC3, cv::Scalar(255, 255, 255));
  cv::circle(picture, {120, 200}, 60, cv::Scalar(230, 60, 20), -1);
  cv::circle(picture, {280, 200}, 60, cv::Scalar(20, 20, 20), -1);
  const Result<Sketch> sketch = ReadSketch(EncodePicture(".png", picture));
  ASSERT_TRUE(sketch.ok()) << sketch.status().ToString();
  EXPECT_EQ((*sketch)(200, 120), Stroke::kValley);
  EXPECT_EQ((*sketch)(200, 280), Stroke::kRidge);
  EXPECT_EQ((*sketch)(200, 200), Stroke::kNone);
}

std::string ReadPicture(const std::string& name) {
  return ReadFile(std::string(LATTICEWORLD_SKETCH_PICTURES) + "/" + name, 1 << 20).value();
}

// The sketch of make_sketch_pictures.py. vertical: what its blue stroke is in this format.
void ExpectTheSmallSketch(const std::string& name, const std::string& bytes, Stroke vertical) {
  const Result<Sketch> sketch = ReadSketch(bytes);
  ASSERT_TRUE(sketch.ok()) << name << ": " << sketch.status().ToString();
  ASSERT_EQ(sketch->rows(), 64) << name;
  ASSERT_EQ(sketch->cols(), 64) << name;
  for (int i = 0; i < 64; ++i) {
    EXPECT_EQ((*sketch)(i, 8), i >= 40 && i <= 43 ? Stroke::kRidge : Stroke::kNone) << name << i;
    EXPECT_EQ((*sketch)(41, i), Stroke::kRidge) << name << ", column " << i;
    const bool in_stroke = i >= 15 && i <= 18;
    EXPECT_EQ((*sketch)(20, i), in_stroke ? vertical : Stroke::kNone) << name << ", column " << i;
  }
}

TEST(SketchReadingTest, ReadsEveryKindOfPicture) {
  for (const char* name : {"palette.png", "palette_transparent.png", "rgba.png", "rgba_16.png",
                           "rgb_16.png", "rgb.tiff", "palette.tiff", "cmyk.tiff"}) {
    ExpectTheSmallSketch(name, ReadPicture(name), Stroke::kValley);
  }
  for (const char* name : {"grey_1.png", "grey_16.png"}) {
    ExpectTheSmallSketch(name, ReadPicture(name), Stroke::kRidge);
  }
  // These show the black stroke alone.
  for (const char* name : {"grey_alpha.png", "grey_alpha_16.png"}) {
    ExpectTheSmallSketch(name, ReadPicture(name), Stroke::kNone);
  }
  ExpectTheSmallSketch("CMYK JPEG", ReadFile(LATTICEWORLD_CMYK_JPEG, 1 << 20).value(),
                       Stroke::kValley);
}

TEST(SketchReadingTest, TurnsAJpegAsItsExifAsks) {
  // A wide picture whose EXIF says that its right side is up (orientation 6).
  Inks inks;
  const DrawnSketch drawn = DrawRiversAndRidges(100, 200, inks);
  std::string bytes = EncodePicture(".jpg", drawn.picture);
  using namespace std::string_literals;
  const std::string exif =
      "\xff\xe1\x00\x22"
      "Exif\0\0MM\0*\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0\x06\0\0\0\0\0\0"s;
  bytes.insert(2, exif);
  const Result<Sketch> sketch = ReadSketch(bytes);
  ASSERT_TRUE(sketch.ok()) << sketch.status().ToString();
  ASSERT_EQ(sketch->rows(), 200);
  ASSERT_EQ(sketch->cols(), 100);
  // Turned clockwise: the upper left of the file is the upper right of the picture.
  Sketch turned(200, 100);
  for (int r = 0; r < 200; ++r) {
    for (int c = 0; c < 100; ++c) turned(r, c) = drawn.strokes(99 - c, r);
  }
  EXPECT_GE(Compare(turned, *sketch).right, 0.95);
}

// The failure's message; fails the test when there is none.
std::string RefusalOf(const std::string& bytes) {
  const Result<Sketch> sketch = ReadSketch(bytes);
  if (sketch.ok()) {
    ADD_FAILURE() << "read a picture that should be refused";
    return "";
  }
  EXPECT_EQ(sketch.status().code(), StatusCode::kInvalidArgument);
  return sketch.status().message();
}

void ExpectRefused(const std::string& bytes, const std::vector<std::string>& words) {
  const std::string message = RefusalOf(bytes);
  for (const std::string& word : words) {
    EXPECT_NE(message.find(word), std::string::npos) << "no \"" << word << "\" in: " << message;
  }
}

cv::Mat Blank(int rows, int cols, const cv::Scalar& colour) {
  return cv::Mat(rows, cols, CV_8UC3, colour);
}

TEST(SketchReadingTest, SaysWhatIsWrongWithAPictureThatIsNoSketch) {
  const std::string legal = "blue strokes (valleys) and black strokes (ridges) on white paper";
  ExpectRefused(EncodePicture(".png", Blank(200, 200, {255, 255, 255})), {"no strokes", legal});
  ExpectRefused(EncodePicture(".jpg", WithNoise(6.0, 3, Blank(200, 200, {230, 235, 240}))),
                {"no strokes", legal});
  ExpectRefused(EncodePicture(".png", Blank(200, 200, {10, 10, 10})), {"no white paper", legal});
  ExpectRefused(EncodePicture(".png", Blank(200, 200, {230, 60, 20})), {"no white paper", legal});

  cv::Mat nearly_all = Blank(300, 300, {255, 255, 255});
  for (int i = 0; i < 300; i += 30) {
    cv::rectangle(nearly_all, {0, i}, {299, i + 21}, cv::Scalar(10, 10, 10), -1);
  }
  ExpectRefused(EncodePicture(".png", nearly_all), {"nearly all strokes", "73", legal});

  Inks red;
  red.valley = cv::Scalar(30, 30, 220);
  ExpectRefused(EncodePicture(".png", DrawRiversAndRidges(300, 300, red).picture),
                {"other colours", "red", legal});
  Inks green;
  green.ridge = cv::Scalar(40, 160, 40);
  ExpectRefused(EncodePicture(".jpg", DrawRiversAndRidges(300, 300, green).picture),
                {"other colours", "green", legal});
}

TEST(SketchReadingTest, RefusesPhotographsOfOtherThings) {
  // Soft shapes of many colours, as of a landscape: noise, blurred at several scales.
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    cv::Mat photograph = Blank(240, 320, {128, 128, 128});
    for (const double sigma : {40.0, 12.0, 4.0}) {
      cv::Mat layer = Blurred(sigma, WithNoise(90.0, 10 * seed + static_cast<int>(sigma),
                                               Blank(240, 320, {128, 128, 128})));
      photograph += (layer - cv::Scalar(128, 128, 128)) * (0.6 * sigma);
      photograph -= (cv::Scalar(128, 128, 128) - layer) * (0.6 * sigma);
    }
    RefusalOf(EncodePicture(".png", photograph));
  }
}

TEST(SketchReadingTest, RefusesFilesBeforeTheyAreDecoded) {
  ExpectRefused("", {"empty", "PNG, JPEG and TIFF"});
  ExpectRefused("GIF89a............", {"a GIF", "PNG, JPEG and TIFF"});
  ExpectRefused("P5 64 64 255 ", {"a PGM"});
  ExpectRefused(EncodePicture(".png", Blank(20, 200, {255, 255, 255})),
                {"the sketch is 200 x 20", "33 to 8193"});
  ExpectRefused(EncodePicture(".jpg", Blank(20, 200, {255, 255, 255})), {"200 x 20"});
  ExpectRefused(EncodePicture(".tiff", Blank(20, 200, {255, 255, 255})), {"200 x 20"});

  // Nothing but a header that announces 65535 x 65535 pixels.
  std::string huge = EncodePicture(".jpg", Blank(64, 64, {255, 255, 255}));
  const std::size_t frame = huge.find(std::string("\xff\xc0", 2));
  ASSERT_NE(frame, std::string::npos);
  for (std::size_t i = 5; i < 9; ++i) huge[frame + i] = static_cast<char>(0xff);
  ExpectRefused(huge, {"65535 x 65535"});
}

TEST(SketchReadingTest, RefusesAJpegOfVeryManyScans) {
  const std::string whole = EncodePicture(".jpg", DrawRiversAndRidges(100, 120, Inks()).picture,
                                          {cv::IMWRITE_JPEG_PROGRESSIVE, 1});
  ASSERT_TRUE(ReadSketch(whole).ok());
  // Its last scan again and again.
  const std::size_t last = whole.rfind(std::string("\xff\xda", 2));
  const std::string scan = whole.substr(last, whole.size() - 2 - last);
  std::string many = whole.substr(0, last);
  for (int i = 0; i < 200; ++i) many += scan;
  ExpectRefused(many + whole.substr(whole.size() - 2), {"more than 100 scans"});
}

TEST(SketchReadingTest, RefusesFilesThatAreCutOff) {
  const cv::Mat picture = DrawRiversAndRidges(100, 120, Inks()).picture;
  for (const char* extension : {".png", ".jpg", ".tiff"}) {
    const std::string whole = EncodePicture(extension, picture);
    ASSERT_TRUE(ReadSketch(whole).ok());
    for (std::size_t size = 4; size + 2 < whole.size(); size += 1 + whole.size() / 40) {
      const std::string message = RefusalOf(whole.substr(0, size));
      EXPECT_NE(message.find("sketch"), std::string::npos) << extension << size << ": " << message;
    }
  }
}

TEST(SketchReadingTest, SurvivesDamagedFiles) {
  const cv::Mat picture = DrawRiversAndRidges(64, 80, Inks()).picture;
  for (const char* extension : {".png", ".jpg", ".tiff"}) {
    const std::string whole = EncodePicture(extension, picture);
    RandomStream random(4, extension);
    for (int i = 0; i < 60; ++i) {
      std::string damaged = whole;
      const int changes = random.UniformInt(1, 4);
      for (int k = 0; k < changes; ++k) {
        damaged[random.UniformInt(0, static_cast<int>(damaged.size()) - 1)] =
            static_cast<char>(random.UniformInt(0, 255));
      }
      const Result<Sketch> sketch = ReadSketch(damaged);
      if (!sketch.ok()) {
        EXPECT_EQ(sketch.status().code(), StatusCode::kInvalidArgument);
      }
    }
  }
}

}  // namespace
}  // namespace latticeworld
