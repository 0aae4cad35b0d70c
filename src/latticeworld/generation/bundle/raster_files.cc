#include "latticeworld/generation/bundle/raster_files.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <vector>

namespace latticeworld {
namespace {

template <typename Pixel>
Result<std::string> EncodePng(const Grid<Pixel>& pixels) {
  constexpr int kType = sizeof(Pixel) == 2 ? CV_16UC1 : CV_8UC1;
  try {
    const cv::Mat image(pixels.rows(), pixels.cols(), kType, const_cast<Pixel*>(pixels.data()));
    std::vector<unsigned char> bytes;
    // Level 1: a third of the time of the default for a few percent more bytes.
    if (!cv::imencode(".png", image, bytes, {cv::IMWRITE_PNG_COMPRESSION, 1})) {
      return Internal("cannot encode a PNG");
    }
    return std::string(bytes.begin(), bytes.end());
  } catch (const cv::Exception& error) {
    return Internal(std::string("cannot encode a PNG: ") + error.what());
  }
}

}  // namespace

Result<HeightPng> EncodeHeights(const Grid<float>& height_m) {
  const auto [lowest, highest] = std::minmax_element(height_m.begin(), height_m.end());
  HeightPng encoded;
  encoded.offset_m = *lowest;
  encoded.scale_m = static_cast<double>(*highest) - *lowest;
  const double values_per_m = encoded.scale_m > 0.0 ? 65535.0 / encoded.scale_m : 0.0;
  Grid<std::uint16_t> pixels(height_m.rows(), height_m.cols());
  std::transform(height_m.begin(), height_m.end(), pixels.begin(), [&](float height) {
    return static_cast<std::uint16_t>(std::lround((height - encoded.offset_m) * values_per_m));
  });
  LW_ASSIGN_OR_RETURN(encoded.png, EncodePng(pixels));
  return encoded;
}

Result<WaterPng> EncodeWaterDepths(const Terrain& terrain) {
  const Grid<float>& level_m = terrain.water_level_m;
  const Grid<float>& ground_m = terrain.ground.height_m();
  Grid<float> depth_m(level_m.rows(), level_m.cols());  // NaN: dry
  WaterPng encoded;
  for (std::size_t i = 0; i < depth_m.size(); ++i) {
    // A shore cell may stand above the level: wet, with no depth.
    const float level = level_m.data()[i];
    const float depth = std::isnan(level) ? level : std::max(level - ground_m.data()[i], 0.0f);
    depth_m.data()[i] = depth;
    if (depth > encoded.scale_m) encoded.scale_m = depth;
  }
  const double values_per_m = encoded.scale_m > 0.0 ? 65534.0 / encoded.scale_m : 0.0;
  Grid<std::uint16_t> pixels(depth_m.rows(), depth_m.cols());
  std::transform(depth_m.begin(), depth_m.end(), pixels.begin(), [&](float depth) {
    if (std::isnan(depth)) return std::uint16_t{0};
    return static_cast<std::uint16_t>(1 + std::lround(depth * values_per_m));
  });
  LW_ASSIGN_OR_RETURN(encoded.png, EncodePng(pixels));
  return encoded;
}

Result<std::string> EncodeWeights(const WeightGrid& weight) { return EncodePng(weight.levels()); }

}  // namespace latticeworld
