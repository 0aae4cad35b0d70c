#ifndef LATTICEWORLD_EXPORTING_CHOSEN_ASSETS_H_
#define LATTICEWORLD_EXPORTING_CHOSEN_ASSETS_H_

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "latticeworld/catalogue/asset_kind.h"
#include "latticeworld/common/status.h"
#include "latticeworld/exporting/export_region.h"

namespace latticeworld {

struct Prop;
struct Scene;

bool IsSmallPlant(AssetKind kind);  // grass, reed, flowers, crops

// Numbers of the scene's assets in a region, in order.
std::vector<std::uint32_t> ChooseAssets(const Scene& scene, const ExportRegion& region,
                                        bool small_plants);

// What exports call assets and props, each by a name that no other part of a file has, whatever
// their names in the world are: single things and props by those, where nothing else has or may
// have them, other assets "asset_<number>", other props "element_<name>".
class PartNames {
 public:
  explicit PartNames(const Scene& scene);
  std::string Of(std::uint32_t asset) const;
  std::string Of(const Prop& prop) const;
  // The name, or where a prop has it, one like it that none has.
  std::string Unlike(std::string name) const;

 private:
  std::map<std::uint32_t, std::string> things_;
  std::set<std::string> props_;
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
