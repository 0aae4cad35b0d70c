#include "latticeworld/rendering/ray/ray_film.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "latticeworld/common/parallel.h"
#include "latticeworld/rendering/views/painting.h"

namespace latticeworld {
namespace {

// The film is so sensitive that a thing in the sun looks about as its own colour does.
constexpr float kFilmSpeed = 0.44f;

// What outlines are found by.
struct Seen {
  cv::Mat distance_m;  // CV_32FC1
  cv::Mat thing;       // CV_32SC1
  cv::Mat rim;         // CV_8UC3
};

cv::Vec3b ToPixel(const Light& display) {
  return ToBytes(Color(display[2], display[1], display[0]));
}

// 1 where another thing, or the same much farther away, is next to a sample that is nearer.
float EdgeAt(const Seen& seen, int x, int y, int reach) {
  const int thing = seen.thing.at<int>(y, x);
  const float distance_m = seen.distance_m.at<float>(y, x);
  float edge = 0.0f;
  for (const auto& step :
       {cv::Point(reach, 0), cv::Point(-reach, 0), cv::Point(0, reach), cv::Point(0, -reach)}) {
    const int nx = std::clamp(x + step.x, 0, seen.thing.cols - 1);
    const int ny = std::clamp(y + step.y, 0, seen.thing.rows - 1);
    const float other_m = seen.distance_m.at<float>(ny, nx);
    if (other_m <= distance_m) continue;
    const bool apart = other_m > 1.02f * distance_m + 0.4f;
    if (seen.thing.at<int>(ny, nx) != thing && (apart || thing != 0)) {
      edge = std::max(edge, apart ? 1.0f : 0.6f);
    }
  }
  return thing == 0 ? 0.0f : edge;
}

void DrawOutlines(const Seen& seen, const FilmOptions& options, cv::Mat* bgr) {
  const int reach = std::max(1, bgr->cols / 1400) * (options.rims ? 2 : 1);  // neon is thick
  const cv::Mat before = bgr->clone();
  ParallelFor(bgr->rows, options.threads, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < bgr->cols; ++x) {
        const float edge = EdgeAt(seen, x, y, reach);
        if (edge <= 0.0f) continue;
        // Far lines are thin and faint.
        const float near = std::clamp(260.0f / seen.distance_m.at<float>(y, x), 0.25f, 1.0f);
        cv::Vec3b& pixel = bgr->at<cv::Vec3b>(y, x);
        const cv::Vec3b rim = seen.rim.at<cv::Vec3b>(y, x);
        for (int channel = 0; channel < 3; ++channel) {
          const float dark = before.at<cv::Vec3b>(y, x)[channel] * (1.0f - 0.72f * edge * near);
          const float bright =
              std::min(255.0f, before.at<cv::Vec3b>(y, x)[channel] + edge * rim[channel]);
          pixel[channel] = static_cast<unsigned char>(options.rims ? bright : dark);
        }
      }
    }
  });
}

// Light spills over from what shines (CV_8UC3): wide and faint.
void Bloom(const cv::Mat& shine, cv::Mat* bgr) {
  cv::Mat bright, wide;
  cv::resize(shine, bright, {}, 0.25, 0.25, cv::INTER_AREA);
  cv::GaussianBlur(bright, wide, {}, std::max(1.0, bright.cols / 90.0));
  cv::GaussianBlur(bright, bright, {}, std::max(0.8, bright.cols / 400.0));
  cv::Mat glow = 0.5 * bright + 1.1 * wide;
  cv::resize(glow, glow, bgr->size(), 0, 0, cv::INTER_LINEAR);
  *bgr += glow;
}

}  // namespace

Light Developed(const Light& light, float exposure) {
  const Light x = light.max(0.0f) * (kFilmSpeed * exposure);
  const Light film = (x * (2.51f * x + 0.03f)) / (x * (2.43f * x + 0.59f) + 0.14f);
  return film.min(1.0f).unaryExpr([](float value) { return FromLinear(value); });
}

Status Expose(const std::function<FilmSample(int x_px, int y_px)>& sample,
              const FilmOptions& options, const Progress& progress, cv::Mat* bgr) {
  const bool lines = options.outlines || options.rims;
  Seen seen;
  if (lines) {
    seen.distance_m.create(bgr->size(), CV_32FC1);
    seen.thing.create(bgr->size(), CV_32SC1);
    seen.rim.create(bgr->size(), CV_8UC3);
  }
  cv::Mat shine;
  if (options.bloom) shine = cv::Mat::zeros(bgr->size(), CV_8UC3);
  // Stripes of the picture one after another; in each, every row is its own part, and neighbours
  // in a stripe are as costly, so that no thread waits long.
  constexpr int kStripe_px = 32;
  for (int first = 0; first < bgr->rows; first += kStripe_px) {
    LW_RETURN_IF_ERROR(progress.CheckCancelled());
    progress.Report("picture", static_cast<double>(first) / bgr->rows);
    const int count = std::min(kStripe_px, bgr->rows - first);
    ParallelFor(count, options.threads, [&](int begin, int end) {
      for (int y = first + begin; y < first + end; ++y) {
        for (int x = 0; x < bgr->cols; ++x) {
          const FilmSample caught = sample(x, y);
          if (!caught.is_clear)
            bgr->at<cv::Vec3b>(y, x) = ToPixel(Developed(caught.light, options.exposure));
          if (options.bloom && caught.shine.maxCoeff() > 0.0f)
            shine.at<cv::Vec3b>(y, x) = ToPixel(Developed(caught.shine, options.exposure));
          if (!lines) continue;
          seen.distance_m.at<float>(y, x) = caught.distance_m;
          seen.thing.at<int>(y, x) = static_cast<int>(caught.thing);
          seen.rim.at<cv::Vec3b>(y, x) = ToPixel(caught.rim);
        }
      }
    });
  }
  if (lines) DrawOutlines(seen, options, bgr);
  if (options.bloom) Bloom(shine, bgr);
  progress.Report("picture", 1.0);
  return Status();
}

}  // namespace latticeworld
