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
#include "latticeworld/layout/class_letters.h"
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

// What one thread needs to make a row of the grid.
struct RowBuffers {
  explicit RowBuffers(int cells)
      : land_m(cells),
        detail(cells),
        level_m(cells),
        fordable(cells),
        given_m(cells),
        lowest_m(cells, -std::numeric_limits<float>::infinity()),
        weight(cells),
        sum(cells),
        amplitude_m(cells),
        rounded(cells),
        best(cells),
        letter(cells) {}

  std::vector<float> scratch;
  std::vector<float> land_m, detail, level_m, fordable, given_m, lowest_m;
  std::vector<float> weight, sum;  // of one class; of all up to it
  std::vector<float> amplitude_m;  // of the undulation
  std::vector<std::uint8_t> rounded, best;
  std::vector<char> letter;  // of the largest weight
};

// Makes the terrain row by row from the plan and from what is finer than it; both must outlive it.
class RowRenderer {
 public:
  // fine: the user's land or undulation. wave: factor on the classes' undulations.
  RowRenderer(const LandPlan& plan, const Grid<float>& fine, float wave, int cells)
      : plan_(plan),
        cells_(cells),
        fords_(plan.masks.vocabulary == Vocabulary::kSuburb),
        fine_sampler_(fine, cells, RowSampler::Kernel::kThrough),
        height_source_(HeightSource(plan, cells)),
        height_field_(height_source_, cells),
        detail_field_(plan.detail, cells),
        fordable_field_(plan.fordable, cells),
        level_sampler_(plan.level_m, cells, RowSampler::Kernel::kSmooth) {
    for (const SmoothedMask& entry : plan.masks.classes) {
      const auto letter = static_cast<unsigned char>(entry.letter);
      amplitude_m_[letter] = wave * TraitsOf(plan.masks.vocabulary, entry.letter).undulation_m;
      surface_of_[letter] = SurfaceOf(plan.masks.vocabulary, entry.letter);
      weight_fields_.push_back(std::make_unique<Field>(entry.weight, cells));
    }
    if (!plan.lowest_m.empty()) lowest_field_ = std::make_unique<Field>(plan.lowest_m, cells);
    if (!plan.given_m.empty()) given_field_ = std::make_unique<Field>(plan.given_m, cells);
  }

  // Fills the row of the terrain's grids and of height_m, but for the ground between cells.
  void Render(int row, RowBuffers* buffers, Terrain* terrain, Grid<float>* height_m) const {
    MixClasses(row, buffers, &terrain->weights);
    SamplePlan(row, buffers);
    fine_sampler_.Row(row, &buffers->scratch, height_m->row(row));
    LayGround(*buffers, height_m->row(row), terrain->water_level_m.row(row),
              terrain->surface.row(row));
  }

 private:
  // The row of each class's weights, and what they say of the ground.
  void MixClasses(int row, RowBuffers* buffers, ClassWeights* weights) const {
    RowBuffers& b = *buffers;
    std::fill(b.amplitude_m.begin(), b.amplitude_m.end(), 0.0f);
    std::fill(b.sum.begin(), b.sum.end(), 0.0f);
    std::fill(b.rounded.begin(), b.rounded.end(), std::uint8_t{0});
    std::fill(b.best.begin(), b.best.end(), std::uint8_t{0});
    std::fill(b.letter.begin(), b.letter.end(), plan_.masks.classes.front().letter);
    const std::size_t classes = weight_fields_.size();
    for (std::size_t i = 0; i < classes; ++i) {
      ClassWeight& entry = weights->classes[i];
      weight_fields_[i]->Row(row, &b.scratch, b.weight.data());
      // Rounded as ToWeights does, so that all sum to 1.
      std::uint8_t* level = entry.weight.levels().row(row);
      RoundedSteps(cells_, i + 1 == classes, b.weight.data(), b.sum.data(), b.rounded.data(),
                   level);
      const float class_m = amplitude_m_[static_cast<unsigned char>(entry.letter)];
      for (int c = 0; c < cells_; ++c) {
        b.amplitude_m[c] += class_m * b.weight[c];
        const bool larger = level[c] > b.best[c];
        b.best[c] = larger ? level[c] : b.best[c];
        b.letter[c] = larger ? entry.letter : b.letter[c];
      }
    }
  }

