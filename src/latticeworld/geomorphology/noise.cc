#include "latticeworld/geomorphology/noise.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "latticeworld/common/parallel.h"
#include "latticeworld/common/random.h"
#include "latticeworld/geomorphology/grid_threads.h"

namespace latticeworld {
namespace {

// Brings 2D gradient noise with unit gradients, at most sqrt(1/2), to at most 1.
constexpr float kPerlinScale = 1.41421356f;

struct Gradient {
  float x;
  float y;
};

// Quintic fade, whose second derivative vanishes at the lattice.
float Fade(float t) { return t * t * t * (t * (t * 6.0f - 15.0f) + 10.0f); }

// One octave, produced row by row.
class Octave {
 public:
  Octave(const GridGeometry& geometry, double wavelength_m, std::uint64_t seed)
      : geometry_(geometry),
        seed_(seed),
        inverse_wavelength_(1.0 / wavelength_m),
        // Noise vanishes at its lattice points: without a shift the world's centre would be one.
        shift_x_(HashToUnit(~seed, 0, 0)),
        shift_y_(HashToUnit(~seed, 1, 0)) {
    fraction_.resize(geometry.cols());
    fade_.resize(geometry.cols());
    std::int64_t previous = 0;
    for (int c = 0; c < geometry.cols(); ++c) {
      const double x = geometry.CenterOf({0, c}).x_m * inverse_wavelength_ + shift_x_;
      const auto lattice = static_cast<std::int64_t>(std::floor(x));
      if (c == 0) first_lattice_ = lattice;
      if (c == 0 || lattice != previous) {
        for (std::int64_t i = c == 0 ? lattice : previous + 1; i <= lattice; ++i) {
          begin_.push_back(c);
        }
        previous = lattice;
      }
      fraction_[c] = static_cast<float>(x - std::floor(x));
      fade_[c] = Fade(fraction_[c]);
    }
    begin_.push_back(geometry.cols());
    upper_.resize(begin_.size());
    lower_.resize(begin_.size());
  }

  // values: one row of noise in [-1, 1].
  void Row(int row, float* values) {
    const double y = geometry_.CenterOf({row, 0}).y_m * inverse_wavelength_ + shift_y_;
    const auto lattice = static_cast<std::int64_t>(std::floor(y));
    if (!filled_ || lattice != lattice_y_) {
      if (filled_ && lattice == lattice_y_ - 1) {
        std::swap(upper_, lower_);  // the next line of the lattice to the south
      } else {
        FillGradients(lattice + 1, &upper_);
      }
      FillGradients(lattice, &lower_);
      lattice_y_ = lattice;
      filled_ = true;
    }
    const auto v = static_cast<float>(y - std::floor(y));
    const float fade_v = Fade(v);
    for (std::size_t i = 0; i + 1 < begin_.size(); ++i) {
      // Along a row each side of a lattice cell is linear in the fraction u: slope * u + offset.
      const Gradient& sw = lower_[i];
      const Gradient& se = lower_[i + 1];
      const Gradient& nw = upper_[i];
      const Gradient& ne = upper_[i + 1];
      const float west_slope = sw.x + fade_v * (nw.x - sw.x);
      const float west_offset = sw.y * v + fade_v * (nw.y * (v - 1.0f) - sw.y * v);
      const float east_slope = se.x + fade_v * (ne.x - se.x);
      const float east_offset = se.y * v + fade_v * (ne.y * (v - 1.0f) - se.y * v) - east_slope;
      for (int c = begin_[i]; c < begin_[i + 1]; ++c) {
        const float west = west_slope * fraction_[c] + west_offset;
        const float east = east_slope * fraction_[c] + east_offset;
        values[c] = kPerlinScale * (west + fade_[c] * (east - west));
      }
    }
  }

 private:
  void FillGradients(std::int64_t lattice_y, std::vector<Gradient>* gradients) const {
    for (std::size_t i = 0; i < gradients->size(); ++i) {
      const double angle =
          2.0 * M_PI * HashToUnit(seed_, first_lattice_ + static_cast<std::int64_t>(i), lattice_y);
      (*gradients)[i] = {static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle))};
    }
  }

  GridGeometry geometry_;
  std::uint64_t seed_;
  double inverse_wavelength_;
  double shift_x_;  // in lattice cells
  double shift_y_;
  std::int64_t first_lattice_ = 0;
  bool filled_ = false;  // the gradients below are those of lattice_y_
  std::int64_t lattice_y_ = 0;
  std::vector<int> begin_;       // first column of each lattice cell, and the end
  std::vector<float> fraction_;  // by column: place within the lattice cell
  std::vector<float> fade_;
  std::vector<Gradient> lower_;  // gradients south and north of the row
  std::vector<Gradient> upper_;
};

template <typename Shape>
Grid<float> Sum(const GridGeometry& geometry, const NoiseOptions& options, std::uint64_t seed,
                int threads, Shape shape) {
  Grid<float> sum(geometry.rows(), geometry.cols());
  ParallelFor(geometry.rows(), internal::GridThreads(sum.size(), threads), [&](int begin, int end) {
    std::vector<Octave> octaves;
    std::vector<float> weights;
    std::vector<float>
        means;  // of the octaves that the grid cannot carry, so that resolutions agree
    double total = 0.0;
    double amplitude = 1.0;
    double wavelength_m = options.wavelength_m;
    for (int i = 0; i < options.octaves; ++i, amplitude *= options.gain, wavelength_m *= 0.5) {
      total += amplitude;
      if (wavelength_m < 2.0 * geometry.resolution_m()) {
        means.push_back(static_cast<float>(amplitude * shape(0.0f)));
      } else {
        octaves.emplace_back(geometry, wavelength_m, seed + static_cast<std::uint64_t>(i));
        weights.push_back(static_cast<float>(amplitude));
      }
    }
    const auto scale = static_cast<float>(1.0 / total);
    std::vector<float> line(geometry.cols());
    for (int r = begin; r < end; ++r) {
      float* target = sum.row(r);
      for (std::size_t i = 0; i < octaves.size(); ++i) {
        octaves[i].Row(r, line.data());
        for (int c = 0; c < geometry.cols(); ++c) target[c] += weights[i] * shape(line[c]);
      }
      for (const float mean : means) {
        for (int c = 0; c < geometry.cols(); ++c) target[c] += mean;
      }
      for (int c = 0; c < geometry.cols(); ++c) target[c] *= scale;
    }
  });
  return sum;
}

}  // namespace

Grid<float> FractalNoise(const GridGeometry& geometry, const NoiseOptions& options,
                         std::uint64_t seed, int threads) {
  return Sum(geometry, options, seed, threads, [](float noise) { return noise; });
}

Grid<float> RidgedNoise(const GridGeometry& geometry, const NoiseOptions& options,
                        std::uint64_t seed, int threads) {
  return Sum(geometry, options, seed, threads, [](float noise) { return 1.0f - std::abs(noise); });
}

}  // namespace latticeworld
