#ifndef LATTICEWORLD_RELIEF_HEIGHT_MAP_PGM_H_
#define LATTICEWORLD_RELIEF_HEIGHT_MAP_PGM_H_

#include <string_view>

#include "latticeworld/common/result.h"
#include "latticeworld/geometry/grid.h"

namespace latticeworld::internal {

struct PgmPicture {
  Grid<float> values;  // as in the file
  int max_value = 0;
};

// Decodes a portable greymap, binary (P5) or plain (P2), whose header ReadPgmHeader accepted.
// Errors: INVALID_ARGUMENT (values missing, not numbers, above maxval).
Result<PgmPicture> DecodePgm(std::string_view bytes);

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_RELIEF_HEIGHT_MAP_PGM_H_
