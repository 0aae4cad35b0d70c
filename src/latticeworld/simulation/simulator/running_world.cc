#include "latticeworld/simulation/simulator/running_world.h"

#include <utility>

#include "latticeworld/simulation/simulator/weathering.h"

namespace latticeworld {

RunningWorld::RunningWorld(std::shared_ptr<const Scene> own_scene,
                           const SimulatorOptions& own_options)
    : scene(std::move(own_scene)),
      options(own_options),
      clock(options.step_s),
      events(&clock),
      paths(*scene),
      dynamic_scene(scene, options.physics_threads),
      weather(scene.get(), options.day_length_s, seed),
      map(scene.get()) {}

void RunningWorld::BeginEpisode(std::uint64_t episode_seed) {
  seed = episode_seed;
  clock.SetEpisodeStep(0);
  agents.Clear();
  map.Clear();
  dynamic_scene.Begin();
  map.List(dynamic_scene);
  paths.Update(map.changes());
  const bool other_weather = weather.HasChanged();
  weather = RunningWeather(scene.get(), options.day_length_s, seed);
  if (other_weather) TellWeather(this);
}

Surroundings RunningWorld::ForAgents() {
  Surroundings world;
  world.scene = scene.get();
  world.changes = &map.changes();
  world.map_version = map.version();
  world.atmosphere = &weather.now();
  world.surfaces = &weather.surfaces();
  world.gusts = &weather.gusts();
  world.drift_m = weather.drift_m();
  world.paths = &paths;
  world.near = &agents.places();
  world.agents = &agents.all();
  world.physics = &dynamic_scene.physics();
  world.events = events.list();
  world.step_s = options.step_s;
  world.pursuit_distance_m = options.pursuit_distance_m;
  world.step = clock.step();
  world.episode_step = clock.episode_step();
  return world;
}

std::string RunningWorld::NameOf(BodyId body) const {
  const AgentId agent = agents.IdOfBody(body);
  return agent != 0 ? agents.all().at(agent).name : dynamic_scene.NameOf(body);
}

void RunningWorld::Erase(AgentId id) {
  dynamic_scene.physics().Remove(agents.all().at(id).body);
  agents.Erase(id);
}

}  // namespace latticeworld
