#ifndef LATTICEWORLD_GEOMORPHOLOGY_REALISM_RELIEF_H_
#define LATTICEWORLD_GEOMORPHOLOGY_REALISM_RELIEF_H_

#include "latticeworld/geometry/grid.h"
#include "latticeworld/geomorphology/realism.h"

namespace latticeworld {

// The parts of MeasureRealism that need no network: slopes and hypsometry of the dry cells, of
// which there is at least one. dry: 1 where dry.
void MeasureSlopes(const Grid<float>& height_m, double resolution_m, const Grid<unsigned char>& dry,
                   RealismMeasures* measures);
void MeasureHypsometry(const Grid<float>& height_m, const Grid<unsigned char>& dry,
                       RealismMeasures* measures);

}  // namespace latticeworld

#endif  // LATTICEWORLD_GEOMORPHOLOGY_REALISM_RELIEF_H_
