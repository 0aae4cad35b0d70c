#include "latticeworld/relief/sketch/sketch_ink.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "latticeworld/common/parallel.h"

namespace latticeworld::internal {
namespace {

constexpr int kColourReach = 2;  // pixels around over which colour is averaged
constexpr int kPeakReach = 3;    // pixels around in which the darkest one is looked for
constexpr int kBandRows = 64;    // rows that are worked on together
constexpr int kNoiseSamples = 1 << 16;

// A stroke's darkest pixels are at least kStrong darker than paper, its others kWeak and kOfPeak of
// the darkest; more where the paper is noisy. Shares of the paper's brightness.
constexpr float kWeak = 0.13f;
constexpr float kStrong = 0.22f;
constexpr float kMostWeak = 0.3f;
constexpr float kMostStrong = 0.45f;
constexpr float kOfPeak = 0.47f;
constexpr float kShade = 0.12f;
// Colours that are this weak (against the strongest) say nothing.
constexpr float kColourless = 0.17f;

struct Thresholds {
  float bias = 0.0f;  // how dark most of the paper is against its estimate, which is a maximum
  float weak = kWeak;
  float strong = kStrong;
};

// How much light is missing along one row, a channel each: 0 on paper, 1 on perfect black, negative
// where brighter than paper.
void AbsorbedRow(const Grid<Rgb>& picture, const Paper& paper, int row, int channel, float bias,
                 float* absorbed) {
  paper.Row(row, channel, absorbed);
  const Rgb* source = picture.row(row);
  for (int c = 0; c < picture.cols(); ++c) {
    absorbed[c] = 1.0f - bias - static_cast<float>(source[c][channel]) / absorbed[c];
  }
}

float Median(std::vector<float>* values) {
  const auto middle = values->begin() + static_cast<std::ptrdiff_t>(values->size() / 2);
  std::nth_element(values->begin(), middle, values->end());
  return *middle;
}

// Paper and its noise, from pixels spread over the picture.
Thresholds MeasurePaper(const Grid<Rgb>& picture, const Paper& paper) {
  const int step =
      std::max(1, static_cast<int>(std::sqrt(static_cast<double>(picture.size()) / kNoiseSamples)));
  const int cols = picture.cols();
  std::vector<float> absorbed(3 * static_cast<std::size_t>(cols));
  std::vector<float> blank;
  for (int r = step / 2; r < picture.rows(); r += step) {
    for (int i = 0; i < 3; ++i) {
      AbsorbedRow(picture, paper, r, i, 0.0f, absorbed.data() + static_cast<std::size_t>(i) * cols);
    }
    for (int c = step / 2; c < cols; c += step) {
      for (int i = 0; i < 3; ++i) {
        const float value = absorbed[static_cast<std::size_t>(i) * cols + c];
        if (value < kStrong) blank.push_back(value);
      }
    }
  }
  Thresholds thresholds;
  if (blank.empty()) return thresholds;
  thresholds.bias = Median(&blank);
  for (float& value : blank) value = std::abs(value - thresholds.bias);
  // The median deviation of normal noise is 0.67 of its standard deviation.
  const float noise = 1.4826f * Median(&blank);
  thresholds.weak = std::clamp(4.0f * noise, kWeak, kMostWeak);
  thresholds.strong = std::clamp(7.0f * noise, kStrong, kMostStrong);
  return thresholds;
}

// The colour of ink that takes away so much of red, green and blue.
Ink ColourOf(float red, float green, float blue) {
  const auto [least, most] = std::minmax({red, green, blue});
  const float range = most - least;
  if (most <= 0.0f || range < kColourless * most) {
    // Near neutral: only blue is looked at closer.
    const bool bluish = blue <= least && most > 0.0f;
    return bluish ? static_cast<Ink>(kFullBlue * range / most) : Ink{0};
  }
  // Hue [degrees] of what is left of white, red 0, green 120, blue 240.
  float hue;
  if (least == red) {
    hue = 60.0f * (blue - green) / range;
  } else if (least == green) {
    hue = 120.0f + 60.0f * (red - blue) / range;
  } else {
    hue = 240.0f + 60.0f * (green - red) / range;
  }
  if (hue < 0.0f) hue += 360.0f;
  if (hue >= 172.0f && hue < 275.0f) {
    return static_cast<Ink>(kFullBlue * std::min(1.0f, range / most));
  }
  if (hue >= 275.0f && hue < 325.0f) return kViolet;
  if (hue < 18.0f || hue >= 325.0f) return kRed;
  if (hue < 48.0f) return kOrange;
  if (hue < 72.0f) return kYellow;
  return kGreen;
}

// Works on some rows at a time.
class Band {
 public:
  Band(const Grid<Rgb>& picture, const Paper& paper, const Thresholds& thresholds)
      : picture_(picture),
        paper_(paper),
        thresholds_(thresholds),
        cols_(picture.cols()),
        line_(cols_ + 2 * kReach) {}

