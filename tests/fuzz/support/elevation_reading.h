#ifndef LATTICEWORLD_TESTS_FUZZ_SUPPORT_ELEVATION_READING_H_
#define LATTICEWORLD_TESTS_FUZZ_SUPPORT_ELEVATION_READING_H_

#include <algorithm>
#include <cmath>
#include <string_view>

#include "fuzz/fuzz_target.h"
#include "latticeworld/relief/elevation/elevation.h"

namespace latticeworld::fuzz {

// Reads bytes as elevation data, for a small world in their middle. name: of the file.
inline void ReadAsElevation(std::string_view bytes, std::string_view name) {
  ElevationOptions options;
  options.size_m = 64.0;
  options.resolution_m = 1.0;
  const auto relief = ReadElevation(bytes, name, options);
  if (!relief.ok()) return;
  Expect(std::all_of(relief->height_m.begin(), relief->height_m.end(),
                     [](float height_m) { return std::isfinite(height_m); }),
         "heights of elevation data are finite");
}

}  // namespace latticeworld::fuzz

#endif  // LATTICEWORLD_TESTS_FUZZ_SUPPORT_ELEVATION_READING_H_
