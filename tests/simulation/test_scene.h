#ifndef LATTICEWORLD_TESTS_SIMULATION_TEST_SCENE_H_
#define LATTICEWORLD_TESTS_SIMULATION_TEST_SCENE_H_

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "latticeworld/scene/scene.h"
#include "latticeworld/simulation/simulator.h"

namespace latticeworld {

// A scene made by hand: grass everywhere unless told otherwise, no wind, sun.
struct TestScene {
  int cells = 128;
  double size_m = 64.0;
  std::function<double(double x_m, double y_m)> height_m = [](double, double) { return 0.0; };
  std::function<double(double x_m, double y_m)> water_depth_m = [](double, double) { return 0.0; };
  std::function<SurfaceClass(double x_m, double y_m)> surface = [](double, double) {
    return SurfaceClass::kGrass;
  };
  std::vector<Asset> assets;
  std::vector<AgentStart> agents;
  std::vector<Prop> props;
  Atmosphere atmosphere;
  EnvironmentConfig environment;  // without values: every surface is as it is by itself

  void AddTree(double x_m, double y_m, double trunk_radius_m = 0.3);
  void AddBuilding(double x_m, double y_m, double half_length_m, double half_width_m,
                   double yaw_rad = 0.0);
  AgentStart& AddAgent(const std::string& name, AgentCategory category, double x_m, double y_m);
  // Of the usual size, mass and strength, on the ground.
  Prop& AddProp(const std::string& name, PropKind kind, double x_m, double y_m);
  std::shared_ptr<const Scene> Build() const;
};

// Rolling hills with slopes up to about max_slope.
std::function<double(double, double)> Hills(double amplitude_m, double wavelength_m);

std::unique_ptr<Simulator> MakeSimulator(const TestScene& scene, std::uint64_t seed = 1,
                                         const SimulatorOptions& options = {});
// At a place, named, of a species of the catalogue; the rest is what suits it.
SpawnRequest RequestFor(const std::string& species, const std::string& name, double x_m,
                        double y_m);
// Spawns it; the request must be a legal one.
void MustSpawn(Simulator* simulator, const SpawnRequest& request);
const AgentSnapshot& Find(const WorldState& state, const std::string& name);
AgentSnapshot Now(const Simulator& simulator, const std::string& name);
PropSnapshot PropNow(const Simulator& simulator, const std::string& name);
VelocityCommand Forward(double speed_mps, double yaw_rate_radps = 0.0);
// Steps for that long; a command is given anew before every step when there is one.
void RunFor(Simulator* simulator, double seconds);
void RunWith(Simulator* simulator, double seconds, const std::string& agent,
             const VelocityCommand& command);
double YawOf(const AgentSnapshot& agent);
int Count(const std::vector<Event>& events, EventKind kind, const std::string& agent);

}  // namespace latticeworld

#endif  // LATTICEWORLD_TESTS_SIMULATION_TEST_SCENE_H_
