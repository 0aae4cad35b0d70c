#include "latticeworld/simulation/simulator/spawning/spawn_places.h"

#include <cmath>
#include <vector>

#include "latticeworld/common/text.h"
#include "latticeworld/scene/agents/spawn_rules.h"
#include "latticeworld/scene/agents/spawn_search.h"
#include "latticeworld/simulation/agents/ways/steering.h"

namespace latticeworld {
namespace {

constexpr int kTries = 8;  // places that the rules allow and something that moved is in the way of
constexpr double kStemSpacing_m = 3.0;  // between the places that a fallen stem takes
constexpr double kBeginNear = 3.0;      // spread about a start that is too narrow, in radii
constexpr int kRespawnTries = 16;
constexpr double kRespawnNear_m = 15.0;

// Checks a place by the rules of the scene alone.
Status CheckLegal(const Species& species, WorldPoint place, const RunningWorld& world) {
  return CheckSpawn(*world.scene, world.weather.now(), species.category, species.radius_m, place,
                    &world.map.changes());
}

// FAILED_PRECONDITION when an agent, a prop or a stem that lies or will lie there is in the way of
// a body there. except: not in its own way; 0: nobody.
Status CheckFree(const Species& species, WorldPoint place, AgentId except,
                 const RunningWorld& world) {
  const auto taken_by = [&](const std::string& what) {
    return FailedPrecondition(TextOf(place) + " is taken by " + what);
  };
  for (const auto& [id, agent] : world.agents.all()) {
    if (id == except) continue;
    const double gap_m =
        DistanceBetween(agent.place(), place) - agent.species->radius_m - species.radius_m;
    if (gap_m <= 0.0) return taken_by(agent.name);
  }
  if (species.plan == BodyPlan::kFlyer) return Status();
  const DynamicScene& scene = world.dynamic_scene;
  for (const auto& [name, running] : scene.props().state()) {
    if (GapTo(scene.props().BoxNow(running).footprint, place) <= species.radius_m) {
      return taken_by(name);
    }
  }
  for (const Footprint& stem : scene.felling().Obstacles()) {
    if (GapTo(stem, place) <= species.radius_m) return taken_by("a tree that lies or falls");
  }
  return Status();
}

// The places that agents, props and stems take.
std::vector<WorldPoint> PlacesTaken(const RunningWorld& world) {
  const DynamicScene& scene = world.dynamic_scene;
  std::vector<WorldPoint> taken;
  for (const auto& [id, agent] : world.agents.all()) taken.push_back(agent.place());
  for (const auto& [name, running] : scene.props().state()) {
    const Eigen::Vector3d at = scene.physics().MotionOf(running.body).position_m;
    taken.push_back({at.x(), at.y()});
  }
  for (const Footprint& stem : scene.felling().Obstacles()) {
    const int places = 1 + static_cast<int>(2.0 * stem.half_length_m / kStemSpacing_m);
    for (int i = 0; i <= places; ++i) {
      taken.push_back(stem.At(stem.half_length_m * (2.0 * i / places - 1.0), 0.0));
    }
  }
  return taken;
}

}  // namespace

std::string TextOf(WorldPoint place) {
  return "(" + FormatDouble(place.x_m) + ", " + FormatDouble(place.y_m) + ")";
}

Result<WorldPoint> PlaceFor(const SpawnRequest& request, const Species& species,
                            const RunningWorld& world, RandomStream* random) {
  if (request.position.has_value()) {
    const Status fits = CheckLegal(species, *request.position, world);
    if (!fits.ok()) {
      return species.name == NameOf(species.category) ? fits : fits.WithContext(species.name);
    }
    LW_RETURN_IF_ERROR(CheckFree(species, *request.position, 0, world));
    return *request.position;
  }
  const std::vector<WorldPoint> taken = PlacesTaken(world);
  Status in_the_way;
  for (int i = 0; i < kTries; ++i) {
    const Result<WorldPoint> place =
        FindSpawn(*world.scene, world.weather.now(), species.category, species.radius_m,
                  request.region, taken, random, &world.map.changes());
    if (!place.ok()) return place;
    in_the_way = CheckFree(species, *place, 0, world);
    if (in_the_way.ok()) return place;
  }
  return in_the_way;
}

WorldPoint PlaceToBegin(const AgentStart& start, const Species& species,
                        const RunningWorld& world) {
  if (species.radius_m <= BodyRadius(start.category)) return start.position;
  std::vector<WorldPoint> taken = PlacesTaken(world);
  bool fits = CheckLegal(species, start.position, world).ok() &&
              CheckFree(species, start.position, 0, world).ok();
  // Those that begin after it are not in the world yet.
  for (const AgentStart& other : world.scene->agents) {
    if (other.name == start.name) continue;
    taken.push_back(other.position);
    fits = fits && DistanceBetween(other.position, start.position) >
                       BodyRadius(other.category) + species.radius_m;
  }
  if (fits) return start.position;
  RandomStream random(0, "start " + start.name);
  const Result<WorldPoint> place =
      SpawnSearch(*world.scene, world.weather.now(), species.category, species.radius_m,
                  Region::kAnywhere, &world.map.changes())
          .FindNear(start.position, kBeginNear * species.radius_m, taken, &random);
  return place.ok() ? *place : start.position;
}

std::optional<WorldPoint> PlaceToRespawn(const RunningWorld& world, Agent* agent) {
  const Species& species = *agent->species;
  WorldPoint place = agent->start.position;
  for (int i = 0; i < kRespawnTries; ++i) {
    if (CheckLegal(species, place, world).ok() &&
        CheckFree(species, place, agent->id, world).ok()) {
      return place;
    }
    const double heading_rad = agent->mind.random.Uniform(-M_PI, M_PI);
    place = Ahead(agent->start.position, heading_rad,
                  agent->mind.random.Uniform(2.0 * species.radius_m, kRespawnNear_m));
  }
  return std::nullopt;
}

}  // namespace latticeworld
