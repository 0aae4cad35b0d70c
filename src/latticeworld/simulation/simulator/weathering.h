#ifndef LATTICEWORLD_SIMULATION_SIMULATOR_WEATHERING_H_
#define LATTICEWORLD_SIMULATION_SIMULATOR_WEATHERING_H_

#include "latticeworld/scene/weather/weather_change.h"
#include "latticeworld/simulation/simulator/running_world.h"

namespace latticeworld {

// The weather goes on for a step, and the ground of the physics and the maps with it. Tells of a
// change that is complete.
void StepWeather(RunningWorld* world);
// The weather begins to move to what the change says, or is there at once; tells which. change:
// valid.
void ChangeWeather(const WeatherChange& change, RunningWorld* world);
// Tells what the weather is now.
void TellWeather(RunningWorld* world);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_SIMULATOR_WEATHERING_H_
