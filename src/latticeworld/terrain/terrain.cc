#include "latticeworld/terrain/terrain.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "latticeworld/common/check.h"
#include "latticeworld/common/range.h"
#include "latticeworld/geomorphology/distance.h"
#include "latticeworld/geomorphology/resample.h"
#include "latticeworld/geomorphology/slope.h"
#include "latticeworld/terrain/cover.h"
#include "latticeworld/terrain/forms/relief_covers.h"
#include "latticeworld/terrain/forms/relief_forms.h"
#include "latticeworld/terrain/forms/relief_places.h"
#include "latticeworld/terrain/land.h"
#include "latticeworld/terrain/lattice.h"
#include "latticeworld/terrain/render.h"
#include "latticeworld/terrain/water/banks.h"
#include "latticeworld/terrain/water/water_bodies.h"
#include "latticeworld/terrain/water/water_level.h"
#include "latticeworld/terrain/ways/benches.h"
#include "latticeworld/terrain/ways/bridges.h"
#include "latticeworld/terrain/ways/climbing_ways.h"
#include "latticeworld/terrain/ways/roads.h"
#include "latticeworld/terrain/ways/streets.h"

namespace latticeworld {
namespace {

// Borders wide and ragged enough that the squares of the layout do not show in the land.
DecodeOptions BorderOptions(const GridGeometry& geometry, bool fords) {
  constexpr double kBlendWidth_cells = 0.6;
  DecodeOptions options;
  options.blend_width_m = kBlendWidth_cells * geometry.size_m() / kLayoutSize;
  options.noise_amplitude = 1.0;
  options.fords = fords;
  return options;
}

// Of land that is shaped around its water anyway.
constexpr double kShapedBankSlope = 0.4;
constexpr float kFordReach_cells = 4.0f;
constexpr double kClimbShare = 0.65;  // of the most that roads slope by: what bends are laid for
constexpr float kRoughSlope = 0.08f;  // where half of the undulation shows [m/m]

// Water, that over fords included.
Grid<unsigned char> WetCells(const Grid<char>& letters, const Grid<Crossing>& crossing) {
  Grid<unsigned char> wet = internal::MaskOf('W', letters);
  for (std::size_t i = 0; i < wet.size(); ++i) {
    if (letters.data()[i] == 'R' && crossing.data()[i] == Crossing::kFord) wet.data()[i] = 1;
  }
  return wet;
}

Grid<unsigned char> FordCells(const Grid<char>& letters, const Grid<Crossing>& crossing) {
  Grid<unsigned char> ford(letters.rows(), letters.cols());
  for (std::size_t i = 0; i < ford.size(); ++i) {
    ford.data()[i] = letters.data()[i] == 'R' && crossing.data()[i] == Crossing::kFord ? 1 : 0;
  }
  return ford;
}

// Roads, buildings and fields: what relief keeps away from.
Grid<unsigned char> BuiltCells(const Grid<char>& letters, Vocabulary vocabulary) {
  Grid<unsigned char> built(letters.rows(), letters.cols(), 0);
  if (vocabulary != Vocabulary::kSuburb) return built;
  for (std::size_t i = 0; i < built.size(); ++i) {
    const char letter = letters.data()[i];
    built.data()[i] = letter == 'R' || letter == 'B' || letter == 'A' ? 1 : 0;
  }
  return built;
}

// Where no way goes that climbs: water and buildings.
Grid<unsigned char> BlockedCells(const Grid<char>& letters, const Grid<unsigned char>& wet) {
  Grid<unsigned char> blocked = wet;
  for (std::size_t i = 0; i < blocked.size(); ++i) {
    if (letters.data()[i] == 'B') blocked.data()[i] = 1;
  }
  return blocked;
}

// How deep water may be on and beside roads [m]: fords are shallow and lead into the water gently,
// and the bed falls away from a road no steeper than an embankment.
Grid<float> DepthNearRoads(const GridGeometry& lattice, const Grid<unsigned char>& road,
                           const Grid<unsigned char>& wet, double ford_depth_m) {
  constexpr float kBedSlope = 0.4f;
  constexpr float kFordSlope = 0.08f;
  const auto cell_m = static_cast<float>(lattice.resolution_m());
  const auto ford_m = static_cast<float>(ford_depth_m);
  Grid<float> depth_m = DistanceTo(true, road);
  const Grid<float> to_shore = DistanceTo(false, wet);
  for (std::size_t i = 0; i < depth_m.size(); ++i) {
    float& depth = depth_m.data()[i];
    if (road.data()[i] == 0) {
      depth = ford_m + kBedSlope * std::max(depth - 1.0f, 0.0f) * cell_m;
    } else {
      depth = std::min(ford_m, kFordSlope * std::max(to_shore.data()[i] - 0.5f, 0.0f) * cell_m);
    }
  }
  return depth_m;
}

// The least of each cell and its neighbours: a floor between steep sides is no steep ground.
Grid<float> LeastAround(const Grid<float>& values) {
  const int rows = values.rows(), cols = values.cols();
  Grid<float> along(rows, cols), least(rows, cols);
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < cols; ++c) {
      along(r, c) = std::min({values(r, c), values.Clamped(r, c - 1), values.Clamped(r, c + 1)});
    }
  }
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < cols; ++c) {
      least(r, c) = std::min({along(r, c), along.Clamped(r - 1, c), along.Clamped(r + 1, c)});
    }
  }
  return least;
}

