#include "latticeworld/terrain/land.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "latticeworld/common/random.h"
#include "latticeworld/geomorphology/blur.h"
#include "latticeworld/geomorphology/erosion.h"
#include "latticeworld/geomorphology/flow.h"
#include "latticeworld/geomorphology/noise.h"
#include "latticeworld/geomorphology/resample.h"
#include "latticeworld/layout/class_letters.h"
#include "latticeworld/terrain/class_traits.h"
#include "latticeworld/terrain/cones.h"
#include "latticeworld/terrain/land_foot.h"
#include "latticeworld/terrain/lattice.h"
#include "latticeworld/terrain/uplands.h"
#include "latticeworld/terrain/water/water_level.h"

namespace latticeworld::internal {
namespace {

// Traits are for a world of this size; heights grow with it, those of soft land less.
constexpr double kTraitSize_m = 512.0;
// Hills from low to high: a share of the world's size, up to a limit [m].
constexpr double kHillsOfSize = 0.012;
constexpr double kMaxHills_m = 7.0;
constexpr double kSoftSteepness_m = 1.5;  // above it is mountain
constexpr double kMostSoftGrowth = 4.0;
// Water lies a little below its shore: a share of the world's size, up to a limit [m].
constexpr double kIncisionOfSize = 0.002;
constexpr double kMaxIncision_m = 0.5;
// The land between two waters of unlike level falls no steeper than this [m/m].
constexpr double kNeighbourSlope = 0.25;

// What slides comes to rest a little below the talus.
constexpr float kRest = 0.9f;
// How the land of classes rises, and how much of that is the region's.
struct Upheaval {
  float lift;          // factor on the uplift of rock and snow in a world of kTraitSize_m ...
  double lift_growth;  // ... and the power of the world's size that it grows with
  float regional;      // share of the uplift that is that of the land around
  float wildness;      // how much of that share land gets that is hardly built on
  double accordance;   // brings summits together, most where half of the world is mountain
};
// Snow and rock rise above the land beside them ...
constexpr Upheaval kByClass = {1.0f, 0.0, 0.4f, 2.0f, 1.0};
// ... but where words say that they are mountains, the region rises as a whole, so that soft land
// among them is high too. Small mountains are steeper than large ones: the height of land grows
// with some power 0.7 to 0.8 of its width (self-affine land, Turcotte 1997).
constexpr Upheaval kMountains = {1.77f, -0.25, 0.95f, 4.0f, 4.5};
constexpr double kRegion_cells = 14.0;  // of the layout: how far the land around reaches
constexpr double kAccordance = 0.5;     // of summits, wherever they stand
constexpr double kMaxCreep_m = 6.0;
// Concavity of channels.
constexpr double kAreaExponent = 0.38;
// Steepness is a slope where channels drain a square of this share of the world's side.
constexpr double kReachOfSize = 20.0;
// A dry edge is cut off from land that goes on beyond it: it lies as much above the rivers as
// channels of this steepness rise, less what soft land has.
constexpr float kEdgeRise = 3.0f;
constexpr float kEdgeSoftness = 0.25f;

// Stream power in units in which a cell of 1 m^2 at slope 1 erodes by its erodibility in a year.
constexpr double kErodibility_per_yr = 1e-5;

struct Fields {
  Grid<float> steepness_m;
  Grid<float> erodibility;  // factor
  Grid<float> talus;
  Grid<float> slide_slope;  // steepest that the ground holds [m/m]
  double mountain_share = 0.0;
  std::uint64_t gully_seed = 0;
};

float LiftIn(const GridGeometry& lattice, const Upheaval& upheaval) {
  return upheaval.lift *
         static_cast<float>(std::pow(lattice.size_m() / kTraitSize_m, upheaval.lift_growth));
}

// Steepness from that of a world of kTraitSize_m, mountains' times `lift`, and how much of the
// world is mountain.
double GrowWithSize(const GridGeometry& lattice, const Grid<float>& uneven, float lift,
                    Grid<float>* steepness_m) {
  const double growth = lattice.size_m() / kTraitSize_m;
  const float hard = lift * static_cast<float>(growth);
  const auto soft = static_cast<float>(std::min(growth, kMostSoftGrowth));
  double mountains = 0.0;
  for (std::size_t i = 0; i < uneven.size(); ++i) {
    float& steepness = steepness_m->data()[i];
    const float mountain =
        std::clamp((steepness - 0.9f) / static_cast<float>(kSoftSteepness_m), 0.0f, 1.0f);
    steepness *= (soft + mountain * (hard - soft)) * (1.0f + 0.2f * uneven.data()[i]);
    mountains += mountain;
  }
  return mountains / uneven.size();
}

Fields FieldsOf(const GridGeometry& lattice, const SmoothedMasks& masks, const Upheaval& upheaval,
                std::uint64_t seed) {
  Fields fields{MixTrait(masks, &ClassTraits::steepness_m),
                Grid<float>(),
                MixTrait(masks, &ClassTraits::talus),
                Grid<float>(),
                0.0,
                StreamSeed(seed, "terrain/gullies")};
  // Scarps would stand where uplift changes at once.
  GaussianBlur(0.8 * LatticeCellsPerLayoutCell(lattice), &fields.steepness_m);
  NoiseOptions options;
  options.wavelength_m = 0.2 * lattice.size_m();
  options.octaves = 3;
  const Grid<float> uneven = FractalNoise(lattice, options, StreamSeed(seed, "terrain/uplift"));
  fields.mountain_share =
      GrowWithSize(lattice, uneven, LiftIn(lattice, upheaval), &fields.steepness_m);
  Grid<float> smoothness = MixTrait(masks, &ClassTraits::smoothness);
  GaussianBlur(0.8 * LatticeCellsPerLayoutCell(lattice), &smoothness);
  Grid<float> regional = fields.steepness_m;
  GaussianBlur(kRegion_cells * LatticeCellsPerLayoutCell(lattice), &regional);
  for (std::size_t i = 0; i < regional.size(); ++i) {
    float& steepness = fields.steepness_m.data()[i];
    // Fields and villages lie where it is level.
    const float wild = std::min(upheaval.wildness * (1.0f - smoothness.data()[i]), 1.0f);
    steepness += upheaval.regional * wild * (regional.data()[i] - steepness);
  }
  // Uneven rock turns rivers away from the lattice's eight directions.
  options.wavelength_m = 0.06 * lattice.size_m();
  options.octaves = 4;
  options.gain = 0.7;
  fields.erodibility = FractalNoise(lattice, options, StreamSeed(seed, "terrain/erodibility"));
  for (float& value : fields.erodibility) value = std::exp(1.6f * value);
  options.wavelength_m = 0.08 * lattice.size_m();
  fields.slide_slope = FractalNoise(lattice, options, StreamSeed(seed, "terrain/slides"));
  for (std::size_t i = 0; i < uneven.size(); ++i) {
    float& value = fields.slide_slope.data()[i];
    value = kRest * fields.talus.data()[i] * (1.0f + 0.5f * value);
  }
  return fields;
}

// Says where water leaves the world: at water itself, and at the low places of a dry edge.
struct BaseLevel {
  Grid<unsigned char> outlet;
  Grid<float> height_m;  // of the outlets
};

// A walk around the edge: cell index by step.
std::vector<std::int32_t> EdgeCells(int n) {
  std::vector<std::int32_t> cells;
  for (int i = 0; i < n - 1; ++i) cells.push_back(i);
  for (int i = 0; i < n - 1; ++i) cells.push_back(i * n + n - 1);
  for (int i = n - 1; i > 0; --i) cells.push_back((n - 1) * n + i);
  for (int i = n - 1; i > 0; --i) cells.push_back(i * n);
  return cells;
}

// The lowest place of the edge within a quarter of the world to both sides, where no water is.
void AddEdgeOutlets(const Grid<float>& hills_m, const Grid<float>& level_m, BaseLevel* base) {
  const int n = hills_m.rows();
  const std::vector<std::int32_t> edge = EdgeCells(n);
  const int count = static_cast<int>(edge.size());
  const int reach = n / 4;
  for (int i = 0; i < count; ++i) {
    bool lowest = true;
    for (int k = -reach; k <= reach && lowest; ++k) {
      const std::int32_t other = edge[(i + k + count) % count];
      if (!std::isnan(level_m.data()[other])) lowest = false;
      const float there = hills_m.data()[other], here = hills_m.data()[edge[i]];
      lowest = lowest && (there > here || (there == here && k >= 0));
    }
    if (!lowest) continue;
    base->outlet.data()[edge[i]] = 1;
    base->height_m.data()[edge[i]] = hills_m.data()[edge[i]];
  }
}

BaseLevel BaseLevelOf(const Grid<float>& hills_m, const Grid<float>& level_m,
                      const ReliefForms& forms) {
  const int n = hills_m.rows();
  BaseLevel base{Grid<unsigned char>(n, n, 0), Grid<float>(n, n, 0.0f)};
  bool any = false;
  for (std::size_t i = 0; i < level_m.size(); ++i) {
    if (std::isnan(level_m.data()[i])) continue;
    any = true;
    base.outlet.data()[i] = 1;
    base.height_m.data()[i] = level_m.data()[i];
  }
  AddEdgeOutlets(hills_m, level_m, &base);
  forms.OpenEdges(hills_m, &base.outlet, &base.height_m);
  if (!any && std::find(base.outlet.begin(), base.outlet.end(), 1) == base.outlet.end()) {
    const auto lowest = std::min_element(hills_m.begin(), hills_m.end()) - hills_m.begin();
    base.outlet.data()[lowest] = 1;
    base.height_m.data()[lowest] = *std::min_element(hills_m.begin(), hills_m.end());
  }
  return base;
}

// The outlets on a coarser lattice: a coarse cell is one where any of its cells is, at the lowest.
BaseLevel Coarser(const BaseLevel& base, int cells) {
  const int n = base.outlet.rows();
  const int factor = n / cells;
  BaseLevel coarse{Grid<unsigned char>(cells, cells, 0), Grid<float>(cells, cells, 0.0f)};
  for (int r = 0; r < n; ++r) {
    for (int c = 0; c < n; ++c) {
      if (base.outlet(r, c) == 0) continue;
      unsigned char& outlet = coarse.outlet(r / factor, c / factor);
      float& height = coarse.height_m(r / factor, c / factor);
      height = outlet != 0 ? std::min(height, base.height_m(r, c)) : base.height_m(r, c);
      outlet = 1;
    }
  }
  return coarse;
}

// Returns the heights at which the water of a dry edge leaves: those of hills, and higher where the
// land is [m].
Grid<float> EdgeHeight(const GridGeometry& lattice, const Fields& fields,
                       const Grid<float>& hills_m) {
  Grid<float> height_m = fields.steepness_m;
  GaussianBlur(2.0 * LatticeCellsPerLayoutCell(lattice), &height_m);
  const auto soft = kEdgeSoftness * static_cast<float>(lattice.size_m() / kTraitSize_m);
  for (std::size_t i = 0; i < height_m.size(); ++i) {
    float& height = height_m.data()[i];
    height = hills_m.data()[i] + kEdgeRise * std::max(height - soft, 0.0f);
  }
  return height_m;
}

// What is as high above its foot as the given heights [m] are above the hills.
Grid<float> OnFoot(const Grid<float>& foot_m, const Grid<float>& hills_m, Grid<float> height_m) {
  for (std::size_t i = 0; i < height_m.size(); ++i) {
    height_m.data()[i] += std::max(foot_m.data()[i] - hills_m.data()[i], 0.0f);
  }
  return height_m;
}

// Returns the land before anything is shaped: rivers leave the world where the land is softest and
// lowest.
Grid<float> PriorLand(const GridGeometry& lattice, const Fields& fields,
                      const Grid<float>& hills_m) {
  Grid<float> prior_m = fields.steepness_m;
  GaussianBlur(3.0 * LatticeCellsPerLayoutCell(lattice), &prior_m);
  for (std::size_t i = 0; i < prior_m.size(); ++i) {
    prior_m.data()[i] = hills_m.data()[i] + 4.0f * prior_m.data()[i];
  }
  return prior_m;
}

// What evolution begins with: rough, so that valleys do not run straight.
Grid<float> FirstLand(const GridGeometry& lattice, const Fields& fields, const Grid<float>& hills_m,
                      std::uint64_t seed) {
  NoiseOptions rough;
  rough.wavelength_m = 0.15 * lattice.size_m();
  rough.octaves = 5;
  rough.gain = 0.6;
  Grid<float> land_m = FractalNoise(lattice, rough, StreamSeed(seed, "terrain/first_land"));
  for (std::size_t i = 0; i < land_m.size(); ++i) {
    land_m.data()[i] =
        hills_m.data()[i] + fields.steepness_m.data()[i] * (8.0f + 3.0f * land_m.data()[i]);
  }
  return land_m;
}

// A time of the land's history. Long ones come to an end that the land before is forgotten in;
// short ones leave high ground as it was, between the valleys that cut into it.
struct Phase {
  int cells;
  double pace;  // of a step: 1 erodes channels of 1 m^2 at slope 1 by 1 m
  int fluvial_steps;
  double creep;      // of a step: diffusivity * time / cell^2
  double slide;      // steepest slope in that of rock
  double roughness;  // of what water finds on the slopes, in their slope
  int thermal_iterations;
};

// Lets a phase's time pass; the land keeps its lattice or gets a finer one.
void Evolve(const GridGeometry& lattice, const Phase& phase, const BaseLevel& base,
            const Fields& fields, Grid<float>* land_m) {
  const int n = phase.cells;
  const double cell_m = lattice.size_m() / n;
  *land_m = Resample(*land_m, n, n);
  const BaseLevel own = n == lattice.rows() ? base : Coarser(base, n);
  for (std::size_t i = 0; i < land_m->size(); ++i) {
    if (own.outlet.data()[i] != 0) land_m->data()[i] = own.height_m.data()[i];
  }
  Grid<float> uplift = Resample(fields.steepness_m, n, n);
  for (float& value : uplift) value *= static_cast<float>(kErodibility_per_yr);
  const Grid<float> erodibility = Resample(fields.erodibility, n, n);
  if (phase.roughness > 0.0) {
    RoughenSlopes(GridGeometry::FromCells(n, lattice.size_m()), phase.roughness, fields.gully_seed,
                  land_m);
  }
  FluvialOptions fluvial;
  fluvial.steps = phase.fluvial_steps;
  fluvial.time_step_yr = phase.pace / kErodibility_per_yr;
  fluvial.area_exponent = kAreaExponent;
  fluvial.erodibility =
      kErodibility_per_yr * std::pow(lattice.size_m() / kReachOfSize, 1.0 - 2.0 * kAreaExponent);
  fluvial.diffusivity_m2_per_yr = phase.creep * cell_m * cell_m / fluvial.time_step_yr;
  ErodeFluvially(cell_m, fluvial, &own.outlet, &uplift, &erodibility, 0, land_m);
  // What stands steeper than the talus above its valley has slid away.
  Grid<float> slide = Resample(fields.slide_slope, n, n);
  for (float& value : slide) value *= static_cast<float>(phase.slide * cell_m);
  LimitSlope(slide, land_m);
  if (phase.thermal_iterations > 0) {
    const Grid<float> talus = Resample(fields.talus, n, n);
    ThermalOptions thermal;
    thermal.iterations = phase.thermal_iterations;
    ErodeThermally(cell_m, thermal, &talus, 0, land_m);
  }
  for (std::size_t i = 0; i < land_m->size(); ++i) {
    if (own.outlet.data()[i] != 0) land_m->data()[i] = own.height_m.data()[i];
  }
}

// Creep rounds soft land, as far as it has come since rain last cut it.
void Creep(const GridGeometry& lattice, const SmoothedMasks& masks, const ReliefForms& forms,
           Grid<float>* land_m) {
  const double layout_cell = LatticeCellsPerLayoutCell(lattice);
  Grid<float> smoothness = MixTrait(masks, &ClassTraits::smoothness);
  forms.Roughen(&smoothness);
  Grid<float> wide = *land_m;
  GaussianBlur(std::min(0.35 * layout_cell, kMaxCreep_m / lattice.resolution_m()), &wide);
  for (std::size_t i = 0; i < wide.size(); ++i) {
    land_m->data()[i] += smoothness.data()[i] * (wide.data()[i] - land_m->data()[i]);
  }
}

Grid<float> RiverFall(const GridGeometry& lattice, const SmoothedMasks& masks) {
  // The water's own class says nothing of the land that it runs through: look around.
  Grid<float> sum(lattice.rows(), lattice.cols()), share(lattice.rows(), lattice.cols());
  for (const SmoothedMask& entry : masks.classes) {
    if (entry.letter == class_letter::kWater) continue;
    const float fall = TraitsOf(masks.vocabulary, entry.letter).river_fall;
    for (std::size_t i = 0; i < sum.size(); ++i) {
      sum.data()[i] += fall * entry.weight.data()[i];
      share.data()[i] += entry.weight.data()[i];
    }
  }
  const double around = 1.0 * LatticeCellsPerLayoutCell(lattice);
  GaussianBlur(around, &sum);
  GaussianBlur(around, &share);
  constexpr float kLeastFall = 0.001f, kTiny = 1e-3f;
  const auto cell_m = static_cast<float>(lattice.resolution_m());
  for (std::size_t i = 0; i < sum.size(); ++i) {
    sum.data()[i] = cell_m * std::max(kLeastFall, sum.data()[i] / std::max(share.data()[i], kTiny));
  }
  return sum;
}

// Terraces of this height [m] and more are worth smoothing.
constexpr double kVisibleStep_m = 0.02;

void SmoothSteps(double step_m, Grid<float>* land) {
  constexpr int kRounds = 3;
  const Grid<float> given = *land;
  const auto half = static_cast<float>(0.5 * step_m);
  double sigma_cells = std::min(land->rows(), land->cols()) / 64.0;
  for (int round = 0; round < kRounds; ++round, sigma_cells *= 0.5) {
    GaussianBlur(sigma_cells, land);
    for (std::size_t i = 0; i < given.size(); ++i) {
      const float middle = given.data()[i];
      land->data()[i] = std::clamp(land->data()[i], middle - half, middle + half);
    }
  }
}

}  // namespace

Result<ShapedLand> ShapeLand(const GridGeometry& lattice, const SmoothedMasks& masks,
                             const WaterBodies& water, const ReliefForms& forms, std::uint64_t seed,
                             const Progress& progress) {
  const int n = lattice.rows();
  const double size_m = lattice.size_m();
  const double incision_m = std::min(kMaxIncision_m, kIncisionOfSize * size_m);
  const Grid<float> hills_m =
      ProceduralRelief(lattice, std::min(kHillsOfSize * size_m, kMaxHills_m), seed);
  const Upheaval& upheaval = forms.MountainsByClass() ? kMountains : kByClass;
  Fields fields = FieldsOf(lattice, masks, upheaval, seed);
  // Land that goes on beyond the edge is as its classes are, whatever words say of this world's.
  const Grid<float> edge_m = EdgeHeight(lattice, fields, hills_m);
  if (!forms.empty()) forms.Raise(&fields.steepness_m, &fields.slide_slope, &fields.talus);

  const std::vector<std::int32_t> outlets = OutletsOf(water, PriorLand(lattice, fields, hills_m));
  ShapedLevels levels(water, FlowDistance(water, outlets, RiverFall(lattice, masks)));
  levels.SetOpenBases(outlets, hills_m, incision_m);
  levels.Reconcile(kNeighbourSlope * lattice.resolution_m());

  // First a coarse land around the water that leaves the world: it says how high closed lakes lie.
  Grid<float> foot_m = FootOf(lattice, water, levels.Levels(), hills_m);
  Grid<float> land_m = OnFoot(foot_m, hills_m, FirstLand(lattice, fields, hills_m, seed));
  const Phase young = {n / 4, 0.2, 4, 0.3, 1.0, 0.0, 0};
  BaseLevel base = BaseLevelOf(OnFoot(foot_m, hills_m, edge_m), levels.Levels(), forms);
  for (int time = 0; time < 2; ++time) Evolve(lattice, young, base, fields, &land_m);
  LW_RETURN_IF_ERROR(progress.CheckCancelled());
  levels.SetClosedBases(Resample(land_m, n, n), incision_m);
  levels.Reconcile(kNeighbourSlope * lattice.resolution_m());
  ShapedLand result;
  result.water_level_m = levels.Levels();

  foot_m = FootOf(lattice, water, result.water_level_m, hills_m);
  land_m = Resample(land_m, n, n);
  for (std::size_t i = 0; i < land_m.size(); ++i) {
    land_m.data()[i] = std::max(land_m.data()[i], foot_m.data()[i]);
  }
  base = BaseLevelOf(OnFoot(foot_m, hills_m, edge_m), result.water_level_m, forms);
  const Phase mature = {n / 2, 0.3, 3, 0.0, 1.2, 0.75, 6};
  const Phase gullies = {n, 0.6, 2, 0.0, 1.3, 0.5, 2};
  const double mountains = fields.mountain_share;
  const double accordance = (kAccordance + upheaval.accordance * mountains * (1.0 - mountains)) *
                            (1.0 - forms.RaisedShare());
  for (const Phase& phase : {young, mature, gullies}) {
    Evolve(lattice, phase, base, fields, &land_m);
    if (phase.cells == n / 2) LowerSummits(accordance, Resample(foot_m, n / 2, n / 2), &land_m);
    LW_RETURN_IF_ERROR(progress.CheckCancelled());
  }
  Creep(lattice, masks, forms, &land_m);
  forms.Lay(result.water_level_m, foot_m, &land_m);
  result.height_m = std::move(land_m);
  return result;
}

void FillHollows(double cell_m, const WaterBodies& water, const Grid<float>& level_m,
                 const Grid<unsigned char>& hollow, Grid<float>* land_m) {
  constexpr double kLeastFall = 0.004;  // [m/m]
  const int n = land_m->rows();
  Grid<unsigned char> outlet = water.wet;
  for (const std::int32_t cell : EdgeCells(n)) outlet.data()[cell] = 1;
  for (std::size_t i = 0; i < outlet.size(); ++i) outlet.data()[i] |= hollow.data()[i];
  Grid<float> surface = *land_m;
  for (std::size_t i = 0; i < surface.size(); ++i) {
    if (water.wet.data()[i] != 0) surface.data()[i] = level_m.data()[i];
  }
  surface = FillDepressions(surface, &outlet);
  // What was filled gets a gentle fall, so that nothing finer closes it again.
  const auto fall_m = static_cast<float>(kLeastFall * cell_m);
  const FlowGraph flow = RouteFlow(surface, &outlet);
  for (const std::int32_t cell : flow.order) {
    const std::int32_t below = flow.receiver[cell];
    if (below == cell) continue;
    surface.data()[cell] = std::max(surface.data()[cell], surface.data()[below] + fall_m);
  }
  for (std::size_t i = 0; i < surface.size(); ++i) {
    if (water.wet.data()[i] == 0) land_m->data()[i] = surface.data()[i];
  }
}

Grid<float> ReliefLand(const Relief& relief, int cells) {
  const bool finer = relief.height_m.rows() > cells || relief.height_m.cols() > cells;
  Grid<float> land = finer ? Resample(relief.height_m, cells, cells) : relief.height_m;
  if (relief.height_step_m >= kVisibleStep_m) SmoothSteps(relief.height_step_m, &land);
  return land;
}

}  // namespace latticeworld::internal
