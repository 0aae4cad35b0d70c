#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <vector>

#include "latticeworld/relief/relief.h"

namespace latticeworld {
namespace {

// A ramp whose values use the whole depth.
cv::Mat Ramp(int rows, int cols, int type) {
  cv::Mat image(rows, cols, type);
  const int largest = type == CV_8UC1 ? 255 : 65535;
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < cols; ++c) {
      const int value = largest * (r * cols + c) / (rows * cols - 1);
      if (type == CV_8UC1) {
        image.at<std::uint8_t>(r, c) = static_cast<std::uint8_t>(value);
      } else {
        image.at<std::uint16_t>(r, c) = static_cast<std::uint16_t>(value);
      }
    }
  }
  return image;
}

std::string Encode(const std::string& extension, const cv::Mat& image,
                   const std::vector<int>& parameters = {}) {
  std::vector<unsigned char> bytes;
  EXPECT_TRUE(cv::imencode(extension, image, bytes, parameters));
  return std::string(bytes.begin(), bytes.end());
}

// The failure's message; fails the test when there is none or its code is another.
std::string RefusalOf(const std::string& bytes) {
  const Result<Relief> relief = ReadHeightMap(bytes, HeightMapOptions());
  if (relief.ok()) {
    ADD_FAILURE() << "read a picture that should be refused";
    return "";
  }
  EXPECT_EQ(relief.status().code(), StatusCode::kInvalidArgument);
  return relief.status().message();
}

void ExpectRefused(const std::string& bytes, const std::string& words) {
  const std::string message = RefusalOf(bytes);
  EXPECT_NE(message.find(words), std::string::npos) << message;
}

void PutBigEndian(std::uint32_t value, std::size_t at, std::string* bytes) {
  for (int i = 0; i < 4; ++i) (*bytes)[at + i] = static_cast<char>(value >> (24 - 8 * i));
}

TEST(HeightMapTest, ReadsEveryFormatAndDepthWithMetricScaleAndOffset) {
  HeightMapOptions options;
  options.height_scale_m = 200.0;
  options.height_offset_m = -50.0;
  for (const int type : {CV_8UC1, CV_16UC1}) {
    const cv::Mat image = Ramp(47, 90, type);
    for (const char* extension : {".png", ".pgm", ".tiff"}) {
      const Result<Relief> relief = ReadWholeHeightMap(Encode(extension, image), options);
      ASSERT_TRUE(relief.ok()) << extension << ": " << relief.status().ToString();
      ASSERT_EQ(relief->height_m.rows(), 47);
      ASSERT_EQ(relief->height_m.cols(), 90);
      const double largest = type == CV_8UC1 ? 255.0 : 65535.0;
      for (int r = 0; r < 47; ++r) {
        for (int c = 0; c < 90; ++c) {
          const int value =
              type == CV_8UC1 ? image.at<std::uint8_t>(r, c) : image.at<std::uint16_t>(r, c);
          EXPECT_NEAR(relief->height_m(r, c), -50.0 + 200.0 * value / largest, 1e-3);
        }
      }
      EXPECT_NEAR(relief->height_step_m, 200.0 / largest, 1e-9);
    }
  }
}

TEST(HeightMapTest, ReadsUncompressedTiff) {
  const std::string bytes =
      Encode(".tiff", Ramp(64, 65, CV_16UC1), {cv::IMWRITE_TIFF_COMPRESSION, 1});
  const Result<Relief> relief = ReadWholeHeightMap(bytes, HeightMapOptions());
  ASSERT_TRUE(relief.ok()) << relief.status().ToString();
  EXPECT_NEAR(relief->height_m(63, 64), 100.0f, 1e-3);
}

TEST(HeightMapTest, CutsTheMiddleSquareOutAndSaysWhichPixelsItKept) {
  const struct {
    int rows, cols, row, col;
    const char* words;
  } kCases[] = {{47, 90, 0, 21,
                 "90 x 47 pixels, and a world is square: the middle is kept, "
                 "columns 21 to 67 of 0 to 89"},
                {91, 40, 25, 0, "rows 25 to 64 of 0 to 90"},
                {40, 41, 0, 0, "columns 0 to 39 of 0 to 40"}};
  for (const auto& test : kCases) {
    const cv::Mat image = Ramp(test.rows, test.cols, CV_16UC1);
    for (const char* extension : {".png", ".pgm", ".tiff"}) {
      const Result<Relief> relief = ReadHeightMap(Encode(extension, image), HeightMapOptions());
      ASSERT_TRUE(relief.ok()) << relief.status().ToString();
      const int side = std::min(test.rows, test.cols);
      ASSERT_EQ(relief->height_m.rows(), side);
      ASSERT_EQ(relief->height_m.cols(), side);
      for (int r = 0; r < side; ++r) {
        for (int c = 0; c < side; ++c) {
          const int value = image.at<std::uint16_t>(test.row + r, test.col + c);
          EXPECT_NEAR(relief->height_m(r, c), 100.0 * value / 65535.0, 1e-3);
        }
      }
      ASSERT_EQ(relief->warnings.size(), 1u);
      EXPECT_NE(relief->warnings[0].find(test.words), std::string::npos) << relief->warnings[0];
    }
  }
  const std::string square = Encode(".png", Ramp(40, 40, CV_8UC1));
  EXPECT_TRUE(ReadHeightMap(square, HeightMapOptions())->warnings.empty());
}