// The mask without what lies so near bridges that roads climb to them there.
Grid<unsigned char> WithoutRamps(const GridGeometry& lattice, const std::vector<Bridge>& bridges,
                                 Grid<unsigned char> mask) {
  constexpr double kRamp_cells = 1.5;  // layout cells
  if (bridges.empty()) return mask;
  const Grid<std::int32_t> of = internal::CellsOfBridges(lattice, bridges, 0.0);
  Grid<unsigned char> below(of.rows(), of.cols());
  for (std::size_t i = 0; i < of.size(); ++i) below.data()[i] = of.data()[i] >= 0 ? 1 : 0;
  const Grid<float> to_bridge = DistanceTo(true, below);
  const auto reach = static_cast<float>(kRamp_cells * internal::LatticeCellsPerLayoutCell(lattice));
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (to_bridge.data()[i] < reach) mask.data()[i] = 0;
  }
  return mask;
}

}  // namespace

std::vector<Violation> Validate(const TerrainOptions& options) {
  std::vector<Violation> violations;
  CheckRange("max_road_slope", options.max_road_slope, {0.001, 0.5}, "", &violations);
  CheckRange("embankment_slope", options.embankment_slope, {0.1, 1.0}, "", &violations);
  CheckRange("max_bank_slope", options.max_bank_slope, {0.1, 1.0}, "", &violations);
  CheckRange("ford_depth", options.ford_depth_m, {0.02, 0.14}, " m", &violations);
  return violations;
}

double Terrain::WaterDepthAt(WorldPoint point) const {
  const float level_m = water_level_m[geometry().CellAt(point)];
  if (std::isnan(level_m)) return 0.0;
  return std::max(0.0, static_cast<double>(level_m) - ground.HeightAt(point));
}

SurfaceClass Terrain::SurfaceAt(WorldPoint point) const {
  return surface[geometry().CellAt(point)];
}

