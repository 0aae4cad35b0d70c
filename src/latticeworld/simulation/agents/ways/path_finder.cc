#include "latticeworld/simulation/agents/ways/path_finder.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/simulation/agents/ways/path_layers.h"
#include "latticeworld/simulation/agents/ways/path_search.h"
#include "latticeworld/simulation/agents/ways/solid_clearance.h"
#include "latticeworld/simulation/agents/ways/steering.h"

namespace latticeworld {
namespace {

// Ways pass solid things at this distance beside the body's radius, where they can.
constexpr double kBeside_m = 0.2;
// A body that was pushed to where it should not be leaves that place by so much.
constexpr double kLeave_m = 1.5;
constexpr double kThin_m = 0.02;  // of the ray that must not go through a wall
// A goal where nobody can be stands for the nearest place where one can.
constexpr double kAroundGoal_m = 6.0;
// Ways may cost so much of the cheapest one: over uneven ground this looks at less than half the
// cells.
constexpr int kGreed_percent = 125;

}  // namespace

struct PathFinder::Layers {
  explicit Layers(const Scene& scene) : maps(scene) {}

  bool IsWayClear(const Species& species, WorldPoint from, WorldPoint to, double margin_m) const {
    return latticeworld::IsWayClear(maps.scene(), maps.changes(), from, to, margin_m,
                                    species.height_m);
  }

  bool IsStraightFree(PathLayer* map, const Species& species, WorldPoint from, WorldPoint to) {
    if (!std::isfinite(from.x_m + from.y_m + to.x_m + to.y_m)) return false;
    double left = 0.0;
    if (!map->IsLineFree(from, to, kLeave_m, &left)) return false;
    const WorldPoint out{from.x_m + left * (to.x_m - from.x_m),
                         from.y_m + left * (to.y_m - from.y_m)};
    if (left > 0.0 && !IsWayClear(species, from, out, kThin_m)) return false;
    return IsWayClear(species, out, to, species.radius_m + (left > 0.0 ? 0.0 : kBeside_m));
  }

  // The cell that the body is in, or the nearest free one that no wall parts from it.
  bool Entry(PathLayer* map, const Species& species, WorldPoint from, CellIndex* entry) {
    *entry = map->CellAt(from);
    if (map->IsFree(*entry)) return true;
    const double reach_m = kLeave_m + species.radius_m + map->cell_m();
    return map->NearestFree(
        from, reach_m,
        [&](CellIndex cell) { return IsWayClear(species, from, map->CenterOf(cell), kThin_m); },
        entry);
  }

  // Corners of the cells' way that are needed: from each one straight to the farthest cell that
  // doubling steps and halving between them find. Cells that follow each other need no look.
  void Straighten(PathLayer* map, const Species& species, WorldPoint from,
                  const std::vector<CellIndex>& cells, WorldPoint end, FoundPath* path) {
    const std::size_t last = cells.size() - 1;
    const auto place = [&](std::size_t i) { return i == last ? end : map->CenterOf(cells[i]); };
    WorldPoint corner = from;
    const auto go_to = [&](WorldPoint next) {
      path->length_m += DistanceBetween(corner, next);
      path->points.push_back(next);
      corner = next;
    };
    if (map->CellAt(from) != cells.front()) go_to(map->CenterOf(cells.front()));
    std::size_t at = 0;
    while (at < last) {
      const auto sees = [&](std::size_t i) {
        return IsStraightFree(map, species, corner, place(i));
      };
      std::size_t seen = at + 1, not_seen = last + 1;
      for (std::size_t step = 2; seen < last; step *= 2) {
        const std::size_t next = std::min(at + step, last);
        if (!sees(next)) {
          not_seen = next;
          break;
        }
        seen = next;
      }
      while (not_seen - seen > 1 && not_seen <= last) {
        const std::size_t middle = seen + (not_seen - seen) / 2;
        (sees(middle) ? seen : not_seen) = middle;
      }
      go_to(place(seen));
      at = seen;
    }
  }

  PathLayers maps;
  PathSearch search;
};

PathFinder::PathFinder(const Scene& scene) : layers_(std::make_unique<Layers>(scene)) {}

PathFinder::~PathFinder() = default;

void PathFinder::Update(const SceneChanges& changes) { layers_->maps.Update(changes); }

FoundPath PathFinder::Find(const Species& species, WorldPoint from, WorldPoint to, int max_nodes) {
  PathLayer& map = layers_->maps.Of(species);
  FoundPath path;
  if (layers_->IsStraightFree(&map, species, from, to)) {
    path.points = {to};
    path.complete = true;
    path.length_m = DistanceBetween(from, to);
    return path;
  }
  CellIndex entry, goal = map.CellAt(to);
  if (!layers_->Entry(&map, species, from, &entry)) return path;
  WorldPoint end = to;
  bool is_goal = map.IsFree(goal);
  if (!is_goal && map.NearestFree(
                      to, kAroundGoal_m, [](CellIndex) { return true; }, &goal))
    end = map.CenterOf(goal);
  const CellPath found = layers_->search.Find(&map, entry, goal, max_nodes, kGreed_percent);
  path.complete = found.complete && is_goal;
  if (!found.complete) end = map.CenterOf(found.cells.back());
  if (found.cells.size() == 1) {
    // It is there already, or as near as it gets.
    path.points = {end};
    path.length_m = DistanceBetween(from, end);
    return path;
  }
  layers_->Straighten(&map, species, from, found.cells, end, &path);
  return path;
}

bool PathFinder::IsStraightFree(const Species& species, WorldPoint from, WorldPoint to) {
  return layers_->IsStraightFree(&layers_->maps.Of(species), species, from, to);
}

}  // namespace latticeworld
