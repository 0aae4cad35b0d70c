#ifndef LATTICEWORLD_TESTS_FUZZ_SUPPORT_STRANGER_SCENE_H_
#define LATTICEWORLD_TESTS_FUZZ_SUPPORT_STRANGER_SCENE_H_

#include <memory>
#include <optional>
#include <string_view>

#include "latticeworld/exporting/export_region.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld::fuzz {

// How the input's scene is to be exported, by the bits of its first byte.
struct ExportChoice {
  std::optional<ExportRegion> region;  // a quarter of the world, or none
  bool expand = false;
  bool small_plants = false;
  bool coarse_heights = false;  // of 8 bits
  int detail = 0;
};
ExportChoice TakeExportChoice(std::string_view* input);

// The scene of the test world, with what a stranger wrote into its bundle: the input has, each
// ended by a zero byte, agents.json, elements.json, bridges.json, assets.csv and things.json. Of a
// file that cannot be read it has nothing.
std::shared_ptr<const Scene> StrangerScene(std::string_view files);

}  // namespace latticeworld::fuzz

#endif  // LATTICEWORLD_TESTS_FUZZ_SUPPORT_STRANGER_SCENE_H_
