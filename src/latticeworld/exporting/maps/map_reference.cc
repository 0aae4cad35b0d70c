#include "latticeworld/exporting/maps/map_reference.h"

#include <cpl_conv.h>
#include <ogr_srs_api.h>

#include <cstdio>
#include <memory>

#include "latticeworld/relief/elevation/gdal_errors.h"

namespace latticeworld {

Result<std::string> MapWkt(const std::optional<GeoOrigin>& origin) {
  if (!origin) return std::string("LOCAL_CS[\"LatticeWorld map\",UNIT[\"metre\",1]]");
  internal::PrepareGdal();
  const internal::GdalErrors errors;
  char projection[160];
  std::snprintf(projection, sizeof projection,
                "+proj=aeqd +lat_0=%.12f +lon_0=%.12f +datum=WGS84 +units=m +no_defs",
                origin->latitude_deg, origin->longitude_deg);
  const std::unique_ptr<void, decltype(&OSRDestroySpatialReference)> reference(
      OSRNewSpatialReference(nullptr), &OSRDestroySpatialReference);
  char* text = nullptr;
  if (reference == nullptr || OSRImportFromProj4(reference.get(), projection) != OGRERR_NONE ||
      OSRExportToWkt(reference.get(), &text) != OGRERR_NONE || text == nullptr) {
    CPLFree(text);
    return Internal("cannot describe the projection" + errors.Last(""));
  }
  std::string wkt(text);
  CPLFree(text);
  return wkt;
}

}  // namespace latticeworld
