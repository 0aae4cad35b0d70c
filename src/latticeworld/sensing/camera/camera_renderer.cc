#include "latticeworld/sensing/camera/camera_renderer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "latticeworld/common/parallel.h"
#include "latticeworld/common/random.h"
#include "latticeworld/scene/scene.h"
#include "latticeworld/sensing/counter_noise.h"

namespace latticeworld {
namespace {

constexpr int kTile = 4;
// A thread takes this many strips at a time: sky and ground take a tenth of the time that crowns
// take.
constexpr int kStripsAtATime = 8;
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
// Contrast that a matching of pictures needs, as the eye does (WMO-No. 8).
constexpr double kLeastContrast = 0.05;

constexpr std::uint32_t kAgentInstances = 0x40000000u;
constexpr std::uint32_t kPropInstances = 0x60000000u;
constexpr std::uint32_t kBridgeInstances = 0x20000000u;
constexpr std::uint32_t kInstanceHash = 0x1fffffffu;

std::uint32_t HashOf(std::string_view name) {
  return static_cast<std::uint32_t>(StreamSeed(0, name)) & kInstanceHash;
}

SensedClass ClassOf(AssetKind kind) {
  switch (kind) {
    case AssetKind::kTree:
      return SensedClass::kTree;
    case AssetKind::kStone:
      return SensedClass::kStone;
    case AssetKind::kBuilding:
      return SensedClass::kBuilding;
    case AssetKind::kBush:
    case AssetKind::kDeadBranch:
    case AssetKind::kGrassTuft:
    case AssetKind::kFlower:
    case AssetKind::kCrop:
      return SensedClass::kPlant;
  }
  return SensedClass::kPlant;
}

SensedClass ClassOf(const Scene& scene, const Ray& ray, const RayHit& hit) {
  switch (hit.target) {
    case RayTarget::kNothing:
      return SensedClass::kSky;
    case RayTarget::kWater:
      return SensedClass::kWater;
    case RayTarget::kAgent:
      return SensedClass::kAgent;
    case RayTarget::kProp:
      return SensedClass::kProp;
    case RayTarget::kBridge:
      return SensedClass::kBridge;
    case RayTarget::kAsset:
      return ClassOf(scene.assets[hit.index].kind);
    case RayTarget::kGround: {
      const Eigen::Vector3f point = ray.origin_m + hit.distance_m * ray.direction;
      const bool road = scene.terrain->SurfaceAt({point.x(), point.y()}) == SurfaceClass::kRoad;
      return road ? SensedClass::kRoad : SensedClass::kGround;
    }
  }
  return SensedClass::kSky;
}

std::uint32_t InstanceOf(const SensedWorld& world, const RayHit& hit) {
  if (hit.target == RayTarget::kAsset) return AssetInstance(hit.index);
  if (hit.target == RayTarget::kBridge) return kBridgeInstances | hit.index;
  if (hit.target == RayTarget::kAgent) return AgentInstance(world.agents[hit.index].name);
  if (hit.target == RayTarget::kProp) return PropInstance(world.props[hit.index].name);
  return 0;
}

// Distances and hits of a strip's pixels, in tiles; kept between strips.
struct Strip {
  std::vector<Ray> rays;
  std::vector<RayHit> hits;
  std::vector<float> distances_m;
  std::vector<float> cosines;         // of the rays to the optical axis
  std::vector<std::uint32_t> places;  // of their pixels
};

}  // namespace

std::uint32_t AssetInstance(std::uint32_t asset) { return asset + 1; }
std::uint32_t AgentInstance(std::string_view name) { return kAgentInstances | HashOf(name); }
std::uint32_t PropInstance(std::string_view name) { return kPropInstances | HashOf(name); }

CameraRenderer::CameraRenderer(const CameraModel& model) : model_(model) {
  if (std::all_of(model.distortion.begin(), model.distortion.end(),
                  [](double k) { return k == 0.0; })) {
    const auto fill = [](int count, double middle_px, double f_px, std::vector<float>* slopes) {
      for (int i = 0; i < count; ++i) slopes->push_back(static_cast<float>((i - middle_px) / f_px));
    };
    fill(model.width, model.cx_px, model.fx_px, &column_slopes_);
    fill(model.height, model.cy_px, model.fy_px, &row_slopes_);
    return;
  }
  distorted_.reserve(static_cast<std::size_t>(model.width) * model.height);
  for (int row = 0; row < model.height; ++row) {
    for (int col = 0; col < model.width; ++col) {
      const Eigen::Vector3d direction = DirectionOf(model, col, row);
      distorted_.push_back((direction.head<2>() / direction.z()).cast<float>());
    }
  }
}

Eigen::Vector3f CameraRenderer::Direction(int row, int col) const {
  if (distorted_.empty()) {
    return Eigen::Vector3f(column_slopes_[col], row_slopes_[row], 1.0f).normalized();
  }
  const Eigen::Vector2f& p = distorted_[static_cast<std::size_t>(row) * model_.width + col];
  return Eigen::Vector3f(p.x(), p.y(), 1.0f).normalized();
}

void CameraRenderer::RenderStrip(const CameraShot& shot, const CameraOutputs& outputs, int begin,
                                 int end, CameraFrame* frame) const {
  const Eigen::Matrix3f map_from_optical = shot.map_from_optical.linear().cast<float>();
  const Eigen::Vector3f origin_m = shot.map_from_optical.translation().cast<float>();
  const bool labels = outputs.class_labels || outputs.instance_labels;
  const auto far_m = static_cast<float>(model_.far_m), near_m = static_cast<float>(model_.near_m);
  // Beyond, the air leaves too little contrast.
  const auto seen_m =
      static_cast<float>(-std::log(kLeastContrast) / shot.conditions.extinction_per_m);
  const auto noise = static_cast<float>(model_.depth_noise);
  const auto depth_of = [&](float distance_m, float cosine, std::size_t place) {
    const float depth_m = distance_m * cosine;
    if (!(depth_m <= far_m)) return seen_m < far_m ? kNaN : kInfinity;
    if (distance_m > seen_m) return kNaN;
    if (depth_m < near_m) return -kInfinity;
    if (noise <= 0.0f) return depth_m;
    const float draw = NormalOf(CounterBits(shot.key, place));
    return std::clamp(depth_m + noise * depth_m * depth_m * draw, near_m, far_m);
  };

  // Rays of a row of square tiles are traced together.
  Strip strip;
  for (int top = begin; top < end; top += kTile) {
    strip.rays.clear();
    strip.cosines.clear();
    strip.places.clear();
    for (int left = 0; left < model_.width; left += kTile) {
      for (int row = top; row < std::min(top + kTile, end); ++row) {
        for (int col = left; col < std::min(left + kTile, model_.width); ++col) {
          const Eigen::Vector3f direction = Direction(row, col);
          Ray ray;
          ray.origin_m = origin_m;
          ray.direction = map_from_optical * direction;
          if (!labels) ray.to_m = far_m / direction.z();
          strip.rays.push_back(ray);
          strip.cosines.push_back(direction.z());
          strip.places.push_back(static_cast<std::uint32_t>(row * model_.width + col));
        }
      }
    }
    // Labels need whole hits, depth alone only distances.
    const std::size_t count = strip.rays.size();
    strip.distances_m.resize(count);
    if (labels) {
      strip.hits.resize(count);
      shot.scene->Trace(strip.rays.data(), count, kSeesAll, shot.except_agent, strip.hits.data());
      for (std::size_t i = 0; i < count; ++i) strip.distances_m[i] = strip.hits[i].distance_m;
    } else {
      shot.scene->TraceDistances(strip.rays.data(), count, kSeesAll, shot.except_agent,
                                 strip.distances_m.data());
    }
    // Each pixel gets what was asked for.
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t place = strip.places[i];
      if (outputs.depth) {
        frame->depth_m[place] = depth_of(strip.distances_m[i], strip.cosines[i], place);
      }
      if (outputs.class_labels) {
        frame->classes[place] =
            static_cast<std::uint8_t>(ClassOf(shot.scene->scene(), strip.rays[i], strip.hits[i]));
      }
      if (outputs.instance_labels) {
        frame->instances[place] = InstanceOf(*shot.world, strip.hits[i]);
      }
    }
  }
}

