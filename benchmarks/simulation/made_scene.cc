#include "simulation/made_scene.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "latticeworld/common/random.h"

namespace latticeworld {
namespace {

double HillAt(WorldPoint at) {
  return 30.0 + 3.0 * std::sin(0.02 * at.x_m + 0.7) * std::cos(0.023 * at.y_m) +
         0.4 * std::sin(0.11 * at.x_m) * std::sin(0.13 * at.y_m + 0.4);
}

std::shared_ptr<const Terrain> Grass(double size_m, double resolution_m) {
  const int cells = static_cast<int>(std::lround(size_m / resolution_m));
  const GridGeometry geometry = GridGeometry::FromCells(cells, size_m);
  Grid<float> height_m(cells, cells);
  for (int row = 0; row < cells; ++row) {
    for (int col = 0; col < cells; ++col) {
      height_m(row, col) = static_cast<float>(HillAt(geometry.CenterOf({row, col})));
    }
  }
  auto terrain = std::make_shared<Terrain>();
  terrain->ground = HeightField(geometry, std::move(height_m));
  terrain->water_level_m = Grid<float>(cells, cells, std::numeric_limits<float>::quiet_NaN());
  terrain->surface = Grid<SurfaceClass>(cells, cells, SurfaceClass::kGrass);
  return terrain;
}

// Which places are nearer than a distance to one of some points, by a grid of marked cells.
class Clearings {
 public:
  Clearings(double size_m, double radius_m) : size_m_(size_m), radius_m_(radius_m) {
    const auto cells = static_cast<std::size_t>(Side()) * static_cast<std::size_t>(Side());
    cells_.resize(cells);
  }
  void Add(WorldPoint point) { cells_[CellOf(point, 0, 0)].push_back(point); }
  bool Contains(WorldPoint point) const {
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        for (const WorldPoint& one : cells_[CellOf(point, dx, dy)]) {
          if (std::hypot(one.x_m - point.x_m, one.y_m - point.y_m) < radius_m_) return true;
        }
      }
    }
    return false;
  }

 private:
  static constexpr double kCell_m = 16.0;
  int Side() const { return static_cast<int>(size_m_ / kCell_m) + 3; }
  std::size_t CellOf(WorldPoint point, int dx, int dy) const {
    const auto index = [this](double value_m, int step) {
      const int cell = static_cast<int>((value_m + 0.5 * size_m_) / kCell_m) + 1 + step;
      return static_cast<std::size_t>(std::clamp(cell, 0, Side() - 1));
    };
    return index(point.y_m, dy) * static_cast<std::size_t>(Side()) + index(point.x_m, dx);
  }

  double size_m_, radius_m_;
  std::vector<std::vector<WorldPoint>> cells_;
};

std::vector<Asset> Trees(const MadeScene& made, const Terrain& terrain) {
  Clearings clearings(made.size_m, made.clearing_m);
  for (const WorldPoint& spot : made.spots) clearings.Add(spot);
  for (const AgentStart& agent : made.agents) clearings.Add(agent.position);
  const int side = static_cast<int>(std::ceil(std::sqrt(made.trees)));
  const double spacing_m = made.size_m / std::max(1, side);
  RandomStream random(1, "trees");
  std::vector<Asset> trees;
  for (int i = 0; i < made.trees; ++i) {
    const auto place = [&](int index) {
      return (index + 0.5 + 0.3 * (random.Uniform() - 0.5)) * spacing_m - 0.5 * made.size_m;
    };
    const double x_m = place(i % side), y_m = place(i / side);
    if (made.clearing_m > 0.0 && clearings.Contains({x_m, y_m})) continue;
    Asset tree;
    tree.x_m = static_cast<float>(x_m);
    tree.y_m = static_cast<float>(y_m);
    tree.z_m = static_cast<float>(terrain.ground.HeightAt({x_m, y_m}));
    tree.height_m = 9.0f;
    tree.half_length_m = tree.half_width_m = 1.8f;
    tree.trunk_radius_m = 0.15f;
    trees.push_back(tree);
  }
  return trees;
}

}  // namespace

AgentStart& MadeScene::AddAgent(AgentCategory category, AgentState state, int team,
                                WorldPoint position) {
  AgentStart start;
  start.name = "agent_" + std::to_string(agents.size() + 1);
  start.category = category;
  start.state = state;
  start.team = team;
  start.position = position;
  if (LocomotionOf(category) == Locomotion::kWings) start.height_above_ground_m = 12.0;
  agents.push_back(start);
  return agents.back();
}

std::shared_ptr<const Scene> MadeScene::Build() const {
  auto scene = std::make_shared<Scene>();
  scene->terrain = Grass(size_m, resolution_m);
  scene->assets = Trees(*this, *scene->terrain);
  scene->index = AssetIndex(size_m, scene->assets);
  scene->agents = agents;
  return scene;
}

std::vector<WorldPoint> Lattice(int count, double spacing_m) {
  const int side = static_cast<int>(std::ceil(std::sqrt(count)));
  std::vector<WorldPoint> places;
  for (int i = 0; i < count; ++i) {
    places.push_back(
        {(i % side - 0.5 * (side - 1)) * spacing_m, (i / side - 0.5 * (side - 1)) * spacing_m});
  }
  return places;
}

}  // namespace latticeworld
