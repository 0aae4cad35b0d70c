// SRTM tiles (.hgt). The first line of an input is the file's name. What follows is repeated until
// it fills a tile of three arc seconds, which has no header and one size; where it begins with '!',
// it is the whole file.

#include <algorithm>
#include <string>

#include "fuzz/support/elevation_reading.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t kTileBytes = 1201 * 1201 * 2;
  const std::string_view input = latticeworld::fuzz::TextOf(data, size);
  const std::size_t line = std::min(input.find('\n'), input.size());
  const std::string_view samples = input.substr(std::min(line + 1, input.size()));
  // One for all inputs: new memory of its size would take longer than to read it.
  static std::string tile;
  tile.assign(samples);
  if (!samples.empty() && samples.front() != '!') {
    while (tile.size() < kTileBytes)
      tile.append(tile, 0, std::min(tile.size(), kTileBytes - tile.size()));
    tile.resize(kTileBytes);
  }
  latticeworld::fuzz::ReadAsElevation(tile, input.substr(0, line));
  return 0;
}
