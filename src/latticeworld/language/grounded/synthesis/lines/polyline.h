#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_SYNTHESIS_LINES_POLYLINE_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_SYNTHESIS_LINES_POLYLINE_H_

#include <vector>

#include "latticeworld/language/grounded/synthesis/canvas.h"

namespace latticeworld {

// Chains of straight pieces between spots [cells]; none is empty.
Spot MiddleOf(const std::vector<Spot>& line);  // mean of all points on it
double DistanceTo(const std::vector<Spot>& line, Spot spot);
double DistanceBetweenLines(const std::vector<Spot>& a,
                            const std::vector<Spot>& b);  // 0: they meet
// Returns how far the two lines are from crossing properly [cells]: 0 if they do, less than 5 if
// they cross too close to an end, else 5 and the distance between them.
double CrossingMiss(const std::vector<Spot>& a, const std::vector<Spot>& b);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_SYNTHESIS_LINES_POLYLINE_H_
