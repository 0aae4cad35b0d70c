#include "relief/sketch_pictures.h"

#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

namespace latticeworld {
namespace {

using Line = std::vector<cv::Point2d>;  // in shares of the picture

const std::vector<Line>& Valleys() {
  static const std::vector<Line> lines = {
      {{0.0, 0.55}, {0.2, 0.5}, {0.4, 0.57}, {0.6, 0.48}, {0.8, 0.52}, {1.0, 0.46}},
      {{0.2, 0.12}, {0.27, 0.3}, {0.4, 0.57}},
      {{0.55, 0.92}, {0.57, 0.7}, {0.6, 0.48}},
      {{0.85, 0.1}, {0.78, 0.3}, {0.8, 0.52}},
  };
  return lines;
}

const std::vector<Line>& Ridges() {
  static const std::vector<Line> lines = {
      {{0.05, 0.08}, {0.1, 0.25}, {0.16, 0.4}},
      {{0.42, 0.06}, {0.5, 0.22}, {0.52, 0.38}, {0.64, 0.3}},
      {{0.3, 0.94}, {0.42, 0.75}, {0.46, 0.66}},
      {{0.7, 0.93}, {0.8, 0.75}, {0.92, 0.62}},
  };
  return lines;
}

void Draw(const std::vector<Line>& lines, const cv::Scalar& colour, int thickness, int line_type,
          cv::Mat* picture) {
  for (const Line& line : lines) {
    std::vector<cv::Point> points;
    for (const cv::Point2d& p : line) {
      points.emplace_back(static_cast<int>(p.x * (picture->cols - 1)),
                          static_cast<int>(p.y * (picture->rows - 1)));
    }
    cv::polylines(*picture, points, false, colour, thickness, line_type);
  }
}

}  // namespace

DrawnSketch DrawRiversAndRidges(int rows, int cols, const Inks& inks) {
  DrawnSketch drawn;
  drawn.picture = cv::Mat(rows, cols, CV_8UC3, cv::Scalar(255, 255, 255));
  Draw(Valleys(), inks.valley, inks.thickness, cv::LINE_AA, &drawn.picture);
  Draw(Ridges(), inks.ridge, inks.thickness, cv::LINE_AA, &drawn.picture);
  cv::Mat truth(rows, cols, CV_8UC1, cv::Scalar(0));
  Draw(Valleys(), cv::Scalar(1), inks.thickness, cv::LINE_8, &truth);
  Draw(Ridges(), cv::Scalar(2), inks.thickness, cv::LINE_8, &truth);
  drawn.strokes = Sketch(rows, cols);
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < cols; ++c) {
      drawn.strokes(r, c) = static_cast<Stroke>(truth.at<unsigned char>(r, c));
    }
  }
  return drawn;
}

std::string EncodePicture(const std::string& extension, const cv::Mat& picture,
                          const std::vector<int>& parameters) {
  std::vector<unsigned char> bytes;
  EXPECT_TRUE(cv::imencode(extension, picture, bytes, parameters));
  return std::string(bytes.begin(), bytes.end());
}

}  // namespace latticeworld