  void SamplePlan(int row, RowBuffers* buffers) const {
    std::vector<float>* scratch = &buffers->scratch;
    height_field_.Row(row, scratch, buffers->land_m.data());
    detail_field_.Row(row, scratch, buffers->detail.data());
    level_sampler_.Row(row, scratch, buffers->level_m.data());
    if (fords_) fordable_field_.Row(row, scratch, buffers->fordable.data());
    if (given_field_) given_field_->Row(row, scratch, buffers->given_m.data());
    if (lowest_field_) lowest_field_->Row(row, scratch, buffers->lowest_m.data());
  }

  // height_m: what is finer than the lattice; gets the ground. water_m: gets levels where it is
  // wet.
  void LayGround(const RowBuffers& b, float* height_m, float* water_m,
                 SurfaceClass* surface) const {
    for (int c = 0; c < cells_; ++c) {
      const float finer_m =
          given_field_ ? height_m[c] - b.given_m[c] : b.amplitude_m[c] * height_m[c];
      height_m[c] = b.land_m[c] + b.detail[c] * finer_m;
      surface[c] = surface_of_[static_cast<unsigned char>(b.letter[c])];
      const bool road = fords_ && b.letter[c] == suburb_letter::kRoad;
      const bool ford = road && b.fordable[c] > 0.5f;
      if (b.letter[c] != class_letter::kWater && !ford) {
        if (!road) height_m[c] = std::max(height_m[c], b.lowest_m[c]);
        continue;
      }
      water_m[c] = std::round(b.level_m[c] * kLevelSteps_per_m) / kLevelSteps_per_m;
      height_m[c] = std::min(height_m[c], water_m[c] - kMinDepth_m);
      if (ford) height_m[c] = std::max(height_m[c], water_m[c] - kMaxFordDepth_m);
    }
  }

  const LandPlan& plan_;
  int cells_;
  bool fords_;                            // the vocabulary has roads
  std::array<float, 256> amplitude_m_{};  // by letter
  std::array<SurfaceClass, 256> surface_of_{};
  RowSampler fine_sampler_;
  Grid<float> height_source_;
  Field height_field_, detail_field_, fordable_field_;
  // Levels are never averaged: a lake beside a river stays level.
  RowSampler level_sampler_;
  std::vector<std::unique_ptr<Field>> weight_fields_;
  std::unique_ptr<Field> given_field_, lowest_field_;
};

// Raises dry cells beside wet ones above their water: each is changed by what its wet neighbours'
// levels are, nothing else.
void CloseShores(const Grid<float>& water_level_m, int threads, Grid<float>* height_m) {
  ParallelFor(height_m->rows(), threads, [&](int begin, int end) {
    for (int row = begin; row < end; ++row) {
      for (int c = 0; c < height_m->cols(); ++c) {
        if (!std::isnan(water_level_m(row, c))) continue;
        float& height = (*height_m)(row, c);
        ForEachNeighbour(water_level_m, row, c, [&](int r, int k) {
          const float level_m = water_level_m(r, k);
          if (!std::isnan(level_m)) height = std::max(height, level_m + kMinFreeboard_m);
        });
      }
    }
  });
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
  Grid<float> height_m(cells, cells);

  // What is finer than the lattice: the user's land, or undulation.
  const NoiseOptions undulation = UndulationOptions(geometry);
  const GridGeometry fine_geometry =
      GridGeometry::FromCells(std::min(cells, kMostNoiseCells), geometry.size_m());
  const Grid<float> noise =
      given ? Grid<float>()
            : FractalNoise(fine_geometry, undulation, StreamSeed(seed, "undulation"), threads);
  LW_RETURN_IF_ERROR(progress.CheckCancelled());
  // In worlds of a few metres the undulation shrinks with its wavelength, so that slopes stay.
  const auto wave = static_cast<float>(undulation.wavelength_m / 30.0);
  const RowRenderer renderer(plan, given ? plan.fine_given_m : noise, wave, cells);
  ParallelFor(cells, threads, [&](int begin, int end) {
    RowBuffers buffers(cells);
    for (int row = begin; row < end && !progress.cancelled(); ++row) {
      renderer.Render(row, &buffers, &terrain, &height_m);
    }
  });
  LW_RETURN_IF_ERROR(progress.CheckCancelled());
  CloseShores(terrain.water_level_m, threads, &height_m);
  terrain.ground = HeightField(geometry, std::move(height_m));
  return terrain;
}

}  // namespace latticeworld::internal