  void Find(int begin, int end, Grid<Ink>* ink) {
    first_ = std::max(0, begin - kReach);
    const int last = std::min(picture_.rows(), end + kReach);
    for (Grid<float>& plane : absorbed_) plane = Grid<float>(last - first_, cols_);
    for (Grid<float>& plane : summed_) plane = Grid<float>(last - first_, cols_);
    darkness_ = Grid<float>(last - first_, cols_);
    peak_ = Grid<float>(last - first_, cols_);
    for (int r = 0; r < last - first_; ++r) MeasureRow(r);
    for (int r = begin; r < end; ++r) DecideRow(r, ink->row(r));
  }

 private:
  static constexpr int kReach = std::max(kColourReach, kPeakReach);

  // Absorption, and along the row its sums and peaks.
  void MeasureRow(int r) {
    float* darkness = darkness_.row(r);
    for (int i = 0; i < 3; ++i) {
      float* absorbed = absorbed_[i].row(r);
      AbsorbedRow(picture_, paper_, first_ + r, i, thresholds_.bias, absorbed);
      float* sums = summed_[i].row(r);
      Pad(absorbed);
      const float* middle = line_.data() + kReach;
      for (int c = 0; c < cols_; ++c) {
        sums[c] = (middle[c - 2] + middle[c - 1]) + middle[c] + (middle[c + 1] + middle[c + 2]);
      }
      for (int c = 0; c < cols_; ++c) {
        darkness[c] = i == 0 ? absorbed[c] : std::max(darkness[c], absorbed[c]);
      }
    }
    Pad(darkness);
    const float* middle = line_.data() + kReach;
    float* peak = peak_.row(r);
    std::copy(darkness, darkness + cols_, peak);
    for (int d = 1; d <= kPeakReach; ++d) {
      for (int c = 0; c < cols_; ++c) {
        peak[c] = std::max(peak[c], std::max(middle[c - d], middle[c + d]));
      }
    }
  }

  void DecideRow(int row, Ink* ink) const {
    const int r = row - first_;
    const auto rows_around = [&](int reach, auto visit) {
      for (int d = -reach; d <= reach; ++d) {
        visit(std::clamp(r + d, 0, darkness_.rows() - 1));
      }
    };
    std::vector<float> peak(cols_, 0.0f);
    rows_around(kPeakReach, [&](int other) {
      const float* source = peak_.row(other);
      for (int c = 0; c < cols_; ++c) peak[c] = std::max(peak[c], source[c]);
    });
    const float* darkness = darkness_.row(r);
    const float shade = std::max(kShade, thresholds_.weak);
    for (int c = 0; c < cols_; ++c) {
      if (darkness[c] < thresholds_.weak) {
        ink[c] = kNoInk;
      } else if (peak[c] < thresholds_.strong) {
        ink[c] = darkness[c] >= shade ? kTint : kNoInk;
      } else if (darkness[c] < kOfPeak * peak[c]) {
        ink[c] = kNoInk;
      } else {
        float colour[3] = {0.0f, 0.0f, 0.0f};
        rows_around(kColourReach, [&](int other) {
          for (int i = 0; i < 3; ++i) colour[i] += summed_[i](other, c);
        });
        ink[c] = ColourOf(colour[0], colour[1], colour[2]);
      }
    }
  }

  // Copies a row between kReach repetitions of its ends.
  void Pad(const float* row) {
    std::fill(line_.begin(), line_.begin() + kReach, row[0]);
    std::copy(row, row + cols_, line_.begin() + kReach);
    std::fill(line_.end() - kReach, line_.end(), row[cols_ - 1]);
  }

  const Grid<Rgb>& picture_;
  const Paper& paper_;
  Thresholds thresholds_;
  int cols_;
  int first_ = 0;  // row of the picture that the first row of the planes is
  std::vector<float> line_;
  Grid<float> absorbed_[3];
  Grid<float> summed_[3];  // over kColourReach to both sides
  Grid<float> darkness_;   // the most absorbed channel
  Grid<float> peak_;       // its largest value over kPeakReach to both sides
};

}  // namespace

Grid<Ink> FindInk(const Grid<Rgb>& picture, const Paper& paper, int threads) {
  const Thresholds thresholds = MeasurePaper(picture, paper);
  Grid<Ink> ink(picture.rows(), picture.cols());
  const int bands = (picture.rows() + kBandRows - 1) / kBandRows;
  ParallelFor(bands, threads, [&](int begin, int end) {
    Band band(picture, paper, thresholds);
    for (int i = begin; i < end; ++i) {
      band.Find(i * kBandRows, std::min(picture.rows(), (i + 1) * kBandRows), &ink);
    }
  });
  return ink;
}

}  // namespace latticeworld::internal
