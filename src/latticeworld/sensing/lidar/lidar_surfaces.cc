#include "latticeworld/sensing/lidar/lidar_surfaces.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include "latticeworld/meshes/mesh.h"
#include "latticeworld/scene/scene.h"
#include "latticeworld/sensing/solids/agent_body.h"

namespace latticeworld {
namespace {

// Reflectances of dry ground at 905 nm, by SurfaceClass, rounded from the ECOSTRESS spectral
// library (Meerdink et al. 2019): green grass, litter, soil with crops, bare loam, worn asphalt,
// concrete, granite, coarse snow, wet sand.
constexpr std::array<float, kSurfaceClassCount> kDryGround = {0.45f, 0.35f, 0.35f, 0.30f, 0.18f,
                                                              0.35f, 0.30f, 0.80f, 0.12f};
constexpr float kSnow = 0.80f;
// Snow so deep hides the ground (Wiscombe and Warren 1980: a few centimetres).
constexpr double kHidingSnow_m = 0.03;
// Wet through, soils and paving keep about 0.6 (Lekner and Dorf 1988; Lobell and Asner 2002).
constexpr double kWetShare = 0.6;
constexpr float kSand = 0.45f;

// Bodies by part: coats (cloth, fleece, hulls, paint), limbs, heads, lamps and eyes. Estimates.
constexpr std::array<float, kBodyPartCount> kBodies = {0.40f, 0.25f, 0.35f, 0.15f};
constexpr float kFleece = 0.65f;
constexpr float kWood = 0.50f;
constexpr float kStone = 0.30f;
// Panes let most through and mirror the rest away.
constexpr float kGlass = 0.08f;

// Fresnel's reflectance of water met at right angles (index of refraction 1.33).
constexpr float kWaterMirror = 0.02f;

// Returns the reflectance of the material that the environment has for a type; `otherwise` if it
// names none.
float MaterialOf(const Scene& scene, AssetType type, float otherwise) {
  const std::string& name = scene.environment.fine_of(type).material;
  for (const Material& material : scene.catalogue->materials(type)) {
    if (material.name == name) return static_cast<float>(material.reflectivity.lidar);
  }
  return otherwise;
}

float GroundOf(SurfaceClass surface, float dry, const Atmosphere& atmosphere) {
  const double wet = surface == SurfaceClass::kSnow || surface == SurfaceClass::kWaterBed
                         ? 1.0
                         : 1.0 - (1.0 - kWetShare) * atmosphere.ground_wetness;
  double reflectance = dry * wet;
  reflectance += (kSand - reflectance) * atmosphere.blown_sand;
  const double covered = std::min(1.0, atmosphere.snow_depth_m / kHidingSnow_m);
  return static_cast<float>(reflectance + (kSnow - reflectance) * covered);
}

// The lidar's reflectances of a list of values.
template <typename Values>
std::vector<float> ReflectancesOf(const Values& values) {
  std::vector<float> reflectances;
  reflectances.reserve(values.size());
  for (const auto& value : values) {
    reflectances.push_back(static_cast<float>(value.reflectivity.lidar));
  }
  return reflectances;
}

float At(const std::vector<float>& values, std::size_t index) {
  return index < values.size() ? values[index] : kStone;
}

// What a mirror of water sends back that is met straight from above, the most that it can.
float BrightestWater(float slope_variance) { return kWaterMirror / (4.0f * slope_variance); }

}  // namespace

LidarSurfaces::LidarSurfaces(std::shared_ptr<const Scene> scene) : scene_(std::move(scene)) {
  for (const auto& entry : EnumNames(AssetType{})) {
    const auto type = static_cast<std::size_t>(entry.value);
    seasonal_[type] = ReflectancesOf(scene_->catalogue->season_variants(entry.value));
    material_[type] = ReflectancesOf(scene_->catalogue->materials(entry.value));
  }
  // Materials of the other types are of what stands on the ground.
  dry_ground_ = kDryGround;
  const std::pair<SurfaceClass, AssetType> made_of[] = {
      {SurfaceClass::kRoad, AssetType::kRoad},
      {SurfaceClass::kBarren, AssetType::kDesert},
      {SurfaceClass::kSnow, AssetType::kSnowMountain}};
  for (const auto& [surface, type] : made_of) {
    float& dry = dry_ground_[static_cast<std::size_t>(surface)];
    dry = MaterialOf(*scene_, type, dry);
  }
  std::array<bool, kSurfaceClassCount> is_there = {};
  for (const SurfaceClass surface : scene_->terrain->surface)
    is_there[static_cast<std::size_t>(surface)] = true;
  for (const auto& entry : EnumNames(SurfaceClass{}))
    if (is_there[static_cast<std::size_t>(entry.value)]) grounds_.push_back(entry.value);
  const Grid<float>& level_m = scene_->terrain->water_level_m;
  has_water_ =
      std::any_of(level_m.begin(), level_m.end(), [](float level) { return !std::isnan(level); });
  for (const Asset& asset : scene_->assets) {
    const auto type = static_cast<std::size_t>(TypeOf(asset.kind));
    brightest_asset_ = std::max({brightest_asset_, At(seasonal_[type], asset.season_variant),
                                 At(material_[type], asset.material)});
  }
  SetWeather(scene_->atmosphere);
}

void LidarSurfaces::SetWeather(const Atmosphere& atmosphere) {
  for (const auto& entry : EnumNames(SurfaceClass{})) {
    const auto surface = static_cast<std::size_t>(entry.value);
    ground_[surface] = GroundOf(entry.value, dry_ground_[surface], atmosphere);
  }
  // Cox and Munk 1954.
  water_slope_variance_ =
      static_cast<float>(0.003 + 0.00512 * atmosphere.wind_mps.head<2>().norm());
  most_of_land_ = brightest_asset_;
  for (const SurfaceClass surface : grounds_)
    most_of_land_ = std::max(most_of_land_, ground_[static_cast<std::size_t>(surface)]);
  if (has_water_) most_of_land_ = std::max(most_of_land_, BrightestWater(water_slope_variance_));
}

float LidarSurfaces::MostReturned(const SensedWorld& world) const {
  float most = std::max(most_of_land_, *std::max_element(kBodies.begin(), kBodies.end()));
  if (!world.props.empty() || !scene_->terrain->bridges.empty())
    most = std::max({most, kWood, kStone});
  const bool has_sheep =
      std::any_of(world.agents.begin(), world.agents.end(),
                  [](const SensedAgent& agent) { return agent.category == AgentCategory::kSheep; });
  return has_sheep ? std::max(most, kFleece) : most;
}

float LidarSurfaces::Reflectance(const Ray& ray, const RayHit& hit,
                                 const SensedWorld& world) const {
  switch (hit.target) {
    case RayTarget::kGround: {
      const Eigen::Vector3f point = ray.origin_m + hit.distance_m * ray.direction;
      const SurfaceClass surface = scene_->terrain->SurfaceAt({point.x(), point.y()});
      return ground_[static_cast<std::size_t>(surface)];
    }
    case RayTarget::kAsset: {
      const Asset& asset = scene_->assets[hit.index];
      const auto type = static_cast<std::size_t>(TypeOf(asset.kind));
      const auto part = static_cast<MeshPart>(hit.part);
      if (part == MeshPart::kWindow) return kGlass;
      const bool grown = part == MeshPart::kLeaves || part == MeshPart::kBlossom;
      return grown ? At(seasonal_[type], asset.season_variant)
                   : At(material_[type], asset.material);
    }
    case RayTarget::kAgent: {
      const bool fleece = world.agents[hit.index].category == AgentCategory::kSheep;
      if (fleece && hit.part == static_cast<std::uint8_t>(BodyPart::kCoat)) return kFleece;
      return kBodies[hit.part % kBodyPartCount];
    }
    case RayTarget::kProp:
      return world.props[hit.index].kind == PropKind::kLooseStone ? kStone : kWood;
    case RayTarget::kBridge:
      return scene_->terrain->bridges[hit.index].kind == BridgeKind::kPlank ? kWood : kStone;
    case RayTarget::kWater:
    case RayTarget::kNothing:
      break;
  }
  return 0.0f;
}

float LidarSurfaces::Return(const Ray& ray, const RayHit& hit, const SensedWorld& world) const {
  const float cosine = std::min(1.0f, std::abs(hit.normal.dot(ray.direction)));
  if (hit.target == RayTarget::kWater) {
    // Facets of waves that face the sensor (Bufton, Hoge and Swift 1983): nothing comes back from
    // beyond some tens of degrees off the vertical.
    const float cos2 = std::max(cosine * cosine, 1e-6f);
    const float tan2 = (1.0f - cos2) / cos2;
    return BrightestWater(water_slope_variance_) / (cos2 * cos2) *
           std::exp(-tan2 / water_slope_variance_);
  }
  return cosine * Reflectance(ray, hit, world);
}

}  // namespace latticeworld
