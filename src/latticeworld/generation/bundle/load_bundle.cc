#include <algorithm>
#include <exception>
#include <new>
#include <set>
#include <utility>

#include "latticeworld/common/digest.h"
#include "latticeworld/common/files.h"
#include "latticeworld/common/text.h"
#include "latticeworld/generation/bundle/agents_json.h"
#include "latticeworld/generation/bundle/assets_csv.h"
#include "latticeworld/generation/bundle/bridges_json.h"
#include "latticeworld/generation/bundle/bundle.h"
#include "latticeworld/generation/bundle/bundle_files.h"
#include "latticeworld/generation/bundle/catalogue_json.h"
#include "latticeworld/generation/bundle/props_json.h"
#include "latticeworld/generation/bundle/replies_json.h"
#include "latticeworld/generation/bundle/terrain_file.h"
#include "latticeworld/generation/bundle/things_json.h"
#include "latticeworld/generation/bundle/world_id.h"
#include "latticeworld/generation/fidelity/fidelity_json.h"
#include "latticeworld/generation/visual.h"

namespace latticeworld {
namespace {

namespace fs = std::filesystem;

// A failure to parse a file of a bundle is damage, whatever the parser calls it.
Status Damaged(std::string_view file, const Status& status) {
  return DataLoss(std::string(file) + ": " + status.message());
}

Status CheckRequest(const GenerationRequest& request) {
  LW_RETURN_IF_ERROR(GridGeometry::Create(request.size_m, request.resolution_m).status());
  return Status::FromViolations("visual instruction", ValidateVisualOptions(request));
}

// Every file that the world needs is listed, once, and nothing else is: names never come from the
// manifest unchecked, so that none can point outside the bundle.
Status CheckFileList(const Manifest& manifest) {
  std::set<std::string> legal = {kLayoutFile,  kEnvironmentFile, kFidelityFile,   kRepliesFile,
                                 kTerrainFile, kAssetsFile,      kAgentsFile,     kPropsFile,
                                 kHeightFile,  kWaterFile,       kMapPictureFile, kMapFile,
                                 kOctreeFile,  kPreviewFile};
  if (manifest.request.visual_kind != VisualKind::kNone) legal.insert(kVisualFile);
  std::set<std::string> missing = legal;
  for (const LayoutClass& entry : ClassesOf(*FromName<Vocabulary>(manifest.request.vocabulary))) {
    legal.insert(WeightFile(entry.letter));  // only for classes that occur
  }
  legal.insert(kThingsFile);     // only where there are any
  legal.insert(kCatalogueFile);  // only where a user added to it
  legal.insert(kBridgesFile);    // only where roads have any
  for (const BundleFile& file : manifest.files) {
    if (legal.erase(file.name) == 0) {
      return DataLoss("lists " + Quote(file.name) + ", which no bundle has or which it has twice");
    }
    missing.erase(file.name);
  }
  if (!missing.empty()) return DataLoss("does not list " + *missing.begin());
  return Status();
}

Result<std::string> ReadVerified(const fs::path& directory, const BundleFile& file) {
  if (file.bytes > kMaxBundleFileBytes) {
    return DataLoss(file.name + ": is listed with " + std::to_string(file.bytes) +
                    " bytes; at most " + std::to_string(kMaxBundleFileBytes) + " are legal");
  }
  auto content = ReadFile(directory / file.name, kMaxBundleFileBytes);
  if (content.status().code() == StatusCode::kNotFound) return DataLoss(file.name + ": is missing");
  if (!content.ok()) return content.status().WithContext(file.name);
  if (content->size() != file.bytes) {
    return DataLoss(file.name + ": is " + std::to_string(content->size()) + " bytes long, not " +
                    std::to_string(file.bytes));
  }
  if (Sha256Hex(*content) != file.sha256) {
    return DataLoss(file.name + ": its SHA-256 is not the one in " + kManifestFile);
  }
  return content;
}

// The files that a world is read back from. The others are checked and forgotten.
struct Contents {
  std::string layout, environment, fidelity, replies, catalogue, terrain, assets, agents, props,
      bridges, things, visual;

