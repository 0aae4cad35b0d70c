#include "latticeworld/simulation/simulator/weathering.h"

#include <string>

namespace latticeworld {
namespace {

void Tell(const std::string& what, RunningWorld* world) {
  world->events.Tell(EventKind::kWeatherChanged, "", what, Eigen::Vector3d::Zero());
}

// Tells the ground of the physics and the maps what the weather has made of it.
void WeatherGround(RunningWorld* world) {
  world->dynamic_scene.physics().SetGround(world->weather.now().ground());
  world->map.FollowGround(world->weather, world->dynamic_scene);
}

}  // namespace

void StepWeather(RunningWorld* world) {
  const RunningWeather::Outcome outcome = world->weather.Step(world->clock.step_s());
  if (outcome.moved) WeatherGround(world);
  if (outcome.complete) TellWeather(world);
}

void ChangeWeather(const WeatherChange& change, RunningWorld* world) {
  RunningWeather& weather = world->weather;
  weather.Change(change);
  const std::string name(NameOf(weather.target().weather));
  Tell(weather.moving() ? name + " begins" : name, world);
  WeatherGround(world);
}

void TellWeather(RunningWorld* world) {
  Tell(std::string(NameOf(world->weather.now().weather)), world);
}

}  // namespace latticeworld
