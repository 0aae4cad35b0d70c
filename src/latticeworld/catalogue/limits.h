#ifndef LATTICEWORLD_CATALOGUE_LIMITS_H_
#define LATTICEWORLD_CATALOGUE_LIMITS_H_

#include <cstddef>

namespace latticeworld {

inline constexpr std::size_t kMaxCatalogueFileBytes = 4 << 20;
inline constexpr std::size_t kMaxCatalogueFiles = 256;
inline constexpr std::size_t kMaxCatalogueBytes = 32 << 20;  // of all files that are added
// No further file is read once there are more violations than this.
inline constexpr std::size_t kMaxCatalogueViolations = 500;
inline constexpr std::size_t kMaxNameBytes = 255;  // of a file
// Models and the values of one type are told apart by a byte; 255 is left for "none".
inline constexpr std::size_t kMaxCatalogueEntries = 255;

}  // namespace latticeworld

#endif  // LATTICEWORLD_CATALOGUE_LIMITS_H_
