#include "latticeworld/terrain/forms/relief_forms.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>

#include "latticeworld/common/random.h"
#include "latticeworld/geomorphology/blur.h"
#include "latticeworld/geomorphology/distance.h"
#include "latticeworld/geomorphology/noise.h"
#include "latticeworld/layout/claims/mask_measures.h"
#include "latticeworld/terrain/components.h"
#include "latticeworld/terrain/forms/relief_measures.h"
#include "latticeworld/terrain/forms/relief_natures.h"
#include "latticeworld/terrain/forms/relief_sections.h"
#include "latticeworld/terrain/lattice.h"

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
    case ReliefKind::kDunes:
      return {0.02f, 0.1f, 1.0f};
    case ReliefKind::kGentle:
      return {0.5f, 0.5f, 1.0f};
    case ReliefKind::kRolling:
      return {1.2f, 0.5f, 0.95f};
    case ReliefKind::kHilly:
      return {1.8f, 0.7f, 0.80f};
    case ReliefKind::kSteep:
      return {6.0f, 1.0f, 0.30f};
    case ReliefKind::kRugged:
      return {6.0f, 1.1f, 0.12f};
    case ReliefKind::kMountainous:
      return {26.0f, 0.90f, 0.12f};
    default:
      return {11.0f, 0.95f, 0.12f};
  }
}

// Soft land, which things are laid into whatever grows on them.
constexpr float kSoftSteepness_m = 0.42f;

bool Evolves(ReliefKind kind) { return kind != ReliefKind::kSlope; }

}  // namespace

ReliefForms::ReliefForms(std::vector<ReliefPiece> pieces, const GridGeometry& lattice,
                         Grid<unsigned char> built, Grid<unsigned char> over,
                         const WaterBodies& water, std::uint64_t seed)
    : pieces_(std::move(pieces)),
      lattice_(lattice),
      built_(std::move(built)),
      over_(std::move(over)),
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

Grid<float> ReliefForms::Inward(const Area& area) const {
  const int n = lattice_.rows();
  constexpr double kReach = 0.55;   // of a mountain that is all of the world, in the world's size
  constexpr float kSummits = 0.5f;  // how unlike in height they are
  const double size_m = lattice_.size_m();
  const bool whole = area.piece->half_width_m >= 0.45 * size_m;
  NoiseOptions options;
  options.wavelength_m = 1.1 * area.piece->half_width_m;
  options.octaves = 4;
  const std::string name = "relief/massif " + std::to_string(area.piece - pieces_.data());
  const Grid<float> east = FractalNoise(lattice_, options, StreamSeed(seed_, name + " east"));
  const Grid<float> north = FractalNoise(lattice_, options, StreamSeed(seed_, name + " north"));
  const double warp_m = 0.6 * area.piece->half_width_m;
  Grid<unsigned char> outside(n, n, 0);
  for (int r = 0; r < n; ++r) {
    for (int c = 0; c < n; ++c) {
      const WorldPoint at = lattice_.CenterOf({r, c});
      const WorldPoint there = {at.x_m + warp_m * east(r, c), at.y_m + warp_m * north(r, c)};
      if (whole) {
        const bool edge = r == 0 || c == 0 || r == n - 1 || c == n - 1;
        outside(r, c) = edge || std::hypot(there.x_m, there.y_m) > kReach * size_m ? 1 : 0;
      } else {
        const CellIndex cell = lattice_.CellAt(there);
        outside(r, c) = area.share[cell] < 0.5f ? 1 : 0;
      }
    }
  }
  Grid<float> inward = DistanceTo(true, outside);
  const float most = *std::max_element(inward.begin(), inward.end());
  for (std::size_t i = 0; i < inward.size(); ++i) {
    float& value = inward.data()[i];
    value =
        (most > 0.0f ? std::min(value / most, 1.0f) : 0.0f) * (1.0f + kSummits * east.data()[i]);
  }
  return inward;
}

