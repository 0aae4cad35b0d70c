#ifndef LATTICEWORLD_SCENE_SCENE_H_
#define LATTICEWORLD_SCENE_SCENE_H_

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "latticeworld/catalogue/catalogue.h"
#include "latticeworld/common/progress.h"
#include "latticeworld/common/result.h"
#include "latticeworld/environment/environment_config.h"
#include "latticeworld/layout/thing_wish.h"
#include "latticeworld/scene/asset.h"
#include "latticeworld/scene/asset_index.h"
#include "latticeworld/scene/props/prop.h"
#include "latticeworld/scene/props/thing.h"
#include "latticeworld/scene/weather/atmosphere.h"
#include "latticeworld/terrain/terrain.h"

namespace latticeworld {

// No world holds more assets than this; larger ones are thinned and say so in a warning.
inline constexpr int kMaxAssets = 500000;

// Agents of a scene at most: those of the groups and the robot that every world has.
inline constexpr int kMaxAgentStarts = kMaxAgents + 1;

// Says where an agent begins.
struct AgentStart {
  std::string name;  // unique, legal as a ROS name: "sheep_1"; the first wheeled robot is "robot"
  AgentCategory category = AgentCategory::kSheep;
  AgentState state = AgentState::kIdle;
  int team = 0;               // 0 animals, 1 robots, 2 goblins and ancient warriors
  bool controllable = false;  // obeys commands instead of behaving by itself: wheeled robots
  WorldPoint position;
  double height_above_ground_m = 0.0;  // of the body's lowest point; flyers > 0
  double heading_rad = 0.0;            // 0 east, counter-clockwise
};

// Everything of a world that does not change while it is simulated.
struct Scene {
  std::shared_ptr<const Terrain> terrain;                             // never null
  std::shared_ptr<const Catalogue> catalogue = Catalogue::BuiltIn();  // what assets are; never null
  EnvironmentConfig environment;
  std::vector<Asset> assets;
  AssetIndex index;  // over assets
  Atmosphere atmosphere;
  std::vector<AgentStart> agents;
  std::vector<Prop> props;         // crates, gates, bridges ...; sorted by name
  std::vector<SceneThing> things;  // that were asked for one by one, in the order of the wishes

  const GridGeometry& geometry() const { return terrain->geometry(); }
};

struct SceneRequest {
  std::shared_ptr<const Terrain> terrain;
  std::shared_ptr<const Catalogue> catalogue = Catalogue::BuiltIn();
  EnvironmentConfig environment;
  std::vector<ThingWish> things;
  double latitude_deg = kUsualLatitude_deg;  // where the sun stands; [-90, 90]
  std::uint64_t seed = 0;
  int threads = 0;  // 0: as many as cores; the scene is the same with any
};

// How many of a kind the densities ask for over the whole world, and how many found a place.
struct KindCount {
  AssetKind kind = AssetKind::kTree;
  int wanted = 0;
  int placed = 0;
};

struct SceneAnswer {
  std::shared_ptr<const Scene> scene;
  std::vector<KindCount> counts;      // one a kind, in the order of AssetKind
  std::vector<std::string> warnings;  // what could not be placed and why
};

// Psi_C: places assets, agents and props by class weights, density and rules (densities.h has
// the numbers a hectare, placement.h and props.h the rules), and what is asked for one by one
// (things.h). Nothing solid overlaps, and nothing
// stands in water, on a road or outside. Every stage draws from its own stream of the seed: the
// same request gives the same bytes. Reports the stage "scene". Errors: CANCELLED.
Result<SceneAnswer> BuildScene(const SceneRequest& request, const Progress& progress);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SCENE_SCENE_H_