TEST(HeightMapTest, ReadsPlainPgmWithCommentsAndItsOwnMaxval) {
  std::string bytes = "P2 # plain\n# of a hand\n33 34\n1000\n";
  for (int i = 0; i < 33 * 34; ++i) bytes += std::to_string(i % 1001) + (i % 17 == 16 ? "\n" : " ");
  const Result<Relief> relief = ReadHeightMap(bytes, HeightMapOptions());
  ASSERT_TRUE(relief.ok()) << relief.status().ToString();
  EXPECT_NEAR(relief->height_m(0, 10), 1.0f, 1e-5);
  EXPECT_NEAR(relief->height_m(30, 10), 100.0f, 1e-4);  // sample 1000
}

TEST(HeightMapTest, TakesTheSmallestAndTheLargestSize) {
  EXPECT_TRUE(ReadHeightMap(Encode(".png", Ramp(33, 33, CV_8UC1)), HeightMapOptions()).ok());
  const cv::Mat largest(33, kMaxReliefSize, CV_8UC1, cv::Scalar(7));
  EXPECT_TRUE(ReadHeightMap(Encode(".png", largest), HeightMapOptions()).ok());
  ExpectRefused(Encode(".png", Ramp(32, 100, CV_8UC1)), "100 x 32 samples; legal are 33 to 8193");
  ExpectRefused(Encode(".pgm", cv::Mat(40, 8194, CV_8UC1, cv::Scalar(1))), "8194 x 40");
}

TEST(HeightMapTest, RefusesHostileSizesFromTheHeaderAlone) {
  for (const std::uint32_t side : {0u, 1u, 30000u, 0xffffffffu}) {
    std::string png = Encode(".png", Ramp(40, 40, CV_8UC1));
    PutBigEndian(side, 16, &png);
    PutBigEndian(side, 20, &png);
    const std::string size = std::to_string(side) + " x " + std::to_string(side);
    ExpectRefused(png, size);
    ExpectRefused("P5 " + std::to_string(side % 2000000000u) + " 100 255\n", " x 100 samples");
  }
  ExpectRefused("P5 99999999999999999999 99999999999999999999 255\n", "legal are 33 to 8193");
}

TEST(HeightMapTest, RefusesWhatIsNoHeightMapAndSaysWhatItIs) {
  ExpectRefused("", "empty");
  ExpectRefused("this is a text", "not a picture");
  ExpectRefused(Encode(".jpg", Ramp(40, 40, CV_8UC1)), "a JPEG");
  ExpectRefused(Encode(".bmp", Ramp(40, 40, CV_8UC1)), "a BMP");
  const cv::Mat color(40, 40, CV_8UC3, cv::Scalar(1, 2, 3));
  const cv::Mat alpha(40, 40, CV_8UC4, cv::Scalar(1, 2, 3, 4));
  ExpectRefused(Encode(".png", color), "colour (RGB)");
  ExpectRefused(Encode(".png", alpha), "RGBA");
  ExpectRefused(Encode(".ppm", color), "a PPM");
  ExpectRefused(Encode(".tiff", color), "3 sample(s)");
  ExpectRefused(Encode(".tiff", cv::Mat(40, 40, CV_32FC1, cv::Scalar(1.0))), "32 bits");
  ExpectRefused(Encode(".png", Ramp(40, 40, CV_8UC1), {cv::IMWRITE_PNG_BILEVEL, 1}), "1 bits");
}

TEST(HeightMapTest, NeverReadsLessThanTheWholePictureFromACutFile) {
  for (const char* extension : {".png", ".pgm", ".tiff"}) {
    const std::string whole = Encode(extension, Ramp(40, 50, CV_16UC1));
    const Grid<float> expected = ReadHeightMap(whole, HeightMapOptions()).value().height_m;
    for (std::size_t size = 0; size < whole.size(); size += 1 + whole.size() / 97) {
      const Result<Relief> relief =
          ReadHeightMap(std::string_view(whole).substr(0, size), HeightMapOptions());
      // A TIFF may end with bytes that belong to no sample.
      const bool harmless = relief.ok() && extension == std::string(".tiff") &&
                            size > whole.size() - 16 && relief->height_m == expected;
      EXPECT_TRUE(!relief.ok() || harmless)
          << extension << " cut to " << size << " of " << whole.size();
    }
  }
}

