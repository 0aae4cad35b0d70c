#include "latticeworld/relief/sketch/sketch_surface.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "latticeworld/common/random.h"
#include "latticeworld/geomorphology/diffusion.h"
#include "latticeworld/geomorphology/distance.h"
#include "latticeworld/geomorphology/noise.h"
#include "latticeworld/geomorphology/resample.h"
#include "latticeworld/relief/sketch/sketch_lines.h"

namespace latticeworld::internal {
namespace {

// What is farther than this [sides] inside of a valley stroke was painted, not drawn: a lake.
constexpr float kLakeRadius = 0.02f;

// Far from all strokes, over this length [sides], the membrane comes to rest on rolling land.
constexpr float kReach = 0.12f;
constexpr int kCycles = 3;  // of the multigrid: errors far below what noise adds

// Stiffness of springs: of valley floors; of the ways by which valleys go on, which are guesses;
// and of ridges, for which it is in 1 / reach and lets the land around have its say.
constexpr float kValleyPull = 4.0f;
constexpr float kImpliedPull = 0.3f;
constexpr float kRidgePull = 10.0f;

// Heights above the valleys' floors: of ridges, of the land far from strokes; and how much both
// vary.
constexpr float kRidgeHeight = 0.8f;
constexpr float kRidgeVariation = 0.35f;
constexpr float kLandHeight = 0.3f;
constexpr float kLandVariation = 0.4f;

// The floors carried on under the land between them pull less, and rise to this far from valleys.
constexpr float kBaseShare = 0.3f;
constexpr float kBaseValleyPull = 2.0f;
constexpr float kBaseImpliedPull = 0.2f;
constexpr float kFarBase = 0.3f;

// Given land pulls so much more than rolling land, which nobody drew; its ridges strive for so much
// more than its height there, since crests are narrow and the grid it was given on is coarse.
constexpr float kLandPull = 30.0f;
constexpr float kCrest = 0.3f;

struct Springs {
  Grid<float> stiffness;
  Grid<float> target;

