#ifndef LATTICEWORLD_GEOMETRY_GEO_ORIGIN_H_
#define LATTICEWORLD_GEOMETRY_GEO_ORIGIN_H_

namespace latticeworld {

// Says where the origin of the frame map lies on the earth, WGS 84: x points east, y north there.
struct GeoOrigin {
  double latitude_deg = 0.0;
  double longitude_deg = 0.0;
  double altitude_m = 0.0;  // of z = 0, above the datum of the elevation data
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_GEOMETRY_GEO_ORIGIN_H_
