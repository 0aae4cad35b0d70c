#ifndef LATTICEWORLD_LANGUAGE_REMOTE_RELIEF_PICTURE_H_
#define LATTICEWORLD_LANGUAGE_REMOTE_RELIEF_PICTURE_H_

#include <string>

#include "latticeworld/common/result.h"
#include "latticeworld/geometry/grid.h"

namespace latticeworld {

inline constexpr int kMaxReliefPictureSide = 512;  // [pixels], what models look at

// The heights as an 8-bit grey PNG for a model that sees: black the lowest, white the highest, the
// longer side at most kMaxReliefPictureSide pixels (means of the samples), row 0 north.
// height_m: (rows x cols), finite. Errors: INTERNAL.
Result<std::string> ReliefPicture(const Grid<float>& height_m);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_REMOTE_RELIEF_PICTURE_H_
