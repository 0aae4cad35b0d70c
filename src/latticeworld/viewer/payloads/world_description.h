#ifndef LATTICEWORLD_VIEWER_PAYLOADS_WORLD_DESCRIPTION_H_
#define LATTICEWORLD_VIEWER_PAYLOADS_WORLD_DESCRIPTION_H_

#include <string>
#include <vector>

namespace latticeworld {

class SpeciesCatalogue;
struct AssetTable;
struct HeightGrid;
struct TextureGrid;
struct World;

inline constexpr int kViewerProtocol = 1;

struct PayloadEntry {
  std::string name;  // "height"
  std::string url;
  std::size_t bytes = 0;  // not coded
};

// The text of world.json: docs/viewer.md.
std::string DescribeWorld(const World& world, const SpeciesCatalogue& species, bool moves,
                          const std::string& key, const HeightGrid& height,
                          const TextureGrid& texture, const AssetTable& assets,
                          const std::vector<PayloadEntry>& payloads);

}  // namespace latticeworld

#endif  // LATTICEWORLD_VIEWER_PAYLOADS_WORLD_DESCRIPTION_H_
