#include "latticeworld/terrain/land.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "latticeworld/common/random.h"
#include "latticeworld/geomorphology/blur.h"
#include "latticeworld/geomorphology/distance.h"
#include "latticeworld/geomorphology/noise.h"
#include "latticeworld/geomorphology/resample.h"

namespace latticeworld::internal {
namespace {

// Hills from low to high: a share of the world's size, up to a limit [m].
constexpr double kHillsOfSize = 0.012;
constexpr double kMaxHills_m = 7.0;

// Fine undulation of a class [m]: roads and building land have none.
double UndulationOf_m(Vocabulary vocabulary, char letter) {
  const bool suburb = vocabulary == Vocabulary::kSuburb;
  switch (letter) {
    case 'A':
      return 0.08;
    case 'B':
      return suburb ? 0.0 : 0.5;
    case 'D':
      return 0.6;
    case 'F':
      return 1.2;
    case 'G':
      return 0.35;
    case 'R':
      return suburb ? 0.0 : 1.2;
    case 'S':
      return 1.0;
    default:
      return 0.0;
  }
}

void AddUndulation(const GridGeometry& geometry, const ClassWeights& weights, std::uint64_t seed,
                   Grid<float>* land) {
  NoiseOptions options;
  options.wavelength_m = std::min(30.0, geometry.size_m() / 10.0);
  options.octaves = 4;
  options.gain = 0.35;
  // In worlds of a few metres the undulation shrinks with its wavelength, so that slopes stay.
  const double scale = options.wavelength_m / 30.0;
  const Grid<float> noise = FractalNoise(geometry, options, StreamSeed(seed, "undulation"));
  for (const ClassWeight& entry : weights.classes) {
    const auto amplitude =
        static_cast<float>(scale * UndulationOf_m(weights.vocabulary, entry.letter));
    if (amplitude == 0.0f) continue;
    const float* weight = entry.weight.data();
    const float* wave = noise.data();
    float* height = land->data();
    for (std::size_t i = 0; i < land->size(); ++i) height[i] += amplitude * weight[i] * wave[i];
  }
}

// A mountain's profile over the distance d from its foot: it starts flat, climbs at the slope
// `steepness` and levels off at limit_m.
struct Profile {
  float steepness;  // [m/m]
  float foot_m;     // the first metres stay flat
  float limit_m;

  float At(float d_m) const {
    const float climb_m = steepness * d_m * d_m / (d_m + foot_m);
    return limit_m * climb_m / (climb_m + limit_m);
  }
};

void AddMountains(const GridGeometry& geometry, const Grid<char>& letters, std::uint64_t seed,
                  Grid<float>* land) {
  Grid<unsigned char> high(letters.rows(), letters.cols());
  Grid<unsigned char> snow(letters.rows(), letters.cols());
  bool any = false;
  for (std::size_t i = 0; i < letters.size(); ++i) {
    const char letter = letters.data()[i];
    snow.data()[i] = letter == 'S';
    high.data()[i] = letter == 'S' || letter == 'R';
    any = any || high.data()[i] != 0;
  }
  if (!any) return;

  const auto resolution_m = static_cast<float>(geometry.resolution_m());
  const auto size_m = static_cast<float>(geometry.size_m());
  // Where nothing else bounds a mountain, it is as if its foot were half a world away.
  const float farthest_m = 0.5f * size_m;
  const Profile rock_profile{0.36f, 0.016f * size_m, 0.12f * size_m};
  const Profile snow_profile{0.32f, 0.016f * size_m, 0.20f * size_m};
  Grid<float> rise = DistanceTo(false, high);
  Grid<float> snow_distance = DistanceTo(false, snow);
  for (std::size_t i = 0; i < rise.size(); ++i) {
    const float d_m = std::min(rise.data()[i] * resolution_m, farthest_m);
    const float snow_m = std::min(snow_distance.data()[i] * resolution_m, farthest_m);
    rise.data()[i] = rock_profile.At(d_m) + snow_profile.At(snow_m);
  }
  // The distance has creases half-way between borders.
  GaussianBlur(0.02 * size_m / resolution_m, &rise);

  // Crests and gullies, as high as the mountain lets them be.
  NoiseOptions options;
  options.wavelength_m = 0.16 * size_m;
  options.octaves = 5;
  options.gain = 0.36;
  const Grid<float> ridges = RidgedNoise(geometry, options, StreamSeed(seed, "mountain_ridges"));
  const float roughest_m = 0.1f * size_m;
  for (std::size_t i = 0; i < rise.size(); ++i) {
    const float height_m = rise.data()[i];
    const float roughness_m = height_m * roughest_m / (height_m + roughest_m);
    land->data()[i] += height_m + 0.9f * roughness_m * (ridges.data()[i] - 0.75f);
  }
}

// Terraces of this height [m] and more are worth smoothing.
constexpr double kVisibleStep_m = 0.02;

void SmoothSteps(double step_m, Grid<float>* land) {
  constexpr int kRounds = 3;
  const Grid<float> given = *land;
  const auto half = static_cast<float>(0.5 * step_m);
  double sigma_cells = land->rows() / 64.0;
  for (int round = 0; round < kRounds; ++round, sigma_cells *= 0.5) {
    GaussianBlur(sigma_cells, land);
    for (std::size_t i = 0; i < given.size(); ++i) {
      const float middle = given.data()[i];
      land->data()[i] = std::clamp(land->data()[i], middle - half, middle + half);
    }
  }
}

}  // namespace

Grid<float> ShapedLand(const GridGeometry& geometry, const ClassWeights& weights,
                       const Grid<char>& letters, std::uint64_t seed) {
  const double hills_m = std::min(kHillsOfSize * geometry.size_m(), kMaxHills_m);
  Grid<float> land = ProceduralRelief(geometry, hills_m, seed);
  AddUndulation(geometry, weights, seed, &land);
  if (weights.vocabulary == Vocabulary::kWild) AddMountains(geometry, letters, seed, &land);
  return land;
}

Grid<float> ReliefLand(const GridGeometry& geometry, const Relief& relief) {
  Grid<float> land = Resample(relief.height_m, geometry.rows(), geometry.cols());
  if (relief.height_step_m >= kVisibleStep_m) SmoothSteps(relief.height_step_m, &land);
  return land;
}

}  // namespace latticeworld::internal
