#include "latticeworld/navigation/tasks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "latticeworld/common/random.h"
#include "latticeworld/common/text.h"
#include "latticeworld/navigation/distance_field.h"
#include "latticeworld/navigation/navigable_map.h"
#include "latticeworld/scene/agents/spawn_site.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {
namespace {

constexpr int kStartsPerGoal = 25;
constexpr int kDrawsPerStart = 20;  // until one is where the robot can be put
constexpr int kGoalsPerTask = 40;
constexpr double kLeastRadius_m = 0.01;  // of a body that is put somewhere

// What a difficulty is made of, by name.
struct DifficultyMeasure {
  const char* name;
  const DifficultyRange TaskWishes::*wanted;
  double (*of)(const TaskDifficulty&);
};
constexpr std::array<DifficultyMeasure, 5> kMeasures = {
    {{"length_m", &TaskWishes::length_m, [](const TaskDifficulty& d) { return d.length_m; }},
     {"climb_m", &TaskWishes::climb_m, [](const TaskDifficulty& d) { return d.climb_m; }},
     {"density", &TaskWishes::density, [](const TaskDifficulty& d) { return d.density; }},
     {"detour", &TaskWishes::detour, [](const TaskDifficulty& d) { return d.detour; }},
     {"agents", &TaskWishes::agents,
      [](const TaskDifficulty& d) { return static_cast<double>(d.agents); }}}};

// What came out of the ways that were tried, for those who asked for what is not there.
struct Offer {
  std::array<double, kMeasures.size()> low, high;
  std::array<int, kMeasures.size()> refused{};
  int tried = 0;

  Offer() {
    low.fill(std::numeric_limits<double>::infinity());
    high.fill(-std::numeric_limits<double>::infinity());
  }
  // Whether the difficulty is wanted.
  bool Take(const TaskDifficulty& difficulty, const TaskWishes& wishes) {
    ++tried;
    bool wanted = true;
    for (std::size_t i = 0; i < kMeasures.size(); ++i) {
      const double value = kMeasures[i].of(difficulty);
      low[i] = std::min(low[i], value);
      high[i] = std::max(high[i], value);
      if ((wishes.*kMeasures[i].wanted).Contains(value)) continue;
      ++refused[i];
      wanted = false;
    }
    return wanted;
  }
  std::string InWords(const TaskWishes& wishes) const {
    if (tried == 0) return "; no way of a wanted length was found at all";
    std::string text;
    for (std::size_t i = 0; i < kMeasures.size(); ++i) {
      if (refused[i] == 0) continue;
      const DifficultyRange& wanted = wishes.*kMeasures[i].wanted;
      text += std::string("; ") + kMeasures[i].name + " was outside [" + FormatDouble(wanted.low) +
              ", " + FormatDouble(wanted.high) + "] in " + std::to_string(refused[i]) + " of " +
              std::to_string(tried) + " ways, which have " + FormatDouble(low[i]) + " to " +
              FormatDouble(high[i]);
    }
    return text;
  }
};

double DistanceToWay(const SurfacePath& way, const Eigen::Vector2d& place) {
  double nearest_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < way.points_m.size(); ++i) {
    const Eigen::Vector2d from = way.points_m[i - 1].head<2>();
    const Eigen::Vector2d along = way.points_m[i].head<2>() - from;
    const double square = along.squaredNorm();
    const double t = square > 0.0 ? std::clamp((place - from).dot(along) / square, 0.0, 1.0) : 0.0;
    nearest_m = std::min(nearest_m, (place - from - t * along).norm());
  }
  return nearest_m;
}

// Share of blocked cells in discs along the way, one a reach.
double DensityAlong(const NavigableMap& map, const SurfacePath& way) {
  const int reach =
      std::max(1, static_cast<int>(std::lround(kDensityReach_m / map.geometry().resolution_m())));
  std::int64_t cells = 0, blocked = 0;
  const auto look = [&](const Eigen::Vector2d& at) {
    const CellIndex middle = map.geometry().CellAt({at.x(), at.y()});
    for (int row = middle.row - reach; row <= middle.row + reach; ++row) {
      for (int col = middle.col - reach; col <= middle.col + reach; ++col) {
        const int dr = row - middle.row, dc = col - middle.col;
        if (dr * dr + dc * dc > reach * reach || !map.free.Contains({row, col})) continue;
        ++cells;
        blocked += map.free(row, col) == 0 ? 1 : 0;
      }
    }
  };
  for (std::size_t i = 1; i < way.points_m.size(); ++i) {
    const Eigen::Vector2d from = way.points_m[i - 1].head<2>(), to = way.points_m[i].head<2>();
    const int pieces =
        std::max(1, static_cast<int>(std::ceil((to - from).norm() / kDensityReach_m)));
    for (int k = 0; k < pieces; ++k) look(from + (to - from) * k / pieces);
  }
  look(way.points_m.back().head<2>());
  return static_cast<double>(blocked) / static_cast<double>(cells);
}

