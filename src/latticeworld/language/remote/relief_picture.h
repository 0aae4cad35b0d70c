#ifndef LATTICEWORLD_LANGUAGE_REMOTE_RELIEF_PICTURE_H_
#define LATTICEWORLD_LANGUAGE_REMOTE_RELIEF_PICTURE_H_

#include <string>

#include "latticeworld/common/result.h"
#include "latticeworld/geometry/grid.h"

namespace latticeworld {

inline constexpr int kMaxReliefPictureSide = 512;  // [pixels], what models look at

// Returns the heights as an 8-bit grey PNG for a model that sees: black is the lowest, white the
// highest, the longer side has at most kMaxReliefPictureSide pixels (means of the samples), and row
// 0 is north. height_m: (rows x cols), finite. Errors: INTERNAL.
Result<std::string> ReliefPicture(const Grid<float>& height_m);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_REMOTE_RELIEF_PICTURE_H_
