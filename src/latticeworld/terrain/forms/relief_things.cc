#include "latticeworld/terrain/forms/relief_things.h"

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
#include "latticeworld/geomorphology/resample.h"
#include "latticeworld/terrain/forms/relief_measures.h"
#include "latticeworld/terrain/forms/relief_natures.h"
#include "latticeworld/terrain/forms/relief_sections.h"
#include "latticeworld/terrain/uplands.h"

namespace latticeworld::internal {
namespace {

bool IsLaid(const ReliefGround& ground, const ReliefPiece& piece) {
  return !piece.has_area() && !RisesBeside(piece, ground.water);
}

// A valley of any kind, which its water leaves.
bool IsCut(const ReliefPiece& piece) { return piece.axis.size() > 1 && IsSunk(piece.kind); }

// Kinds with walls, whose outlines have bays and spurs.
bool IsWalled(ReliefKind kind) {
  return kind == ReliefKind::kPlateau || kind == ReliefKind::kMesa || kind == ReliefKind::kGorge ||
         kind == ReliefKind::kCanyon;
}

// How long rain has cut into a kind, in the time that valleys take to grow through a hill.
double AgeOf(ReliefKind kind) {
  switch (kind) {
    case ReliefKind::kTerraces:
    case ReliefKind::kBasin:
      return 0.0;
    case ReliefKind::kMoraine:
      return 0.3;
    case ReliefKind::kHill:
      return 0.5;
    case ReliefKind::kCrater:
      return 0.6;
    default:
      return 1.0;
  }
}

// Says where a cell lies beside the axis of a piece.
struct AxisPlace {
  double off_m = 0.0;    // from the axis; of a cliff: to its left positive
  double along_m = 0.0;  // from its first point
};

AxisPlace PlaceBeside(const std::vector<WorldPoint>& axis, WorldPoint at) {
  if (axis.size() == 1) return {std::hypot(at.x_m - axis[0].x_m, at.y_m - axis[0].y_m), 0.0};
  AxisPlace place = {std::numeric_limits<double>::infinity(), 0.0};
  double before_m = 0.0;
  for (std::size_t i = 0; i + 1 < axis.size(); ++i) {
    const WorldPoint a = axis[i], b = axis[i + 1];
    const double dx = b.x_m - a.x_m, dy = b.y_m - a.y_m;
    const double length_m = std::max(std::hypot(dx, dy), 1e-6);
    const double on = std::clamp(
        ((at.x_m - a.x_m) * dx + (at.y_m - a.y_m) * dy) / (length_m * length_m), 0.0, 1.0);
    const double off_m = std::hypot(a.x_m + on * dx - at.x_m, a.y_m + on * dy - at.y_m);
    if (off_m < place.off_m) place = {off_m, before_m + on * length_m};
    before_m += length_m;
  }
  return place;
}

// Returns the place beside a line that swings about the chord of the axis, so that sides are told
// apart everywhere.
AxisPlace PlaceBesideChord(const std::vector<WorldPoint>& axis, WorldPoint at) {
  const WorldPoint first = axis.front(), last = axis.back();
  const double chord_m = std::max(std::hypot(last.x_m - first.x_m, last.y_m - first.y_m), 1e-6);
  const double dx = (last.x_m - first.x_m) / chord_m, dy = (last.y_m - first.y_m) / chord_m;
  const auto along_m = [&](WorldPoint p) {
    return (p.x_m - first.x_m) * dx + (p.y_m - first.y_m) * dy;
  };
  const auto left_m = [&](WorldPoint p) {
    return (p.y_m - first.y_m) * dx - (p.x_m - first.x_m) * dy;
  };
  const double here_m = std::clamp(along_m(at), 0.0, chord_m);
  double swing_m = 0.0;
  for (std::size_t i = 0; i + 1 < axis.size(); ++i) {
    const double begin_m = along_m(axis[i]), end_m = along_m(axis[i + 1]);
    if (here_m < begin_m || here_m > end_m) continue;
    const double t = (here_m - begin_m) / std::max(end_m - begin_m, 1e-6);
    swing_m = (1.0 - t) * left_m(axis[i]) + t * left_m(axis[i + 1]);
    break;
  }
  return {left_m(at) - swing_m, here_m};
}

double LengthOf(const std::vector<WorldPoint>& axis) {
  double length_m = 0.0;
  for (std::size_t i = 0; i + 1 < axis.size(); ++i) {
    length_m += std::hypot(axis[i + 1].x_m - axis[i].x_m, axis[i + 1].y_m - axis[i].y_m);
  }
  return length_m;
}

// A thing that is laid into the land.
struct Thing {
  const ReliefPiece* piece;
  std::string name;     // of its random streams
  Grid<float> off;      // distance from the axis [half widths], wavering; signed for cliffs
  Grid<float> along;    // share of the axis' length, in [0, 1]
  Grid<float> shape;    // in shares of its height, with its sign
  Grid<float> room_m;   // the most that there is room for
  Grid<float> floor_m;  // below which nothing is cut; empty: nowhere

