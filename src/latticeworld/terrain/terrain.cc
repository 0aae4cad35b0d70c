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
#include "latticeworld/layout/class_letters.h"
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
#include "latticeworld/terrain/ways/gorge_bridges.h"
#include "latticeworld/terrain/ways/graded_ways.h"
#include "latticeworld/terrain/ways/roads.h"
#include "latticeworld/terrain/ways/streets.h"
#include "latticeworld/terrain/ways/way_finder.h"

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

// Banks are no steeper than this in land that is shaped around its water anyway.
constexpr double kShapedBankSlope = 0.4;
constexpr float kFordReach_cells = 4.0f;
constexpr double kClimbShare = 0.65;  // of the most that roads slope by: what bends are laid for
constexpr float kRoughSlope = 0.08f;  // where half of the undulation shows [m/m]

// Water, that over fords included.
Grid<unsigned char> WetCells(const Grid<char>& letters, const Grid<Crossing>& crossing) {
  Grid<unsigned char> wet = internal::MaskOf(class_letter::kWater, letters);
  for (std::size_t i = 0; i < wet.size(); ++i) {
    const bool road = letters.data()[i] == suburb_letter::kRoad;
    if (road && crossing.data()[i] == Crossing::kFord) wet.data()[i] = 1;
  }
  return wet;
}

Grid<unsigned char> FordCells(const Grid<char>& letters, const Grid<Crossing>& crossing) {
  Grid<unsigned char> ford(letters.rows(), letters.cols());
  for (std::size_t i = 0; i < ford.size(); ++i) {
    const bool road = letters.data()[i] == suburb_letter::kRoad;
    ford.data()[i] = road && crossing.data()[i] == Crossing::kFord ? 1 : 0;
  }
  return ford;
}

