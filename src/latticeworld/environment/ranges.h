#ifndef LATTICEWORLD_ENVIRONMENT_RANGES_H_
#define LATTICEWORLD_ENVIRONMENT_RANGES_H_

#include "latticeworld/common/range.h"

namespace latticeworld {

// The continuous parameters, for validation and schema alike.
inline constexpr Range kDensityRange{0.0, 1.0};
inline constexpr Range kRotationRange{0.0, 360.0, false, true};  // [degrees]
inline constexpr Range kScaleRange{0.25, 4.0};
inline constexpr Range kHeightRange{-5.0, 5.0};  // [m]
inline constexpr Range kWindRange{0.0, 40.0};    // [m/s]
inline constexpr Range kSlopeRange{0.0, 90.0};   // [degrees]

}  // namespace latticeworld

#endif  // LATTICEWORLD_ENVIRONMENT_RANGES_H_