  void Set(std::size_t i, float pull, float height) {
    stiffness.data()[i] = pull;
    target.data()[i] = height;
  }
};

// Broad peaks and saddles, about in [-0.6, 0.6].
Grid<float> MakePeaks(int cells, std::uint64_t seed, int threads) {
  NoiseOptions options;
  options.wavelength_m = 0.35;
  options.octaves = 5;
  options.gain = 0.55;
  return FractalNoise(GridGeometry::FromCells(cells, 1.0), options, StreamSeed(seed, "peaks"),
                      threads);
}

Courses CoursesOf(const Sketch& strokes, const Grid<unsigned char>& ridge, std::uint64_t seed,
                  int threads) {
  const Grid<unsigned char> blue = MaskOf(Stroke::kValley, strokes);
  Grid<unsigned char> valley = Thin(blue);
  Grid<unsigned char> lake(strokes.rows(), strokes.cols(), 0);
  const Grid<float> inside = DistanceTo(false, blue, threads);
  const float lake_radius = kLakeRadius * static_cast<float>(strokes.cols());
  for (std::size_t i = 0; i < lake.size(); ++i) {
    if (inside.data()[i] <= lake_radius) continue;
    lake.data()[i] = 1;
    valley.data()[i] = 1;
  }
  return FindCourses(valley, lake, ridge, StreamSeed(seed, "courses"), threads);
}

// Given land in the heights of the surface: at the drawn valleys, on average, as high as their
// floors, and at the ridges kRidgeHeight above that. Without either, its lowest and highest
// twentieth stand for them.
Grid<float> LandOfSurface(const Grid<float>& land, const SketchSurface& surface, int threads) {
  const int cells = surface.ridge.rows();
  Grid<float> height = Resample(land, cells, cells, threads);
  double valley = 0.0, floor = 0.0, ridge = 0.0;
  std::size_t valleys = 0, ridges = 0;
  for (std::size_t i = 0; i < height.size(); ++i) {
    if (surface.courses.valley.data()[i] == kDrawn) {
      valley += height.data()[i];
      floor += surface.courses.floor.data()[i];
      ++valleys;
    } else if (surface.ridge.data()[i] != 0) {
      ridge += height.data()[i];
      ++ridges;
    }
  }
  std::vector<float> sorted(height.begin(), height.end());
  std::sort(sorted.begin(), sorted.end());
  const double low =
      valleys > 0 ? valley / static_cast<double>(valleys) : sorted[sorted.size() / 20];
  double high = ridges > 0 ? ridge / static_cast<double>(ridges)
                           : sorted[sorted.size() - 1 - sorted.size() / 20];
  if (!(high > low)) high = sorted.back();  // it is not level
  const double bottom = valleys > 0 ? floor / static_cast<double>(valleys) : 0.0;
  const double scale = kRidgeHeight / std::max(high - low, 1e-9);
  for (float& h : height) h = static_cast<float>(bottom + scale * (h - low));
  return height;
}

}  // namespace

Result<SketchSurface> MakeSketchSurface(const Sketch& sketch, const Grid<float>* land, int cells,
                                        std::uint64_t seed, int threads, const Progress& progress) {
  // Ridges are thinned; valleys become courses with floors.
  const Sketch strokes = ResampleSketch(sketch, cells, cells);
  SketchSurface surface;
  surface.ridge = Thin(MaskOf(Stroke::kRidge, strokes));
  LW_RETURN_IF_ERROR(progress.CheckCancelled());
  surface.courses = CoursesOf(strokes, surface.ridge, seed, threads);
  LW_RETURN_IF_ERROR(progress.CheckCancelled());
  const Grid<unsigned char>& valley = surface.courses.valley;
  const Grid<float>& floor = surface.courses.floor;

  // Membranes find the heights: springs pull cells to the heights that are known.
  MembraneOptions options;
  options.cycles = kCycles;
  options.threads = threads;
  const float reach = kReach * static_cast<float>(cells);
  const float weak_pull = 1.0f / (reach * reach);
  Springs springs{Grid<float>(cells, cells), Grid<float>(cells, cells)};

  // The floors, carried on under the land between them: without valleys it is level.
  Grid<float> base(cells, cells, 0.0f);
  if (std::any_of(valley.begin(), valley.end(), [](unsigned char v) { return v != 0; })) {
    for (std::size_t i = 0; i < base.size(); ++i) {
      const unsigned char kind = valley.data()[i];
      if (kind == 0) {
        springs.Set(i, kBaseShare * weak_pull, kFarBase);
      } else {
        springs.Set(i, kind == kDrawn ? kBaseValleyPull : kBaseImpliedPull, floor.data()[i]);
      }
    }
    LW_ASSIGN_OR_RETURN(base, SolveMembrane(springs.stiffness, springs.target, options, progress));
  }

  // Floors and ridges pull strongly, the given land or a usual height weakly.
  const Grid<float> peaks = MakePeaks(cells, seed, threads);
  const Grid<float> given =
      land == nullptr ? Grid<float>() : LandOfSurface(*land, surface, threads);
  for (std::size_t i = 0; i < base.size(); ++i) {
    const unsigned char kind = valley.data()[i];
    const float peak = peaks.data()[i];
    if (kind == kDrawn) {
      springs.Set(i, kValleyPull, floor.data()[i]);
    } else if (surface.ridge.data()[i] != 0) {
      const float height = land == nullptr ? base.data()[i] + kRidgeHeight + kRidgeVariation * peak
                                           : given.data()[i] + kCrest;
      springs.Set(i, kRidgePull / reach, height);
    } else if (kind == kImplied) {
      springs.Set(i, kImpliedPull, floor.data()[i]);
    } else if (land != nullptr) {
      springs.Set(i, kLandPull * weak_pull, given.data()[i]);
    } else {
      springs.Set(i, weak_pull, base.data()[i] + kLandHeight + kLandVariation * peak);
    }
  }
  LW_ASSIGN_OR_RETURN(surface.height,
                      SolveMembrane(springs.stiffness, springs.target, options, progress));
  return surface;
}

}  // namespace latticeworld::internal
