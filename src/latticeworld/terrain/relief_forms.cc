#include "latticeworld/terrain/relief_forms.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>

#include "latticeworld/common/random.h"
#include "latticeworld/geomorphology/blur.h"
#include "latticeworld/geomorphology/distance.h"
#include "latticeworld/geomorphology/erosion.h"
#include "latticeworld/geomorphology/noise.h"
#include "latticeworld/layout/mask_measures.h"
#include "latticeworld/terrain/cones.h"
#include "latticeworld/terrain/lattice.h"
#include "latticeworld/terrain/relief_measures.h"

namespace latticeworld::internal {
namespace {

// How landscape evolution shapes an area. Lengths are for a world of 512 m.
struct AreaTraits {
  float steepness_m;  // uplift over erodibility
  float slide;        // of the steepest slope that rock holds
  float smoothness;   // of creep
};
AreaTraits TraitsOf(ReliefKind kind) {
  switch (kind) {
    case ReliefKind::kFlat:
      return {0.02f, 0.1f, 1.0f};
    case ReliefKind::kGentle:
      return {1.0f, 0.5f, 1.0f};
    case ReliefKind::kRolling:
      return {3.0f, 0.5f, 0.95f};
    case ReliefKind::kHilly:
      return {8.0f, 0.7f, 0.80f};
    case ReliefKind::kSteep:
      return {20.0f, 1.0f, 0.30f};
    case ReliefKind::kRugged:
      return {16.0f, 1.1f, 0.12f};
    default:
      return {55.0f, 0.95f, 0.12f};
  }
}

// How rough rock is, as a share of its height, and how far rain cuts into what was laid [m]: a
// gully of so much runs back from its foot by the root of its drainage area in a step.
constexpr double kRoughness = 0.035;
constexpr double kGullies = 0.25;

bool Evolves(ReliefKind kind) { return kind != ReliefKind::kSlope && kind != ReliefKind::kDunes; }

bool IsSunk(ReliefKind kind) {
  return kind == ReliefKind::kValley || kind == ReliefKind::kGorge || kind == ReliefKind::kCanyon ||
         kind == ReliefKind::kBasin;
}

float Smooth(float t) {
  t = std::clamp(t, 0.0f, 1.0f);
  return t * t * (3.0f - 2.0f * t);
}

// From 1 at 0 to 0 at 1: straight, rounded off over a quarter at either end.
float Flank(float u) {
  constexpr float kRound = 0.25f;
  constexpr float kSlope = 1.0f / (1.0f - kRound);
  u = std::clamp(u, 0.0f, 1.0f);
  if (u < kRound) return 1.0f - 0.5f * kSlope * u * u / kRound;
  if (u > 1.0f - kRound) return 0.5f * kSlope * (1.0f - u) * (1.0f - u) / kRound;
  return 1.0f - kSlope * (u - 0.5f * kRound);
}

// The section of a kind: how high, or how deep, it is by the distance from its axis in half widths,
// in shares of its height.
float Section(ReliefKind kind, float u) {
  switch (kind) {
    case ReliefKind::kPlateau:
      return 1.0f - Smooth((u - 0.62f) / 0.36f);
    case ReliefKind::kMesa:  // a cliff over an apron of what fell from it
      return 0.72f * (1.0f - Smooth((u - 0.62f) / 0.13f)) + 0.28f * Flank((u - 0.5f) / 0.5f);
    case ReliefKind::kCrater:
      return u < 0.55f ? 1.35f * Smooth(u / 0.55f) - 1.0f
                       : 0.35f * (1.0f - Smooth((u - 0.55f) / 0.45f));
    case ReliefKind::kBasin:
      return Flank(std::max(0.0f, (u - 0.15f) / 0.85f));
    case ReliefKind::kValley:
      return Flank(std::max(0.0f, (u - 0.18f) / 0.82f));
    case ReliefKind::kGorge:
      return 1.0f - Smooth((u - 0.25f) / 0.6f);
    case ReliefKind::kCanyon:  // walls in two storeys
      return 0.5f * (2.0f - Smooth((u - 0.25f) / 0.2f) - Smooth((u - 0.7f) / 0.2f));
    case ReliefKind::kTerraces: {
      constexpr float kSteps = 6.0f;
      const float height = kSteps * Flank(u);
      const float whole = std::floor(height);
      return (whole + Smooth((height - whole - 0.6f) / 0.4f)) / kSteps;
    }
    default:
      return Flank(u);
  }
}

}  // namespace

// A thing that is laid into the land.
struct ReliefForms::Laid {
  const ReliefPiece* piece;
  Grid<float> shape;   // in shares of its height, with its sign
  Grid<float> room_m;  // the most that there is room for

