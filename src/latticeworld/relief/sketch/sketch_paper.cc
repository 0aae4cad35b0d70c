#include "latticeworld/relief/sketch/sketch_paper.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include "latticeworld/common/parallel.h"
#include "latticeworld/common/progress.h"
#include "latticeworld/geomorphology/blur.h"
#include "latticeworld/geomorphology/diffusion.h"

namespace latticeworld::internal {
namespace {

constexpr int kBlocks = 384;              // of the longer side, at most
constexpr double kClosingOfSide = 0.035;  // radius of the closing
constexpr int kMinClosing = 6;            // blocks
// Against the picture's bright parts paper is at least this bright, and its palest channel at least
// this share of its strongest.
constexpr float kDarkestPaper = 0.35f;
constexpr float kPalestChannel = 0.72f;
constexpr double kLeastPaper = 0.2;  // of the picture
constexpr float kNail = 1e4f;

float Luminance(float red, float green, float blue) {
  return 0.299f * red + 0.587f * green + 0.114f * blue;
}

// Means of block x block pixels, a channel each.
std::array<Grid<float>, 3> Shrink(const Grid<Rgb>& picture, int block, int threads) {
  const int rows = (picture.rows() + block - 1) / block;
  const int cols = (picture.cols() + block - 1) / block;
  std::array<Grid<float>, 3> small;
  for (Grid<float>& channel : small) channel = Grid<float>(rows, cols, 0.0f);
  ParallelFor(rows, threads, [&](int begin, int end) {
    for (int r = begin; r < end; ++r) {
      const int row_end = std::min(picture.rows(), (r + 1) * block);
      for (int row = r * block; row < row_end; ++row) {
        const Rgb* source = picture.row(row);
        for (int i = 0; i < 3; ++i) {
          float* sums = small[i].row(r);
          for (int c = 0; c < picture.cols(); ++c) sums[c / block] += source[c][i];
        }
      }
      for (int c = 0; c < cols; ++c) {
        const int count =
            (row_end - r * block) * (std::min(picture.cols(), (c + 1) * block) - c * block);
        for (Grid<float>& channel : small) channel(r, c) /= static_cast<float>(count);
      }
    }
  });
  return small;
}

// Replaces each value by the largest (or smallest) within radius cells along rows and columns.
template <typename Pick>
void Extreme(int radius, Pick pick, Grid<float>* values) {
  Grid<float> along(values->rows(), values->cols());
  const int cols = values->cols();
  for (int r = 0; r < values->rows(); ++r) {
    const float* source = values->row(r);
    float* target = along.row(r);
    std::copy(source, source + cols, target);
    for (int d = 1; d <= std::min(radius, cols - 1); ++d) {
      for (int c = d; c < cols; ++c) target[c] = pick(target[c], source[c - d]);
      for (int c = 0; c < cols - d; ++c) target[c] = pick(target[c], source[c + d]);
    }
  }
  for (int r = 0; r < values->rows(); ++r) {
    float* target = values->row(r);
    std::copy(along.row(r), along.row(r) + cols, target);
    const int last = std::min(r + radius, values->rows() - 1);
    for (int other = std::max(0, r - radius); other <= last; ++other) {
      const float* source = along.row(other);
      for (int c = 0; c < cols; ++c) target[c] = pick(target[c], source[c]);
    }
  }
}

void Close(int radius, Grid<float>* values) {
  Extreme(
      radius, [](float a, float b) { return std::max(a, b); }, values);
  Extreme(
      radius, [](float a, float b) { return std::min(a, b); }, values);
}

// The mean colour of the brighter part of the picture.
std::array<float, 3> BrightColour(const std::array<Grid<float>, 3>& closed) {
  std::vector<float> luminance(closed[0].size());
  for (std::size_t i = 0; i < luminance.size(); ++i) {
    luminance[i] = Luminance(closed[0].data()[i], closed[1].data()[i], closed[2].data()[i]);
  }
  std::vector<float> sorted = luminance;
  const auto median = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() * 6 / 10);
  std::nth_element(sorted.begin(), median, sorted.end());
  std::array<double, 3> sum{};
  double count = 0.0;
  for (std::size_t i = 0; i < luminance.size(); ++i) {
    if (luminance[i] < *median) continue;
    for (int k = 0; k < 3; ++k) sum[k] += closed[k].data()[i];
    count += 1.0;
  }
  std::array<float, 3> colour;
  for (int k = 0; k < 3; ++k) colour[k] = static_cast<float>(std::max(1.0, sum[k] / count));
  return colour;
}

}  // namespace

