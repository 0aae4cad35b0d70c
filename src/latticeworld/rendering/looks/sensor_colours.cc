#include "latticeworld/rendering/looks/sensor_colours.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <utility>
#include <vector>

#include "latticeworld/common/parallel.h"
#include "latticeworld/rendering/looks/ground_colors.h"
#include "latticeworld/rendering/ray/precipitation.h"
#include "latticeworld/rendering/views/camera_strip.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {
namespace {

using Eigen::Vector3f;

// The scene as it is in dry weather without its assets, for what they stand on.
Scene BareOf(const Scene& scene) {
  Scene bare;
  bare.terrain = scene.terrain;
  bare.catalogue = scene.catalogue;
  bare.environment = scene.environment;
  bare.atmosphere = scene.atmosphere;
  bare.atmosphere.weather = Weather::kSunny;
  bare.atmosphere.snow_depth_m = 0.0;
  return bare;
}

GroundMaterials DryGround(const Scene& scene) {
  Scene dry = BareOf(scene);
  dry.assets = scene.assets;  // crops colour the ground
  return MaterialsOf(dry);
}

bool IsSameLens(const CameraModel& a, const CameraModel& b) {
  return a.width == b.width && a.height == b.height && a.fx_px == b.fx_px && a.fy_px == b.fy_px &&
         a.cx_px == b.cx_px && a.cy_px == b.cy_px && a.distortion == b.distortion;
}

// Holds the directions in which a camera's pixels look, in its optical frame, row by row.
struct Lens {
  CameraModel model;
  std::vector<Vector3f> directions;
};
std::shared_ptr<const Lens> MakeLens(const CameraModel& model) {
  auto lens = std::make_shared<Lens>();
  lens->model = model;
  lens->directions.reserve(static_cast<std::size_t>(model.width) * model.height);
  for (int v = 0; v < model.height; ++v) {
    for (int u = 0; u < model.width; ++u) {
      lens->directions.push_back(DirectionOf(model, u, v).cast<float>());
    }
  }
  return lens;
}

constexpr std::size_t kMostLenses = 8;

}  // namespace

struct SceneColours::Parts {
  Parts(std::shared_ptr<const Scene> own_scene, int own_threads)
      : scene(std::move(own_scene)), threads(own_threads) {}

  const std::shared_ptr<const Scene> scene;
  const int threads;

  // What things look like: made with the first picture.
  std::mutex mutex;
  std::unique_ptr<const Scene> bare;
  std::unique_ptr<const RayMaterials> materials;
  Plain plain;
  std::vector<std::shared_ptr<const Lens>> lenses;  // the latest last

  void Prepare() {
    const std::lock_guard<std::mutex> lock(mutex);
    if (materials != nullptr) return;
    bare = std::make_unique<const Scene>(BareOf(*scene));
    const GroundMaterials ground = DryGround(*scene);
    materials = std::make_unique<const RayMaterials>(*bare, ground, scene->assets,
                                                     /*lamps_are_lit=*/true, /*relief=*/1.0f);
    plain = PlainAround(*scene, *materials);
  }

  std::shared_ptr<const Lens> LensOf(const CameraModel& model) {
    const std::lock_guard<std::mutex> lock(mutex);
    for (const std::shared_ptr<const Lens>& lens : lenses) {
      if (IsSameLens(lens->model, model)) return lens;
    }
    if (lenses.size() >= kMostLenses) lenses.erase(lenses.begin());
    lenses.push_back(MakeLens(model));
    return lenses.back();
  }
};

SceneColours::SceneColours(std::shared_ptr<const Scene> scene, int threads)
    : parts_(std::make_unique<Parts>(std::move(scene), threads)) {}

SceneColours::~SceneColours() = default;

void SceneColours::Render(const SensorScene& rays, const SensedWorld& world,
                          const CameraModel& model, const Eigen::Isometry3d& map_from_optical,
                          std::uint32_t except_agent, CameraFrame* frame) const {
  parts_->Prepare();
  const std::shared_ptr<const Lens> lens = parts_->LensOf(model);
  const ArtisticStyle style = parts_->scene->environment.coarse.artistic_style;
  const RaySky sky(world.atmosphere, style);
  const Weathering weathering(world.atmosphere, parts_->scene->environment.coarse.season);
  const CameraStrip::View view = {*parts_->scene,
                                  rays,
                                  world,
                                  *parts_->materials,
                                  sky,
                                  weathering,
                                  parts_->plain,
                                  style,
                                  except_agent,
                                  static_cast<float>(1.0 / model.fx_px)};
  const Film film(sky.exposure());
  const Vector3f eye_m = map_from_optical.translation().cast<float>();
  const Eigen::Matrix3f map_from_camera = map_from_optical.linear().cast<float>();

  frame->colour.resize(3 * lens->directions.size());
  // Tiles of 4 x 4 pixels are the packets in which rays are traced.
  constexpr int kTile = 4;
  constexpr int kStripsAtATime = 8;  // the ground takes a tenth of the time that crowns take
  const int strips = (model.height + kTile - 1) / kTile;
  ParallelInPieces(strips, kStripsAtATime, parts_->threads, [&](int begin, int end) {
    CameraStrip strip(view);
    std::vector<int> pixels;
    for (int number = begin; number < end; ++number) {
      pixels.clear();
      const int last_row = std::min(model.height, kTile * (number + 1));
      for (int left = 0; left < model.width; left += kTile) {
        for (int v = kTile * number; v < last_row; ++v) {
          for (int u = left; u < std::min(model.width, left + kTile); ++u) {
            pixels.push_back(v * model.width + u);
          }
        }
      }
      strip.Begin(eye_m);
      for (const int pixel : pixels) {
        strip.Add(
            (map_from_camera * lens->directions[static_cast<std::size_t>(pixel)]).normalized());
      }
      const std::vector<Light>& lights = strip.Look();
      for (std::size_t i = 0; i < pixels.size(); ++i) {
        film.Expose(lights[i], &frame->colour[3 * static_cast<std::size_t>(pixels[i])]);
      }
    }
  });
  DrawPrecipitation(world, model, sky, map_from_optical, &frame->colour);
}

}  // namespace latticeworld