TEST(HeightMapTest, SurvivesEveryDamagedByte) {
  for (const char* extension : {".png", ".pgm", ".tiff"}) {
    const std::string whole = Encode(extension, Ramp(33, 34, CV_8UC1));
    for (std::size_t at = 0; at < whole.size(); at += at < 64 ? 1 : 1 + whole.size() / 199) {
      std::string damaged = whole;
      damaged[at] = static_cast<char>(damaged[at] ^ 0xa5);
      const Result<Relief> relief = ReadHeightMap(damaged, HeightMapOptions());
      if (relief.ok()) continue;
      EXPECT_EQ(relief.status().code(), StatusCode::kInvalidArgument);
    }
  }
}

TEST(HeightMapTest, SaysThatADamagedPngIsDamaged) {
  std::string png = Encode(".png", Ramp(40, 40, CV_8UC1));
  png[60] = static_cast<char>(png[60] ^ 1);
  ExpectRefused(png, "checksum");
}

TEST(HeightMapTest, RefusesPgmSamplesAboveTheirMaxval) {
  std::string bytes = "P5 33 33 100\n" + std::string(33 * 33, 'd');  // 'd' is 100
  EXPECT_TRUE(ReadHeightMap(bytes, HeightMapOptions()).ok());
  bytes[bytes.size() - 33 * 33 + 7] = 'e';
  ExpectRefused(bytes, "sample 8 of the PGM height map is 101");
  std::string plain = "P2 33 33 100\n101";
  for (int i = 1; i < 33 * 33; ++i) plain += " 5";
  ExpectRefused(plain, "sample 1 of the PGM height map is 101");
}

// An uncompressed TIFF of one strip, made by hand: 8 bits, 33 x 33 samples.
std::string HandMadeTiff(std::uint32_t strip_offset, std::uint32_t strip_bytes) {
  const std::vector<std::vector<std::uint32_t>> fields = {{256, 33}, {257, 33}, {258, 8},
                                                          {259, 1},  {262, 1},  {273, strip_offset},
                                                          {277, 1},  {278, 33}, {279, strip_bytes}};
  const auto put = [](std::uint32_t value, int size, std::string* bytes) {
    for (int i = 0; i < size; ++i) bytes->push_back(static_cast<char>(value >> (8 * i)));
  };
  std::string bytes("II*\0\x08\0\0\0", 8);
  put(static_cast<std::uint32_t>(fields.size()), 2, &bytes);
  for (const auto& field : fields) {
    put(field[0], 2, &bytes);
    put(4, 2, &bytes);  // LONG
    put(1, 4, &bytes);
    put(field[1], 4, &bytes);
  }
  put(0, 4, &bytes);  // no further directory
  return bytes + std::string(33 * 33, '\x33');
}

TEST(HeightMapTest, RefusesTiffStripsOutsideTheFile) {
  constexpr std::uint32_t kSamples = 33 * 33, kData = 8 + 2 + 9 * 12 + 4;
  const Result<Relief> relief = ReadHeightMap(HandMadeTiff(kData, kSamples), HeightMapOptions());
  ASSERT_TRUE(relief.ok()) << relief.status().ToString();
  EXPECT_NEAR(relief->height_m(32, 32), 20.0f, 1e-4);  // 0x33 of 255
  ExpectRefused(HandMadeTiff(kData + 1, kSamples), "piece 1 of its 1 strips lies outside");
  ExpectRefused(HandMadeTiff(0xffffffffu, kSamples), "piece 1 of its 1 strips lies outside");
  ExpectRefused(HandMadeTiff(kData, 0), "piece 1 of its 1 strips lies outside");
  ExpectRefused(HandMadeTiff(kData, kSamples - 1), "its samples take 1089 bytes, 1088 are there");
}

TEST(HeightMapTest, NamesEveryIllegalOption) {
  HeightMapOptions options;
  options.height_scale_m = -1.0;
  options.height_offset_m = std::nan("");
  const Result<Relief> relief = ReadHeightMap(Encode(".png", Ramp(40, 40, CV_8UC1)), options);
  ASSERT_FALSE(relief.ok());
  EXPECT_EQ(relief.status().violations().size(), 2u);
}

}  // namespace
}  // namespace latticeworld
