#ifndef LATTICEWORLD_EXPORTING_MAPS_GEOTIFF_H_
#define LATTICEWORLD_EXPORTING_MAPS_GEOTIFF_H_

#include <optional>
#include <vector>

#include "latticeworld/common/progress.h"
#include "latticeworld/common/result.h"
#include "latticeworld/exporting/export_files.h"
#include "latticeworld/exporting/export_region.h"
#include "latticeworld/geometry/geo_origin.h"

namespace latticeworld {

struct Scene;

struct GeoTiffOptions {
  std::optional<ExportRegion> region;  // absent: the whole world; pixels are the cells whose
                                       // centres it holds
};

// The layers of a world as GeoTIFFs (OGC 19-008), a pixel a cell, in the projection of MapWkt,
// north up, deflated: "elevation.tif" (float32, z of the frame map [m]; metadata ZERO_ALTITUDE_M
// tells the altitude of z = 0 where the world lies on the earth), "water.tif" (float32, the water's
// surface [m], NaN: dry), "classes.tif" (uint8, SurfaceClass; its names in the metadata
// CLASS_<number>; names and colours, as GDAL and QGIS look for them, in "classes.tif.aux.xml"),
// "traversability.tif" (float32, BuildTraversability of usual RobotLimits).
// Reports the stage "geotiff". Errors: INVALID_ARGUMENT (region), CANCELLED, INTERNAL (GDAL, in its
// words).
Result<std::vector<ExportFile>> GeoTiffFiles(const Scene& scene,
                                             const std::optional<GeoOrigin>& origin,
                                             const GeoTiffOptions& options,
                                             const Progress& progress);

}  // namespace latticeworld

#endif  // LATTICEWORLD_EXPORTING_MAPS_GEOTIFF_H_
