#include <algorithm>
#include <exception>
#include <future>
#include <new>
#include <utility>

#include "latticeworld/common/digest.h"
#include "latticeworld/common/files.h"
#include "latticeworld/exporting/maps/map_server.h"
#include "latticeworld/generation/bundle/agents_json.h"
#include "latticeworld/generation/bundle/assets_csv.h"
#include "latticeworld/generation/bundle/bridges_json.h"
#include "latticeworld/generation/bundle/bundle.h"
#include "latticeworld/generation/bundle/bundle_files.h"
#include "latticeworld/generation/bundle/catalogue_json.h"
#include "latticeworld/generation/bundle/props_json.h"
#include "latticeworld/generation/bundle/raster_files.h"
#include "latticeworld/generation/bundle/replies_json.h"
#include "latticeworld/generation/bundle/terrain_file.h"
#include "latticeworld/generation/bundle/things_json.h"
#include "latticeworld/generation/fidelity/fidelity_json.h"
#include "latticeworld/mapping/octree/octree.h"
#include "latticeworld/mapping/traversability.h"
#include "latticeworld/rendering/picture.h"

namespace latticeworld {
namespace {

namespace fs = std::filesystem;

// Columns of voxels a side of world.bt; bounds the memory that a large world's octree takes.
constexpr double kMaxOctreeColumns = 2048.0;
constexpr int kPreviewWidth_px = 512;  // the map: painted, which takes less than tracing rays

// Writes files one after another, if there is a directory, and keeps the manifest's list of them.
class BundleWriter {
 public:
  // directory: nullptr: nothing is written.
  BundleWriter(DirectoryWriter* directory, Manifest* manifest)
      : directory_(directory), manifest_(manifest) {}

  Status Add(const std::string& name, const std::string& content) {
    if (directory_ != nullptr) LW_RETURN_IF_ERROR(directory_->Write(name, content));
    manifest_->files.push_back({name, content.size(), Sha256Hex(content)});
    return Status();
  }
  Status Add(const std::string& name, const Result<std::string>& content) {
    if (!content.ok()) return content.status().WithContext(name);
    return Add(name, *content);
  }

