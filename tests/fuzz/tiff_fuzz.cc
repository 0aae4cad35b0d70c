// TIFF pictures, as height maps and as sketches.

#include "fuzz/support/picture_reading.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  latticeworld::fuzz::ReadAsPictures(latticeworld::fuzz::TextOf(data, size));
  return 0;
}
