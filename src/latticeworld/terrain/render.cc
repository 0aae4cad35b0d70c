#include "latticeworld/terrain/render.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "latticeworld/common/parallel.h"
#include "latticeworld/common/random.h"
#include "latticeworld/geomorphology/noise.h"
#include "latticeworld/geomorphology/resample.h"
#include "latticeworld/terrain/class_traits.h"
#include "latticeworld/terrain/components.h"
#include "latticeworld/terrain/cover.h"
#include "latticeworld/terrain/lattice.h"

namespace latticeworld::internal {
namespace {

constexpr float kDry = std::numeric_limits<float>::quiet_NaN();
constexpr float kMinDepth_m = 0.02f;
constexpr float kMinFreeboard_m = 0.01f;
// Undulation is made on so many cells at most, and read between them.
constexpr int kMostNoiseCells = 2048;
constexpr float kMaxFordDepth_m = 0.15f;
// Water levels come in steps that numbers of their size hold exactly: a lake is level to the bit.
constexpr float kLevelSteps_per_m = 1024.0f;

// A lattice field as the grid's cells see it: where the grid is coarser, averaged first.
class Field {
 public:
  Field(const Grid<float>& lattice, int cells)
      : averaged_(cells < lattice.rows() ? Resample(lattice, cells, cells) : Grid<float>()),
        sampler_(averaged_.empty() ? lattice : averaged_, cells,
                 averaged_.empty() ? RowSampler::Kernel::kSmooth : RowSampler::Kernel::kThrough) {}
  Field(const Field&) = delete;
  Field& operator=(const Field&) = delete;

  void Row(int row, std::vector<float>* scratch, float* values) const {
    sampler_.Row(row, scratch, values);
  }