TaskDifficulty DifficultyOf(const Scene& scene, const NavigableMap& map, const SurfacePath& way) {
  TaskDifficulty difficulty;
  difficulty.length_m = way.length_m;
  difficulty.climb_m = way.climb_m;
  difficulty.density = DensityAlong(map, way);
  const double straight_m = (way.points_m.back() - way.points_m.front()).norm();
  difficulty.detour = straight_m > 0.0 ? std::max(1.0, way.length_m / straight_m) : 1.0;
  difficulty.agents = static_cast<int>(
      std::count_if(scene.agents.begin(), scene.agents.end(), [&](const AgentStart& agent) {
        return !agent.controllable &&
               DistanceToWay(way, {agent.position.x_m, agent.position.y_m}) <= kAgentReach_m;
      }));
  return difficulty;
}

// The map without the cells in which the robot's disc would reach the outermost ones: planners such
// as navfn and global_planner take those for closed.
NavigableMap WithoutEdge(NavigableMap map, double radius_m) {
  const GridGeometry& geometry = map.geometry();
  const double limit_m = geometry.half_size_m() - geometry.resolution_m() - radius_m;
  for (int row = 0; row < map.free.rows(); ++row) {
    for (int col = 0; col < map.free.cols(); ++col) {
      const WorldPoint center = geometry.CenterOf({row, col});
      if (std::max(std::abs(center.x_m), std::abs(center.y_m)) > limit_m) map.free(row, col) = 0;
    }
  }
  return map;
}

// Whether world_server would put the robot there: its whole disc on ground that it can stand on.
bool CanSpawn(const Scene& scene, const RobotLimits& robot, WorldPoint place) {
  const AgentCategory category =
      robot.on_wheels ? AgentCategory::kWheeledRobot : AgentCategory::kRoboticDog;
  return ExamineSpawn(scene, scene.atmosphere, category, std::max(robot.radius_m, kLeastRadius_m),
                      place)
             .flaw == SpawnFlaw::kNone;
}

// Free cells where a task may begin and end: outside of bushes and crops, which let a robot pass
// but hide everything else from its eyes.
Grid<std::uint8_t> OpenCells(const Scene& scene, const NavigableMap& map, double radius_m) {
  const GridGeometry& geometry = map.geometry();
  Grid<std::uint8_t> open = map.free;
  for (const Asset& asset : scene.assets) {
    if (asset.kind != AssetKind::kBush && asset.kind != AssetKind::kCrop) continue;
    const double reach_m = std::max(asset.half_length_m, asset.half_width_m) + radius_m;
    const CellIndex low = geometry.CellAt({asset.x_m - reach_m, asset.y_m + reach_m});
    const CellIndex high = geometry.CellAt({asset.x_m + reach_m, asset.y_m - reach_m});
    for (int row = std::max(low.row, 0); row <= std::min(high.row, open.rows() - 1); ++row) {
      for (int col = std::max(low.col, 0); col <= std::min(high.col, open.cols() - 1); ++col) {
        const WorldPoint center = geometry.CenterOf({row, col});
        if (std::hypot(center.x_m - asset.x_m, center.y_m - asset.y_m) < reach_m)
          open(row, col) = 0;
      }
    }
  }
  return open;
}

// Those of `open` that are so far from the goal.
std::vector<CellIndex> CellsOf(const DistanceField& field, const DifficultyRange& length_m,
                               const Grid<std::uint8_t>& open) {
  std::vector<CellIndex> cells;
  for (int row = 0; row < field.distance_m.rows(); ++row) {
    for (int col = 0; col < field.distance_m.cols(); ++col) {
      const double distance_m = field.distance_m(row, col);
      if (open(row, col) != 0 && std::isfinite(distance_m) && length_m.Contains(distance_m))
        cells.push_back({row, col});
    }
  }
  return cells;
}

}  // namespace

