#ifndef LATTICEWORLD_EXPORTING_MAPS_HEIGHT_ARRAYS_H_
#define LATTICEWORLD_EXPORTING_MAPS_HEIGHT_ARRAYS_H_

#include <optional>
#include <string>
#include <vector>

#include "latticeworld/common/progress.h"
#include "latticeworld/common/result.h"
#include "latticeworld/exporting/export_files.h"
#include "latticeworld/exporting/export_region.h"
#include "latticeworld/geometry/geo_origin.h"

namespace latticeworld {

struct Scene;

struct HeightArraysOptions {
  std::optional<ExportRegion> region;  // absent: the whole world; values are of the cells whose
                                       // centres it holds
};

// The ground of a world as arrays of NumPy (format 1.0, in C's order, lowest byte first), (rows x
// cols), row 0 north, column 0 west, a value a cell at its centre:
//
//   heights.npy   float32, z of the frame map [m]; below water the bed
//   water.npy     float32, the water's surface [m], NaN: dry; only where there is some
//   classes.npy   uint8, SurfaceClass: what the ground is made of
//   letters.npy   uint8, ASCII of the layout's letter that weighs most
//   heights.json  how they lie: frame, unit, shape, resolution, places of the outermost centres,
//                 lowest and highest height, how quads are split; names of classes, with friction
//                 against rubber in the weather that the world begins in, and of letters; where the
//                 frame map lies on the earth, or null
//
// Reports the stage "heights". Errors: INVALID_ARGUMENT (region), CANCELLED.
Result<std::vector<ExportFile>> HeightFiles(const Scene& scene, const std::string& name,
                                            const std::optional<GeoOrigin>& origin,
                                            const HeightArraysOptions& options,
                                            const Progress& progress);

}  // namespace latticeworld

#endif  // LATTICEWORLD_EXPORTING_MAPS_HEIGHT_ARRAYS_H_
