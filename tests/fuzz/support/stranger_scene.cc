#include "fuzz/support/stranger_scene.h"

#include <algorithm>
#include <utility>

#include "generation/test_world.h"
#include "latticeworld/generation/bundle/agents_json.h"
#include "latticeworld/generation/bundle/assets_csv.h"
#include "latticeworld/generation/bundle/bridges_json.h"
#include "latticeworld/generation/bundle/props_json.h"
#include "latticeworld/generation/bundle/things_json.h"

namespace latticeworld::fuzz {
namespace {

std::string_view TakeFile(std::string_view* files) {
  const std::size_t end = std::min(files->find('\0'), files->size());
  const std::string_view file = files->substr(0, end);
  files->remove_prefix(std::min(end + 1, files->size()));
  return file;
}

template <typename Value>
Value ReadableOrNone(Result<Value> read) {
  return read.ok() ? *std::move(read) : Value();
}

}  // namespace

ExportChoice TakeExportChoice(std::string_view* input) {
  ExportChoice choice;
  if (input->empty()) return choice;
  const auto bits = static_cast<unsigned char>(input->front());
  input->remove_prefix(1);
  if ((bits & 1) != 0) choice.region = ExportRegion{-16.0, -16.0, 0.0, 0.0};
  choice.expand = (bits & 2) != 0;
  choice.small_plants = (bits & 4) != 0;
  choice.coarse_heights = (bits & 8) != 0;
  choice.detail = (bits >> 4) % 3;
  return choice;
}

std::shared_ptr<const Scene> StrangerScene(std::string_view files) {
  static const std::shared_ptr<const World> world = MakeTestWorld();
  auto scene = std::make_shared<Scene>(*world->scene);
  const GridGeometry& geometry = world->scene->geometry();
  scene->agents = ReadableOrNone(DecodeAgents(TakeFile(&files), geometry));
  scene->props = ReadableOrNone(DecodeProps(TakeFile(&files), geometry, scene->agents));
  auto terrain = std::make_shared<Terrain>(*scene->terrain);
  terrain->bridges = ReadableOrNone(DecodeBridges(TakeFile(&files), geometry));
  scene->terrain = std::move(terrain);
  scene->assets = ReadableOrNone(DecodeAssets(TakeFile(&files), geometry, *scene->catalogue));
  scene->index = AssetIndex(geometry.size_m(), scene->assets);
  scene->things =
      ReadableOrNone(DecodeThings(TakeFile(&files), geometry, scene->assets.size())).things;
  return scene;
}

}  // namespace latticeworld::fuzz
