// Single things: placing and measuring those of a request in a village of 512 m.

#include <benchmark/benchmark.h>

#include <cmath>
#include <memory>
#include <vector>

#include "latticeworld/layout/thing_wish.h"
#include "latticeworld/scene/props/thing_claims.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {
namespace {

constexpr double kSize_m = 512.0;
constexpr int kCells = 1024;

// Grassland with a lake, a village and a road.
std::shared_ptr<const Terrain> VillageGround() {
  static const std::shared_ptr<const Terrain> terrain = [] {
    const GridGeometry geometry = GridGeometry::FromCells(kCells, kSize_m);
    auto ground = std::make_shared<Terrain>();
    Grid<float> grass(kCells, kCells, 1.0f), houses(kCells, kCells, 0.0f);
    ground->water_level_m = Grid<float>(kCells, kCells, NAN);
    ground->surface = Grid<SurfaceClass>(kCells, kCells, SurfaceClass::kGrass);
    Grid<float> height_m(kCells, kCells, 0.5f);
    for (int row = 0; row < kCells; ++row) {
      for (int col = 0; col < kCells; ++col) {
        const WorldPoint at = geometry.CenterOf({row, col});
        if (std::hypot(at.x_m - 150.0, at.y_m - 60.0) < 60.0) {
          height_m(row, col) = -1.0f;
          ground->water_level_m(row, col) = 0.0f;
        } else if (std::abs(at.x_m - 20.0) < 3.0) {
          ground->surface(row, col) = SurfaceClass::kRoad;
        } else if (std::hypot(at.x_m + 120.0, at.y_m) < 60.0) {
          houses(row, col) = 1.0f;
          grass(row, col) = 0.0f;
        }
      }
    }
    ground->ground = HeightField(geometry, std::move(height_m));
    ground->weights.vocabulary = Vocabulary::kSuburb;
    ground->weights.classes.push_back({'B', std::move(houses)});
    ground->weights.classes.push_back({'G', std::move(grass)});
    return ground;
  }();
  return terrain;
}

ThingWish Wish(const char* kind, int count, ThingRelation relation, ThingTarget target) {
  ThingWish wish;
  wish.kind = kind;
  wish.count = wish.count_least = wish.count_most = count;
  wish.relation = relation;
  wish.target = target;
  return wish;
}

// A church that faces the lake, a well before it, benches around that, lamps along the road, trees
// in a row near the village, a grid of tents.
std::vector<ThingWish> Wishes() {
  std::vector<ThingWish> wishes = {
      Wish("church", 1, ThingRelation::kNear, {'B', -1}),
      Wish("well", 1, ThingRelation::kInFront, {'\0', 0}),
      Wish("bench", 4, ThingRelation::kAround, {'\0', 1}),
      Wish("lamp", 12, ThingRelation::kAlong, {'R', -1}),
      Wish("tree", 5, ThingRelation::kNear, {'B', -1}),
      Wish("tent", 16, ThingRelation::kNear, {'W', -1}),
  };
  wishes[0].facing.letter = 'W';
  wishes[3].spacing_m = 20.0;
  wishes[4].arrangement = ThingArrangement::kRow;
  wishes[5].arrangement = ThingArrangement::kGrid;
  return wishes;
}

SceneRequest Request(bool with_things) {
  SceneRequest request;
  request.terrain = VillageGround();
  for (int type = 0; type < kAssetTypeCount; ++type) {
    const AssetTypeValues& values = ValuesOf(static_cast<AssetType>(type));
    request.environment.fine[type].season_variant = values.season_variants.front();
    request.environment.fine[type].material = values.materials.front();
    request.environment.fine[type].density = 0.0;
  }
  request.seed = 3;
  if (with_things) request.things = Wishes();
  return request;
}

// The scene without what grows: the difference of both is what single things cost.
void BM_SceneOfThings(benchmark::State& state) {
  const SceneRequest request = Request(state.range(0) != 0);
  for (auto _ : state) benchmark::DoNotOptimize(BuildScene(request, Progress()));
  state.SetLabel(state.range(0) != 0 ? "39 single things" : "none");
}
BENCHMARK(BM_SceneOfThings)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

// One claim on its own: that one well stands.
void BM_OneThingClaim(benchmark::State& state) {
  SceneRequest request = Request(false);
  request.things = {Wish("well", 1, ThingRelation::kNone, {'\0', -1})};
  const auto answer = BuildScene(request, Progress());
  for (auto _ : state) {
    benchmark::DoNotOptimize(MeasureThings(*answer->scene, request.things));
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(BM_OneThingClaim)->Unit(benchmark::kMicrosecond);

void BM_ThingClaims(benchmark::State& state) {
  const std::vector<ThingWish> wishes = Wishes();
  const auto answer = BuildScene(Request(true), Progress());
  std::int64_t claims = 0;
  for (auto _ : state) {
    claims += static_cast<std::int64_t>(MeasureThings(*answer->scene, wishes).size());
  }
  state.SetItemsProcessed(claims);  // a claim each
}
BENCHMARK(BM_ThingClaims)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace latticeworld
