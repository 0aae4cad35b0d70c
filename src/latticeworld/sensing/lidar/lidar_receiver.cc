#include "latticeworld/sensing/lidar/lidar_receiver.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "latticeworld/scene/weather/atmosphere.h"
#include "latticeworld/sensing/counter_noise.h"
#include "latticeworld/sensing/weather_effects.h"

namespace latticeworld {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

// The receiver sees the whole beam from this distance on. It is an estimate: with it fog of 40 m of
// visibility hides what is further than 20 to 25 m, as Bijelic, Gruber and Ritter (2018) measured.
constexpr float kCrossover_m = 5.0f;
// A pulse of 5 ns, there and back.
constexpr float kPulse_m = 0.75f;
constexpr double kFogBackscatter = 0.046;
// Single particles hide a beam within this length, as weather_effects.cc has it.
constexpr float kBlindingLength_m = 10.0f;
// Backscatter of single particles as diffuse reflectance; drops send most of the light on.
constexpr float kRainReflectance = 0.02f;
constexpr float kSnowReflectance = 0.80f;
constexpr float kSandReflectance = 0.40f;
// A white target straight ahead at a tenth of the range has the full intensity.
constexpr float kFullScaleShare = 0.1f;

float ParticleReflectance(Weather weather) {
  switch (weather) {
    case Weather::kRain:
      return kRainReflectance;
    case Weather::kSnow:
      return kSnowReflectance;
    case Weather::kSandstorm:
      return kSandReflectance;
    default:
      return 0.0f;
  }
}

// Overlap of beam and view over the distance squared.
float Gain(float distance_m) {
  const float far_m = std::max(distance_m, kCrossover_m);
  return 1.0f / (far_m * far_m);
}

}  // namespace

LidarReceiver::LidarReceiver(const LidarModel& model, const Atmosphere& atmosphere)
    : min_range_m_(static_cast<float>(model.min_range_m)),
      max_range_m_(static_cast<float>(model.max_range_m)),
      range_step_m_(static_cast<float>(model.range_step_m)),
      dropout_probability_(static_cast<float>(model.dropout_probability)) {
  const SensorConditions conditions = ConditionsIn(atmosphere);
  noise_m_ = static_cast<float>(std::hypot(model.noise_m, conditions.range_noise_m));
  extinction_per_m_ = static_cast<float>(conditions.extinction_per_m);
  lost_probability_ = static_cast<float>(conditions.dropout_probability);
  const double range2 = model.max_range_m * model.max_range_m;
  threshold_ = static_cast<float>(model.max_range_reflectivity / range2);
  full_scale_ = static_cast<float>(1.0 / (kFullScaleShare * kFullScaleShare * range2));
  if (atmosphere.weather == Weather::kFog) {
    fog_backscatter_ =
        static_cast<float>(M_PI * kFogBackscatter / atmosphere.visibility_m * kPulse_m);
  }
  particle_reflectance_ = ParticleReflectance(atmosphere.weather);
}

LidarEcho LidarReceiver::EchoAt(float distance_m, float strength, std::uint64_t noise_bits) const {
  float range_m = distance_m + noise_m_ * NormalOf(noise_bits);
  if (range_step_m_ > 0.0f) range_m = range_step_m_ * std::round(range_m / range_step_m_);
  LidarEcho echo;
  echo.range_m = std::clamp(range_m, min_range_m_, max_range_m_);
  echo.intensity = 255.0f * std::sqrt(std::min(1.0f, strength / full_scale_));
  return echo;
}

float LidarReceiver::StrengthAt(float distance_m, float returned) const {
  return returned * std::exp(-2.0f * extinction_per_m_ * distance_m) /
         std::max(distance_m * distance_m, 1e-6f);
}

float LidarReceiver::Reach(float most_returned) const {
  // The air's own echoes are nearer than what they hide.
  float low_m = std::max({min_range_m_, kCrossover_m, kBlindingLength_m}), high_m = max_range_m_;
  if (low_m >= high_m || StrengthAt(high_m, most_returned) >= threshold_) return high_m;
  // Air weakens light, so that without it one sees as far at least.
  high_m = std::min(high_m, 1.001f * std::sqrt(most_returned / threshold_));
  constexpr int kHalvings = 6;
  for (int i = 0; i < kHalvings && low_m < high_m; ++i) {
    const float middle_m = 0.5f * (low_m + high_m);
    (StrengthAt(middle_m, most_returned) >= threshold_ ? low_m : high_m) = middle_m;
  }
  return std::max(low_m, high_m);
}

LidarReceiver::AirEcho LidarReceiver::FogEcho(std::uint64_t bits) const {
  const float span_m = kCrossover_m - min_range_m_;
  if (span_m <= 0.0f) return {};
  // Draws the echo's distance from the near part, less often the farther, as light weakens on its
  // way.
  const float twice = 2.0f * extinction_per_m_;
  const float reach = -std::expm1(-twice * span_m);
  const float distance_m = min_range_m_ - std::log1p(-reach * UnitOf(bits)) / twice;
  const float unevenness = -std::log1p(-UnitOf(bits >> 32));
  return {distance_m,
          fog_backscatter_ * unevenness * std::exp(-twice * distance_m) * Gain(distance_m)};
}

LidarReceiver::AirEcho LidarReceiver::ParticleEcho(std::uint64_t bits) const {
  const float distance_m = kBlindingLength_m * UnitOf(bits);
  if (distance_m < min_range_m_) return {};
  // The particle meets more than half of the beam.
  const float share = 0.5f + 0.5f * UnitOf(bits >> 32);
  return {distance_m, particle_reflectance_ * share * Gain(distance_m)};
}

LidarEcho LidarReceiver::Receive(float distance_m, float returned, std::uint64_t key,
                                 std::uint64_t beam) const {
  const std::uint64_t bits = CounterBits(key, 2 * beam);
  const std::uint64_t noise_bits = bits >> 24;
  if (UnitOf(bits) < dropout_probability_) return {kNaN, 0.0f};

  const bool met = distance_m <= max_range_m_;
  const bool lost = [&] {
    if (lost_probability_ <= 0.0f) return false;
    return UnitOf(CounterBits(key, 2 * beam + 1) >> 40) < lost_probability_;
  }();
  AirEcho air;
  if (fog_backscatter_ > 0.0f) {
    air = FogEcho(CounterBits(~key, beam));
  } else if (lost && particle_reflectance_ > 0.0f) {
    air = ParticleEcho(CounterBits(~key, beam));
  }
  const float hard = met && !lost ? StrengthAt(distance_m, returned) : 0.0f;
  if (met && distance_m < min_range_m_) return {-kInfinity, 0.0f};
  // What stands nearer than the echo of the air hides it.
  if (air.strength >= threshold_ && air.strength > hard && air.distance_m < distance_m) {
    return EchoAt(air.distance_m, air.strength, noise_bits);
  }
  if (hard >= threshold_) return EchoAt(distance_m, hard, noise_bits);
  return {lost ? kNaN : kInfinity, 0.0f};
}

}  // namespace latticeworld
