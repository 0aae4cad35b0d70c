#include "latticeworld/language/local/decoding/height_eyes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "latticeworld/language/local/decoding/area_means.h"
#include "latticeworld/language/local/decoding/attention_cache.h"
#include "latticeworld/relief/relief.h"

namespace latticeworld {
namespace {

constexpr float kNormEpsilon = 1e-5f;

// GELU (Hendrycks and Gimpel 2016), by the error function.
void GateWithError(std::vector<float>* values) {
  for (float& value : *values) value *= 0.5f * (1.0f + std::erf(value * 0.70710678f));
}

void AddTo(std::vector<float>* sums, const std::vector<float>& terms) {
  for (std::size_t i = 0; i < sums->size(); ++i) (*sums)[i] += terms[i];
}

// Mean 0 and standard deviation 1; flat land stays 0.
void Normalize(std::vector<float>* samples) {
  double sum = 0.0, squares = 0.0;
  for (const float sample : *samples) sum += sample;
  const double mean = sum / static_cast<double>(samples->size());
  for (const float sample : *samples) squares += (sample - mean) * (sample - mean);
  const double deviation = std::sqrt(squares / static_cast<double>(samples->size()));
  for (float& sample : *samples)
    sample = static_cast<float>((sample - mean) / std::max(deviation, 1e-6));
}

}  // namespace

std::vector<float> HeightEyes::Linear::operator()(const std::vector<float>& in,
                                                  std::size_t count) const {
  std::vector<float> out(count * weights.rows());
  weights.Multiply(in.data(), count, out.data());
  for (std::size_t i = 0; i < out.size(); ++i) out[i] += bias[i % bias.size()];
  return out;
}

std::vector<float> HeightEyes::Norm::operator()(const std::vector<float>& in) const {
  const std::size_t width = gains.size();
  std::vector<float> out(in.size());
  for (std::size_t begin = 0; begin < in.size(); begin += width) {
    double sum = 0.0, squares = 0.0;
    for (std::size_t i = 0; i < width; ++i) sum += in[begin + i];
    const double mean = sum / static_cast<double>(width);
    for (std::size_t i = 0; i < width; ++i)
      squares += (in[begin + i] - mean) * (in[begin + i] - mean);
    const double scale = 1.0 / std::sqrt(squares / static_cast<double>(width) + kNormEpsilon);
    for (std::size_t i = 0; i < width; ++i)
      out[begin + i] = static_cast<float>((in[begin + i] - mean) * scale) * gains[i] + bias[i];
  }
  return out;
}

Result<std::vector<float>> HeightEyes::See(std::string_view picture) const {
  HeightMapOptions options;
  options.height_scale_m = 1.0;
  LW_ASSIGN_OR_RETURN(const Relief relief, ReadHeightMap(picture, options));
  return See(relief.height_m);
}

std::vector<float> HeightEyes::See(const Grid<float>& heights) const {
  std::vector<float> places = Patches(heights);
  for (const Layer& layer : layers_) {
    Attend(layer, &places);
    FeedForward(layer, &places);
  }
  return Project({places.begin() + static_cast<std::ptrdiff_t>(width_), places.end()});
}

std::vector<float> HeightEyes::Patches(const Grid<float>& heights) const {
  std::vector<float> samples = AreaMeans(heights, side_);
  Normalize(&samples);
  std::vector<float> in;
  in.reserve(samples.size());
  for (std::size_t row = 0; row < side_; row += patch_)
    for (std::size_t col = 0; col < side_; col += patch_)
      for (std::size_t r = row; r < row + patch_; ++r)
        in.insert(in.end(), samples.data() + r * side_ + col,
                  samples.data() + r * side_ + col + patch_);
  std::vector<float> places = whole_;
  const std::vector<float> seen = patches_(in, grid_ * grid_);
  places.insert(places.end(), seen.begin(), seen.end());
  AddTo(&places, places_);
  return places;
}

void HeightEyes::Attend(const Layer& layer, std::vector<float>* places) const {
  const std::size_t count = places->size() / width_;
  const std::size_t stride = 3 * width_, head_width = width_ / heads_;
  const std::vector<float> parts = layer.queries_keys_values(layer.first_norm(*places), count);
  AttentionCache cache(heads_, head_width);
  cache.Append(parts.data() + width_, parts.data() + 2 * width_, stride, count);
  std::vector<float> made(places->size());
  for (std::size_t head = 0; head < heads_; ++head)
    for (std::size_t i = 0; i < count; ++i)
      cache.Attend(head, parts.data() + i * stride + head * head_width, count,
                   made.data() + i * width_ + head * head_width);
  AddTo(places, layer.attended(made, count));
}

void HeightEyes::FeedForward(const Layer& layer, std::vector<float>* places) const {
  const std::size_t count = places->size() / width_;
  std::vector<float> hidden = layer.up(layer.second_norm(*places), count);
  GateWithError(&hidden);
  AddTo(places, layer.down(hidden, count));
}

std::vector<float> HeightEyes::Project(const std::vector<float>& features) const {
  const std::vector<float> normed = projection_norm_(features);
  const auto grid = static_cast<std::ptrdiff_t>(grid_);
  std::vector<float> around(places() * 9 *
                            width_);  // (places x 9 x width); nothing beyond the edges
  float* out = around.data();
  for (std::ptrdiff_t row = 0; row < grid; row += 2) {
    for (std::ptrdiff_t col = 0; col < grid; col += 2) {
      for (std::ptrdiff_t r = row - 1; r <= row + 1; ++r) {
        for (std::ptrdiff_t c = col - 1; c <= col + 1; ++c, out += width_) {
          if (r < 0 || r >= grid || c < 0 || c >= grid) continue;
          std::copy_n(normed.data() + static_cast<std::size_t>(r * grid + c) * width_, width_, out);
        }
      }
    }
  }
  std::vector<float> near = near_(around, places());
  GateWithError(&near);
  return each_(near, places());
}

}  // namespace latticeworld
