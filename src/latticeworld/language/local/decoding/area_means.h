#ifndef LATTICEWORLD_LANGUAGE_LOCAL_DECODING_AREA_MEANS_H_
#define LATTICEWORLD_LANGUAGE_LOCAL_DECODING_AREA_MEANS_H_

#include <cstddef>
#include <vector>

#include "latticeworld/geometry/grid.h"

namespace latticeworld {

// (side x side) means of a picture over cells of equal size; a sample that lies in two cells counts
// in each by its share. picture: not empty.
std::vector<float> AreaMeans(const Grid<float>& picture, std::size_t side);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_LOCAL_DECODING_AREA_MEANS_H_
