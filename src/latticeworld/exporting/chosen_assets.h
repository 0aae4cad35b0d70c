#ifndef LATTICEWORLD_EXPORTING_CHOSEN_ASSETS_H_
#define LATTICEWORLD_EXPORTING_CHOSEN_ASSETS_H_

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "latticeworld/catalogue/asset_kind.h"
#include "latticeworld/common/status.h"
#include "latticeworld/exporting/export_region.h"

namespace latticeworld {

struct Scene;

bool IsSmallPlant(AssetKind kind);  // grass, reed, flowers, crops

// Numbers of the scene's assets in a region, in order.
std::vector<std::uint32_t> ChooseAssets(const Scene& scene, const ExportRegion& region,
                                        bool small_plants);

// What exports call assets: single things by their names, where no other part of a file has that
// name, the rest "asset_<number>".
class AssetNames {
 public:
  explicit AssetNames(const Scene& scene);
  std::string Of(std::uint32_t asset) const;

 private:
  std::map<std::uint32_t, std::string> things_;
};

// INVALID_ARGUMENT that says what helps. things: "things"; small_plants: whether there are some.
Status TooMany(std::size_t given, const std::string& things, std::size_t legal, bool small_plants);

// Things of one mesh and one look.
struct LookGroup {
  std::string model;                   // ModelNameOf
  std::string name;                    // "<model>/<material>/<shade>"
  std::vector<std::uint32_t> members;  // numbers in scene.assets, increasing
};
// Groups assets by model and material; a group that is not small is parted into thirds, from dark
// to light, by the colour of its assets' main parts. Sorted by name, every asset in one group.
std::vector<LookGroup> GroupAssets(const Scene& scene, const std::vector<std::uint32_t>& assets);

}  // namespace latticeworld

#endif  // LATTICEWORLD_EXPORTING_CHOSEN_ASSETS_H_
