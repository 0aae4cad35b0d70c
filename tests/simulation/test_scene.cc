#include "simulation/test_scene.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "latticeworld/common/check.h"
#include "latticeworld/scene/agents/agent_placement.h"
#include "latticeworld/scene/props/props.h"
#include "latticeworld/species/species_catalogue.h"

namespace latticeworld {

void TestScene::AddTree(double x_m, double y_m, double trunk_radius_m) {
  Asset tree;
  tree.kind = AssetKind::kTree;
  tree.x_m = static_cast<float>(x_m);
  tree.y_m = static_cast<float>(y_m);
  tree.z_m = static_cast<float>(height_m(x_m, y_m));
  tree.height_m = 8.0f;
  tree.half_length_m = tree.half_width_m = 2.0f;
  tree.trunk_radius_m = static_cast<float>(trunk_radius_m);
  assets.push_back(tree);
}

void TestScene::AddBuilding(double x_m, double y_m, double half_length_m, double half_width_m,
                            double yaw_rad) {
  Asset building;
  building.kind = AssetKind::kBuilding;
  building.x_m = static_cast<float>(x_m);
  building.y_m = static_cast<float>(y_m);
  building.z_m = static_cast<float>(height_m(x_m, y_m));
  building.height_m = 6.0f;
  building.half_length_m = static_cast<float>(half_length_m);
  building.half_width_m = static_cast<float>(half_width_m);
  building.yaw_rad = static_cast<float>(yaw_rad);
  assets.push_back(building);
}

AgentStart& TestScene::AddAgent(const std::string& name, AgentCategory category, double x_m,
                                double y_m) {
  AgentStart start;
  start.name = name;
  start.category = category;
  start.state = UsualState(category);
  start.controllable = category == AgentCategory::kWheeledRobot;
  start.team = TeamOf(category);
  start.position = {x_m, y_m};
  const bool flies = SpeciesCatalogue::BuiltIn()->Of(category).plan == BodyPlan::kFlyer;
  if (flies) start.height_above_ground_m = 10.0;
  agents.push_back(start);
  return agents.back();
}

Prop& TestScene::AddProp(const std::string& name, PropKind kind, double x_m, double y_m) {
  Prop prop = UsualProp(kind);
  prop.name = name;
  prop.position = {x_m, y_m};
  prop.z_m = height_m(x_m, y_m);
  props.push_back(prop);
  return props.back();
}

std::shared_ptr<const Scene> TestScene::Build() const {
  const GridGeometry geometry = GridGeometry::FromCells(cells, size_m);
  Grid<float> height(cells, cells);
  auto terrain = std::make_shared<Terrain>();
  terrain->water_level_m = Grid<float>(cells, cells, std::numeric_limits<float>::quiet_NaN());
  terrain->surface = Grid<SurfaceClass>(cells, cells, SurfaceClass::kGrass);
  for (int row = 0; row < cells; ++row) {
    for (int col = 0; col < cells; ++col) {
      const WorldPoint at = geometry.CenterOf({row, col});
      const double z = height_m(at.x_m, at.y_m);
      const double depth = water_depth_m(at.x_m, at.y_m);
      height(row, col) = static_cast<float>(z);
      terrain->surface(row, col) = surface(at.x_m, at.y_m);
      if (depth > 0.0) terrain->water_level_m(row, col) = static_cast<float>(z + depth);
    }
  }
  terrain->ground = HeightField(geometry, std::move(height));
  auto scene = std::make_shared<Scene>();
  scene->terrain = std::move(terrain);
  scene->assets = assets;
  scene->index = AssetIndex(geometry.size_m(), assets);
  scene->agents = agents;
  scene->props = props;
  std::sort(scene->props.begin(), scene->props.end(),
            [](const Prop& a, const Prop& b) { return a.name < b.name; });
  scene->atmosphere = atmosphere;
  scene->environment = environment;
  return scene;
}

std::function<double(double, double)> Hills(double amplitude_m, double wavelength_m) {
  return [=](double x, double y) {
    const double k = 2.0 * M_PI / wavelength_m;
    return amplitude_m * std::sin(k * x + 0.7) * std::cos(k * y + 0.3) +
           0.25 * amplitude_m * std::sin(2.3 * k * x) * std::sin(1.9 * k * y);
  };
}

std::unique_ptr<Simulator> MakeSimulator(const TestScene& scene, std::uint64_t seed,
                                         const SimulatorOptions& options) {
  auto simulator = Simulator::Create(scene.Build(), options, seed);
  LW_CHECK(simulator.ok(), simulator.status().ToString());
  return std::move(simulator).value();
}

SpawnRequest RequestFor(const std::string& species, const std::string& name, double x_m,
                        double y_m) {
  SpawnRequest request;
  request.species = species;
  request.name = name;
  request.position = WorldPoint{x_m, y_m};
  return request;
}

void MustSpawn(Simulator* simulator, const SpawnRequest& request) {
  const auto name = simulator->Spawn(request);
  LW_CHECK(name.ok(), name.status().ToString());
}

const AgentSnapshot& Find(const WorldState& state, const std::string& name) {
  const auto found = std::find_if(state.agents.begin(), state.agents.end(),
                                  [&](const AgentSnapshot& agent) { return agent.name == name; });
  LW_CHECK(found != state.agents.end(), "no agent " + name);
  return *found;
}

AgentSnapshot Now(const Simulator& simulator, const std::string& name) {
  return Find(*simulator.State(), name);
}

PropSnapshot PropNow(const Simulator& simulator, const std::string& name) {
  for (const PropSnapshot& prop : simulator.State()->props) {
    if (prop.name == name) return prop;
  }
  LW_CHECK(false, "no element " + name);
  return {};
}

VelocityCommand Forward(double speed_mps, double yaw_rate_radps) {
  VelocityCommand command;
  command.linear_mps.x() = speed_mps;
  command.yaw_rate_radps = yaw_rate_radps;
  return command;
}

void RunFor(Simulator* simulator, double seconds) {
  const int steps = static_cast<int>(std::lround(seconds / simulator->options().step_s));
  for (int i = 0; i < steps; ++i) simulator->Step();
}

void RunWith(Simulator* simulator, double seconds, const std::string& agent,
             const VelocityCommand& command) {
  const int steps = static_cast<int>(std::lround(seconds / simulator->options().step_s));
  for (int i = 0; i < steps; ++i) {
    LW_CHECK(simulator->Command(agent, command).ok(), "a legal command");
    simulator->Step();
  }
}

double YawOf(const AgentSnapshot& agent) {
  const Eigen::Vector3d forward = agent.orientation * Eigen::Vector3d::UnitX();
  return std::atan2(forward.y(), forward.x());
}

int Count(const std::vector<Event>& events, EventKind kind, const std::string& agent) {
  return static_cast<int>(std::count_if(events.begin(), events.end(), [&](const Event& event) {
    return event.kind == kind && event.agent == agent;
  }));
}

}  // namespace latticeworld
