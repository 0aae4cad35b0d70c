#include "latticeworld/exporting/chosen_assets.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>
#include <utility>

#include "latticeworld/exporting/gltf/model_library.h"
#include "latticeworld/exporting/gltf/model_mesh.h"
#include "latticeworld/rendering/looks/asset_looks.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {
namespace {

constexpr std::array<const char*, 3> kShades = {"dark", "middle", "light"};
constexpr std::size_t kFewest = 12;  // that get shades

// Returns 10,000 times the luma of the asset's main part by Rec. 709, from its sRGB bytes.
int LumaOf(const Scene& scene, const Asset& asset) {
  const Rgb color = PartColors(scene, asset)[static_cast<std::size_t>(MainPartOf(asset.kind))];
  return 2126 * color.r + 7152 * color.g + 722 * color.b;
}

void AddShades(const Scene& scene, const LookGroup& whole, std::vector<LookGroup>* groups) {
  std::vector<std::pair<int, std::uint32_t>> by_luma;
  for (const std::uint32_t number : whole.members)
    by_luma.emplace_back(LumaOf(scene, scene.assets[number]), number);
  std::sort(by_luma.begin(), by_luma.end());
  for (std::size_t shade = 0; shade < kShades.size(); ++shade) {
    LookGroup group = {whole.model, whole.name + "/" + kShades[shade], {}};
    const std::size_t begin = by_luma.size() * shade / kShades.size();
    const std::size_t end = by_luma.size() * (shade + 1) / kShades.size();
    for (std::size_t i = begin; i < end; ++i) group.members.push_back(by_luma[i].second);
    std::sort(group.members.begin(), group.members.end());
    groups->push_back(std::move(group));
  }
}

// Whether files have a part of that name already, or may have. A format's own names are among them.
bool IsTaken(std::string_view name) {
  constexpr std::string_view kNames[] = {"ground", "water", "sun",    "sky",
                                         "link",   "world", "default"};
  constexpr std::string_view kBegins[] = {"asset_", "element_", "map_", "road_bridge_"};
  constexpr std::string_view kSolid = "_solid";  // what asset X bumps into is "X_solid"
  const bool begins = std::any_of(std::begin(kBegins), std::end(kBegins), [&](auto begin) {
    return name.substr(0, begin.size()) == begin;
  });
  return begins || std::find(std::begin(kNames), std::end(kNames), name) != std::end(kNames) ||
         (name.size() >= kSolid.size() && name.substr(name.size() - kSolid.size()) == kSolid);
}

}  // namespace

PartNames::PartNames(const Scene& scene) {
  for (const Prop& prop : scene.props) props_.insert(Of(prop));
  std::set<std::string> used = props_;
  for (const SceneThing& thing : scene.things) {
    if (thing.asset < 0 || IsTaken(thing.name) || !used.insert(thing.name).second) continue;
    things_.emplace(static_cast<std::uint32_t>(thing.asset), thing.name);
  }
}

std::string PartNames::Of(std::uint32_t asset) const {
  const auto found = things_.find(asset);
  return found == things_.end() ? "asset_" + std::to_string(asset) : found->second;
}

std::string PartNames::Of(const Prop& prop) const {
  return IsTaken(prop.name) ? "element_" + prop.name : prop.name;
}

std::string PartNames::Unlike(std::string name) const {
  while (props_.count(name) > 0) name += "_";
  return name;
}

bool IsSmallPlant(AssetKind kind) {
  return kind == AssetKind::kGrassTuft || kind == AssetKind::kFlower || kind == AssetKind::kCrop;
}

std::vector<std::uint32_t> ChooseAssets(const Scene& scene, const ExportRegion& region,
                                        bool small_plants) {
  std::vector<std::uint32_t> chosen;
  for (std::uint32_t i = 0; i < scene.assets.size(); ++i) {
    const Asset& asset = scene.assets[i];
    if (!region.Holds(asset.position())) continue;
    if (small_plants || !IsSmallPlant(asset.kind)) chosen.push_back(i);
  }
  return chosen;
}

Status TooMany(std::size_t given, const std::string& things, std::size_t legal, bool small_plants) {
  return InvalidArgument(std::to_string(given) + " " + things + " are too many; legal are " +
                         std::to_string(legal) + ": take a region" +
                         (small_plants ? ", or no small plants" : ""));
}

std::vector<LookGroup> GroupAssets(const Scene& scene, const std::vector<std::uint32_t>& assets) {
  std::map<std::pair<std::string, std::string>, std::vector<std::uint32_t>> members;
  for (const std::uint32_t number : assets) {
    const Asset& asset = scene.assets[number];
    const auto& materials = scene.catalogue->materials(TypeOf(asset.kind));
    members[{ModelNameOf(scene, asset), materials[asset.material].name}].push_back(number);
  }
  std::vector<LookGroup> groups;
  for (auto& [key, numbers] : members) {
    LookGroup group = {key.first, key.first + "/" + key.second, std::move(numbers)};
    if (group.members.size() < kFewest) {
      groups.push_back(std::move(group));
    } else {
      AddShades(scene, group, &groups);
    }
  }
  return groups;
}

}  // namespace latticeworld
