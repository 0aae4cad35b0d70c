#include "latticeworld/simulation/simulator/running_weather.h"

#include <cmath>

#include "latticeworld/common/digest.h"
#include "latticeworld/scene/scene.h"
#include "latticeworld/scene/weather/sun.h"

namespace latticeworld {
namespace {

// Whole steps never add up to exactly the time that was asked for.
constexpr double kTimeTolerance_s = 1e-9;

void AddVector(const Eigen::Vector3d& vector, Digest* digest) {
  for (int i = 0; i < 3; ++i) digest->Add(vector[i]);
}

void AddAtmosphere(const Atmosphere& atmosphere, Digest* digest) {
  digest->Add(atmosphere.weather);
  for (const double value :
       {atmosphere.intensity, atmosphere.visibility_m, atmosphere.rain_mmph,
        atmosphere.snowfall_mmph, atmosphere.cloud_cover, atmosphere.gust_mps, atmosphere.hour,
        atmosphere.day_of_year, atmosphere.latitude_deg, atmosphere.direct_light,
        atmosphere.diffuse_light, atmosphere.sun_intensity, atmosphere.ambient_intensity,
        atmosphere.ground_wetness, atmosphere.snow_depth_m, atmosphere.blown_sand,
        atmosphere.water_rise_m}) {
    digest->Add(value);
  }
  AddVector(atmosphere.wind_mps, digest);
  AddVector(atmosphere.sun_direction, digest);
}

}  // namespace

RunningWeather::RunningWeather(const Scene* scene, double day_length_s, std::uint64_t seed)
    : scene_(scene),
      day_length_s_(day_length_s),
      gusts_(seed),
      now_(scene->atmosphere),
      from_(now_),
      to_(now_),
      heading_rad_(WindHeading(now_, 0.0)),
      surfaces_(*scene, now_.ground()) {}

void RunningWeather::Change(const WeatherChange& change) {
  const auto with_change = [this, &change](const Atmosphere& atmosphere) {
    return TargetOf(atmosphere, change, scene_->environment.coarse,
                    scene_->environment.fine_of(AssetType::kDesert).wind_mps, heading_rad_);
  };
  // What moves already goes on to where it was going, as far as the change leaves it alone.
  const bool at_once = change.transition_s == 0.0;
  transition_s_ = at_once ? remaining_s() : change.transition_s;
  elapsed_s_ = 0.0;
  from_ = at_once ? with_change(now_) : now_;
  to_ = with_change(to_);
  heading_rad_ = change.wind_heading_rad.value_or(WindHeading(to_, heading_rad_));
  if (at_once && AreAlike(from_, to_)) {
    transition_s_ = 0.0;
    from_ = to_;
  }
  now_ = from_;
  surfaces_ = SurfaceTable(*scene_, now_.ground());
}

RunningWeather::Outcome RunningWeather::Step(double step_s) {
  drift_m_ += step_s * now_.wind_mps.head<2>();
  Outcome outcome;
  outcome.moved = moving();
  if (outcome.moved) elapsed_s_ += step_s;
  if (day_length_s_ > 0.0) {
    const double hours = 24.0 * step_s / day_length_s_;
    from_.hour = std::fmod(from_.hour + hours, 24.0);
    to_.hour = std::fmod(to_.hour + hours, 24.0);
    SetSun(&from_);
    SetSun(&to_);
  }
  outcome.complete = outcome.moved && elapsed_s_ >= transition_s_ - kTimeTolerance_s;
  if (outcome.complete) {
    from_ = to_;
    transition_s_ = elapsed_s_ = 0.0;
  }
  if (outcome.moved || day_length_s_ > 0.0) {
    now_ = moving() ? Between(from_, to_, elapsed_s_ / transition_s_) : to_;
  }
  if (outcome.moved) surfaces_ = SurfaceTable(*scene_, now_.ground());
  return outcome;
}

bool RunningWeather::HasChanged() const {
  Atmosphere own = scene_->atmosphere;
  if (day_length_s_ > 0.0) own.hour = now_.hour;
  return moving() || !AreAlike(now_, own);
}

void RunningWeather::AddTo(Digest* digest) const {
  AddAtmosphere(now_, digest);
  AddAtmosphere(from_, digest);
  AddAtmosphere(to_, digest);
  digest->Add(heading_rad_);
  digest->Add(transition_s_);
  digest->Add(elapsed_s_);
  digest->Add(drift_m_.x());
  digest->Add(drift_m_.y());
  digest->Add(day_length_s_);
}

}  // namespace latticeworld