void ReliefForms::Raise(Grid<float>* steepness_m, Grid<float>* slide_slope,
                        Grid<float>* talus) const {
  const auto growth = static_cast<float>(lattice_.size_m() / 512.0);
  // What is laid stands on soft land, whatever grows there: its height is its own.
  const Grid<float> things = ShareOfThings(ground(), pieces_);
  for (std::size_t i = 0; i < things.size(); ++i) {
    float& steepness = steepness_m->data()[i];
    steepness += things.data()[i] * (std::min(growth * kSoftSteepness_m, steepness) - steepness);
  }
  for (const Area& area : areas_) {
    if (area.piece->rises_by_class) RaiseMiddle(area, steepness_m);
    if (!Evolves(area.piece->kind) || area.piece->rises_by_class) continue;
    const AreaTraits traits = TraitsOf(area.piece->kind);
    const bool mountain = IsMountain(area.piece->kind);
    // Evolution is linear in uplift and steepest slope together: what rises twice as high is
    // twice as steep everywhere.
    const auto scale =
        mountain ? static_cast<float>(std::clamp(
                       area.piece->height_m / (0.62 * area.piece->half_width_m), 0.1, 1.25))
                 : 1.0f;
    // A mountain rises most in its middle: gentle at its foot, steep below its summits.
    const Grid<float> inward = mountain ? Inward(area) : Grid<float>();
    for (std::size_t i = 0; i < area.share.size(); ++i) {
      const float share = area.share.data()[i];
      const float up = mountain ? 0.15f + 1.4f * inward.data()[i] : 1.0f;
      const float hold = mountain ? 0.45f + 0.65f * inward.data()[i] : 1.0f;
      float& steepness = steepness_m->data()[i];
      steepness += share * (scale * growth * up * traits.steepness_m - steepness);
      slide_slope->data()[i] *= 1.0f + share * (scale * hold * traits.slide - 1.0f);
      float& loose = talus->data()[i];
      loose += share * (std::max(loose, 0.6f) - loose);
    }
  }
  for (const ReliefPiece& piece : pieces_) {
    if (RisesBeside(piece, water_)) RaiseBeside(piece, steepness_m);
  }
}

void ReliefForms::RaiseMiddle(const Area& area, Grid<float>* steepness_m) const {
  constexpr float kAtRim = -0.25f, kInMiddle = 0.9f;  // of the uplift that the class has
  const Grid<float> inward = Inward(area);
  for (std::size_t i = 0; i < inward.size(); ++i) {
    steepness_m->data()[i] *= 1.0f + area.share.data()[i] * (kAtRim + kInMiddle * inward.data()[i]);
  }
}

Grid<float> ReliefForms::FromFloor(const ReliefPiece& valley) const {
  if (!valley.follows_water) return DistanceFromAxis(ground(), valley);
  const int n = lattice_.rows();
  const double layout_cell = LatticeCellsPerLayoutCell(lattice_);
  Grid<unsigned char> followed = water_.wet;
  // Borders of classes waver, so water is looked for around the cells of the layout too.
  const LayoutMask around = valley.area.Grown8();
  for (int r = 0; r < n; ++r) {
    for (int c = 0; c < n; ++c) {
      const CellIndex cell = {static_cast<int>(r / layout_cell), static_cast<int>(c / layout_cell)};
      if (!around.Contains(cell)) followed(r, c) = 0;
    }
  }
  Grid<float> from = DistanceTo(true, followed);
  const auto half = static_cast<float>(valley.half_width_m / lattice_.resolution_m());
  const auto shore = static_cast<float>(0.5 * layout_cell);
  for (float& value : from) value = (value + shore) / half;
  return from;
}