 private:
  Grid<float> averaged_;
  RowSampler sampler_;
};

// The next class's weights in 255ths: the steps by which the rounded sum of all up to it grows.
void RoundedSteps(int cells, bool last, const float* weight, float* sum, std::uint8_t* given,
                  std::uint8_t* level) {
  constexpr auto kLevels = static_cast<float>(WeightGrid::kLevels);
  for (int c = 0; c < cells; ++c) {
    sum[c] += weight[c];
    const auto reached =
        static_cast<std::uint8_t>(last ? kLevels : kLevels * std::min(sum[c], 1.0f) + 0.5f);
    level[c] = static_cast<std::uint8_t>(reached - given[c]);
    given[c] = reached;
  }
}

NoiseOptions UndulationOptions(const GridGeometry& geometry) {
  NoiseOptions options;
  options.wavelength_m = std::min(30.0, geometry.size_m() / 16.0);
  options.octaves = 5;
  options.gain = 0.57;  // as rough land is: amplitudes fall as wavelengths to the power of 0.8
  return options;
}

// What the smooth kernel reads the land from: where it is rough it goes through the plan's heights,
// where it is built or held by a shore it stays between them.
Grid<float> HeightSource(const LandPlan& plan, int cells) {
  Grid<float> source = plan.height_m;
  if (cells < source.rows()) return source;
  const Grid<float> through = SplineCoefficients(plan.height_m);
  for (std::size_t i = 0; i < source.size(); ++i) {
    source.data()[i] += plan.detail.data()[i] * (through.data()[i] - source.data()[i]);
  }
  return source;
}

}  // namespace

Result<Terrain> Render(const GridGeometry& geometry, const LandPlan& plan, std::uint64_t seed,
                       int threads, const Progress& progress) {
  const bool given = !plan.given_m.empty();
  const int cells = geometry.rows();
  Terrain terrain;
  terrain.weights.vocabulary = plan.masks.vocabulary;
  for (const SmoothedMask& entry : plan.masks.classes) {
    terrain.weights.classes.push_back({entry.letter, WeightGrid(cells, cells)});
  }
  terrain.surface = Grid<SurfaceClass>(cells, cells);
  terrain.water_level_m = Grid<float>(cells, cells, kDry);

  // What is finer than the lattice: the user's land, or undulation.
  const NoiseOptions undulation = UndulationOptions(geometry);
  const GridGeometry fine_geometry =
      GridGeometry::FromCells(std::min(cells, kMostNoiseCells), geometry.size_m());
  const Grid<float> noise =
      given ? Grid<float>()
            : FractalNoise(fine_geometry, undulation, StreamSeed(seed, "undulation"), threads);
  const RowSampler fine_sampler(given ? plan.fine_given_m : noise, cells,
                                RowSampler::Kernel::kThrough);
  LW_RETURN_IF_ERROR(progress.CheckCancelled());
  Grid<float> height_m(cells, cells);

  // In worlds of a few metres the undulation shrinks with its wavelength, so that slopes stay.
  const auto wave = static_cast<float>(undulation.wavelength_m / 30.0);
  std::array<float, 256> amplitude_m{};
  std::array<SurfaceClass, 256> surface_of{};
  for (const SmoothedMask& entry : plan.masks.classes) {
    const auto letter = static_cast<unsigned char>(entry.letter);
    amplitude_m[letter] = wave * TraitsOf(plan.masks.vocabulary, entry.letter).undulation_m;
    surface_of[letter] = SurfaceOf(plan.masks.vocabulary, entry.letter);
  }
  const bool fords = plan.masks.vocabulary == Vocabulary::kSuburb;
  const std::size_t classes = plan.masks.classes.size();
  std::vector<std::unique_ptr<Field>> weight_fields;
  for (const SmoothedMask& entry : plan.masks.classes) {
    weight_fields.push_back(std::make_unique<Field>(entry.weight, cells));
  }
  const Grid<float> height_source = HeightSource(plan, cells);
  const Field height_field(height_source, cells), detail_field(plan.detail, cells);
  const Field fordable_field(plan.fordable, cells);
  std::unique_ptr<Field> given_field, lowest_field;
  if (!plan.lowest_m.empty()) lowest_field = std::make_unique<Field>(plan.lowest_m, cells);
  if (given) given_field = std::make_unique<Field>(plan.given_m, cells);
  // Levels are never averaged: a lake beside a river stays level.
  const RowSampler level_sampler(plan.level_m, cells, RowSampler::Kernel::kSmooth);

  ParallelFor(cells, threads, [&](int begin, int end) {
    std::vector<float> scratch;
    std::vector<float> land(cells), detail(cells), water_m(cells), fordable(cells), user_m(cells);
    std::vector<float> lowest_m(cells, -std::numeric_limits<float>::infinity());
    std::vector<float> weight(cells), sum(cells), amplitude(cells);
    std::vector<std::uint8_t> rounded(cells), best(cells);
    std::vector<char> letter(cells);
    for (int row = begin; row < end; ++row) {
      if (progress.cancelled()) return;
      std::fill(amplitude.begin(), amplitude.end(), 0.0f);
      std::fill(sum.begin(), sum.end(), 0.0f);
      std::fill(rounded.begin(), rounded.end(), std::uint8_t{0});
      std::fill(best.begin(), best.end(), std::uint8_t{0});
      std::fill(letter.begin(), letter.end(), plan.masks.classes.front().letter);
      for (std::size_t i = 0; i < classes; ++i) {
        ClassWeight& entry = terrain.weights.classes[i];
        weight_fields[i]->Row(row, &scratch, weight.data());
        // Rounded as ToWeights does, so that all sum to 1.
        RoundedSteps(cells, i + 1 == classes, weight.data(), sum.data(), rounded.data(),
                     entry.weight.levels().row(row));
        const std::uint8_t* level = entry.weight.levels().row(row);
        const float class_m = amplitude_m[static_cast<unsigned char>(entry.letter)];
        for (int c = 0; c < cells; ++c) {
          amplitude[c] += class_m * weight[c];
          const bool larger = level[c] > best[c];
          best[c] = larger ? level[c] : best[c];
          letter[c] = larger ? entry.letter : letter[c];
        }
      }
      height_field.Row(row, &scratch, land.data());
      detail_field.Row(row, &scratch, detail.data());
      level_sampler.Row(row, &scratch, water_m.data());
      if (fords) fordable_field.Row(row, &scratch, fordable.data());
      if (given_field) given_field->Row(row, &scratch, user_m.data());

      if (lowest_field) lowest_field->Row(row, &scratch, lowest_m.data());
      float* height = height_m.row(row);
      fine_sampler.Row(row, &scratch, height);
      float* water = terrain.water_level_m.row(row);
      SurfaceClass* surface = terrain.surface.row(row);
      for (int c = 0; c < cells; ++c) {
        const float finer = given_field ? height[c] - user_m[c] : amplitude[c] * height[c];
        height[c] = land[c] + detail[c] * finer;
        surface[c] = surface_of[static_cast<unsigned char>(letter[c])];
        const bool ford = fords && letter[c] == 'R' && fordable[c] > 0.5f;
        if (letter[c] != 'W' && !ford) {
          if (!fords || letter[c] != 'R') height[c] = std::max(height[c], lowest_m[c]);
          continue;
        }
        water[c] = std::round(water_m[c] * kLevelSteps_per_m) / kLevelSteps_per_m;
        height[c] = std::min(height[c], water[c] - kMinDepth_m);
        if (ford) height[c] = std::max(height[c], water[c] - kMaxFordDepth_m);
      }
    }
  });
  LW_RETURN_IF_ERROR(progress.CheckCancelled());

  // Close the shores: a dry cell is changed by what its wet neighbours' levels are, nothing else.
  const Grid<float>& water = terrain.water_level_m;
  ParallelFor(cells, threads, [&](int begin, int end) {
    for (int row = begin; row < end; ++row) {
      for (int c = 0; c < cells; ++c) {
        if (!std::isnan(water(row, c))) continue;
        float& height = height_m(row, c);
        ForEachNeighbour(water, row, c, [&](int r, int k) {
          if (!std::isnan(water(r, k))) height = std::max(height, water(r, k) + kMinFreeboard_m);
        });
      }
    }
  });
  terrain.ground = HeightField(geometry, std::move(height_m));
  return terrain;
}

}  // namespace latticeworld::internal
