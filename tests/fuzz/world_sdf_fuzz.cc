// SDF files of worlds that strangers wrote, read back by libsdformat.

#include <algorithm>
#include <sdf/sdf.hh>

#include "fuzz/fuzz_target.h"
#include "fuzz/support/stranger_scene.h"
#include "latticeworld/exporting/simulators/sdf_world.h"

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
  sdf::Root root;
  const sdf::Errors errors = root.LoadSdfString(world->content);
  for (const sdf::Error& error : errors) std::fprintf(stderr, "%s\n", error.Message().c_str());
  fuzz::Expect(errors.empty(), "libsdformat reads what was written");
  return 0;
}
