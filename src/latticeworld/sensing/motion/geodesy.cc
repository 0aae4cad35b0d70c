#include "latticeworld/sensing/motion/geodesy.h"

#include <algorithm>
#include <cmath>

namespace latticeworld {
namespace {

constexpr double kRadPerDeg = M_PI / 180.0;
constexpr double kSquaredEccentricity = kEarthFlattening * (2.0 - kEarthFlattening);

// Gauss coefficients of degree 1 of IGRF-13 for 2020 [T], and the radius that they are of.
constexpr double kG10_t = -29404.8e-9, kG11_t = -1450.9e-9, kH11_t = 4652.5e-9;
constexpr double kMagneticRadius_m = 6371200.0;

}  // namespace

Eigen::Vector3d EcefOf(const GeoPoint& point) {
  const double latitude = point.latitude_deg * kRadPerDeg;
  const double longitude = point.longitude_deg * kRadPerDeg;
  const double sine = std::sin(latitude), cosine = std::cos(latitude);
  const double normal_m =
      kEarthSemiMajorAxis_m / std::sqrt(1.0 - kSquaredEccentricity * sine * sine);
  const double across_m = (normal_m + point.altitude_m) * cosine;
  return {across_m * std::cos(longitude), across_m * std::sin(longitude),
          (normal_m * (1.0 - kSquaredEccentricity) + point.altitude_m) * sine};
}

GeoPoint GeoPointOf(const Eigen::Vector3d& ecef_m) {
  constexpr double a = kEarthSemiMajorAxis_m, e2 = kSquaredEccentricity;
  constexpr double b = a * (1.0 - kEarthFlattening);
  const double z2 = ecef_m.z() * ecef_m.z();
  const double r = std::hypot(ecef_m.x(), ecef_m.y()), r2 = r * r;
  // Heikkinen's names.
  const double f = 54.0 * b * b * z2;
  const double g = r2 + (1.0 - e2) * z2 - e2 * (a * a - b * b);
  const double c = e2 * e2 * f * r2 / (g * g * g);
  const double s = std::cbrt(1.0 + c + std::sqrt(std::max(0.0, c * c + 2.0 * c)));
  const double k = s + 1.0 + 1.0 / s;
  const double p = f / (3.0 * k * k * g * g);
  const double q = std::sqrt(std::max(0.0, 1.0 + 2.0 * e2 * e2 * p));
  const double r0 =
      -p * e2 * r / (1.0 + q) +
      std::sqrt(std::max(0.0, 0.5 * a * a * (1.0 + 1.0 / q) -
                                  p * (1.0 - e2) * z2 / (q * (1.0 + q)) - 0.5 * p * r2));
  const double along = r - e2 * r0;
  const double u = std::sqrt(along * along + z2);
  const double v = std::sqrt(along * along + (1.0 - e2) * z2);
  GeoPoint point;
  point.longitude_deg = std::atan2(ecef_m.y(), ecef_m.x()) / kRadPerDeg;
  if (!(g > 0.0) || !(v > 0.0) || !std::isfinite(u)) {
    point.altitude_m = ecef_m.norm() - a;
    return point;
  }
  const double z0 = b * b * ecef_m.z() / (a * v);
  point.altitude_m = u * (1.0 - b * b / (a * v));
  point.latitude_deg = std::atan2(ecef_m.z() + e2 / (1.0 - e2) * z0, r) / kRadPerDeg;
  return point;
}

Eigen::Matrix3d EnuFromEcef(const GeoPoint& origin) {
  const double latitude = origin.latitude_deg * kRadPerDeg;
  const double longitude = origin.longitude_deg * kRadPerDeg;
  const double sin_lat = std::sin(latitude), cos_lat = std::cos(latitude);
  const double sin_lon = std::sin(longitude), cos_lon = std::cos(longitude);
  Eigen::Matrix3d enu;
  enu << -sin_lon, cos_lon, 0.0,                        //
      -sin_lat * cos_lon, -sin_lat * sin_lon, cos_lat,  //
      cos_lat * cos_lon, cos_lat * sin_lon, sin_lat;
  return enu;
}

GeoPoint GeoPointAt(const GeoPoint& origin, const Eigen::Vector3d& map_m) {
  return GeoPointOf(EcefOf(origin) + EnuFromEcef(origin).transpose() * map_m);
}

Eigen::Vector3d MagneticField(const GeoPoint& point) {
  // -grad of a^3 / r^3 (g . r), with the dipole g along the axes of ECEF: (g11, h11, g10).
  const Eigen::Vector3d dipole_t(kG11_t, kH11_t, kG10_t);
  const Eigen::Vector3d place_m = EcefOf(point);
  const double radius_m = place_m.norm();
  const Eigen::Vector3d up = place_m / radius_m;
  const double share = std::pow(kMagneticRadius_m / radius_m, 3);
  return EnuFromEcef(point) * (share * (3.0 * dipole_t.dot(up) * up - dipole_t));
}

}  // namespace latticeworld
