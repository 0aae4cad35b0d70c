#include "latticeworld/rendering/views/painting.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace latticeworld {
namespace {

constexpr float kLetterHeight = 21.0f;  // of OpenCV's Hershey fonts at scale 1 [px]
constexpr int kFont = cv::FONT_HERSHEY_DUPLEX;

// A cheap repeatable texture in [0, 1) (integer hash after Wang).
float Speckle(int x, int y) {
  std::uint32_t h =
      static_cast<std::uint32_t>(x) * 73856093u ^ static_cast<std::uint32_t>(y) * 19349663u;
  h = (h ^ 61u) ^ (h >> 16);
  h *= 9u;
  h ^= h >> 4;
  h *= 0x27d4eb2du;
  h ^= h >> 15;
  return static_cast<float>(h & 0xFFFF) / 65536.0f;
}

void PaintLit(int x, int y, const Eigen::Vector3f& normal, const Ball& ball,
              const PictureLight& light, cv::Mat* bgr) {
  const int grain = 1 + static_cast<int>(ball.radius.x() / 9.0f);
  const float speckle = Speckle(x / grain, y / grain);
  if (speckle > ball.foliage) return;
  Color color = ball.color * (1.0f + ball.roughness * (Speckle(y / grain, x / grain) - 0.5f));
  if (ball.snow > 0.0f) {
    const float cover =
        ball.snow * std::clamp(2.2f * normal.z() - 0.7f + 0.5f * speckle, 0.0f, 1.0f);
    color = Mix(color, FromRgb(242, 246, 250), 0.9f * cover);
  }
  bgr->at<cv::Vec3b>(y, x) = ToBytes(Times(color, Shade(light, normal, 1.0f)));
}

}  // namespace

cv::Vec3b ToBytes(const Color& color) {
  const auto byte = [](float value) {
    return static_cast<unsigned char>(std::clamp(value * 255.0f + 0.5f, 0.0f, 255.0f));
  };
  return {byte(color[0]), byte(color[1]), byte(color[2])};
}

void FillPolygon(const std::vector<Eigen::Vector2f>& corners, const Color& color, cv::Mat* bgr) {
  const cv::Vec3b bytes = ToBytes(color);
  float low = corners[0].y(), high = corners[0].y();
  for (const auto& corner : corners) {
    low = std::min(low, corner.y());
    high = std::max(high, corner.y());
  }
  const int first = std::max(0, static_cast<int>(std::ceil(low)));
  const int last = std::min(bgr->rows - 1, static_cast<int>(std::floor(high)));
  for (int y = first; y <= last; ++y) {
    float left = 1e9f, right = -1e9f;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const auto& a = corners[i];
      const auto& b = corners[(i + 1) % corners.size()];
      if ((a.y() > y) == (b.y() > y) && a.y() != y && b.y() != y) continue;
      const float t = a.y() == b.y() ? 0.0f : std::clamp((y - a.y()) / (b.y() - a.y()), 0.0f, 1.0f);
      const float x = a.x() + t * (b.x() - a.x());
      left = std::min(left, x);
      right = std::max(right, x);
    }
    const int x_first = std::max(0, static_cast<int>(std::ceil(left)));
    const int x_last = std::min(bgr->cols - 1, static_cast<int>(std::floor(right)));
    for (int x = x_first; x <= x_last; ++x) bgr->at<cv::Vec3b>(y, x) = bytes;
  }
}

void PaintBall(const Ball& ball, const PictureLight& light, cv::Mat* bgr) {
  const int y_first = std::max(0, static_cast<int>(std::ceil(ball.center.y() - ball.radius.y())));
  const int y_last =
      std::min(bgr->rows - 1, static_cast<int>(std::floor(ball.center.y() + ball.radius.y())));
  const int x_first = std::max(0, static_cast<int>(std::ceil(ball.center.x() - ball.radius.x())));
  const int x_last =
      std::min(bgr->cols - 1, static_cast<int>(std::floor(ball.center.x() + ball.radius.x())));
  for (int y = y_first; y <= y_last; ++y) {
    const float v = (ball.center.y() - y) / ball.radius.y();
    for (int x = x_first; x <= x_last; ++x) {
      const float u = (x - ball.center.x()) / ball.radius.x();
      const float out = u * u + v * v;
      // A ragged rim for leaves.
      if (out > 1.0f - 0.35f * ball.roughness * Speckle(x, y)) continue;
      PaintLit(x, y, Eigen::Vector3f(u, v, std::sqrt(1.0f - out)), ball, light, bgr);
    }
  }
}

void DrawLabel(const std::string& text, const Eigen::Vector2f& at, float height, const Color& color,
               cv::Mat* bgr) {
  const double scale = kSupersample * height / kLetterHeight;
  const int thickness = std::max(1, static_cast<int>(std::lround(scale * 1.25)));
  const cv::Vec3b bytes = ToBytes(color);
  cv::putText(*bgr, text,
              {static_cast<int>(at.x() * kSupersample), static_cast<int>(at.y() * kSupersample)},
              kFont, scale, cv::Scalar(bytes[0], bytes[1], bytes[2]), thickness, cv::LINE_AA);
}

float LabelWidth(const std::string& text, float height) {
  int baseline = 0;
  const double scale = kSupersample * height / kLetterHeight;
  return static_cast<float>(cv::getTextSize(text, kFont, scale, 1, &baseline).width) / kSupersample;
}

}  // namespace latticeworld
