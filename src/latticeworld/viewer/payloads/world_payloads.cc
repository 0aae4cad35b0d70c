#include "latticeworld/viewer/payloads/world_payloads.h"

#include <array>
#include <cstddef>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <utility>
#include <vector>

#include "latticeworld/common/digest.h"
#include "latticeworld/exporting/gltf/model_library.h"
#include "latticeworld/generation/world.h"
#include "latticeworld/layout/picture.h"
#include "latticeworld/rendering/looks/ground_colors.h"
#include "latticeworld/rendering/picture.h"
#include "latticeworld/rendering/views/thematic_map.h"
#include "latticeworld/species/species_catalogue.h"
#include "latticeworld/viewer/payloads/world_assets.h"
#include "latticeworld/viewer/payloads/world_description.h"
#include "latticeworld/viewer/payloads/world_grids.h"

namespace latticeworld {
namespace {

constexpr char kStage[] = "viewer";
constexpr std::size_t kKeyDigits = 8;
constexpr int kMapWidth_px = 768;
constexpr int kLayoutCell_px = 8;
constexpr int kMostGround_px = 2048;
constexpr int kGroundQuality = 88;  // of the JPEG, [0, 100]
// Colours of larger grounds would take more than half a gigabyte to make.
constexpr int kMostGroundCells = 4096;

struct NamedFile {
  std::string name;  // "height"
  std::string file;  // "height.bin"
  std::string bytes;
};

// The ground's own colours as a JPEG, north up.
Result<std::string> DrawGround(const Scene& scene) {
  try {
    cv::Mat color = MaterialsOf(scene).color;
    if (color.cols > kMostGround_px) {
      cv::resize(color, color, {kMostGround_px, kMostGround_px}, 0.0, 0.0, cv::INTER_AREA);
    }
    cv::Mat bytes;
    color.convertTo(bytes, CV_8UC3, 255.0);
    std::vector<unsigned char> jpeg;
    if (!cv::imencode(".jpg", bytes, jpeg, {cv::IMWRITE_JPEG_QUALITY, kGroundQuality})) {
      return Internal("cannot encode the ground's colours");
    }
    return std::string(jpeg.begin(), jpeg.end());
  } catch (const cv::Exception& error) {
    return Internal(std::string("cannot paint the ground: ") + error.what());
  }
}

}  // namespace

Result<std::shared_ptr<const WorldPayloads>> MakeWorldPayloads(const World& world,
                                                               const SpeciesCatalogue& species,
                                                               bool moves,
                                                               const Progress& progress) {
  const Scene& scene = *world.scene;
  PictureOptions picture;
  picture.width_px = kMapWidth_px;
  picture.agents = false;
  const auto advance = [&progress](double fraction) {
    progress.Report(kStage, fraction);
    return progress.CheckCancelled();
  };
  // The grids and the table of assets come first: the description tells of them too.
  LW_RETURN_IF_ERROR(advance(0.0));
  HeightGrid height = MakeHeightGrid(*scene.terrain);
  TextureGrid texture = MakeTextureGrid(*scene.terrain);
  LW_RETURN_IF_ERROR(advance(0.15));
  AssetTable assets = MakeAssetTable(scene);
  LW_RETURN_IF_ERROR(advance(0.25));

  // These are the files that a page fetches; a ground of very many cells has no pictures.
  std::vector<NamedFile> files;
  files.push_back({"height", "height.bin", std::move(height.heights)});
  files.push_back({"water", "water.bin", std::move(height.waters)});
  files.push_back({"weights", "weights.bin", std::move(texture.weights)});
  files.push_back({"surface", "surface.bin", std::move(texture.surfaces)});
  files.push_back({"assets", "assets.bin", assets.bytes});
  if (scene.geometry().rows() <= kMostGroundCells) {
    LW_ASSIGN_OR_RETURN(std::string ground, DrawGround(scene));
    files.push_back({"ground", "ground.jpg", std::move(ground)});
    LW_RETURN_IF_ERROR(advance(0.4));
    LW_ASSIGN_OR_RETURN(std::string map, DrawTopView(scene, picture));
    files.push_back({"map", "map.png", std::move(map)});
    LW_RETURN_IF_ERROR(advance(0.55));
    LW_ASSIGN_OR_RETURN(std::string relief, DrawThematicMap(scene, MapTheme::kHeight, picture));
    files.push_back({"relief", "relief.png", std::move(relief)});
    LW_RETURN_IF_ERROR(advance(0.65));
  }
  LW_ASSIGN_OR_RETURN(std::string layout, ToPng(world.layout, kLayoutCell_px));
  files.push_back({"layout", "layout.png", std::move(layout)});
  LW_ASSIGN_OR_RETURN(std::string models, ModelLibraryGlb(scene, species));
  files.push_back({"models", "models.glb", std::move(models)});
  LW_RETURN_IF_ERROR(advance(0.9));

  // The key names these bytes, so that browsers may keep them for good.
  Digest digest;
  digest.Add(kViewerProtocol);
  digest.Add(moves);
  for (const NamedFile& file : files) {
    digest.AddText(file.name);
    digest.AddText(file.bytes);
  }
  auto payloads = std::make_shared<WorldPayloads>();
  payloads->world_id = world.id;
  payloads->key = world.id + "-" + digest.Hex().substr(0, kKeyDigits);
  // Each file gets its address below the key.
  std::vector<PayloadEntry> entries;
  for (NamedFile& file : files) {
    const std::string url = "/api/worlds/" + payloads->key + "/" + file.file;
    entries.push_back({file.name, url, file.bytes.size()});
    const std::string type(ContentTypeOf(file.file));
    payloads->files.emplace(url, MakePayload(type, std::move(file.bytes), IsCompressible(type)));
  }
  payloads->description = MakePayload(
      std::string(ContentTypeOf(".json")),
      DescribeWorld(world, species, moves, payloads->key, height, texture, assets, entries),
      /*compress=*/true);
  LW_RETURN_IF_ERROR(advance(1.0));
  return std::shared_ptr<const WorldPayloads>(std::move(payloads));
}

}  // namespace latticeworld
