#include "latticeworld/navigation/navigable_map.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "latticeworld/common/text.h"
#include "latticeworld/mapping/bridge_decks.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {
namespace {

std::string InWords(WorldPoint point) {
  return "(" + FormatDouble(point.x_m) + ", " + FormatDouble(point.y_m) + ")";
}

}  // namespace

NavigableMap BuildNavigableMap(const Scene& scene, const RobotLimits& limits,
                               const SceneChanges& changes, int threads) {
  NavigableMap map;
  map.ground = DrivenSurface(scene, limits, changes);
  const Grid<float> ease = BuildTraversability(scene, limits, changes, threads);
  map.free = Grid<std::uint8_t>(ease.rows(), ease.cols());
  std::transform(ease.begin(), ease.end(), map.free.begin(),
                 [](float value) { return static_cast<std::uint8_t>(value > 0.0f); });
  return map;
}

Status CheckInside(const GridGeometry& geometry, WorldPoint point, const char* what) {
  if (!std::isfinite(point.x_m) || !std::isfinite(point.y_m))
    return InvalidArgument(std::string(what) + " " + InWords(point) + " must be finite numbers");
  if (geometry.Contains(point)) return Status();
  const std::string half = FormatDouble(geometry.half_size_m());
  return Status(StatusCode::kOutOfRange, std::string(what) + " " + InWords(point) +
                                             " is outside the world, which reaches from -" + half +
                                             " to " + half + " m in x and y");
}

SurfaceLine MeasureLine(const NavigableMap& map, WorldPoint from, WorldPoint to) {
  SurfaceLine line;
  if (!map.IsFree(from) || !map.IsFree(to)) return line;
  const double run_m = std::hypot(to.x_m - from.x_m, to.y_m - from.y_m);
  // Half a cell at a time: no blocked cell is crossed but by less than a corner of it.
  const int pieces =
      std::max(1, static_cast<int>(std::ceil(2.0 * run_m / map.geometry().resolution_m())));
  double height_m = map.ground.HeightAt(from);
  for (int i = 1; i <= pieces; ++i) {
    const double t = static_cast<double>(i) / pieces;
    const WorldPoint at{from.x_m + t * (to.x_m - from.x_m), from.y_m + t * (to.y_m - from.y_m)};
    if (map.free[map.geometry().CellAt(at)] == 0) return line;
    const double next_m = map.ground.HeightAt(at);
    line.length_m += std::hypot(run_m / pieces, next_m - height_m);
    line.climb_m += std::max(0.0, next_m - height_m);
    height_m = next_m;
  }
  line.is_free = true;
  return line;
}

}  // namespace latticeworld
