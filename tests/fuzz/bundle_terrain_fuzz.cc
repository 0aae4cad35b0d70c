// terrain.bin of a bundle: grids in a zlib stream. Where an input begins with '!', what follows
// the head is packed first, for hardly a random change of a zlib stream is one.

#include <zlib.h>

#include <vector>

#include "fuzz/fuzz_target.h"
#include "latticeworld/generation/bundle/terrain_file.h"

namespace {

using namespace latticeworld;

// The head of a world of 32 x 32 cells with one class, of suburb, and `grids` packed behind it; the
// grids' own length stands in the file as they are.
std::string Packed(std::string_view grids) {
  std::string file("LWTERR2\n\x20\0\0\0\x20\0\0\0\x01\0\0\0G", 21);
  std::vector<Bytef> packed(compressBound(grids.size()));
  uLongf length = packed.size();
  compress2(packed.data(), &length, reinterpret_cast<const Bytef*>(grids.data()), grids.size(), 1);
  for (int i = 0; i < 8; ++i) file += static_cast<char>(std::uint64_t{length} >> (8 * i));
  file.append(reinterpret_cast<const char*>(packed.data()), length);
  return file;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view input = fuzz::TextOf(data, size);
  static const GridGeometry geometry = *GridGeometry::Create(32.0, 1.0);
  const bool packs = !input.empty() && input.front() == '!';
  const auto terrain = DecodeTerrain(packs ? Packed(input.substr(1)) : std::string(input), geometry,
                                     Vocabulary::kSuburb);
  if (!terrain.ok()) return 0;
  const auto bytes = EncodeTerrain(*terrain);
  fuzz::Expect(bytes.ok() && DecodeTerrain(*bytes, geometry, Vocabulary::kSuburb).ok(),
               "a terrain that was read can be written and read");
  return 0;
}