Result<Paper> Paper::Estimate(const Grid<Rgb>& picture, int threads) {
  // A closing of the shrunk picture takes away thin strokes.
  const int side = std::max(picture.rows(), picture.cols());
  Paper paper((side + kBlocks - 1) / kBlocks, picture.cols());
  paper.brightness_ = Shrink(picture, paper.block_, threads);
  const int small_side = std::max(paper.brightness_[0].rows(), paper.brightness_[0].cols());
  const int radius = std::max(kMinClosing, static_cast<int>(kClosingOfSide * small_side));
  ParallelFor(3, threads, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      // Else single bright grains of noise would count.
      GaussianBlur(1.0, &paper.brightness_[i], 1);
      Close(radius, &paper.brightness_[i]);
    }
  });

  // Fill what the closing left dark or coloured: wide strokes and painted areas.
  const std::array<float, 3> bright = BrightColour(paper.brightness_);
  const float bright_luminance = Luminance(bright[0], bright[1], bright[2]);
  Grid<float> stiffness(paper.brightness_[0].rows(), paper.brightness_[0].cols());
  std::size_t paper_cells = 0;
  for (std::size_t i = 0; i < stiffness.size(); ++i) {
    const float red = paper.brightness_[0].data()[i];
    const float green = paper.brightness_[1].data()[i];
    const float blue = paper.brightness_[2].data()[i];
    const auto [least, most] = std::minmax({red / bright[0], green / bright[1], blue / bright[2]});
    const bool is_paper = Luminance(red, green, blue) >= kDarkestPaper * bright_luminance &&
                          least >= kPalestChannel * most;
    stiffness.data()[i] = is_paper ? kNail : 0.0f;
    paper_cells += is_paper;
  }
  // There must be paper, and it must be white and bright.
  const auto [weakest, strongest] = std::minmax({bright[0], bright[1], bright[2]});
  if (paper_cells < kLeastPaper * stiffness.size() || weakest < 0.45f * strongest ||
      bright_luminance < 40.0f) {
    return InvalidArgument(
        "the sketch has no white paper: its brighter parts are red " +
        std::to_string(std::lround(bright[0])) + ", green " +
        std::to_string(std::lround(bright[1])) + ", blue " +
        std::to_string(std::lround(bright[2])) + ", and " +
        std::to_string(100 * paper_cells / stiffness.size()) +
        " % of the picture is like them; legal are blue strokes (valleys) and black strokes "
        "(ridges) on white paper");
  }
  // A membrane that is nailed to the paper fills what is none.
  if (paper_cells < stiffness.size()) {
    MembraneOptions options;
    options.cycles = 3;
    options.threads = threads;
    for (Grid<float>& channel : paper.brightness_) {
      LW_ASSIGN_OR_RETURN(channel, SolveMembrane(stiffness, channel, options, Progress()));
    }
  }
  for (Grid<float>& channel : paper.brightness_) {
    for (float& value : channel) value = std::clamp(value, 1.0f, 255.0f);
  }
  return paper;
}

void Paper::Row(int row, int channel, float* brightness) const {
  const Grid<float>& small = brightness_[channel];
  const float scale = 1.0f / static_cast<float>(block_);
  const auto place = [scale](int i, int count, int* first, int* second) {
    const float at = std::clamp((static_cast<float>(i) + 0.5f) * scale - 0.5f, 0.0f,
                                static_cast<float>(count) - 1.0f);
    *first = static_cast<int>(at);
    *second = std::min(*first + 1, count - 1);
    return at - static_cast<float>(*first);
  };
  int upper;
  int lower;
  const float v = place(row, small.rows(), &upper, &lower);
  const float* a = small.row(upper);
  const float* b = small.row(lower);
  for (int c = 0; c < cols_; ++c) {
    int left;
    int right;
    const float u = place(c, small.cols(), &left, &right);
    const float above = a[left] + u * (a[right] - a[left]);
    const float below = b[left] + u * (b[right] - b[left]);
    brightness[c] = above + v * (below - above);
  }
}

}  // namespace latticeworld::internal
