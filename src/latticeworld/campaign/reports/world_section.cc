#include "latticeworld/campaign/reports/world_section.h"

#include <algorithm>
#include <set>
#include <utility>

#include "latticeworld/campaign/world_source.h"
#include "latticeworld/campaign/yaml_reader.h"

namespace latticeworld {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostSeeds = 10000;

// A name that a path has, of the letters that names may have.
std::string NameOfFolder(const fs::path& path) {
  std::string name = (path.has_filename() ? path : path.parent_path()).filename().string();
  for (char& letter : name) {
    const bool plain = (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
                       (letter >= '0' && letter <= '9') || letter == '_';
    if (!plain) letter = '-';
  }
  return name.substr(0, 40);
}

void ReadBundle(YamlMapping* entry, const fs::path& folder, std::vector<CampaignWorld>* worlds) {
  CampaignWorld world;
  std::string path;
  entry->Text("bundle", 1, &path);
  world.bundle = folder / path;
  world.name = NameOfFolder(path);
  entry->Name("name", &world.name);
  std::error_code error;
  if (!path.empty() && !fs::is_directory(world.bundle, error)) {
    AddYamlViolation(entry->Get("bundle"), entry->PathOf("bundle"), "not_found",
                     "the folder of a bundle is wanted", entry->violations());
  }
  worlds->push_back(std::move(world));
}

void ReadMade(YamlMapping* entry, std::vector<CampaignWorld>* worlds) {
  CampaignWorld world;
  entry->Require("name");
  entry->Name("name", &world.name);
  entry->Text("layout", 0, &world.layout);
  entry->Text("environment", 0, &world.environment);
  entry->Text("vocabulary", 1, &world.vocabulary);
  entry->Number("size_m", &world.size_m);
  entry->Number("resolution_m", &world.resolution_m);
  entry->AddIllegal({{"layout_instruction", "layout"},
                     {"environment_instruction", "environment"},
                     {"size", "size_m"},
                     {"resolution", "resolution_m"}},
                    CheckWorldRequest(world).violations());
  std::vector<std::uint64_t> seeds = {1};
  const YAML::Node node = entry->Get("seeds");
  if (entry->Has("seeds")) seeds = ReadSeeds(node, entry->PathOf("seeds"), entry->violations());
  const std::string name = world.name;
  for (const std::uint64_t seed : seeds) {
    world.seed = seed;
    world.name = entry->Has("seeds") ? name + "-" + std::to_string(seed) : name;
    worlds->push_back(world);
  }
}

}  // namespace

std::vector<std::uint64_t> ReadSeeds(const YAML::Node& node, const std::string& path,
                                     std::vector<Violation>* violations) {
  constexpr char kLegal[] =
      "legal are a list of whole numbers above 0, each once, or {from: FIRST, to: LAST}, 10000 at "
      "most";
  std::vector<std::uint64_t> seeds;
  if (node.IsDefined() && node.IsMap()) {
    std::uint64_t from = 1, to = 0;
    YamlMapping range(node, path, violations);
    const std::size_t before = violations->size();
    range.Require("from");
    range.Require("to");
    range.Seed("from", &from);
    range.Seed("to", &to);
    range.Finish();
    if (violations->size() > before) return seeds;
    if (to < from || to - from >= kMostSeeds) {
      AddYamlViolation(node, path, "bad_seeds", kLegal, violations);
      return seeds;
    }
    for (std::uint64_t seed = from; seed <= to; ++seed) seeds.push_back(seed);
    return seeds;
  }
  std::set<std::uint64_t> seen;
  bool legal =
      node.IsDefined() && node.IsSequence() && node.size() > 0 && node.size() <= kMostSeeds;
  for (std::size_t i = 0; legal && i < node.size(); ++i) {
    std::uint64_t seed = 0;
    legal = ReadYamlUnsigned(node[i], &seed) && seed > 0 && seen.insert(seed).second;
    seeds.push_back(seed);
  }
  if (legal) return seeds;
  AddYamlViolation(node, path, "bad_seeds", kLegal, violations);
  return {};
}

std::vector<CampaignWorld> ReadWorldSection(const YAML::Node& node, const fs::path& folder,
                                            std::vector<Violation>* violations) {
  std::vector<CampaignWorld> worlds;
  if (!node.IsDefined() || !node.IsSequence() || node.size() == 0) {
    AddYamlViolation(node, "/worlds", "wrong_type", "a list of at least one world is wanted",
                     violations);
    return worlds;
  }
  std::set<std::string> names;
  for (std::size_t i = 0; i < node.size(); ++i) {
    const std::string path = "/worlds/" + std::to_string(i);
    YamlMapping entry(node[i], path, violations);
    const std::size_t first = worlds.size();
    if (entry.Has("bundle")) {
      ReadBundle(&entry, folder, &worlds);
    } else {
      ReadMade(&entry, &worlds);
    }
    entry.Finish();
    for (std::size_t k = first; k < worlds.size(); ++k) {
      if (worlds[k].name.empty() || names.insert(worlds[k].name).second) continue;
      AddYamlViolation(node[i], path, "duplicate_name",
                       "the world \"" + worlds[k].name + "\" is there already; give another name",
                       violations);
      break;
    }
  }
  return worlds;
}

}  // namespace latticeworld