void ReliefForms::RaiseBeside(const ReliefPiece& valley, Grid<float>* steepness_m) const {
  // Uplift over erodibility by height. Among mountains a valley is theirs: they rise beside it.
  constexpr double kRiseByWater = 0.17, kRiseAmongMountains = 0.18, kRise = 0.03;
  const auto soft_m = kSoftSteepness_m * static_cast<float>(lattice_.size_m() / 512.0);
  const auto rise_m = static_cast<float>((valley.follows_water ? kRiseByWater
                                          : MountainsByClass() ? kRiseAmongMountains
                                                               : kRise) *
                                         valley.height_m);
  const Grid<float> from = FromFloor(valley);
  for (std::size_t i = 0; i < from.size(); ++i) {
    const float u = from.data()[i];
    const float beside = SmoothStep((u - 0.1f) / 0.4f) * (1.0f - SmoothStep((u - 1.4f) / 0.8f));
    const float floor = 1.0f - SmoothStep((u - 0.15f) / 0.3f);
    float& steepness = steepness_m->data()[i];
    steepness += beside * std::max(rise_m - steepness, 0.0f);
    steepness -= floor * std::max(steepness - soft_m, 0.0f);
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

bool ReliefForms::MountainsByClass() const {
  return std::any_of(areas_.begin(), areas_.end(),
                     [](const Area& area) { return area.piece->rises_by_class; });
}

double ReliefForms::RaisedShare() const {
  double sum = 0.0;
  for (const Area& area : areas_) {
    if (!Evolves(area.piece->kind) || area.piece->rises_by_class) continue;
    for (const float share : area.share) sum += share;
  }
  return std::min(sum / (static_cast<double>(lattice_.rows()) * lattice_.cols()), 1.0);
}

void ReliefForms::ScaleArea(const Area& area, const Grid<float>& foot_m,
                            Grid<float>* land_m) const {
  constexpr float kWithin = 0.6f;
  const bool mountain = IsMountain(area.piece->kind);
  std::vector<float> heights;
  for (std::size_t i = 0; i < land_m->size(); ++i) {
    if (area.share.data()[i] > kWithin) heights.push_back(land_m->data()[i] - foot_m.data()[i]);
  }
  if (heights.empty()) return;
  const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
  const float spread =
      mountain ? *high - *low : Quantile(0.98, &heights) - Quantile(0.02, &heights);
  // What rises by its class is only lifted where it is too low for a mountain.
  const bool by_class = area.piece->rises_by_class;
  const float least = by_class ? 1.0f : 0.05f, most = by_class ? 1.3f : 3.0f;
  const float factor =
      std::clamp(static_cast<float>(area.piece->height_m) / std::max(spread, 0.01f), least, most);
  for (std::size_t i = 0; i < land_m->size(); ++i) {
    const float foot = foot_m.data()[i];
    float& land = land_m->data()[i];
    if (land > foot) land = foot + (land - foot) * (1.0f + area.share.data()[i] * (factor - 1.0f));
  }
}

// Land beside the floors is lifted or lowered by one factor, so that it drains as it did: by that
// of the valley that asks for most, where several lie side by side.
void ReliefForms::ScaleValleys(const Grid<float>& foot_m, Grid<float>* land_m) const {
  Grid<float> change(land_m->rows(), land_m->cols());  // of the height above the foot, as a share
  for (const ReliefPiece& piece : pieces_) {
    if (!RisesBeside(piece, water_)) continue;
    const Grid<float> from = FromFloor(piece);
    const float factor = ValleyFactor(piece, from, foot_m, *land_m);
    for (std::size_t i = 0; i < from.size(); ++i) {
      const float u = from.data()[i];
      const float beside = SmoothStep((u - 0.15f) / 0.5f) * (1.0f - SmoothStep((u - 1.4f) / 1.2f));
      const float asked = beside * (factor - 1.0f);
      float& most = change.data()[i];
      if (std::abs(asked) > std::abs(most)) most = asked;
    }
  }
  for (std::size_t i = 0; i < change.size(); ++i) {
    const float foot = foot_m.data()[i];
    float& land = land_m->data()[i];
    if (land > foot) land = foot + (land - foot) * (1.0f + change.data()[i]);
  }
}

float ReliefForms::ValleyFactor(const ReliefPiece& valley, const Grid<float>& from,
                                const Grid<float>& foot_m, const Grid<float>& land_m) const {
  constexpr float kLeast = 0.6f;
  // What lies about a valley that is not a river's is its own land as much.
  const float most = valley.follows_water ? 3.0f : 1.3f;
  std::vector<float> rims, floors;
  for (std::size_t i = 0; i < from.size(); ++i) {
    const float above_m = land_m.data()[i] - foot_m.data()[i];
    if (from.data()[i] <= 0.15f) floors.push_back(above_m);
    if (from.data()[i] >= 1.0f && from.data()[i] <= 1.25f) rims.push_back(above_m);
  }
  if (rims.empty()) return 1.0f;
  const float floor_m = floors.empty() ? 0.0f : Quantile(0.5, &floors);
  const float rim_m = Quantile(0.5, &rims);
  return std::clamp((static_cast<float>(valley.height_m) + floor_m) / std::max(rim_m, 0.01f),
                    kLeast, most);
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
      // A dune rises gently on the windward side and falls at sand's angle of repose in the lee.
      const float wave = t < 0.68f ? SmoothStep(t / 0.68f) : 1.0f - SmoothStep((t - 0.68f) / 0.32f);
      const float tall = std::clamp(0.75f + 0.9f * height(r, c), 0.15f, 1.0f);
      (*land_m)(r, c) += static_cast<float>(area.piece->height_m) * wave * tall * area.share(r, c);
    }
  }
}

void ReliefForms::Lay(const Grid<float>& level_m, const Grid<float>& foot_m,
                      Grid<float>* land_m) const {
  for (const Area& area : areas_) {
    if (area.piece->kind == ReliefKind::kSlope) {
      LayTilt(area, land_m);
    } else if (area.piece->kind == ReliefKind::kDunes) {
      LayDunes(area, land_m);
    } else {
      ScaleArea(area, foot_m, land_m);
    }
  }
  ScaleValleys(foot_m, land_m);
  LayThings(ground(), pieces_, level_m, foot_m, land_m);
}

Grid<unsigned char> ReliefForms::Hollows() const {
  Grid<unsigned char> hollow(lattice_.rows(), lattice_.cols(), 0);
  // Rain seeps away between dunes.
  for (const Area& area : areas_) {
    if (area.piece->kind != ReliefKind::kDunes) continue;
    for (std::size_t i = 0; i < hollow.size(); ++i) hollow.data()[i] |= area.share.data()[i] > 0.3f;
  }
  for (const ReliefPiece& piece : pieces_) {
    if (piece.kind != ReliefKind::kBasin && piece.kind != ReliefKind::kCrater) continue;
    if (piece.has_area()) continue;
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
