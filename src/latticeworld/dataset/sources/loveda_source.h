#ifndef LATTICEWORLD_DATASET_SOURCES_LOVEDA_SOURCE_H_
#define LATTICEWORLD_DATASET_SOURCES_LOVEDA_SOURCE_H_

#include <array>
#include <filesystem>
#include <memory>

#include "latticeworld/common/enum_names.h"
#include "latticeworld/common/result.h"
#include "latticeworld/dataset/sources/instance_source.h"

namespace latticeworld {

// Which of LoveDA's two domains. The method takes scenes of the outskirts, which the publisher does
// not mark: its rural domain holds most of them.
enum class LoveDaScenes : std::uint8_t { kRural, kUrban, kAll };

constexpr std::array<EnumName<LoveDaScenes>, 3> EnumNames(LoveDaScenes) {
  return {{{LoveDaScenes::kRural, "rural"},
           {LoveDaScenes::kUrban, "urban"},
           {LoveDaScenes::kAll, "all"}}};
}

struct LoveDaOptions {
  std::filesystem::path folder;
  LoveDaScenes scenes = LoveDaScenes::kRural;
};

// Suburb layouts from LoveDA as it is published (Wang et al. 2021, "LoveDA: A Remote Sensing
// Land-Cover Dataset for Domain Adaptive Semantic Segmentation"):
//
//   {Train,Val}/{Urban,Rural}/{images_png,masks_png}/N.png
//
// or one of these folders inside: {Urban,Rural}, or images_png and masks_png themselves, of which
// options.scenes says nothing. Its test part has no masks and is left out. Mask values: 0 no data,
// 1 background (grassland), 2 building, 3 road, 4 water, 5 barren, 6 forest, 7 agriculture. A group
// is an image; its four instances are the quarter turns of its layout, anticlockwise
// ("<group>-r0", "-r90", "-r180", "-r270"), without a relief. Only the header of images is read.
//
// Errors: NOT_FOUND (no folder), INVALID_ARGUMENT (a folder that is none of these, or has no
// images), PERMISSION_DENIED. A group's errors are those of InstanceSource.
Result<std::unique_ptr<InstanceSource>> MakeLoveDaSource(const LoveDaOptions& options);

}  // namespace latticeworld

#endif  // LATTICEWORLD_DATASET_SOURCES_LOVEDA_SOURCE_H_
