#include "latticeworld/scene/weather/sun.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/scene/weather/atmosphere.h"

namespace latticeworld {
namespace {

constexpr double kDegree = M_PI / 180.0;
constexpr double kHour_rad = 15.0 * kDegree;
constexpr double kTwilightElevation_rad = 3.0 * kDegree;  // of the sun at dawn and dusk

// Hours between noon and the moment at which the sun stands at the twilight's elevation.
double TwilightHours(double day_of_year, double latitude_deg) {
  const double declination_rad = SunDeclination(day_of_year);
  // At the poles every hour has the same elevation; just beside them the limits below decide.
  const double latitude_rad = std::clamp(latitude_deg, -89.9, 89.9) * kDegree;
  const double cosine =
      (std::sin(kTwilightElevation_rad) - std::sin(latitude_rad) * std::sin(declination_rad)) /
      (std::cos(latitude_rad) * std::cos(declination_rad));
  return std::acos(std::clamp(cosine, -1.0, 1.0)) / kHour_rad;
}

// Share of the overhead clear-sky sun that reaches the ground: air mass after Kasten and Young
// (1989), transmission 0.7^(AM^0.678) after Meinel and Meinel (1976), 1 for the sun at the zenith.
// The sun rises by its disc, so that light does not jump.
double ClearSkyIntensity(double elevation_rad) {
  constexpr double kSunDisc_rad = 0.53 * kDegree;
  if (elevation_rad <= 0.0) return 0.0;
  const double elevation_deg = elevation_rad / kDegree;
  const double air_mass =
      1.0 / (std::sin(elevation_rad) + 0.50572 * std::pow(elevation_deg + 6.07995, -1.6364));
  const double risen = std::min(1.0, elevation_rad / kSunDisc_rad);
  return risen * std::min(1.0, std::pow(0.7, std::pow(air_mass, 0.678)) / 0.7);
}

}  // namespace

double DayOfYear(Season season, double latitude_deg) {
  constexpr double kMarchEquinox = 80.0, kHalfYear = 182.5, kYear = 365.0;
  double day = kMarchEquinox;
  switch (season) {
    case Season::kSpring:
      break;
    case Season::kSummer:
      day = 172.0;
      break;
    case Season::kAutumn:
      day = 266.0;
      break;
    case Season::kWinter:
      day = 355.0;
      break;
  }
  if (latitude_deg < 0.0) day += kHalfYear;
  return day > kYear ? day - kYear : day;
}

double SunDeclination(double day_of_year) {
  const double a = 2.0 * M_PI * (day_of_year - 1.0) / 365.0;
  return 0.006918 - 0.399912 * std::cos(a) + 0.070257 * std::sin(a) - 0.006758 * std::cos(2.0 * a) +
         0.000907 * std::sin(2.0 * a) - 0.002697 * std::cos(3.0 * a) + 0.00148 * std::sin(3.0 * a);
}

Eigen::Vector3d SunDirection(double day_of_year, double hour, double latitude_deg) {
  // Equatorial to horizontal coordinates.
  const double declination_rad = SunDeclination(day_of_year);
  const double latitude_rad = latitude_deg * kDegree;
  const double angle_rad = (hour - 12.0) * kHour_rad;
  const double sin_d = std::sin(declination_rad), cos_d = std::cos(declination_rad);
  const double sin_l = std::sin(latitude_rad), cos_l = std::cos(latitude_rad);
  return Eigen::Vector3d(-cos_d * std::sin(angle_rad),
                         cos_l * sin_d - sin_l * cos_d * std::cos(angle_rad),
                         sin_l * sin_d + cos_l * cos_d * std::cos(angle_rad))
      .normalized();
}

double HourOf(TimeOfDay time, double day_of_year, double latitude_deg) {
  switch (time) {
    case TimeOfDay::kDawn:
      return 12.0 - TwilightHours(day_of_year, latitude_deg);
    case TimeOfDay::kMorning:
      return 9.0;
    case TimeOfDay::kNoon:
      return 12.0;
    case TimeOfDay::kAfternoon:
      return 15.0;
    case TimeOfDay::kDusk:
      return std::min(12.0 + TwilightHours(day_of_year, latitude_deg), 23.999);
    case TimeOfDay::kNight:
      return 0.0;
    case TimeOfDay::kDay:
      return 11.0;
  }
  return 12.0;
}

void SetSun(Atmosphere* atmosphere) {
  constexpr double kNightSky = 0.05, kDaySky = 0.3;
  atmosphere->sun_direction =
      SunDirection(atmosphere->day_of_year, atmosphere->hour, atmosphere->latitude_deg);
  const double up = std::clamp(atmosphere->sun_direction.z(), -1.0, 1.0);
  atmosphere->sun_intensity = atmosphere->direct_light * ClearSkyIntensity(std::asin(up));
  const double daylight = std::clamp(up / 0.5, 0.0, 1.0);  // full once the sun is 30 degrees high
  atmosphere->ambient_intensity =
      kNightSky + kDaySky * atmosphere->diffuse_light * std::sqrt(daylight);
}

}  // namespace latticeworld
