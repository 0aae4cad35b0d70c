#include <algorithm>
#include <array>

#include "latticeworld/common/check.h"
#include "latticeworld/scene/vegetation/scatter.h"

namespace latticeworld {
namespace {

constexpr int kSamples = 96;  // a side: points that the mean clumping of a class is taken of
constexpr std::size_t kMostTerms = 26;  // a class has a letter

}  // namespace

ClumpedDensity::ClumpedDensity(const Placement& placement, AssetKind kind, const Clumping& clumping,
                               const Peak& peak)
    : geometry_(placement.terrain.geometry()),
      density_(DensityFor(placement, kind)),
      clumping_(clumping) {
  LW_CHECK(density_.terms().size() <= kMostTerms, "a class has a letter of its own");
  for (const DensityField::Term& term : density_.terms()) {
    peaks_.push_back(peak(term.letter));
    largest_per_m2_ = std::max(largest_per_m2_, term.per_m2 * peaks_.back());
    means_.push_back(MeanOf(term, peaks_.back()));
  }
}

double ClumpedDensity::MostAt(CellIndex cell) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < peaks_.size(); ++i) {
    const DensityField::Term& term = density_.terms()[i];
    sum += peaks_[i] * term.per_m2 * term.WeightAt(cell);
  }
  return sum;
}

double ClumpedDensity::At(WorldPoint point, double draw, char* letter) const {
  const CellIndex cell = geometry_.CellAt(point);
  const std::vector<DensityField::Term>& terms = density_.terms();
  std::array<double, kMostTerms> part;
  double sum = 0.0;
  for (std::size_t i = 0; i < terms.size(); ++i) {
    const double weight = terms[i].WeightAt(cell);
    part[i] = 0.0;
    if (weight > 0.0) {
      const double times = std::min(peaks_[i], clumping_(point, terms[i].letter) / means_[i]);
      part[i] = weight * terms[i].per_m2 * times;
    }
    sum += part[i];
  }
  draw *= sum;
  for (std::size_t i = 0; i < terms.size(); ++i) {
    if (part[i] <= 0.0) continue;
    *letter = terms[i].letter;
    draw -= part[i];
    if (draw < 0.0) break;
  }
  return sum;
}

// Returns the mean clumping over the points of the class, by samples. What exceeds `peak` times the
// mean is cut off, and the rest is raised for it.
double ClumpedDensity::MeanOf(const DensityField::Term& term, double peak) const {
  struct Sample {
    float weight, clumping;
  };
  std::vector<Sample> samples;
  const double step_m = geometry_.size_m() / kSamples;
  for (int row = 0; row < kSamples; ++row) {
    for (int col = 0; col < kSamples; ++col) {
      const WorldPoint point = {(col + 0.5) * step_m - geometry_.half_size_m(),
                                (row + 0.5) * step_m - geometry_.half_size_m()};
      const auto weight = static_cast<float>(term.WeightAt(geometry_.CellAt(point)));
      if (weight <= 0.0f) continue;
      samples.push_back({weight, static_cast<float>(clumping_(point, term.letter))});
    }
  }
  double mean = 0.0;
  constexpr int kRounds = 3;
  for (int round = 0; round < kRounds; ++round) {
    double weights = 0.0, sum = 0.0;
    for (const Sample& sample : samples) {
      const double times = double{sample.clumping};
      weights += sample.weight;
      sum += sample.weight * (mean > 0.0 ? std::min(peak * mean, times) : times);
    }
    if (weights <= 0.0 || sum <= 0.0) return 1.0;
    mean = sum / weights;
  }
  return mean;
}

}  // namespace latticeworld
