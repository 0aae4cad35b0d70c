#ifndef LATTICEWORLD_SENSING_MOTION_GEODESY_H_
#define LATTICEWORLD_SENSING_MOTION_GEODESY_H_

#include <Eigen/Core>

#include "latticeworld/geometry/geo_origin.h"

namespace latticeworld {

// WGS 84 (NIMA TR8350.2, 2000).
inline constexpr double kEarthSemiMajorAxis_m = 6378137.0;
inline constexpr double kEarthFlattening = 1.0 / 298.257223563;

// A place on the earth; the altitude is above the ellipsoid.
using GeoPoint = GeoOrigin;

// Earth-centred, earth-fixed: x towards the meridian of Greenwich, z towards the north pole [m].
Eigen::Vector3d EcefOf(const GeoPoint& point);
// Converts by Heikkinen's closed form (1982, as in Zhu 1994): within micrometres for altitudes from
// -5000 km up. Within 43 km of the earth's centre, where the form has no answer, the latitude is 0
// and the altitude that above a sphere of the equator's radius. At the poles the longitude is that
// of the signs of zero, 0 or 180.
GeoPoint GeoPointOf(const Eigen::Vector3d& ecef_m);

// The tangent plane at an origin: rows are east, north and up in ECEF.
Eigen::Matrix3d EnuFromEcef(const GeoPoint& origin);
// Returns where a point of the frame map lies; map's origin lies at `origin`, its x points east,
// its y north.
GeoPoint GeoPointAt(const GeoPoint& origin, const Eigen::Vector3d& map_m);

// The field of the earth, east, north and up [T]: the dipole of IGRF-13 for 2020 (Alken et al.
// 2021), which has nine tenths of the field. Strengths are off by 10 % on average and by up to 30 %
// (South Atlantic), directions by 6 degrees on average, up to 25.
Eigen::Vector3d MagneticField(const GeoPoint& point);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SENSING_MOTION_GEODESY_H_