Result<Terrain> BuildTerrain(const TerrainRequest& request, const Progress& progress) {
  LW_CHECK(request.layout != nullptr, "a terrain needs a layout");
  const auto advance = [&progress](double fraction) {
    progress.Report("terrain", fraction);
    return progress.CheckCancelled();
  };

  if (std::vector<Violation> violations = Validate(request.options); !violations.empty()) {
    return Status::FromViolations("unusable terrain options", std::move(violations));
  }
  // The plan, on the lattice.
  LW_RETURN_IF_ERROR(advance(0.0));
  const GridGeometry lattice = internal::LatticeOf(request.geometry);
  const int n = lattice.rows();
  DecodedLayout lines = DecodeLayoutWithLines(
      *request.layout, lattice, BorderOptions(lattice, request.options.fords), request.seed);
  const Grid<char> letters = internal::DominantLetters(lines.masks);
  const bool has_relief = request.relief != nullptr;
  const internal::WaterBodies water = internal::FindWaterBodies(
      WetCells(letters, lines.crossing), internal::LatticeCellsPerLayoutCell(lattice), !has_relief);
  LW_RETURN_IF_ERROR(advance(0.1));

  const std::vector<ReliefWish> no_words;
  const internal::ReliefForms forms(internal::PlaceReliefs(has_relief ? no_words : request.reliefs,
                                                           *request.layout, lattice.size_m()),
                                    lattice, BuiltCells(letters, lines.masks.vocabulary), water,
                                    request.seed);
  internal::LandPlan plan;
  Grid<float> level_m;
  if (has_relief) {
    plan.fine_given_m = internal::ReliefLand(*request.relief, request.geometry.rows());
    plan.height_m = Resample(plan.fine_given_m, n, n);
    plan.given_m = plan.height_m;
    level_m = internal::GradedLevels(lattice, water, plan.height_m, internal::GradedRule());
  } else {
    LW_ASSIGN_OR_RETURN(
        internal::ShapedLand land,
        internal::ShapeLand(lattice, lines.masks, water, forms, request.seed, progress));
    plan.height_m = std::move(land.height_m);
    level_m = std::move(land.water_level_m);
  }
  LW_RETURN_IF_ERROR(advance(0.5));

  const internal::Banks banks(lattice, water, level_m,
                              has_relief
                                  ? request.options.max_bank_slope
                                  : std::min(kShapedBankSlope, request.options.max_bank_slope));
  banks.Shape(&plan.height_m);
  if (!has_relief) {
    internal::FillHollows(lattice.resolution_m(), water, level_m, forms.Hollows(), &plan.height_m);
  }
  Grid<float> shaped(n, n, 0.0f);
  std::vector<internal::Street> streets;
  std::vector<Bridge> bridges;
  if (lines.masks.vocabulary == Vocabulary::kSuburb) {
    for (const SmoothedMask& entry : lines.masks.classes) {
      if (entry.letter == 'A') internal::TerraceFields(lattice, entry.weight, &plan.height_m);
    }
    internal::LevelPads(lattice, internal::MaskOf('B', letters), banks, &plan.height_m, &shaped);
    const Grid<unsigned char> road = internal::MaskOf('R', letters);
    Grid<unsigned char> paved = road;
    if (std::find(letters.begin(), letters.end(), 'B') != letters.end()) {
      const internal::StreetGround ground = {lattice, &letters, &water.wet, &plan.height_m, &lines};
      streets = internal::LayOutStreets(ground, internal::StreetRule(), request.seed);
    }
    for (internal::Street& way :
         internal::ClimbingWays(request.reliefs, forms.pieces(), lattice,
                                {plan.height_m, road, BlockedCells(letters, water.wet)},
                                kClimbShare * request.options.max_road_slope)) {
      streets.push_back(std::move(way));
    }
    if (!streets.empty()) internal::MarkStreets(lattice, streets, water.wet, &paved, &lines);
    const double ford_depth_m =
        std::min(request.options.ford_depth_m, internal::RiverDepth_m(lattice.size_m()));
    const Grid<float> depth_m = DepthNearRoads(lattice, road, water.wet, ford_depth_m);
    bridges = internal::PlanBridges({lattice, letters, lines, water, banks, request.options.bridge_kind});
    internal::RoadRule rule;
    rule.max_slope = request.options.max_road_slope;
    rule.embankment_slope = request.options.embankment_slope;
    internal::GradeRoads(lattice, paved, lines, banks, depth_m, rule, &bridges, &plan.height_m,
                         &shaped);
    // What was built must not open a shore, nor bury it but where a road climbs to a bridge.
    Grid<unsigned char> beside_roads = road;
    for (unsigned char& cell : beside_roads) cell = cell == 0 ? 1 : 0;
    banks.Raise(beside_roads, &plan.height_m);
    banks.Clamp(WithoutRamps(lattice, bridges, std::move(beside_roads)), &plan.height_m);
    banks.Dig(&depth_m, &plan.height_m);
  } else {
    banks.Dig(nullptr, &plan.height_m);
  }
  LW_RETURN_IF_ERROR(advance(0.6));

  const Grid<float> slope = LeastAround(GradientMagnitude(plan.height_m, lattice.resolution_m()));
  internal::CoverByHeight(request.covers, plan.height_m, &lines.masks);
  plan.masks = std::move(lines.masks);
  plan.level_m = banks.level_everywhere_m();
  plan.lowest_m = banks.lowest_m();
  const Grid<float> to_ford = DistanceTo(true, FordCells(letters, lines.crossing));
  plan.fordable = Grid<float>(n, n);
  plan.detail = Grid<float>(n, n);
  for (std::size_t i = 0; i < shaped.size(); ++i) {
    // A little into the river, so that no edge of the road stays dry between ford and river.
    plan.fordable.data()[i] =
        water.wet.data()[i] != 0 && to_ford.data()[i] < kFordReach_cells ? 1.0f : 0.0f;
    // Near water nothing finer may open a shore.
    const float near_water = std::clamp(banks.to_water().data()[i] / 8.0f - 0.25f, 0.0f, 1.0f);
    // What the valleys' floors are like the drainage has said: the steeper, the rougher.
    const float steep = has_relief
                            ? 1.0f
                            : slope.data()[i] * slope.data()[i] /
                                  (slope.data()[i] * slope.data()[i] + kRoughSlope * kRoughSlope);
    plan.detail.data()[i] = (1.0f - shaped.data()[i]) * near_water * steep;
  }
  LW_ASSIGN_OR_RETURN(Terrain terrain, internal::Render(request.geometry, plan, request.seed,
                                                        request.threads, progress));
  internal::PaveStreets(streets, &terrain);
  terrain.bridges = std::move(bridges);
  LW_RETURN_IF_ERROR(advance(1.0));
  return terrain;
}

}  // namespace latticeworld
