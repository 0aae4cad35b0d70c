#include "latticeworld/sensing/motion/geodesy.h"

#include <gtest/gtest.h>

#include <cmath>

#include "latticeworld/common/random.h"
#include "latticeworld/sensing/motion/magnetometer.h"

namespace latticeworld {
namespace {

using Eigen::Vector3d;

TEST(GeodesyTest, KnownPlacesHaveTheirCoordinates) {
  const double b = 6356752.314245;  // semi-minor axis of WGS 84
  EXPECT_TRUE(EcefOf({0.0, 0.0, 0.0}).isApprox(Vector3d(6378137.0, 0.0, 0.0), 1e-12));
  EXPECT_TRUE(EcefOf({0.0, 90.0, 100.0}).isApprox(Vector3d(0.0, 6378237.0, 0.0), 1e-12));
  EXPECT_NEAR(EcefOf({90.0, 0.0, 0.0}).z(), b, 1e-5);
  EXPECT_NEAR(EcefOf({-90.0, 0.0, 5.0}).z(), -b - 5.0, 1e-5);
  // 45 degrees north: N = a / sqrt(1 - e^2 / 2).
  const double normal_m = 6378137.0 / std::sqrt(1.0 - 0.5 * 0.00669437999014);
  const Vector3d middle = EcefOf({45.0, 180.0, 0.0});
  EXPECT_NEAR(middle.x(), -normal_m * std::sqrt(0.5), 1e-4);
  EXPECT_NEAR(middle.z(), normal_m * (1.0 - 0.00669437999014) * std::sqrt(0.5), 1e-4);
}

TEST(GeodesyTest, EveryPlaceComesBack) {
  RandomStream random(3, "geodesy test");
  for (int i = 0; i < 5000; ++i) {
    const GeoPoint point = {random.Uniform(-90.0, 90.0), random.Uniform(-180.0, 180.0),
                            random.Uniform(-5000.0, 20000.0)};
    const GeoPoint back = GeoPointOf(EcefOf(point));
    EXPECT_NEAR(back.latitude_deg, point.latitude_deg, 1e-11);
    EXPECT_NEAR(back.longitude_deg, point.longitude_deg, 1e-11);
    EXPECT_NEAR(back.altitude_m, point.altitude_m, 1e-6);
  }
  for (const double latitude_deg : {-90.0, 0.0, 90.0}) {
    const GeoPoint back = GeoPointOf(EcefOf({latitude_deg, 0.0, 123.0}));
    EXPECT_NEAR(back.latitude_deg, latitude_deg, 1e-11);
    EXPECT_NEAR(back.altitude_m, 123.0, 1e-6);
  }
  EXPECT_TRUE(std::isfinite(GeoPointOf(Vector3d::Zero()).altitude_m));
  EXPECT_TRUE(std::isfinite(GeoPointOf(Vector3d(1.0, 2.0, 3.0)).latitude_deg));
}

TEST(GeodesyTest, TheMapIsTheTangentPlaneAtItsOrigin) {
  const GeoPoint origin = {48.0, 11.0, 500.0};
  const GeoPoint same = GeoPointAt(origin, Vector3d::Zero());
  EXPECT_NEAR(same.latitude_deg, 48.0, 1e-11);
  EXPECT_NEAR(same.altitude_m, 500.0, 1e-6);
  // Radii of curvature at 48 degrees: meridian M and prime vertical N.
  const double e2 = 0.00669437999014, w = 1.0 - e2 * std::pow(std::sin(48.0 * M_PI / 180.0), 2);
  const double meridian_m = 6378137.0 * (1.0 - e2) / std::pow(w, 1.5) + 500.0;
  const double vertical_m = 6378137.0 / std::sqrt(w) + 500.0;
  const GeoPoint north = GeoPointAt(origin, {0.0, 100.0, 0.0});
  EXPECT_NEAR(north.latitude_deg - 48.0, 100.0 / meridian_m * 180.0 / M_PI, 1e-9);
  EXPECT_NEAR(north.longitude_deg, 11.0, 1e-9);
  // The earth falls away from the plane by d^2 / 2 R.
  EXPECT_NEAR(north.altitude_m - 500.0, 100.0 * 100.0 / (2.0 * meridian_m), 1e-5);
  const GeoPoint east = GeoPointAt(origin, {100.0, 0.0, 7.0});
  EXPECT_NEAR(east.longitude_deg - 11.0,
              100.0 / (vertical_m * std::cos(48.0 * M_PI / 180.0)) * 180.0 / M_PI, 1e-8);
  EXPECT_NEAR(east.altitude_m, 507.0, 1e-2);
}

TEST(GeodesyTest, TheFieldIsADipoles) {
  // Along the dipole's axis it is twice as strong as around its equator, and upright.
  const Vector3d axis = Vector3d(-1450.9, 4652.5, -29404.8).normalized();
  const GeoPoint pole = GeoPointOf(-6371200.0 * axis);
  EXPECT_NEAR(pole.latitude_deg, 80.7, 0.3);  // geomagnetic pole of 2020: 80.65 N, 72.7 W
  EXPECT_NEAR(pole.longitude_deg, -72.7, 0.2);
  const Vector3d at_pole_t = MagneticField(pole);
  EXPECT_LT(at_pole_t.z(), 0.0);
  EXPECT_NEAR(at_pole_t.norm(), 2.0 * 29805e-9, 6e-7);
  const Vector3d at_equator_t = MagneticField(GeoPointOf(6371200.0 * axis.unitOrthogonal()));
  EXPECT_NEAR(at_equator_t.norm(), 29805e-9, 6e-7);
  EXPECT_GT(at_equator_t.y(), 0.9 * at_equator_t.norm());
}

TEST(GeodesyTest, TheFieldOfMunichIsWithinTheModelsError) {
  // World Magnetic Model: 48.5 uT, 64 degrees down.
  const Vector3d field_t = MagneticField({48.1, 11.6, 500.0});
  EXPECT_NEAR(field_t.norm(), 48.5e-6, 5e-6);
  const double inclination = std::atan2(-field_t.z(), field_t.head<2>().norm());
  EXPECT_NEAR(inclination * 180.0 / M_PI, 64.0, 6.0);
}

TEST(MagnetometerTest, TurnsWithTheRobotAndKeepsItsBias) {
  const GeoOrigin origin = {48.0, 11.0, 0.0};
  const Eigen::Matrix3d west = Eigen::AngleAxisd(M_PI, Vector3d::UnitZ()).toRotationMatrix();
  const Magnetometer exact({}, origin, 1);
  const Vector3d east_t = exact.Read(Eigen::Matrix3d::Identity(), 0).field_t;
  EXPECT_TRUE(east_t.isApprox(MagneticField(origin), 1e-12));
  EXPECT_TRUE(exact.Read(west, 0).field_t.isApprox(Vector3d(-east_t.x(), -east_t.y(), east_t.z())));

  double bias = 0.0, white = 0.0;
  constexpr int kSensors = 300, kReadings = 100;
  for (int sensor = 0; sensor < kSensors; ++sensor) {
    const Magnetometer noisy({2e-7, 5e-7}, origin, sensor);
    Vector3d sum = Vector3d::Zero(), squares = Vector3d::Zero();
    for (int k = 0; k < kReadings; ++k) {
      const Vector3d error = noisy.Read(Eigen::Matrix3d::Identity(), k).field_t - east_t;
      sum += error;
      squares += error.cwiseAbs2();
    }
    bias += (sum / kReadings).squaredNorm() / 3.0;
    white += (squares / kReadings - (sum / kReadings).cwiseAbs2()).sum() / 3.0;
  }
  EXPECT_NEAR(std::sqrt(bias / kSensors), 5e-7, 5e-8);
  EXPECT_NEAR(std::sqrt(white / kSensors), 2e-7, 1e-8);
}

}  // namespace
}  // namespace latticeworld
