#include "latticeworld/relief/relief.h"

#include <algorithm>
#include <utility>

#include "latticeworld/common/check.h"
#include "latticeworld/common/range.h"
#include "latticeworld/relief/caption.h"

namespace latticeworld {
namespace {

// Means of 32 x 32 blocks of whole samples, scaled to [0, 1].
Grid<float> Summarize(const Grid<float>& height_m) {
  Grid<float> summary(kReliefSummarySize, kReliefSummarySize);
  const auto begin = [](int i, int samples) {
    return static_cast<int>(static_cast<std::int64_t>(i) * samples / kReliefSummarySize);
  };
  for (int r = 0; r < kReliefSummarySize; ++r) {
    const int row_end = begin(r + 1, height_m.rows());
    for (int c = 0; c < kReliefSummarySize; ++c) {
      const int col_begin = begin(c, height_m.cols());
      const int col_end = begin(c + 1, height_m.cols());
      double sum = 0.0;
      for (int row = begin(r, height_m.rows()); row < row_end; ++row) {
        for (int col = col_begin; col < col_end; ++col) sum += height_m(row, col);
      }
      const double count =
          static_cast<double>(row_end - begin(r, height_m.rows())) * (col_end - col_begin);
      summary(r, c) = static_cast<float>(sum / count);
    }
  }
  const auto [low, high] = std::minmax_element(summary.begin(), summary.end());
  const float offset = *low;
  const float range = *high - offset;
  for (float& value : summary) value = range > 0.0f ? (value - offset) / range : 0.0f;
  return summary;
}

}  // namespace

std::vector<Violation> Validate(const HeightMapOptions& options) {
  std::vector<Violation> violations;
  CheckRange("height_scale", options.height_scale_m, {0.0, 9000.0}, " m", &violations);
  CheckRange("height_offset", options.height_offset_m, {-9000.0, 9000.0}, " m", &violations);
  return violations;
}

Relief MakeRelief(Grid<float> height_m, double height_step_m) {
  LW_CHECK(height_m.rows() >= kMinReliefSize && height_m.cols() >= kMinReliefSize,
           "a relief has at least 33 samples a side");
  Relief relief;
  relief.summary = Summarize(height_m);
  relief.caption = internal::CaptionOf(height_m);
  relief.height_m = std::move(height_m);
  relief.height_step_m = height_step_m;
  return relief;
}

}  // namespace latticeworld
