#ifndef LATTICEWORLD_EXPORTING_MAPS_MAP_REFERENCE_H_
#define LATTICEWORLD_EXPORTING_MAPS_MAP_REFERENCE_H_

#include <optional>
#include <string>

#include "latticeworld/common/result.h"
#include "latticeworld/geometry/geo_origin.h"

namespace latticeworld {

// What the frame map is, as well-known text (OGC 01-009): the azimuthal equidistant projection of
// WGS 84 around the world's origin, which differs from its tangent plane by less than 3 mm up to
// 5 km from it; without an origin, a local system of metres. Errors: INTERNAL (GDAL, in its words).
Result<std::string> MapWkt(const std::optional<GeoOrigin>& origin);

}  // namespace latticeworld

#endif  // LATTICEWORLD_EXPORTING_MAPS_MAP_REFERENCE_H_
