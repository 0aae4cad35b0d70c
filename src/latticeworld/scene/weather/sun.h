#ifndef LATTICEWORLD_SCENE_WEATHER_SUN_H_
#define LATTICEWORLD_SCENE_WEATHER_SUN_H_

#include <Eigen/Core>

#include "latticeworld/environment/attributes.h"

namespace latticeworld {

struct Atmosphere;

// Day in the middle of the season [1, 366): the solstice or equinox of that half of the earth.
double DayOfYear(Season season, double latitude_deg);
// Declination of the sun [rad] by the Fourier series of Spencer (1971), good to 0.0006 rad.
double SunDeclination(double day_of_year);
// Returns the unit vector towards the sun, east-north-up. hour: by the sun.
Eigen::Vector3d SunDirection(double day_of_year, double hour, double latitude_deg);
// Hour of a time of day, [0, 24): dawn and dusk are when the sun stands 3 degrees over the horizon;
// where it never does, the hour at which it comes nearest to that.
double HourOf(TimeOfDay time, double day_of_year, double latitude_deg);

// Sets sun_direction, sun_intensity and ambient_intensity by the atmosphere's other fields.
void SetSun(Atmosphere* atmosphere);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SCENE_WEATHER_SUN_H_
