#ifndef LATTICEWORLD_GENERATION_BUNDLE_TERRAIN_FILE_H_
#define LATTICEWORLD_GENERATION_BUNDLE_TERRAIN_FILE_H_

#include <string>
#include <string_view>

#include "latticeworld/common/result.h"
#include "latticeworld/terrain/terrain.h"

namespace latticeworld {

// terrain.bin: every grid of a terrain, bit for bit. All integers are little-endian.
//
//   8 bytes   "LWTERR2\n"
//   uint32    rows, uint32 columns, uint32 number of classes
//   char      letter of each class
//   then elevation [m] (float32), water level [m] (float32, NaN: dry), surface class (uint8) and
//   the weight of each class (uint8, in 255ths), each grid row by row from the north-west corner as
//   uint64
//   length of what follows bytes     a zlib stream; a float32 grid goes in as four planes of bytes,
//   the least significant
//             bytes of all cells first, which halves its length
//
// Errors: INTERNAL (zlib).
Result<std::string> EncodeTerrain(const Terrain& terrain);

// Errors: DATA_LOSS saying what is wrong: cut, another size than `geometry`, a class that the
// vocabulary has not, heights that are not finite, unknown surfaces.
Result<Terrain> DecodeTerrain(std::string_view content, const GridGeometry& geometry,
                              Vocabulary vocabulary);

}  // namespace latticeworld

#endif  // LATTICEWORLD_GENERATION_BUNDLE_TERRAIN_FILE_H_
