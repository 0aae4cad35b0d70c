#ifndef LATTICEWORLD_SPECIES_VEHICLE_OUTLINE_H_
#define LATTICEWORLD_SPECIES_VEHICLE_OUTLINE_H_

#include "latticeworld/species/species.h"

namespace latticeworld {

// The middle of a differential vehicle's mass lies a quarter of the wheelbase behind its axle, so
// that it stands on the castor: x of the axle in base_link [m].
inline double DifferentialAxle(const VehicleDesign& design) { return 0.25 * design.wheelbase_m; }

// Radius [m] of the circle around base_link that holds chassis and wheels in plan, steered as they
// may be. The radius_m of a species is at least that.
double CircumscribedRadius(const VehicleDesign& design);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SPECIES_VEHICLE_OUTLINE_H_
