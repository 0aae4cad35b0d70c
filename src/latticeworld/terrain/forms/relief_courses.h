#ifndef LATTICEWORLD_TERRAIN_FORMS_RELIEF_COURSES_H_
#define LATTICEWORLD_TERRAIN_FORMS_RELIEF_COURSES_H_

#include <vector>

#include "latticeworld/geometry/grid_geometry.h"
#include "latticeworld/layout/layout_mask.h"
#include "latticeworld/layout/relief_wish.h"
#include "latticeworld/terrain/forms/relief_places.h"
#include "latticeworld/terrain/forms/relief_room.h"

namespace latticeworld::internal {

// Lays the axis of a form that runs, as ridges, valleys and cliffs do: along the water that is said
// to run through it, along the cells that the layout shows of it, between the places that words
// name, or else through the place of the zone that has the most room. piece: with its half width.
// obstacles: what the course keeps off where it can. Marks in the room what the form covers.
void LayCourse(const ReliefWish& wish, const LayoutMask& zone, const LayoutMask& obstacles,
               ReliefRoom* room, ReliefPiece* piece);

// Ends of a straight line of that length [m] through a place: of eight headings the one that meets
// least of obstacles and forms in its way. What is sunk goes on to the world's edge, so that its
// water gets away.
std::vector<WorldPoint> LineThrough(const ReliefWish& wish, WorldPoint at, double length_m,
                                    const LayoutMask& obstacles, const ReliefRoom& room);

// Makes a line straight and cuts it or draws it out to a length [m] about its middle.
void CutTo(double length_m, std::vector<WorldPoint>* ends);

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_TERRAIN_FORMS_RELIEF_COURSES_H_