// Roads, buildings and fields: what relief keeps away from.
Grid<unsigned char> BuiltCells(const Grid<char>& letters, Vocabulary vocabulary) {
  Grid<unsigned char> built(letters.rows(), letters.cols(), 0);
  for (std::size_t i = 0; i < built.size(); ++i) {
    built.data()[i] = IsManMade(vocabulary, letters.data()[i]) ? 1 : 0;
  }
  return built;
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

// The layout on the lattice.
struct LatticeLayout {
  GridGeometry lattice;
  DecodedLayout lines;
  Grid<char> letters;  // of the largest weight in each cell
  internal::WaterBodies water;

  bool is_suburb() const { return lines.masks.vocabulary == Vocabulary::kSuburb; }
};

// Where no way goes that climbs: water and buildings.
Grid<unsigned char> BlockedCells(const LatticeLayout& layout) {
  Grid<unsigned char> blocked = layout.water.wet;
  const Vocabulary vocabulary = layout.lines.masks.vocabulary;
  for (std::size_t i = 0; i < blocked.size(); ++i) {
    if (IsBuilding(vocabulary, layout.letters.data()[i])) blocked.data()[i] = 1;
  }
  return blocked;
}

Grid<unsigned char> RoadCells(const LatticeLayout& layout) {
  if (layout.is_suburb()) return internal::MaskOf(suburb_letter::kRoad, layout.letters);
  return Grid<unsigned char>(layout.letters.rows(), layout.letters.cols(), 0);
}

LatticeLayout PutOnLattice(const TerrainRequest& request) {
  const GridGeometry lattice = internal::LatticeOf(request.geometry);
  DecodedLayout lines = DecodeLayout(*request.layout, lattice,
                                     BorderOptions(lattice, request.options.fords), request.seed);
  Grid<char> letters = internal::DominantLetters(lines.masks);
  const bool lone_is_still = request.relief == nullptr;
  internal::WaterBodies water =
      internal::FindWaterBodies(WetCells(letters, lines.crossing),
                                internal::LatticeCellsPerLayoutCell(lattice), lone_is_still);
  return {lattice, std::move(lines), std::move(letters), std::move(water)};
}

// The land before its shores are shaped and anything is built, as heights and given heights of the
// plan: the user's, or what evolution and words make of the layout. Returns the levels of the water
// [m], NaN where dry. Errors: CANCELLED.
Result<Grid<float>> RaiseLand(const TerrainRequest& request, const LatticeLayout& layout,
                              const internal::ReliefForms& forms, const Progress& progress,
                              internal::LandPlan* plan) {
  if (request.relief != nullptr) {
    const int n = layout.lattice.rows();
    plan->fine_given_m = internal::ReliefLand(*request.relief, request.geometry.rows());
    plan->height_m = Resample(plan->fine_given_m, n, n);
    plan->given_m = plan->height_m;
    return internal::GradedLevels(layout.lattice, layout.water, plan->height_m,
                                  internal::GradedRule());
  }
  LW_ASSIGN_OR_RETURN(internal::ShapedLand land,
                      internal::ShapeLand(layout.lattice, layout.lines.masks, layout.water, forms,
                                          request.seed, progress));
  plan->height_m = std::move(land.height_m);
  return std::move(land.water_level_m);
}

// Shapes the land [m] around its water. level_m: of the water, NaN where dry. Returns how the water
// sits in the land.
internal::Banks ShapeShores(const TerrainRequest& request, const LatticeLayout& layout,
                            const internal::ReliefForms& forms, const Grid<float>& level_m,
                            Grid<float>* height_m) {
  const bool given = request.relief != nullptr;
  const double most_slope = request.options.max_bank_slope;
  internal::Banks banks(layout.lattice, layout.water, level_m,
                        given ? most_slope : std::min(kShapedBankSlope, most_slope));
  banks.Shape(height_m);
  if (!given) {
    internal::FillHollows(layout.lattice.resolution_m(), layout.water, level_m, forms.Hollows(),
                          height_m);
  }
  return banks;
}

// Whether words ask for ways that the layout does not have.
bool AsksForWays(const std::vector<ReliefWish>& reliefs) {
  return std::any_of(reliefs.begin(), reliefs.end(), [](const ReliefWish& wish) {
    return std::any_of(wish.ties.begin(), wish.ties.end(), [](const ReliefTie& tie) {
      return tie.kind == ReliefTie::Kind::kClimbed || tie.kind == ReliefTie::Kind::kBridged;
    });
  });
}

// What is built into the land.
struct Works {
  std::vector<internal::Street> streets;      // as steep as roads
  std::vector<internal::ClimbingWay> graded;  // ways whose slope is said
  std::vector<Bridge> bridges;                // over gorges first
  Grid<unsigned char> open;                   // GorgeBridges::open
  Grid<float> shaped;  // how much of each cell roads and buildings shape, in [0, 1]
};

// The land, its roads and its gorges, as ways find them.
struct WorkGround {
  const TerrainRequest& request;
  const internal::ReliefForms& forms;
  const std::vector<internal::RoadOverGorge>& over_gorges;
  const internal::Banks& banks;
  const Grid<float>& level_m;       // of the water, NaN where dry
  const Grid<unsigned char>& road;  // 1 on the layout's roads
};

// Ways that the layout does not have: streets of settlements, what climbs into the relief, and what
// leads over gorges, with the bridges of these.
void LayOutWays(const WorkGround& ground, const Grid<float>& height_m, LatticeLayout* layout,
                Works* works) {
  const TerrainRequest& request = ground.request;
  const Grid<char>& letters = layout->letters;
  const bool settled = layout->is_suburb() && std::find(letters.begin(), letters.end(),
                                                        suburb_letter::kBuilding) != letters.end();
  if (settled) {
    const internal::StreetGround streets = {layout->lattice, &letters, &layout->water.wet,
                                            &height_m, &layout->lines};
    works->streets = internal::LayOutStreets(streets, internal::StreetRule(), request.seed);
  }
  const Grid<unsigned char> blocked = BlockedCells(*layout);
  const double max_slope = kClimbShare * request.options.max_road_slope;
  if (AsksForWays(request.reliefs)) {
    const internal::WayFinder finder(layout->lattice, {height_m, ground.road, blocked});
    for (internal::ClimbingWay& way :
         internal::ClimbingWays(request.reliefs, ground.forms.pieces(), finder, max_slope)) {
      if (way.slope) {
        works->graded.push_back(std::move(way));
      } else {
        works->streets.push_back(std::move(way.street));
      }
    }
  }
  if (!AsksForWays(request.reliefs) && ground.over_gorges.empty()) return;
  internal::GorgeBridges over =
      internal::PlanGorgeBridges(request.reliefs, ground.forms.pieces(), ground.over_gorges,
                                 {layout->lattice, height_m, ground.road, blocked, layout->lines,
                                  ground.level_m, request.options.bridge_kind, max_slope});
  if (over.bridges.empty()) return;
  internal::RoadToLand(over.road_to_land, &layout->lines.masks, &layout->letters);
  works->bridges = std::move(over.bridges);
  works->open = std::move(over.open);
  works->streets.insert(works->streets.end(), over.ways.begin(), over.ways.end());
}

// Grades roads and streets into the land [m], with their bridges, and digs the beds of the water.
// layout: its centre lines get those of the streets.
void BuildRoads(const WorkGround& ground, LatticeLayout* layout, Works* works,
                Grid<float>* height_m) {
  const TerrainRequest& request = ground.request;
  const GridGeometry& lattice = layout->lattice;
  const internal::WaterBodies& water = layout->water;
  const Grid<unsigned char>& road = ground.road;
  Grid<unsigned char> paved = road;
  // Below decks over gorges there is no road.
  for (std::size_t i = 0; i < works->open.size(); ++i) {
    if (works->open.data()[i] != 0) paved.data()[i] = 0;
  }
  if (!works->streets.empty()) {
    internal::MarkStreets(lattice, works->streets, water.wet, &paved, &layout->lines);
  }
  const double ford_depth_m =
      std::min(request.options.ford_depth_m, internal::RiverDepth_m(lattice.size_m()));
  const Grid<float> depth_m = DepthNearRoads(lattice, road, water.wet, ford_depth_m);
  if (layout->is_suburb()) {
    for (Bridge& bridge : internal::PlanBridges({lattice, layout->letters, layout->lines, water,
                                                 ground.banks, request.options.bridge_kind})) {
      works->bridges.push_back(std::move(bridge));
    }
  }
  internal::RoadRule rule;
  rule.max_slope = request.options.max_road_slope;
  rule.embankment_slope = request.options.embankment_slope;
  internal::GradeRoads(lattice, paved, layout->lines, ground.banks, depth_m, rule, works->open,
                       &works->bridges, height_m, &works->shaped);
  internal::GradeWays(lattice, works->graded, paved, rule.embankment_slope, height_m,
                      &works->shaped);
  // What was built must not open a shore, nor bury it but where a road climbs to a bridge.
  Grid<unsigned char> beside_roads = road;
  for (unsigned char& cell : beside_roads) cell = cell == 0 ? 1 : 0;
  ground.banks.Raise(beside_roads, height_m);
  ground.banks.Clamp(WithoutRamps(lattice, works->bridges, std::move(beside_roads)), height_m);
  ground.banks.Dig(&depth_m, height_m);
}

// Builds terraces of fields, pads of buildings and all roads into the land [m], and digs the beds
// of the water. layout: see BuildRoads.
Works BuildIntoLand(const TerrainRequest& request, const internal::ReliefForms& forms,
                    const std::vector<internal::RoadOverGorge>& over_gorges,
                    const internal::Banks& banks, const Grid<float>& level_m, LatticeLayout* layout,
                    Grid<float>* height_m) {
  const int n = layout->lattice.rows();
  Works works;
  works.shaped = Grid<float>(n, n, 0.0f);
  if (!layout->is_suburb() && !AsksForWays(request.reliefs)) {
    banks.Dig(nullptr, height_m);
    return works;
  }
  if (layout->is_suburb()) {
    for (const SmoothedMask& entry : layout->lines.masks.classes) {
      if (entry.letter == suburb_letter::kFarmland) {
        internal::TerraceFields(layout->lattice, entry.weight, height_m);
      }
    }
    internal::LevelPads(layout->lattice,
                        internal::MaskOf(suburb_letter::kBuilding, layout->letters), banks,
                        height_m, &works.shaped);
  }
  const Grid<unsigned char> road = RoadCells(*layout);
  const WorkGround ground = {request, forms, over_gorges, banks, level_m, road};
  LayOutWays(ground, *height_m, layout, &works);
  BuildRoads(ground, layout, &works, height_m);
  return works;
}

// Plans where the water may be forded, and how much of what is finer than the lattice stays there.
// shaped: see Works.
void PlanDetail(const LatticeLayout& layout, const internal::Banks& banks,
                const Grid<float>& shaped, internal::LandPlan* plan) {
  const int n = layout.lattice.rows();
  const bool given = !plan->given_m.empty();
  const Grid<float> slope =
      LeastAround(GradientMagnitude(plan->height_m, layout.lattice.resolution_m()));
  const Grid<float> to_ford = DistanceTo(true, FordCells(layout.letters, layout.lines.crossing));
  plan->fordable = Grid<float>(n, n);
  plan->detail = Grid<float>(n, n);
  for (std::size_t i = 0; i < shaped.size(); ++i) {
    // A little into the river, so that no edge of the road stays dry between ford and river.
    plan->fordable.data()[i] =
        layout.water.wet.data()[i] != 0 && to_ford.data()[i] < kFordReach_cells ? 1.0f : 0.0f;
    // Near water nothing finer may open a shore.
    const float near_water = std::clamp(banks.to_water().data()[i] / 8.0f - 0.25f, 0.0f, 1.0f);
    // What the valleys' floors are like the drainage has said: the steeper, the rougher.
    const float steep = given ? 1.0f
                              : slope.data()[i] * slope.data()[i] /
                                    (slope.data()[i] * slope.data()[i] + kRoughSlope * kRoughSlope);
    plan->detail.data()[i] = (1.0f - shaped.data()[i]) * near_water * steep;
  }
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
  LW_RETURN_IF_ERROR(advance(0.0));
  LatticeLayout layout = PutOnLattice(request);
  LW_RETURN_IF_ERROR(advance(0.1));

  const std::vector<ReliefWish> no_words;
  std::vector<internal::ReliefPiece> pieces =
      internal::PlaceReliefs(request.relief != nullptr ? no_words : request.reliefs,
                             *request.layout, layout.lattice.size_m());
  const Grid<unsigned char> road = RoadCells(layout);
  const std::vector<internal::RoadOverGorge> over_gorges =
      internal::RoadsOverGorges(pieces, layout.lattice, road);
  const internal::ReliefForms forms(
      std::move(pieces), layout.lattice, BuiltCells(layout.letters, layout.lines.masks.vocabulary),
      internal::CellsOverGorges(over_gorges, layout.lattice, road), layout.water, request.seed);
  internal::LandPlan plan;
  LW_ASSIGN_OR_RETURN(const Grid<float> level_m,
                      RaiseLand(request, layout, forms, progress, &plan));
  LW_RETURN_IF_ERROR(advance(0.5));

  const internal::Banks banks = ShapeShores(request, layout, forms, level_m, &plan.height_m);
  Works works = BuildIntoLand(request, forms, over_gorges, banks, level_m, &layout, &plan.height_m);
  LW_RETURN_IF_ERROR(advance(0.6));

  plan.level_m = banks.level_everywhere_m();
  plan.lowest_m = banks.lowest_m();
  PlanDetail(layout, banks, works.shaped, &plan);
  internal::CoverByHeight(request.covers, plan.height_m, &layout.lines.masks);
  plan.masks = std::move(layout.lines.masks);
  LW_ASSIGN_OR_RETURN(Terrain terrain, internal::Render(request.geometry, plan, request.seed,
                                                        request.threads, progress));
  for (internal::ClimbingWay& way : works.graded) works.streets.push_back(std::move(way.street));
  internal::PaveStreets(works.streets, &terrain);
  terrain.bridges = std::move(works.bridges);
  LW_RETURN_IF_ERROR(advance(1.0));
  return terrain;
}

}  // namespace latticeworld
