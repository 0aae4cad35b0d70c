// Elevation as GeoTIFF.

#include "fuzz/support/elevation_reading.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  latticeworld::fuzz::ReadAsElevation(latticeworld::fuzz::TextOf(data, size), "land.tif");
  return 0;
}
