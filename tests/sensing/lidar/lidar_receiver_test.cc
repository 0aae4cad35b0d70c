#include "latticeworld/sensing/lidar/lidar_receiver.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "latticeworld/scene/weather/atmosphere.h"
#include "latticeworld/sensing/weather_effects.h"

namespace latticeworld {
namespace {

LidarModel Model() {
  LidarModel model;
  model.ring_elevations_rad = {0.0};
  model.min_range_m = 0.5;
  model.max_range_m = 100.0;
  model.max_range_reflectivity = 0.1;
  model.noise_m = 0.0;
  return model;
}

Atmosphere Air(Weather weather, double visibility_m) {
  Atmosphere atmosphere;
  atmosphere.weather = weather;
  atmosphere.visibility_m = visibility_m;
  return atmosphere;
}

struct Tally {
  int echoes = 0, near = 0, nothing = 0, dropped = 0;  // near: not from the target
  double mean_m = 0.0, deviation_m = 0.0;              // of echoes from the target
};

Tally Shoot(const LidarReceiver& receiver, double distance_m, double returned, int beams = 20000) {
  Tally tally;
  double squares = 0.0;
  for (int i = 0; i < beams; ++i) {
    const LidarEcho echo =
        receiver.Receive(static_cast<float>(distance_m), static_cast<float>(returned), 77, i);
    if (std::isnan(echo.range_m)) {
      ++tally.dropped;
    } else if (std::isinf(echo.range_m)) {
      ++tally.nothing;
    } else if (std::abs(echo.range_m - distance_m) > 2.0) {
      ++tally.near;
      EXPECT_GE(echo.range_m, 0.5f);
      EXPECT_LE(echo.range_m, 10.5f);
    } else {
      ++tally.echoes;
      tally.mean_m += echo.range_m;
      squares += std::pow(echo.range_m - distance_m, 2);
    }
  }
  if (tally.echoes > 0) {
    tally.mean_m /= tally.echoes;
    tally.deviation_m = std::sqrt(squares / tally.echoes);
  }
  return tally;
}

// The furthest that a surface is told from, without chance.
double Reach(const LidarReceiver& receiver, double returned) {
  double low = 1.0, high = 1000.0;
  for (int i = 0; i < 50; ++i) {
    const double middle = 0.5 * (low + high);
    (Shoot(receiver, middle, returned, 1).echoes == 1 ? low : high) = middle;
  }
  return low;
}

TEST(LidarReceiverTest, DarkerSurfacesAreLostBeforeAndBrighterOnesAtTheRangesEnd) {
  const LidarReceiver receiver(Model(), Air(Weather::kSunny, 1e9));
  EXPECT_NEAR(Reach(receiver, 0.1001), 100.0, 0.01);
  EXPECT_NEAR(Reach(receiver, 0.025), 50.0, 0.01);
  EXPECT_NEAR(Reach(receiver, 0.9), 100.0, 0.01);
  EXPECT_EQ(Shoot(receiver, INFINITY, 0.0, 100).nothing, 100);
  EXPECT_EQ(receiver.Receive(0.4f, 0.5f, 1, 1).range_m, -INFINITY);
}

// Range at which a surface still sends as strong an echo through the air as from nominal_m in clear
// air: r exp(a r) = nominal, solved by halving. In [0, nominal_m].
double RangeThroughAir(double extinction_per_m, double nominal_m) {
  double near = 0.0, far = nominal_m;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (near + far);
    (middle * std::exp(extinction_per_m * middle) < nominal_m ? near : far) = middle;
  }
  return near;
}

TEST(LidarReceiverTest, ThickAirShortensTheRangeAtWhichTheEchoIsAsStrong) {
  // Cloudy air drops no beam, but has a visibility.
  LidarModel model = Model();
  for (const double visibility_m : {20000.0, 5000.0}) {
    const Atmosphere air = Air(Weather::kCloudy, visibility_m);
    const LidarReceiver receiver(model, air);
    for (const double returned : {0.02, 0.05, 0.1}) {
      const double nominal_m = 100.0 * std::sqrt(returned / 0.1);
      const double expected_m = RangeThroughAir(ConditionsIn(air).extinction_per_m, nominal_m);
      const Tally within = Shoot(receiver, 0.999 * expected_m, returned);
      const Tally beyond = Shoot(receiver, 1.001 * expected_m, returned);
      EXPECT_GT(within.echoes, 19000);
      EXPECT_EQ(beyond.echoes, 0);
    }
  }
}

TEST(LidarReceiverTest, DenseFogLeavesAFewTensOfMetres) {
  const double extinction_per_m = ConditionsIn(Air(Weather::kCloudy, 50.0)).extinction_per_m;
  EXPECT_GT(RangeThroughAir(extinction_per_m, 100.0), 15.0);
  EXPECT_LT(RangeThroughAir(extinction_per_m, 100.0), 40.0);
}

TEST(LidarReceiverTest, NoiseAndStepsAreTheModels) {
  LidarModel model = Model();
  model.noise_m = 0.03;
  const Tally tally = Shoot(LidarReceiver(model, Air(Weather::kSunny, 1e9)), 20.0, 0.3);
  EXPECT_EQ(tally.echoes, 20000);
  EXPECT_NEAR(tally.mean_m, 20.0, 0.001);
  EXPECT_NEAR(tally.deviation_m, 0.03, 0.001);
  model.noise_m = 0.0;
  model.range_step_m = 0.25;
  const LidarReceiver stepped(model, Air(Weather::kSunny, 1e9));
  EXPECT_EQ(stepped.Receive(20.1f, 0.3f, 1, 1).range_m, 20.0f);
  EXPECT_EQ(stepped.Receive(20.2f, 0.3f, 1, 1).range_m, 20.25f);
}

TEST(LidarReceiverTest, ClearAirDropsAsManyBeamsAsTheModelSays) {
  LidarModel model = Model();
  model.dropout_probability = 0.1;
  const Tally tally = Shoot(LidarReceiver(model, Air(Weather::kSunny, 1e9)), 20.0, 0.3);
  EXPECT_NEAR(tally.dropped, 2000, 200);
  EXPECT_EQ(tally.near, 0);
}

TEST(LidarReceiverTest, IntensityFallsWithDistanceAndWithReflectance) {
  const LidarReceiver receiver(Model(), Air(Weather::kSunny, 1e9));
  const auto intensity = [&](float distance_m, float returned) {
    return receiver.Receive(distance_m, returned, 1, 1).intensity;
  };
  EXPECT_NEAR(intensity(10.0f, 1.0f), 255.0f, 0.1f);
  EXPECT_NEAR(intensity(20.0f, 1.0f), 127.5f, 0.1f);
  EXPECT_NEAR(intensity(10.0f, 0.25f), 127.5f, 0.1f);
  EXPECT_LE(intensity(1.0f, 1.0f), 255.0f);
}

TEST(LidarReceiverTest, RainLosesBeamsAndSnowMakesFalseEchoesOfThem) {
  const Tally clear = Shoot(LidarReceiver(Model(), Air(Weather::kSunny, 40000.0)), 30.0, 0.3);
  EXPECT_EQ(clear.near + clear.dropped, 0);
  for (const Weather weather : {Weather::kRain, Weather::kSnow, Weather::kSandstorm}) {
    const Atmosphere air = Air(weather, 500.0);
    const Tally tally = Shoot(LidarReceiver(Model(), air), 30.0, 0.3);
    const double lost = ConditionsIn(air).dropout_probability * 20000;
    EXPECT_NEAR(tally.near + tally.dropped, lost, 5.0 * std::sqrt(lost)) << NameOf(weather);
    EXPECT_GT(tally.near, 0);
    EXPECT_GT(tally.dropped, 0);
    EXPECT_NEAR(tally.deviation_m, ConditionsIn(air).range_noise_m, 0.002);
  }
}

TEST(LidarReceiverTest, DenseFogHidesWhatIsFurtherThanAQuarterOfAHundredMetres) {
  const LidarReceiver receiver(Model(), Air(Weather::kFog, 40.0));
  const Tally near = Shoot(receiver, 4.0, 0.3), far = Shoot(receiver, 25.0, 0.3);
  EXPECT_GT(near.echoes, 8000);  // half of the beams are lost within the first metres
  EXPECT_LT(far.echoes, 2000);   // where the fog is thin
  EXPECT_GT(far.near, 10000);    // the fog itself
  // Thin fog shows itself in few beams.
  const Tally thin = Shoot(LidarReceiver(Model(), Air(Weather::kFog, 1000.0)), 25.0, 0.3);
  EXPECT_LT(thin.near, 2000);
  EXPECT_GT(thin.echoes, 18000);
}

TEST(LidarReceiverTest, FogInFrontOfNothingNeverEchoesFromBehindATarget) {
  const LidarReceiver receiver(Model(), Air(Weather::kFog, 40.0));
  for (int i = 0; i < 5000; ++i) {
    const LidarEcho echo = receiver.Receive(1.0f, 0.3f, 5, i);
    if (std::isfinite(echo.range_m)) {
      EXPECT_LE(echo.range_m, 3.0f);
    }
  }
}

bool AreSame(float a, float b) { return a == b || (std::isnan(a) && std::isnan(b)); }

TEST(LidarReceiverTest, FromItsReachOnNothingChangesWhatIsReceived) {
  LidarModel model = Model();
  model.noise_m = 0.02;
  model.dropout_probability = 0.01;
  for (const double reflectivity : {0.1, 0.9}) {
    model.max_range_reflectivity = reflectivity;
    for (const Atmosphere& air :
         {Air(Weather::kSunny, 1e9), Air(Weather::kCloudy, 300.0), Air(Weather::kRain, 500.0),
          Air(Weather::kSnow, 200.0), Air(Weather::kFog, 40.0), Air(Weather::kSandstorm, 60.0)}) {
      const LidarReceiver receiver(model, air);
      for (const float most : {0.02f, 0.3f, 0.8f, 1.67f}) {
        const float reach_m = receiver.Reach(most);
        EXPECT_LE(reach_m, 100.0f);
        for (const float further : {1.0001f, 1.1f, 3.0f}) {
          for (std::uint64_t beam = 0; beam < 500; ++beam) {
            const LidarEcho met = receiver.Receive(further * reach_m, most, 3, beam);
            const LidarEcho nothing = receiver.Receive(INFINITY, 0.0f, 3, beam);
            ASSERT_TRUE(AreSame(met.range_m, nothing.range_m))
                << NameOf(air.weather) << ", " << further * reach_m << " m";
            ASSERT_EQ(met.intensity, nothing.intensity);
          }
        }
      }
    }
  }
}

TEST(LidarReceiverTest, ItsReachIsHardlyMoreThanWhatIsToldFrom) {
  LidarModel model = Model();
  model.max_range_reflectivity = 0.9;
  for (const double visibility_m : {1e9, 300.0}) {
    const LidarReceiver receiver(model, Air(Weather::kCloudy, visibility_m));
    for (const double most : {0.3, 0.8})
      EXPECT_NEAR(receiver.Reach(static_cast<float>(most)), Reach(receiver, most), 1.0);
  }
}

}  // namespace
}  // namespace latticeworld