  void Add(double height_m, Grid<float>* land_m) const {
    const auto height = static_cast<float>(height_m);
    for (std::size_t i = 0; i < shape.size(); ++i) {
      const float most = room_m.data()[i];
      float& land = land_m->data()[i];
      const float wanted = land + std::clamp(height * shape.data()[i], -most, most);
      land = floor_m.empty() || wanted > land ? wanted
                                              : std::max(wanted, std::min(land, floor_m.data()[i]));
    }
  }
};

// Places beside the axis, on a coarser lattice and read between its cells: they are smooth.
void FindPlaces(const ReliefGround& ground, Thing* thing) {
  const ReliefPiece& piece = *thing->piece;
  const int n = ground.lattice.rows();
  const bool narrow = piece.half_width_m < 16.0 * ground.lattice.resolution_m();
  const GridGeometry coarse =
      GridGeometry::FromCells(narrow ? n / 2 : n / 4, ground.lattice.size_m());
  const bool cliff = piece.kind == ReliefKind::kCliff;
  // The high side of a cliff is where it is headed, else on the left of the axis.
  double side = 1.0;
  if (cliff) {
    const WorldPoint a = piece.axis.front(), b = piece.axis.back();
    const double left =
        -(b.y_m - a.y_m) * piece.heading.east - (b.x_m - a.x_m) * piece.heading.south;
    side = left < 0.0 ? -1.0 : 1.0;
  }
  const WorldPoint first = piece.axis.front(), last = piece.axis.back();
  const double chord_m = std::hypot(last.x_m - first.x_m, last.y_m - first.y_m);
  const double length_m = std::max(cliff ? chord_m : LengthOf(piece.axis), 1e-6);
  Grid<float> off(coarse.rows(), coarse.cols()), along(coarse.rows(), coarse.cols());
  for (int r = 0; r < coarse.rows(); ++r) {
    for (int c = 0; c < coarse.cols(); ++c) {
      const WorldPoint at = coarse.CenterOf({r, c});
      const AxisPlace place =
          cliff ? PlaceBesideChord(piece.axis, at) : PlaceBeside(piece.axis, at);
      off(r, c) = static_cast<float>(side * place.off_m / piece.half_width_m);
      along(r, c) = static_cast<float>(place.along_m / length_m);
    }
  }
  thing->off = Resample(off, n, n);
  thing->along = Resample(along, n, n);
}

// Outlines waver, least near the axis.
void Waver(const ReliefGround& ground, Thing* thing) {
  const float waver = IsWalled(thing->piece->kind) ? 0.8f : 0.45f;
  NoiseOptions options;
  options.wavelength_m = 1.6 * thing->piece->half_width_m;
  options.octaves = 5;
  options.gain = 0.55;
  const Grid<float> noise = FractalNoise(ground.lattice, options,
                                         StreamSeed(ground.seed, "relief/outline " + thing->name));
  for (std::size_t i = 0; i < noise.size(); ++i) {
    float& off = thing->off.data()[i];
    if (thing->piece->kind == ReliefKind::kCliff) {
      off += 1.5f * waver * noise.data()[i];
    } else {
      off *= 1.0f + waver * noise.data()[i] * SmoothStep(2.0f * off);
    }
  }
}

// A cliff in shares of its height: behind its edge the land comes down again slowly, and so it does
// beyond its ends.
float CliffShape(const ReliefGround& ground, const ReliefPiece& piece, float off, float along) {
  const auto size = static_cast<float>(ground.lattice.size_m() / piece.half_width_m);
  const float back = 1.0f - SmoothStep((off - 3.0f) / (0.3f * size));
  const float ends = SmoothStep(along / 0.3f) * SmoothStep((1.0f - along) / 0.3f);
  return SmoothStep(0.5f + 0.5f * off) * back * ends;
}

// The section, and what is uneven: nothing in nature is as even, on flanks more than on tops.
void FindShape(const ReliefGround& ground, Thing* thing) {
  const ReliefPiece& piece = *thing->piece;
  NoiseOptions options;
  options.wavelength_m = 0.7 * piece.half_width_m;
  options.octaves = 5;
  const Grid<float> uneven = FractalNoise(ground.lattice, options,
                                          StreamSeed(ground.seed, "relief/uneven " + thing->name));
  thing->shape = Grid<float>(uneven.rows(), uneven.cols());
  for (std::size_t i = 0; i < uneven.size(); ++i) {
    const float off = thing->off.data()[i];
    float value = piece.kind == ReliefKind::kCliff
                      ? CliffShape(ground, piece, off, thing->along.data()[i])
                      : Section(piece.kind, off);
    const float flank = std::abs(value) * (1.0f - std::abs(value));
    value += 0.5f * flank * uneven.data()[i];
    thing->shape.data()[i] = IsSunk(piece.kind) ? -value : value;
  }
}

// How much of a piece there is room for [m]: it falls off toward what stands or flows there.
Grid<float> RoomFor(const ReliefGround& ground, const ReliefPiece& piece) {
  constexpr float kRise = 0.5f;
  const bool keeps_off_built =
      piece.kind != ReliefKind::kValley && piece.kind != ReliefKind::kBasin && !piece.carries_built;
  // What is cut goes down to the water and no deeper.
  Grid<unsigned char> mask = ground.water.wet;
  if (IsCut(piece)) std::fill(mask.begin(), mask.end(), 0);
  const bool bridged = piece.kind == ReliefKind::kGorge || piece.kind == ReliefKind::kCanyon;
  if (keeps_off_built) {
    for (std::size_t i = 0; i < mask.size(); ++i) {
      if (bridged && ground.over.data()[i] != 0) continue;
      if (ground.built.data()[i] != 0) mask.data()[i] = 1;
    }
  }
  Grid<float> room_m = DistanceTo(true, mask);
  const auto cell_m = static_cast<float>(ground.lattice.resolution_m());
  for (float& room : room_m) room = kRise * std::max(0.0f, room - 2.0f) * cell_m;
  return room_m;
}

Thing MakeThing(const ReliefGround& ground, const ReliefPiece& piece, std::size_t number,
                const Grid<float>& foot_m) {
  Thing thing;
  thing.piece = &piece;
  thing.name = std::to_string(number);
  FindPlaces(ground, &thing);
  Waver(ground, &thing);
  FindShape(ground, &thing);
  thing.room_m = RoomFor(ground, piece);
  if (IsCut(piece) && !ground.water.bodies.cells.empty()) thing.floor_m = foot_m;
  return thing;
}

// Makes the floor of a course that is sunk even, falling toward the lower of its ends, so that
// water runs along it.
void LevelFloor(const ReliefGround& ground, const Thing& thing, Grid<float>* land_m) {
  constexpr double kFall = 0.012;       // [m/m]
  constexpr double kMostOfDepth = 0.2;  // that the ends differ by
  const ReliefPiece& piece = *thing.piece;
  const double length_m = LengthOf(piece.axis);
  Grid<float> wide_m = *land_m;
  GaussianBlur(piece.half_width_m / ground.lattice.resolution_m(), &wide_m);
  const auto at = [&](WorldPoint point) { return wide_m[ground.lattice.CellAt(point)]; };
  const float sign = at(piece.axis.front()) < at(piece.axis.back()) ? 1.0f : -1.0f;
  const auto fall_m = static_cast<float>(std::min(kFall * length_m, kMostOfDepth * piece.height_m));
  for (std::size_t i = 0; i < wide_m.size(); ++i) {
    const float floor = -thing.shape.data()[i];
    if (floor <= 0.0f || thing.room_m.data()[i] <= 0.0f) continue;
    const float even = std::min(1.0f, floor * floor);
    float& land = land_m->data()[i];
    land += even * (wide_m.data()[i] - land);
    land += even * sign * fall_m * (thing.along.data()[i] - 0.5f);
  }
}

// Rain cuts valleys into what was laid, as wide for its size as those of hills are: they are cut
// on a coarser lattice, and the land keeps what is finer.
void Weather(const ReliefGround& ground, const Thing& thing, const Grid<float>& level_m,
             Grid<float>* land_m) {
  constexpr double kHalfWidth_cells = 24.0;  // of the coarser lattice
  const double age = AgeOf(thing.piece->kind);
  if (age <= 0.0) return;
  const int n = ground.lattice.rows();
  const double half_cells = thing.piece->half_width_m / ground.lattice.resolution_m();
  const int finer = half_cells > 2.8 * kHalfWidth_cells   ? 4
                    : half_cells > 1.4 * kHalfWidth_cells ? 2
                                                          : 1;
  const GridGeometry lattice = GridGeometry::FromCells(n / finer, ground.lattice.size_m());
  Grid<float> surface_m = *land_m;
  Grid<float> wet(n, n);
  for (std::size_t i = 0; i < surface_m.size(); ++i) {
    wet.data()[i] = ground.water.wet.data()[i];
    if (ground.water.wet.data()[i] != 0) surface_m.data()[i] = level_m.data()[i];
  }
  surface_m = Resample(surface_m, n / finer, n / finer);
  wet = Resample(wet, n / finer, n / finer);
  Grid<unsigned char> outlet(n / finer, n / finer, 0);
  for (std::size_t i = 0; i < outlet.size(); ++i) outlet.data()[i] = wet.data()[i] > 0.3f ? 1 : 0;
  for (int i = 0; i < n / finer; ++i) {
    outlet(0, i) = outlet(n / finer - 1, i) = outlet(i, 0) = outlet(i, n / finer - 1) = 1;
  }
  const Grid<float> before_m = surface_m;
  Dissect(lattice, outlet, StreamSeed(ground.seed, "relief/dissection " + thing.name), &surface_m);
  for (std::size_t i = 0; i < surface_m.size(); ++i) surface_m.data()[i] -= before_m.data()[i];
  surface_m = Resample(surface_m, n, n);
  for (std::size_t i = 0; i < surface_m.size(); ++i) {
    const float off = std::abs(thing.off.data()[i]);
    const float share = static_cast<float>(age) * (1.0f - SmoothStep((off - 1.0f) / 0.5f));
    land_m->data()[i] += share * surface_m.data()[i];
  }
}

}  // namespace

void LayThings(const ReliefGround& ground, const std::vector<ReliefPiece>& pieces,
               const Grid<float>& level_m, const Grid<float>& foot_m, Grid<float>* land_m) {
  std::vector<Thing> things;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (IsLaid(ground, pieces[i])) things.push_back(MakeThing(ground, pieces[i], i, foot_m));
  }
  if (things.empty()) return;
  for (const Thing& thing : things) {
    if (IsCut(*thing.piece)) LevelFloor(ground, thing, land_m);
    thing.Add(thing.piece->height_m, land_m);
  }
  for (const Thing& thing : things) Weather(ground, thing, level_m, land_m);
  // What the land was like before, and what rain has taken, are in the way of a height to the
  // metre.
  for (const Thing& thing : things) {
    const ReliefPiece& piece = *thing.piece;
    if (piece.kind == ReliefKind::kCrater || piece.kind == ReliefKind::kBasin) {
      const double is_m =
          std::max(HollowDepth_m(piece, ground.lattice, *land_m), 0.5 * piece.height_m);
      thing.Add(piece.height_m * (std::min(2.0, piece.height_m / is_m) - 1.0), land_m);
      continue;
    }
    const double is_m = Amplitude_m(piece, ground.lattice, *land_m);
    const double most_m = 0.5 * piece.height_m;
    thing.Add(std::clamp(piece.height_m - is_m, -most_m, most_m), land_m);
  }
}

bool RisesBeside(const ReliefPiece& piece, const WaterBodies& water) {
  return piece.follows_water || (piece.kind == ReliefKind::kValley && !water.bodies.cells.empty());
}

Grid<float> DistanceFromAxis(const ReliefGround& ground, const ReliefPiece& piece) {
  Thing thing;
  thing.piece = &piece;
  FindPlaces(ground, &thing);
  return thing.off;
}

Grid<float> ShareOfThings(const ReliefGround& ground, const std::vector<ReliefPiece>& pieces) {
  const int n = ground.lattice.rows();
  Grid<float> share(n, n, 0.0f);
  for (const ReliefPiece& piece : pieces) {
    if (!IsLaid(ground, piece) || IsSunk(piece.kind)) continue;
    Thing thing;
    thing.piece = &piece;
    FindPlaces(ground, &thing);
    for (std::size_t i = 0; i < share.size(); ++i) {
      const float off = std::abs(thing.off.data()[i]);
      share.data()[i] = std::max(share.data()[i], 1.0f - SmoothStep((off - 1.6f) / 1.2f));
    }
  }
  return share;
}

}  // namespace latticeworld::internal