void CameraRenderer::Render(const CameraShot& shot, const CameraOutputs& outputs,
                            CameraFrame* frame) const {
  if (!outputs.depth && !outputs.class_labels && !outputs.instance_labels) return;
  const std::size_t pixels = static_cast<std::size_t>(model_.width) * model_.height;
  if (outputs.depth) frame->depth_m.resize(pixels);
  if (outputs.class_labels) frame->classes.resize(pixels);
  if (outputs.instance_labels) frame->instances.resize(pixels);
  const int strips = (model_.height + kTile - 1) / kTile;
  ParallelInPieces(strips, kStripsAtATime, std::max(1, shot.threads), [&](int begin, int end) {
    RenderStrip(shot, outputs, begin * kTile, std::min(end * kTile, model_.height), frame);
  });
}

void AddColourNoise(const CameraModel& model, std::uint64_t key, CameraFrame* frame) {
  if (model.colour_noise <= 0.0) return;
  const auto noise = static_cast<float>(model.colour_noise);
  for (std::size_t i = 0; i < frame->colour.size(); ++i) {
    const float value =
        static_cast<float>(frame->colour[i]) + noise * NormalOf(CounterBits(key, i));
    frame->colour[i] = static_cast<std::uint8_t>(std::clamp(std::round(value), 0.0f, 255.0f));
  }
}

}  // namespace latticeworld
