#ifndef LATTICEWORLD_RENDERING_LOOKS_VILLAGE_GROUND_H_
#define LATTICEWORLD_RENDERING_LOOKS_VILLAGE_GROUND_H_

#include <opencv2/core/mat.hpp>

#include "latticeworld/rendering/ray/picture_light.h"

namespace latticeworld {

struct Scene;

// Deserts, and land that is mostly barren whatever its environment is called: no gardens grow.
bool IsDryLand(const Scene& scene);

// Village ground between houses: lawns and beds, patch by patch. Hedges are assets. waviness:
// smooth noise that bends the patches' borders.
Color GardenColor(const Color& grass, double x_m, double y_m, float waviness);

// How much each cell is the trodden yard around a building or the way from its door to the street
// (CV_32FC1, [0, 1]).
cv::Mat YardsAroundHouses(const Scene& scene);

// How much each cell of road is its rim (CV_32FC1, [0, 1]), where roads are wide enough for one.
cv::Mat RoadRims(const Scene& scene);

}  // namespace latticeworld

#endif  // LATTICEWORLD_RENDERING_LOOKS_VILLAGE_GROUND_H_