Status Validate(const TaskWishes& wishes) {
  std::vector<Violation> violations;
  const auto add = [&](const char* pointer, const std::string& legal, double given) {
    violations.push_back(
        {"out_of_range", pointer, legal + ", not " + FormatDouble(given), FormatDouble(given)});
  };
  if (wishes.count < 1 || wishes.count > 1000) add("count", "must be from 1 to 1000", wishes.count);
  if (!(wishes.goal_radius_m > 0.0 && wishes.goal_radius_m <= 100.0))
    add("goal_radius_m", "must be above 0 and at most 100", wishes.goal_radius_m);
  for (const DifficultyMeasure& measure : kMeasures) {
    const DifficultyRange& range = wishes.*measure.wanted;
    if (!(range.low >= 0.0) || !std::isfinite(range.low))
      add(measure.name, "must begin at a finite number of at least 0", range.low);
    else if (!(range.high >= range.low))
      add(measure.name, "must end at or above its begin, " + FormatDouble(range.low), range.high);
  }
  if (violations.empty()) return Status();
  return Status::FromViolations("what tasks are asked for", std::move(violations));
}

Result<std::vector<NavigationTask>> SampleTasks(const Scene& scene, const TaskWishes& wishes,
                                                const Progress& progress) {
  LW_RETURN_IF_ERROR(Validate(wishes));
  // Goals and starts are open cells, some way from the world's edge.
  const NavigableMap map = BuildNavigableMap(scene, wishes.robot);
  const NavigableMap inner = WithoutEdge(map, wishes.robot.radius_m);
  const Grid<std::uint8_t> open = OpenCells(scene, inner, wishes.robot.radius_m);
  std::vector<CellIndex> ends;
  for (int row = 0; row < open.rows(); ++row) {
    for (int col = 0; col < open.cols(); ++col) {
      if (open(row, col) != 0) ends.push_back({row, col});
    }
  }
  if (ends.empty())
    return FailedPrecondition(
        "the robot can be nowhere in this world: nothing is free for it outside of bushes, crops "
        "and the world's edge");

  // Goals are drawn, and for each some starts, until there are tasks enough.
  RandomStream random(wishes.seed, "navigation tasks");
  const auto draw = [&](const std::vector<CellIndex>& cells) {
    return map.geometry().CenterOf(cells[random.NextBits() % cells.size()]);
  };
  Offer offer;
  std::vector<NavigationTask> tasks;
  const int most_goals = kGoalsPerTask * wishes.count;
  for (int goals = 0; static_cast<int>(tasks.size()) < wishes.count && goals < most_goals;
       ++goals) {
    LW_RETURN_IF_ERROR(progress.CheckCancelled());
    const WorldPoint goal = draw(ends);
    // A way that is pulled straight may be a little shorter than the field has it.
    LW_ASSIGN_OR_RETURN(const DistanceField field,
                        DistancesTo(inner, goal, 1.02 * wishes.length_m.high));
    const std::vector<CellIndex> starts = CellsOf(field, wishes.length_m, open);
    // The first start whose way is as difficult as wished makes a task.
    for (int i = 0; i < kStartsPerGoal && !starts.empty(); ++i) {
      NavigationTask task;
      task.start = draw(starts);
      for (int k = 1; k < kDrawsPerStart && !CanSpawn(scene, wishes.robot, task.start); ++k)
        task.start = draw(starts);
      if (!CanSpawn(scene, wishes.robot, task.start)) continue;
      task.start_heading_rad = random.Uniform(-M_PI, M_PI);
      task.goal = goal;
      task.goal_radius_m = wishes.goal_radius_m;
      Result<SurfacePath> way = PathDown(inner, field, task.start);
      if (!way.ok()) continue;
      task.way = std::move(way).value();
      task.difficulty = DifficultyOf(scene, map, task.way);
      if (!offer.Take(task.difficulty, wishes)) continue;
      tasks.push_back(std::move(task));
      progress.Report("tasks", static_cast<double>(tasks.size()) / wishes.count);
      break;
    }
  }
  if (static_cast<int>(tasks.size()) < wishes.count)
    return FailedPrecondition("found " + std::to_string(tasks.size()) + " of " +
                              std::to_string(wishes.count) + " tasks" + offer.InWords(wishes));
  return tasks;
}

}  // namespace latticeworld
