#ifndef LATTICEWORLD_SENSING_WEATHER_EFFECTS_H_
#define LATTICEWORLD_SENSING_WEATHER_EFFECTS_H_

namespace latticeworld {

struct Atmosphere;

// What the air of the moment does to sensors that look through it.
struct SensorConditions {
  double extinction_per_m = 0.0;     // of visible and near infrared light, > 0
  double dropout_probability = 0.0;  // of one lidar beam, [0, 1): its echo is lost near the sensor
  double range_noise_m = 0.0;        // standard deviation, to be added to the sensor's own
};

// Extinction by the meteorological optical range, over which 5 % of a beam is left: 2.996 / V
// (WMO-No. 8; Koschmieder 1924 with his threshold of 2 % has 3.912 / V). A beam drops out when a
// drop, flake or grain within the first metres takes more of its light than half; echoes that are
// mixed with theirs scatter over the length of the pulse (after Rasshofer, Spies and Spies 2011;
// the two lengths are estimates for automotive lidars).
SensorConditions ConditionsIn(const Atmosphere& atmosphere);

// How far away an eye makes out a body against the land [m]: where 5 % of its contrast is left.
double SightRange(const Atmosphere& atmosphere);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SENSING_WEATHER_EFFECTS_H_