 private:
  DirectoryWriter* directory_;
  Manifest* manifest_;
};

Status AddSources(const World& world, BundleWriter* writer) {
  const Catalogue& catalogue = *world.scene->catalogue;
  LW_RETURN_IF_ERROR(writer->Add(kLayoutFile, ToText(world.layout)));
  LW_RETURN_IF_ERROR(writer->Add(kEnvironmentFile, ToJson(world.environment)));
  LW_RETURN_IF_ERROR(writer->Add(kFidelityFile, EncodeFidelity(world.fidelity)));
  LW_RETURN_IF_ERROR(writer->Add(kRepliesFile, EncodeReplies(world.replies)));
  LW_RETURN_IF_ERROR(writer->Add(kTerrainFile, EncodeTerrain(*world.scene->terrain)));
  LW_RETURN_IF_ERROR(writer->Add(kAssetsFile, EncodeAssets(world.scene->assets, catalogue)));
  LW_RETURN_IF_ERROR(writer->Add(kAgentsFile, EncodeAgents(world.scene->agents)));
  LW_RETURN_IF_ERROR(writer->Add(kPropsFile, EncodeProps(world.scene->props)));
  if (!world.scene->terrain->bridges.empty()) {
    LW_RETURN_IF_ERROR(writer->Add(kBridgesFile, EncodeBridges(world.scene->terrain->bridges)));
  }
  if (!world.request.things.empty() || !world.scene->things.empty()) {
    const ThingsFile things = {world.request.things, world.scene->things};
    LW_RETURN_IF_ERROR(writer->Add(kThingsFile, EncodeThings(things)));
  }
  if (!catalogue.added_files().empty()) {
    LW_RETURN_IF_ERROR(writer->Add(kCatalogueFile, EncodeCatalogue(catalogue)));
  }
  if (world.request.visual_kind == VisualKind::kNone) return Status();
  return writer->Add(kVisualFile, world.request.visual);
}

Status AddRasters(const Terrain& terrain, BundleWriter* writer, Manifest* manifest) {
  LW_ASSIGN_OR_RETURN(const HeightPng heights, EncodeHeights(terrain.ground.height_m()));
  manifest->height_png_scale_m = heights.scale_m;
  manifest->height_png_offset_m = heights.offset_m;
  LW_RETURN_IF_ERROR(writer->Add(kHeightFile, heights.png));
  LW_ASSIGN_OR_RETURN(const WaterPng water, EncodeWaterDepths(terrain));
  manifest->water_png_scale_m = water.scale_m;
  LW_RETURN_IF_ERROR(writer->Add(kWaterFile, water.png));
  for (const ClassWeight& entry : terrain.weights.classes) {
    LW_RETURN_IF_ERROR(writer->Add(WeightFile(entry.letter), EncodeWeights(entry.weight)));
  }
  return Status();
}

Status AddMaps(const Scene& scene, MapValues values, BundleWriter* writer) {
  const Result<MapServerFiles> map =
      ToMapServer(BuildOccupancy(scene, RobotLimits()), scene.geometry(), values);
  if (!map.ok()) return map.status().WithContext(kMapFile);
  LW_RETURN_IF_ERROR(writer->Add(kMapPictureFile, map->pgm));
  LW_RETURN_IF_ERROR(writer->Add(kMapFile, map->yaml));
  PictureOptions options;
  options.width_px = kPreviewWidth_px;
  return writer->Add(kPreviewFile, DrawTopView(scene, options));
}

Result<std::string> EncodeOctree(const Scene& scene, double resolution_m,
                                 const Progress& progress) {
  OctreeOptions options;
  options.resolution_m = resolution_m;
  LW_ASSIGN_OR_RETURN(const OctreeData data, BuildBinaryData(scene, options, progress));
  return BinaryFile(data, resolution_m);
}

// All files but the manifest.
Status AddFiles(const World& world, BundleWriter* writer, Manifest* manifest) {
  const Scene& scene = *world.scene;
  manifest->octree_resolution_m =
      std::max(scene.geometry().resolution_m(), scene.geometry().size_m() / kMaxOctreeColumns);
  // The octree takes as long as all the rest, so it is built beside it; after it, where no more
  // threads can be had.
  Progress octree_progress;
  auto octree = std::async(std::launch::async | std::launch::deferred, [&] {
    return EncodeOctree(scene, manifest->octree_resolution_m, octree_progress);
  });
  const auto add_others = [&]() -> Status {
    LW_RETURN_IF_ERROR(AddSources(world, writer));
    LW_RETURN_IF_ERROR(AddRasters(*scene.terrain, writer, manifest));
    return AddMaps(scene, manifest->map_values, writer);
  };
  if (const Status status = add_others(); !status.ok()) {
    octree_progress.Cancel();
    return status;
  }
  return writer->Add(kOctreeFile, octree.get());
}

// "worlds/lake/" names the same directory as "worlds/lake".
fs::path WithoutTrailingSlash(const fs::path& directory) {
  return directory.has_filename() ? directory : directory.parent_path();
}

// Encodes every file but the manifest. directory: where they go; nullptr: nowhere.
Result<Manifest> Encode(const World& world, MapValues map_values, DirectoryWriter* directory) {
  Manifest manifest;
  manifest.map_values = map_values;
  manifest.world_id = world.id;
  manifest.geo = world.geo;
  manifest.request = world.request;
  manifest.atmosphere = world.scene->atmosphere;
  manifest.warnings = world.warnings;
  manifest.stages = world.stages;

  BundleWriter writer(directory, &manifest);
  LW_RETURN_IF_ERROR(AddFiles(world, &writer, &manifest));
  return manifest;
}

Status Save(const World& world, const fs::path& target, MapValues map_values) {
  LW_ASSIGN_OR_RETURN(DirectoryWriter directory,
                      DirectoryWriter::Create(WithoutTrailingSlash(target)));
  LW_ASSIGN_OR_RETURN(const Manifest manifest, Encode(world, map_values, &directory));
  const std::string text = EncodeManifest(manifest);
  if (text.size() > kMaxManifestBytes) {  // nobody would read it
    return ResourceExhausted(std::string(kManifestFile) + " has " + std::to_string(text.size()) +
                             " bytes; at most " + std::to_string(kMaxManifestBytes) +
                             " are legal: its warnings are too many or too long");
  }
  LW_RETURN_IF_ERROR(directory.Write(kManifestFile, text));
  return directory.Commit();
}

// What `function` gives, or the failure that it throws.
template <typename Function>
auto Caught(const std::string& context, const Function& function) -> decltype(function()) {
  try {
    return function();
  } catch (const std::bad_alloc&) {
    return ResourceExhausted(context + ": not enough memory");
  } catch (const std::exception& error) {  // std::filesystem, JSON
    return Internal(context + ": " + error.what());
  }
}

}  // namespace

Status SaveBundle(const World& world, const fs::path& directory, MapValues map_values) {
  const std::string context = "cannot save " + directory.string();
  return Caught(context, [&] { return Save(world, directory, map_values).WithContext(context); });
}

Result<Manifest> MakeManifest(const World& world, MapValues map_values) {
  return Caught("cannot encode " + world.id, [&] { return Encode(world, map_values, nullptr); });
}

}  // namespace latticeworld
