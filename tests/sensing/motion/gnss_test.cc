#include "latticeworld/sensing/motion/gnss.h"

#include <gtest/gtest.h>

#include <cmath>

#include "latticeworld/sensing/motion/geodesy.h"
#include "latticeworld/sensing/sensed_world.h"
#include "mapping/hand_made_scene.h"

namespace latticeworld {
namespace {

using Eigen::Vector3d;

const GeoOrigin kOrigin = {48.0, 11.0, 500.0};

// Where a fix lies on the map.
Vector3d MapOf(const GnssReading& fix) {
  const Vector3d ecef_m = EcefOf({fix.latitude_deg, fix.longitude_deg, fix.altitude_m});
  return EnuFromEcef(kOrigin) * (ecef_m - EcefOf(kOrigin));
}

TEST(GnssTest, WithoutNoiseAFixIsThePlace) {
  GnssReceiver receiver({}, kOrigin, 5.0, 1);
  for (const Vector3d& place : {Vector3d(0.0, 0.0, 0.0), Vector3d(400.0, -300.0, 80.0)}) {
    EXPECT_TRUE(MapOf(receiver.Read(place, true, 3)).isApprox(place, 1e-6) || place.isZero());
    EXPECT_LT((MapOf(receiver.Read(place, false, 4)) - place).norm(), 1e-6);
  }
}

TEST(GnssTest, ErrorsSpreadAsTheReadingSays) {
  GnssModel model;
  model.horizontal_noise_m = 0.4;
  model.vertical_noise_m = 0.8;
  model.horizontal_wander_m = 1.0;
  model.vertical_wander_m = 2.0;
  model.canopy_factor = 3.0;
  for (const bool under_trees : {false, true}) {
    Vector3d squares = Vector3d::Zero(), sum = Vector3d::Zero();
    GnssReading reading;
    constexpr int kReceivers = 2000;
    for (int i = 0; i < kReceivers; ++i) {
      GnssReceiver receiver(model, kOrigin, 5.0, i);
      reading = receiver.Read(Vector3d::Zero(), under_trees, 20);
      const Vector3d error = MapOf(reading);
      sum += error;
      squares += error.cwiseAbs2();
    }
    const double factor = under_trees ? 3.0 : 1.0;
    const Vector3d expected =
        factor * Vector3d(std::hypot(0.4, 1.0), std::hypot(0.4, 1.0), std::hypot(0.8, 2.0));
    EXPECT_TRUE(reading.stddev_m.isApprox(expected, 1e-12));
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(std::sqrt(squares[axis] / kReceivers), expected[axis], 0.08 * expected[axis]);
      EXPECT_NEAR(sum[axis] / kReceivers, 0.0, 0.12 * expected[axis]);
    }
  }
}

TEST(GnssTest, ErrorsWanderSlowly) {
  GnssModel model;
  model.horizontal_wander_m = 2.0;
  model.wander_time_s = 100.0;
  double soon = 0.0, late = 0.0;
  for (int i = 0; i < 300; ++i) {
    GnssReceiver receiver(model, kOrigin, 1.0, i);
    const double begin = MapOf(receiver.Read(Vector3d::Zero(), false, 0)).x();
    soon += std::pow(MapOf(receiver.Read(Vector3d::Zero(), false, 1)).x() - begin, 2);
    late += std::pow(MapOf(receiver.Read(Vector3d::Zero(), false, 500)).x() - begin, 2);
  }
  // 2 sigma^2 (1 - exp(-t / tau))
  EXPECT_NEAR(std::sqrt(soon / 300), 2.0 * std::sqrt(2.0 * 0.00995), 0.06);
  EXPECT_NEAR(std::sqrt(late / 300), 2.0 * std::sqrt(2.0), 0.3);
}

TEST(GnssTest, ATreeCoversWhatIsBelowItsCrownWhileItStands) {
  const Scene scene = WithAssets(
      MakeScene(64, 64.0, [](double, double) { return 1.0; }),
      {MakeTree(5.0, 0.0, 10.0, 3.0, 0.2), MakeRound(AssetKind::kStone, -5.0, 0.0, 2.0, 2.0)});
  SensedWorld world;
  EXPECT_TRUE(IsUnderTrees(scene, world, {5.5, 2.5, 1.5}));
  EXPECT_FALSE(IsUnderTrees(scene, world, {5.5, 3.5, 1.5}));
  EXPECT_FALSE(IsUnderTrees(scene, world, {5.5, 2.5, 11.5}));
  EXPECT_FALSE(IsUnderTrees(scene, world, {-5.0, 0.5, 1.5}));
  world.gone = {0};
  EXPECT_FALSE(IsUnderTrees(scene, world, {5.5, 2.5, 1.5}));
  world.gone.clear();
  world.felled.resize(1);
  EXPECT_FALSE(IsUnderTrees(scene, world, {5.5, 2.5, 1.5}));
}

}  // namespace
}  // namespace latticeworld