  std::string* Find(std::string_view name) {
    if (name == kLayoutFile) return &layout;
    if (name == kEnvironmentFile) return &environment;
    if (name == kFidelityFile) return &fidelity;
    if (name == kRepliesFile) return &replies;
    if (name == kCatalogueFile) return &catalogue;
    if (name == kTerrainFile) return &terrain;
    if (name == kAssetsFile) return &assets;
    if (name == kAgentsFile) return &agents;
    if (name == kPropsFile) return &props;
    if (name == kBridgesFile) return &bridges;
    if (name == kThingsFile) return &things;
    if (name == kVisualFile) return &visual;
    return nullptr;
  }
};

Result<Contents> ReadContents(const fs::path& directory, const Manifest& manifest) {
  Contents contents;
  for (const BundleFile& file : manifest.files) {
    LW_ASSIGN_OR_RETURN(std::string content, ReadVerified(directory, file));
    if (std::string* kept = contents.Find(file.name)) *kept = std::move(content);
  }
  return contents;
}

Result<std::shared_ptr<const Catalogue>> ParseCatalogue(const Contents& contents) {
  if (contents.catalogue.empty()) return Catalogue::BuiltIn();
  auto catalogue = DecodeCatalogue(contents.catalogue);
  if (!catalogue.ok()) return Damaged(kCatalogueFile, catalogue.status());
  return catalogue;
}

// Gives the scene its things; the request's as they were written.
Result<std::string> ParseThingsFile(const Contents& contents, Scene* scene) {
  if (contents.things.empty()) return std::string();
  auto file = DecodeThings(contents.things, scene->geometry(), scene->assets.size());
  if (!file.ok()) return Damaged(kThingsFile, file.status());
  scene->things = std::move(file->things);
  return std::move(file->request);
}

Result<std::shared_ptr<Scene>> ParseScene(const Contents& contents, const Manifest& manifest,
                                          std::shared_ptr<const Catalogue> catalogue,
                                          EnvironmentConfig environment) {
  LW_ASSIGN_OR_RETURN(const GridGeometry geometry,
                      GridGeometry::Create(manifest.request.size_m, manifest.request.resolution_m));
  auto terrain =
      DecodeTerrain(contents.terrain, geometry, *FromName<Vocabulary>(manifest.request.vocabulary));
  if (!terrain.ok()) return Damaged(kTerrainFile, terrain.status());
  if (!contents.bridges.empty()) {
    auto bridges = DecodeBridges(contents.bridges, geometry);
    if (!bridges.ok()) return Damaged(kBridgesFile, bridges.status());
    terrain->bridges = *std::move(bridges);
  }
  auto assets = DecodeAssets(contents.assets, geometry, *catalogue);
  if (!assets.ok()) return Damaged(kAssetsFile, assets.status());
  auto agents = DecodeAgents(contents.agents, geometry);
  if (!agents.ok()) return Damaged(kAgentsFile, agents.status());
  auto props = DecodeProps(contents.props, geometry, *agents);
  if (!props.ok()) return Damaged(kPropsFile, props.status());

  auto scene = std::make_shared<Scene>();
  scene->terrain = std::make_shared<const Terrain>(*std::move(terrain));
  scene->catalogue = std::move(catalogue);
  scene->environment = std::move(environment);
  scene->assets = *std::move(assets);
  scene->index = AssetIndex(geometry.size_m(), scene->assets);
  scene->atmosphere = manifest.atmosphere;
  scene->agents = *std::move(agents);
  scene->props = *std::move(props);
  return scene;
}

Result<std::shared_ptr<const World>> Load(const fs::path& directory) {
  LW_ASSIGN_OR_RETURN(Manifest manifest, ReadManifest(directory));
  for (const Status& status : {CheckRequest(manifest.request), CheckFileList(manifest)}) {
    if (!status.ok()) return Damaged(kManifestFile, status);
  }
  LW_ASSIGN_OR_RETURN(Contents contents, ReadContents(directory, manifest));
  auto layout = ParseLayout(contents.layout, *FromName<Vocabulary>(manifest.request.vocabulary));
  if (!layout.ok()) return Damaged(kLayoutFile, layout.status());
  LW_ASSIGN_OR_RETURN(const auto catalogue, ParseCatalogue(contents));
  auto environment = ParseEnvironment(contents.environment, *catalogue);
  if (!environment.ok()) return Damaged(kEnvironmentFile, environment.status());
  auto fidelity = DecodeFidelity(contents.fidelity);
  if (!fidelity.ok()) return Damaged(kFidelityFile, fidelity.status());
  auto replies = DecodeReplies(contents.replies);
  if (!replies.ok()) return Damaged(kRepliesFile, replies.status());
  LW_ASSIGN_OR_RETURN(auto scene, ParseScene(contents, manifest, catalogue, *environment));

  LW_ASSIGN_OR_RETURN(const std::string request_things, ParseThingsFile(contents, scene.get()));

  const std::string id = ContentId(*layout, *scene, manifest.geo);
  if (id != manifest.world_id) {
    return DataLoss(std::string(kManifestFile) + ": names " + Quote(manifest.world_id) +
                    ", but the files hold " + id);
  }
  auto world = std::make_shared<World>();
  world->id = id;
  world->request = std::move(manifest.request);
  world->request.things = request_things;
  world->request.visual = std::move(contents.visual);
  world->layout = *std::move(layout);
  world->environment = *std::move(environment);
  world->scene = std::move(scene);
  world->geo = manifest.geo;
  world->fidelity = *std::move(fidelity);
  world->replies = *std::move(replies);
  world->warnings = std::move(manifest.warnings);
  world->stages = std::move(manifest.stages);
  return std::shared_ptr<const World>(std::move(world));
}

}  // namespace

Result<Manifest> ReadManifest(const fs::path& directory) {
  std::error_code error;
  const fs::file_status status = fs::status(directory, error);
  if (!fs::exists(status)) return NotFound("there is no such directory");
  if (!fs::is_directory(status)) return NotFound("it is not a directory");
  const auto content = ReadFile(directory / kManifestFile, kMaxManifestBytes);
  if (content.status().code() == StatusCode::kNotFound) {
    return DataLoss(std::string(kManifestFile) + ": is missing; a bundle has one");
  }
  if (!content.ok()) return content.status().WithContext(kManifestFile);
  auto manifest = DecodeManifest(*content);
  if (!manifest.ok()) return manifest.status().WithContext(kManifestFile);
  return manifest;
}

Result<std::shared_ptr<const World>> LoadBundle(const fs::path& directory) {
  const std::string context = "cannot load " + directory.string();
  try {
    auto world = Load(directory);
    if (!world.ok()) return world.status().WithContext(context);
    return world;
  } catch (const std::bad_alloc&) {
    return ResourceExhausted(context + ": not enough memory");
  } catch (const std::exception& error) {  // std::filesystem
    return Internal(context + ": " + error.what());
  }
}

}  // namespace latticeworld
