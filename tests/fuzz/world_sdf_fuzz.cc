// SDF files of worlds that strangers wrote, read back by libsdformat. It takes far longer to read a
// world than we take to write it, so that it reads each shape of a file once: the file without the
// numbers between its tags, all of which are finite. Names stand in tags, and are part of the
// shape.

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <sdf/sdf.hh>
#include <string>
#include <string_view>
#include <unordered_set>

#include "fuzz/fuzz_target.h"
#include "fuzz/support/stranger_scene.h"
#include "latticeworld/exporting/simulators/sdf_world.h"

namespace {

bool IsFiniteNumber(std::string_view word) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() && end == word.data() + word.size() && std::isfinite(value);
}

// The file with '#' for each word between its tags that is a finite number.
std::string ShapeOf(std::string_view xml) {
  std::string shape;
  while (!xml.empty()) {
    const bool is_tag = xml.front() == '<';
    const std::size_t end =
        is_tag ? xml.find('>') : std::min(xml.find_first_of(" \n<", 1), xml.size());
    const std::string_view piece = xml.substr(0, is_tag ? end + 1 : end);
    const std::size_t begin = std::min(piece.find_first_not_of(" \n"), piece.size());
    shape.append(!is_tag && IsFiniteNumber(piece.substr(begin)) ? "#" : piece);
    xml.remove_prefix(piece.size());
  }
  return shape;
}

void ReadBack(const std::string& xml) {
  static std::unordered_set<std::size_t> known;
  if (!known.insert(std::hash<std::string>()(ShapeOf(xml))).second) return;
  sdf::Root root;
  const sdf::Errors errors = root.LoadSdfString(xml);
  for (const sdf::Error& error : errors) std::fprintf(stderr, "%s\n", error.Message().c_str());
  latticeworld::fuzz::Expect(errors.empty(), "libsdformat reads what was written");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace latticeworld;
  sdf::Console::Instance()->SetQuiet(true);
  std::string_view input = fuzz::TextOf(data, size);
  const fuzz::ExportChoice choice = fuzz::TakeExportChoice(&input);
  SdfOptions options;
  options.region = choice.region;
  options.heightmap_vertices = 17;
  options.heightmap_bits = choice.coarse_heights ? 8 : 16;
  options.texture_px = 16;
  options.small_plants = choice.small_plants;
  options.detail = choice.detail;
  const auto scene = fuzz::StrangerScene(input);
  const auto files =
      SdfFiles(*scene, "world-0123456789ab", GeoOrigin{47.0, 8.0, 400.0}, options, Progress());
  fuzz::Expect(files.ok(), "a world that can be loaded can be exported");
  const auto world = std::find_if(files->begin(), files->end(),
                                  [](const ExportFile& file) { return file.name == "world.sdf"; });
  fuzz::Expect(world != files->end(), "an export has the world's file");
  ReadBack(world->content);
  return 0;
}
