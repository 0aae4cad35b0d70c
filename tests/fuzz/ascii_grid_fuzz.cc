// Elevation as Arc/Info ASCII grids.

#include "fuzz/support/elevation_reading.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  latticeworld::fuzz::ReadAsElevation(latticeworld::fuzz::TextOf(data, size), "land.asc");
  return 0;
}