  void Add(double height_m, Grid<float>* land_m) const {
    const auto height = static_cast<float>(height_m);
    for (std::size_t i = 0; i < shape.size(); ++i) {
      const float most = room_m.data()[i];
      land_m->data()[i] += std::clamp(height * shape.data()[i], -most, most);
    }
  }
};

ReliefForms::ReliefForms(std::vector<ReliefPiece> pieces, const GridGeometry& lattice,
                         Grid<unsigned char> built, const WaterBodies& water, std::uint64_t seed)
    : pieces_(std::move(pieces)),
      lattice_(lattice),
      built_(std::move(built)),
      water_(water),
      seed_(seed) {
  for (const ReliefPiece& piece : pieces_) {
    if (piece.has_area()) areas_.push_back({&piece, ShareOf(piece.area, Evolves(piece.kind))});
  }
}

Grid<float> ReliefForms::ShareOf(const LayoutMask& area, bool off_built) const {
  const int n = lattice_.rows();
  const double layout_cell = LatticeCellsPerLayoutCell(lattice_);
  NoiseOptions waver;
  waver.wavelength_m = 0.16 * lattice_.size_m();
  waver.octaves = 4;
  const Grid<float> down = FractalNoise(lattice_, waver, StreamSeed(seed_, "relief/area rows"));
  const Grid<float> along = FractalNoise(lattice_, waver, StreamSeed(seed_, "relief/area columns"));
  constexpr double kWaver_cells = 2.5;
  Grid<float> share(n, n);
  for (int r = 0; r < n; ++r) {
    for (int c = 0; c < n; ++c) {
      const auto of = [](double cells) {
        return std::clamp(static_cast<int>(std::floor(cells)), 0, kLayoutSize - 1);
      };
      const CellIndex cell = {of(r / layout_cell + kWaver_cells * down(r, c)),
                              of(c / layout_cell + kWaver_cells * along(r, c))};
      const bool kept = area.Contains(cell) && (!off_built || built_(r, c) == 0);
      share(r, c) = kept ? 1.0f : 0.0f;
    }
  }
  GaussianBlur(0.8 * layout_cell, &share);
  return share;
}

void ReliefForms::Raise(Grid<float>* steepness_m, Grid<float>* slide_slope,
                        Grid<float>* talus) const {
  const auto growth = static_cast<float>(lattice_.size_m() / 512.0);
  for (const Area& area : areas_) {
    if (!Evolves(area.piece->kind) || area.piece->rises_by_class) continue;
    const AreaTraits traits = TraitsOf(area.piece->kind);
    const bool mountain =
        area.piece->kind == ReliefKind::kMountain || area.piece->kind == ReliefKind::kPeak;
    // Evolution is linear in uplift and steepest slope together: what rises twice as high is
    // twice as steep everywhere.
    const auto scale =
        mountain ? static_cast<float>(std::clamp(
                       area.piece->height_m / (0.62 * area.piece->half_width_m), 0.1, 1.25))
                 : 1.0f;
    for (std::size_t i = 0; i < area.share.size(); ++i) {
      const float share = area.share.data()[i];
      float& steepness = steepness_m->data()[i];
      steepness += share * (scale * growth * traits.steepness_m - steepness);
      slide_slope->data()[i] *= 1.0f + share * (scale * traits.slide - 1.0f);
      float& loose = talus->data()[i];
      loose += share * (std::max(loose, 0.6f) - loose);
    }
  }
}

void ReliefForms::OpenEdges(const Grid<float>& hills_m, Grid<unsigned char>* outlet,
                            Grid<float>* height_m) const {
  const int n = hills_m.rows();
  const int reach = n / 14;
  NoiseOptions options;
  options.wavelength_m = 0.12 * lattice_.size_m();
  options.octaves = 2;
  for (const Area& area : areas_) {
    const bool whole =
        area.piece->kind == ReliefKind::kMountain || area.piece->kind == ReliefKind::kPeak;
    if (!whole || area.piece->rises_by_class) continue;
    if (area.piece->half_width_m < 0.45 * lattice_.size_m()) continue;
    const Grid<float> low = FractalNoise(lattice_, options, StreamSeed(seed_, "relief/mouths"));
    // Valleys end where the noise is lowest for some way along the edge.
    const auto open = [&](int r, int c, int down, int right) {
      for (int k = -reach; k <= reach; ++k) {
        if (low.Clamped(r + k * down, c + k * right) < low(r, c)) return;
      }
      if ((*outlet)(r, c) != 0 || area.share(r, c) < 0.5f) return;
      (*outlet)(r, c) = 1;
      (*height_m)(r, c) = hills_m(r, c);
    };
    for (int i = 0; i < n; ++i) {
      open(0, i, 0, 1);
      open(n - 1, i, 0, 1);
      open(i, 0, 1, 0);
      open(i, n - 1, 1, 0);
    }
  }
}

void ReliefForms::Roughen(Grid<float>* smoothness) const {
  for (const Area& area : areas_) {
    if (!Evolves(area.piece->kind) || area.piece->rises_by_class) continue;
    const float wanted = TraitsOf(area.piece->kind).smoothness;
    for (std::size_t i = 0; i < area.share.size(); ++i) {
      float& value = smoothness->data()[i];
      value += area.share.data()[i] * (wanted - value);
    }
  }
}

void ReliefForms::Scale(const Area& area, const Grid<float>& base_m, Grid<float>* land_m) const {
  constexpr float kWithin = 0.6f;
  const bool mountain =
      area.piece->kind == ReliefKind::kMountain || area.piece->kind == ReliefKind::kPeak;
  std::vector<float> heights;
  for (std::size_t i = 0; i < land_m->size(); ++i) {
    if (area.share.data()[i] > kWithin) heights.push_back(land_m->data()[i] - base_m.data()[i]);
  }
  if (heights.empty()) return;
  const float high = *std::max_element(heights.begin(), heights.end());
  const float spread = mountain ? high : Quantile(0.98, &heights) - Quantile(0.02, &heights);
  // What rises by its class is only lifted where it is too low for a mountain.
  const float least = area.piece->rises_by_class ? 1.0f : 0.05f;
  const float factor =
      std::clamp(static_cast<float>(area.piece->height_m) / std::max(spread, 0.01f), least, 3.0f);
  for (std::size_t i = 0; i < land_m->size(); ++i) {
    const float base = base_m.data()[i];
    float& land = land_m->data()[i];
    land = base + (land - base) * (1.0f + area.share.data()[i] * (factor - 1.0f));
  }
}

void ReliefForms::Weather(Grid<float>* land_m) const {
  const int n = lattice_.rows();
  Grid<float> rough(n, n, 0.0f);
  for (const Area& area : areas_) {
    const bool rocky =
        area.piece->kind == ReliefKind::kMountain || area.piece->kind == ReliefKind::kPeak ||
        area.piece->kind == ReliefKind::kMountainous || area.piece->kind == ReliefKind::kRugged;
    if (!rocky || area.piece->rises_by_class) continue;
    const auto rough_m = static_cast<float>(kRoughness * area.piece->height_m);
    for (std::size_t i = 0; i < rough.size(); ++i) {
      rough.data()[i] = std::max(rough.data()[i], rough_m * area.share.data()[i]);
    }
  }
  if (*std::max_element(rough.begin(), rough.end()) > 0.0f) {
    NoiseOptions options;
    options.wavelength_m = 0.09 * lattice_.size_m();
    options.octaves = 5;
    const Grid<float> noise = FractalNoise(lattice_, options, StreamSeed(seed_, "relief/rough"));
    for (std::size_t i = 0; i < rough.size(); ++i) {
      land_m->data()[i] += rough.data()[i] * noise.data()[i];
    }
  }
}

// Rain cuts gullies into what was laid.
void ReliefForms::Gully(const Grid<float>& laid, const Grid<float>& level_m,
                        Grid<float>* land_m) const {
  const int n = lattice_.rows();
  Grid<unsigned char> outlet = water_.wet;
  for (int i = 0; i < n; ++i) {
    outlet(0, i) = outlet(n - 1, i) = outlet(i, 0) = outlet(i, n - 1) = 1;
  }
  Grid<float> eroded = *land_m;
  NoiseOptions uneven;
  uneven.wavelength_m = 0.05 * lattice_.size_m();
  uneven.octaves = 3;
  Grid<float> soft = FractalNoise(lattice_, uneven, StreamSeed(seed_, "relief/soft rock"));
  for (float& value : soft) value = std::exp(2.0f * value);
  for (std::size_t i = 0; i < eroded.size(); ++i) {
    if (water_.wet.data()[i] != 0) eroded.data()[i] = level_m.data()[i];
  }
  FluvialOptions options;
  options.steps = 1;
  options.time_step_yr = kGullies / options.erodibility;
  ErodeFluvially(lattice_.resolution_m(), options, &outlet, nullptr, &soft, 0, &eroded);
  // Their sides slump.
  for (std::size_t i = 0; i < eroded.size(); ++i) {
    const bool wet = water_.wet.data()[i] != 0;
    eroded.data()[i] = wet ? 0.0f : std::min(0.0f, eroded.data()[i] - land_m->data()[i]);
  }
  GaussianBlur(2.0, &eroded);
  for (std::size_t i = 0; i < eroded.size(); ++i) {
    land_m->data()[i] += std::min(1.0f, laid.data()[i]) * eroded.data()[i];
  }
}

void ReliefForms::LayTilt(const Area& area, Grid<float>* land_m) const {
  const int n = lattice_.rows();
  const Claim::Heading to = area.piece->heading;
  const double reach = std::abs(to.east) + std::abs(to.south);
  // It rises from the area's lowest side on.
  double low = 0.5;
  const GridGeometry cells = GridGeometry::FromCells(kLayoutSize, lattice_.size_m());
  ForEachCell(area.piece->area, [&](CellIndex cell) {
    const WorldPoint at = cells.CenterOf(cell);
    const double along = (at.x_m * to.east - at.y_m * to.south) / (reach * lattice_.size_m());
    low = std::min(low, along - 0.5 / kLayoutSize);
  });
  for (int r = 0; r < n; ++r) {
    for (int c = 0; c < n; ++c) {
      const WorldPoint at = lattice_.CenterOf({r, c});
      const double along = (at.x_m * to.east - at.y_m * to.south) / (reach * lattice_.size_m());
      (*land_m)(r, c) +=
          static_cast<float>(area.piece->height_m * (along - low)) * area.share(r, c);
    }
  }
}

void ReliefForms::LayDunes(const Area& area, Grid<float>* land_m) const {
  const int n = lattice_.rows();
  const double length_m = 2.0 * area.piece->half_width_m;
  NoiseOptions waver;
  waver.wavelength_m = 4.0 * length_m;
  waver.octaves = 3;
  const Grid<float> phase = FractalNoise(lattice_, waver, StreamSeed(seed_, "relief/dunes"));
  waver.wavelength_m = 2.5 * length_m;
  const Grid<float> height =
      FractalNoise(lattice_, waver, StreamSeed(seed_, "relief/dune heights"));
  const Claim::Heading to = area.piece->heading;
  const double norm = std::hypot(to.east, to.south);
  for (int r = 0; r < n; ++r) {
    for (int c = 0; c < n; ++c) {
      const WorldPoint at = lattice_.CenterOf({r, c});
      const double along = (at.x_m * to.east - at.y_m * to.south) / (norm * length_m);
      const auto turn = static_cast<float>(along) + 1.6f * phase(r, c);
      const float t = turn - std::floor(turn);
      // Up gently on the windward side, down at sand's angle of repose in the lee.
      const float wave = t < 0.68f ? Smooth(t / 0.68f) : 1.0f - Smooth((t - 0.68f) / 0.32f);
      const float tall = std::clamp(0.75f + 0.9f * height(r, c), 0.15f, 1.0f);
      (*land_m)(r, c) += static_cast<float>(area.piece->height_m) * wave * tall * area.share(r, c);
    }
  }
}

Grid<float> ReliefForms::AxisDistance(const ReliefPiece& piece) const {
  const int n = lattice_.rows();
  NoiseOptions waver;
  waver.wavelength_m = 1.6 * piece.half_width_m;
  waver.octaves = 4;
  const Grid<float> noise =
      FractalNoise(lattice_, waver, StreamSeed(seed_, "relief/outline " + NumberOf(piece)));
  Grid<float> distance(n, n);
  const double reach_m = piece.kind == ReliefKind::kCliff || piece.follows_water
                             ? lattice_.size_m()
                             : 2.0 * piece.half_width_m;
  for (int r = 0; r < n; ++r) {
    for (int c = 0; c < n; ++c) {
      const WorldPoint at = lattice_.CenterOf({r, c});
      const double d_m = DistanceToAxis_m(piece, at);
      float& u = distance(r, c);
      u = static_cast<float>(d_m / piece.half_width_m);
      // Beyond its reach a piece does nothing.
      if (d_m < reach_m) u *= 1.0f + 0.35f * noise(r, c) * Smooth(2.0f * u);
    }
  }
  return distance;
}

// How much of a piece there is room for [m]: it falls off toward what stands or flows there.
Grid<float> ReliefForms::RoomFor(const ReliefPiece& piece) const {
  constexpr float kRise = 0.5f;
  const bool keeps_off_built =
      piece.kind != ReliefKind::kValley && piece.kind != ReliefKind::kBasin && !piece.carries_built;
  Grid<unsigned char> mask = water_.wet;
  if (piece.follows_water) std::fill(mask.begin(), mask.end(), 0);
  if (keeps_off_built) {
    for (std::size_t i = 0; i < mask.size(); ++i) {
      if (built_.data()[i] != 0) mask.data()[i] = 1;
    }
  }
  Grid<float> room_m = DistanceTo(true, mask);
  const auto cell_m = static_cast<float>(lattice_.resolution_m());
  for (float& room : room_m) room = kRise * std::max(0.0f, room - 2.0f) * cell_m;
  return room_m;
}

// In shares of the piece's height, with its sign.
Grid<float> ReliefForms::ShapeOf(const ReliefPiece& piece) const {
  Grid<float> shape = AxisDistance(piece);
  const auto half_m = static_cast<float>(piece.half_width_m);
  const auto size_m = static_cast<float>(lattice_.size_m());
  const int n = lattice_.rows();
  for (int r = 0; r < n; ++r) {
    for (int c = 0; c < n; ++c) {
      float& value = shape(r, c);
      if (piece.kind == ReliefKind::kCliff) {
        const WorldPoint at = lattice_.CenterOf({r, c});
        const auto side_m = static_cast<float>(SideOfAxis_m(piece, at));
        const auto off_m = static_cast<float>(DistanceToAxis_m(piece, at));
        const float beyond_ends = std::max(0.0f, off_m - std::abs(side_m));
        // Behind its edge the land comes down again slowly, and so it does beyond its ends.
        const float back = 1.0f - Smooth((side_m - 3.0f * half_m) / (0.3f * size_m));
        const float ends = 1.0f - Smooth(beyond_ends / (0.12f * size_m));
        const float wavering = side_m * (off_m > 1e-3f ? value * half_m / off_m : 1.0f);
        value = Smooth(0.5f + 0.5f * wavering / half_m) * back * ends;
      } else if (piece.follows_water) {
        // The land beside the water rises, and comes down again far from it.
        const float far = 1.0f - Smooth((value - 1.3f) * half_m / (0.3f * size_m));
        value = (1.0f - Section(piece.kind, value)) * far;
      } else if (IsSunk(piece.kind)) {
        value = -Section(piece.kind, value);
      } else {
        value = Section(piece.kind, value);
      }
    }
  }
  return shape;
}

// Nothing in nature is as even as a section: a tenth of the height, more on flanks than on tops.
void ReliefForms::Uneven(const ReliefPiece& piece, Grid<float>* shape) const {
  NoiseOptions options;
  options.wavelength_m = 0.7 * piece.half_width_m;
  options.octaves = 5;
  const Grid<float> noise =
      FractalNoise(lattice_, options, StreamSeed(seed_, "relief/uneven " + NumberOf(piece)));
  for (std::size_t i = 0; i < noise.size(); ++i) {
    float& value = shape->data()[i];
    const float flank = std::abs(value) * (1.0f - std::abs(value));
    value += 0.5f * flank * noise.data()[i];
  }
}

void ReliefForms::Lay(const Grid<float>& level_m, Grid<float>* land_m) const {
  if (empty()) return;
  if (!areas_.empty()) {
    // Heights are told from the nearest water, or from the lowest land.
    Grid<float> base_m(land_m->rows(), land_m->cols(),
                       *std::min_element(land_m->begin(), land_m->end()));
    const Grid<std::int32_t> nearest = NearestOf(water_.wet);
    for (std::size_t i = 0; i < base_m.size(); ++i) {
      if (nearest.data()[i] >= 0) base_m.data()[i] = level_m.data()[nearest.data()[i]];
    }
    GaussianBlur(LatticeCellsPerLayoutCell(lattice_), &base_m);
    for (const Area& area : areas_) {
      if (area.piece->kind == ReliefKind::kSlope) {
        LayTilt(area, land_m);
      } else if (area.piece->kind == ReliefKind::kDunes) {
        LayDunes(area, land_m);
      } else {
        Scale(area, base_m, land_m);
      }
    }
    Weather(land_m);
  }
  LayThings(level_m, land_m);
}

void ReliefForms::LayThings(const Grid<float>& level_m, Grid<float>* land_m) const {
  Grid<float> raised(land_m->rows(), land_m->cols(), 0.0f);
  std::vector<Laid> all;
  for (const ReliefPiece& piece : pieces_) {
    if (piece.has_area()) continue;
    Laid laid = {&piece, ShapeOf(piece), RoomFor(piece)};
    Uneven(piece, &laid.shape);
    laid.Add(piece.height_m, land_m);
    if (!IsSunk(piece.kind) && piece.kind != ReliefKind::kCrater) {
      for (std::size_t i = 0; i < raised.size(); ++i) raised.data()[i] += laid.shape.data()[i];
    }
    all.push_back(std::move(laid));
  }
  if (all.empty()) return;
  Gully(raised, level_m, land_m);
  // What the land was like before, and what rain has taken, are in the way of a height to the
  // metre.
  for (const Laid& laid : all) {
    const ReliefPiece& piece = *laid.piece;
    if (piece.kind == ReliefKind::kCrater || piece.kind == ReliefKind::kBasin) {
      const double is_m = std::max(HollowDepth_m(piece, lattice_, *land_m), 0.5 * piece.height_m);
      laid.Add(piece.height_m * (std::min(2.0, piece.height_m / is_m) - 1.0), land_m);
      continue;
    }
    const double is_m = Amplitude_m(piece, lattice_, *land_m);
    laid.Add(std::clamp(piece.height_m - is_m, -0.5 * piece.height_m, 0.5 * piece.height_m),
             land_m);
  }
}

Grid<unsigned char> ReliefForms::Hollows() const {
  Grid<unsigned char> hollow(lattice_.rows(), lattice_.cols(), 0);
  for (const ReliefPiece& piece : pieces_) {
    if (piece.kind != ReliefKind::kBasin && piece.kind != ReliefKind::kCrater) continue;
    for (int r = 0; r < hollow.rows(); ++r) {
      for (int c = 0; c < hollow.cols(); ++c) {
        const WorldPoint at = lattice_.CenterOf({r, c});
        if (DistanceToAxis_m(piece, at) < 0.2 * piece.half_width_m) hollow(r, c) = 1;
      }
    }
  }
  return hollow;
}

}  // namespace latticeworld::internal
