#include "latticeworld/rendering/ray/ray_materials.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/common/parallel.h"
#include "latticeworld/rendering/looks/asset_looks.h"
#include "latticeworld/rendering/looks/body_looks.h"
#include "latticeworld/rendering/looks/bridge_looks.h"
#include "latticeworld/rendering/looks/ground_colors.h"
#include "latticeworld/rendering/looks/picture_style.h"
#include "latticeworld/rendering/ray/lamp_lights.h"
#include "latticeworld/rendering/ray/ray_noise.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {
namespace {

using Eigen::Vector3f;

const Light kSnow(.84f, .88f, .94f);
constexpr float kDeepSnow_m = 0.1f;  // from which on it covers all

std::uint8_t ByteOf(float value) {
  return static_cast<std::uint8_t>(std::lround(255.0f * std::clamp(value, 0.0f, 1.0f)));
}

// How much noise ground has close by, of patches, tufts and grains.
struct Texture {
  float coarse, fine, bump;
};
Texture TextureOf(SurfaceClass surface) {
  switch (surface) {
    case SurfaceClass::kGrass:
    case SurfaceClass::kBuilding:
      return {0.20f, 0.42f, 0.35f};
    case SurfaceClass::kForestFloor:
      return {0.22f, 0.40f, 0.35f};
    case SurfaceClass::kFarmland:
      return {0.14f, 0.34f, 0.40f};
    case SurfaceClass::kBarren:
    case SurfaceClass::kWaterBed:
      return {0.10f, 0.18f, 0.18f};
    case SurfaceClass::kRock:
      return {0.20f, 0.26f, 0.55f};
    case SurfaceClass::kRoad:
      return {0.06f, 0.14f, 0.06f};
    case SurfaceClass::kSnow:
      return {0.03f, 0.03f, 0.12f};
  }
  return {};
}

}  // namespace

RayMaterials::RayMaterials(const Scene& scene, const GroundMaterials& ground,
                           const std::vector<Asset>& assets, bool lamps_are_lit, float relief)
    : scene_(scene), assets_(assets), lamps_are_lit_(lamps_are_lit), relief_(relief) {
  for (std::size_t i = 0; i < linear_.size(); ++i)
    linear_[i] = ToLinear(static_cast<float>(i) / 255.0f);
  snow_ = static_cast<float>(std::clamp(scene.atmosphere.snow_depth_m / kDeepSnow_m, 0.0, 1.0));

  const int rows = ground.color.rows, cols = ground.color.cols;
  ground_color_ = Grid<std::array<float, 3>>(rows, cols);
  ParallelFor(rows, 0, [&](int begin, int end) {
    for (int row = begin; row < end; ++row) {
      const Color* in = ground.color.ptr<Color>(row);
      std::array<float, 3>* out = ground_color_.row(row);
      for (int col = 0; col < cols; ++col) {
        for (int channel = 0; channel < 3; ++channel)
          out[col][channel] = linear_[ByteOf(in[col][2 - channel])];
      }
    }
  });

  asset_colors_.resize(assets.size());
  ParallelFor(static_cast<int>(assets.size()), 0, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) asset_colors_[i] = PartColors(scene, assets[i]);
  });

  const CoarseAttributes& coarse = scene.environment.coarse;
  const bool cyberpunk = coarse.artistic_style == ArtisticStyle::kCyberpunk;
  const bool cartoon = coarse.artistic_style == ArtisticStyle::kCartoon;
  water_scatter_ = cyberpunk ? Light(.03f, .05f, .13f)
                   : cartoon ? Light(.02f, .22f, .42f)
                             : Light(.010f, .036f, .044f);
  water_extinction_pm_ = Light(.85f, .38f, .32f);
  if (coarse.season == Season::kWinter && scene.atmosphere.snow_depth_m > 0.0) ice_ = 0.8f;
  ice_albedo_ = LightOf(InStyle(coarse.artistic_style, FromRgb(196, 214, 224)));
}

Light RayMaterials::LinearOf(const Rgb& color) const {
  return {linear_[color.r], linear_[color.g], linear_[color.b]};
}

Light RayMaterials::GroundColorAt(float x_m, float y_m) const {
  const GridGeometry& geometry = scene_.geometry();
  const float col =
      std::clamp(static_cast<float>(geometry.ColOf(x_m)), 0.0f, geometry.cols() - 1.001f);
  const float row =
      std::clamp(static_cast<float>(geometry.RowOf(y_m)), 0.0f, geometry.rows() - 1.001f);
  const int west = static_cast<int>(col), north = static_cast<int>(row);
  const float u = col - static_cast<float>(west), v = row - static_cast<float>(north);
  return (CellColor(north, west) * (1 - u) + CellColor(north, west + 1) * u) * (1 - v) +
         (CellColor(north + 1, west) * (1 - u) + CellColor(north + 1, west + 1) * u) * v;
}

SurfaceLook RayMaterials::Ground(const Vector3f& point_m, float footprint_m) const {
  const GridGeometry& geometry = scene_.geometry();
  const float cell_m = static_cast<float>(geometry.resolution_m());
  float x_m = point_m.x(), y_m = point_m.y();
  // Close by, borders of cells would be seen: they are frayed.
  if (footprint_m < 0.5f * cell_m) {
    x_m += 0.45f * cell_m * DetailNoise(x_m, y_m, 0.9f * cell_m, 3, 0.6f, footprint_m, 311);
    y_m += 0.45f * cell_m * DetailNoise(x_m, y_m, 0.9f * cell_m, 3, 0.6f, footprint_m, 315);
  }
  const float col =
      std::clamp(static_cast<float>(geometry.ColOf(x_m)), 0.0f, geometry.cols() - 1.001f);
  const float row =
      std::clamp(static_cast<float>(geometry.RowOf(y_m)), 0.0f, geometry.rows() - 1.001f);
  const int west = static_cast<int>(col), north = static_cast<int>(row);
  const float u = col - west, v = row - north;
  SurfaceLook look;
  look.albedo = GroundColorAt(x_m, y_m);

  // Normals of the cells, evenly between them.
  const Grid<float>& height_m = scene_.terrain->ground.height_m();
  const auto slope = [&](int r, int c) -> Eigen::Vector2f {
    return Eigen::Vector2f(height_m.Clamped(r, c + 1) - height_m.Clamped(r, c - 1),
                           height_m.Clamped(r - 1, c) - height_m.Clamped(r + 1, c)) /
           (2.0f * cell_m);
  };
  Eigen::Vector2f dz = (slope(north, west) * (1 - u) + slope(north, west + 1) * u) * (1 - v) +
                       (slope(north + 1, west) * (1 - u) + slope(north + 1, west + 1) * u) * v;

  dz *= relief_;

  // Close by, the ground has a texture by its class, and by the snow on it.
  if (footprint_m < 1.2f) {
    const SurfaceClass surface =
        scene_.terrain->surface(north + (v > 0.5f ? 1 : 0), west + (u > 0.5f ? 1 : 0));
    Texture texture = TextureOf(surface);
    if (snow_ > 0.0f) {
      const Texture snow = TextureOf(SurfaceClass::kSnow);
      const float white = std::clamp(2.2f * (look.albedo.minCoeff() - 0.25f), 0.0f, 1.0f);
      texture.coarse += white * (snow.coarse - texture.coarse);
      texture.fine += white * (snow.fine - texture.fine);
      texture.bump += white * (snow.bump - texture.bump);
    }
    const float coarse = DetailNoise(point_m.x(), point_m.y(), 1.7f, 3, 0.6f, footprint_m, 321);
    const float fine = DetailNoise(point_m.x(), point_m.y(), 0.16f, 4, 0.75f, footprint_m, 331);
    look.albedo *= std::max(0.25f, 1.0f + texture.coarse * coarse + texture.fine * fine);
    // Closer still it has bumps.
    if (footprint_m < 0.05f) {
      constexpr float kStep_m = 0.012f;
      const auto bump_at = [&](float dx, float dy) {
        return DetailNoise(point_m.x() + dx, point_m.y() + dy, 0.16f, 3, 0.7f, footprint_m, 331);
      };
      const float here = bump_at(0.0f, 0.0f);
      const Eigen::Vector2f bump =
          Eigen::Vector2f(bump_at(kStep_m, 0.0f) - here, bump_at(0.0f, kStep_m) - here) *
          (0.03f * texture.bump / kStep_m);
      dz += bump;
    }
  }
  look.normal = Vector3f(-dz.x(), -dz.y(), 1.0f).normalized();
  return look;
}

void RayMaterials::SetWindow(const Asset& asset, const Vector3f& point_m, const RayHit& hit,
                             SurfaceLook* look) const {
  look->mirror = 0.35f;
  look->albedo *= 0.5f;
  // What lies flat is water or a skylight.
  if (!lamps_are_lit_ || std::abs(hit.normal.z()) > 0.7f) return;
  if (scene_.catalogue->models()[asset.model].name == kLampModel) {
    look->emission = 1.6f * LampColor(scene_.environment.coarse.artistic_style, asset);
    return;
  }
  // One lamp behind what lies about two metres and a storey apart on one side of the house.
  const float c = std::cos(asset.yaw_rad), s = std::sin(asset.yaw_rad);
  const float dx = point_m.x() - asset.x_m, dy = point_m.y() - asset.y_m;
  const float along = c * dx + s * dy, across = c * dy - s * dx;
  const float facing = c * hit.normal.x() + s * hit.normal.y();
  const bool front = std::abs(facing) > 0.7f;
  const auto side =
      static_cast<std::uint32_t>(front ? (facing > 0.0f ? 1 : 2) : (across > 0.0f ? 3 : 4));
  const auto place = static_cast<std::uint32_t>(
      static_cast<std::int32_t>(std::floor((front ? across : along) / 2.2f)) + 64);
  const auto storey =
      static_cast<std::uint32_t>(std::max(0.0f, std::floor((point_m.z() - asset.z_m) / 2.9f)));
  const std::uint32_t window = HashOf(hit.index, place * 8u + side, storey);
  const float draw = UnitHash(window, 1, 341);
  const bool cyberpunk = scene_.environment.coarse.artistic_style == ArtisticStyle::kCyberpunk;
  if (draw > (cyberpunk ? 0.5f : 0.62f)) return;
  const Light lamp =
      LightOf(WindowLight(scene_.environment.coarse.artistic_style, UnitHash(window, 2, 342)));
  look->emission = lamp * (cyberpunk ? 0.4f : 0.75f + 0.5f * UnitHash(window, 3, 343));
}

SurfaceLook RayMaterials::BridgeAt(const RayHit& hit, const Vector3f& point_m,
                                   float footprint_m) const {
  SurfaceLook look =
      LookOfBridge(scene_.terrain->bridges[hit.index], scene_.environment.coarse.artistic_style,
                   hit, point_m, footprint_m);
  const float lies = std::clamp(2.2f * (hit.normal.z() - 0.25f), 0.0f, 1.0f);
  // Decks are driven on, as roads are.
  const bool deck = hit.part == static_cast<std::uint8_t>(BridgePartKind::kDeck);
  look.albedo = Blend(look.albedo, kSnow, (deck ? 0.5f : 0.95f) * snow_ * lies);
  return look;
}

SurfaceLook RayMaterials::AssetAt(const RayHit& hit, const Vector3f& point_m,
                                  float footprint_m) const {
  const Asset& asset = assets_[hit.index];
  const auto part = static_cast<MeshPart>(hit.part);
  SurfaceLook look;
  look.normal = hit.normal;
  look.albedo = LinearOf(asset_colors_[hit.index][hit.part]);

  const SeasonVariant& variant =
      scene_.catalogue->season_variants(TypeOf(asset.kind))[asset.season_variant];
  float snow = std::max(static_cast<float>(variant.snow), snow_);
  switch (part) {
    case MeshPart::kLeaves: {
      look.translucency = 0.35f;
      const bool crown = asset.kind == AssetKind::kTree || asset.kind == AssetKind::kBush;
      if (crown) {
        // The crown as a whole catches light like a round thing; its leaves vary it.
        const Vector3f out((point_m.x() - asset.x_m) / asset.half_length_m,
                           (point_m.y() - asset.y_m) / asset.half_width_m,
                           (point_m.z() - asset.z_m) / (0.55f * asset.height_m) - 0.9f);
        look.normal = (0.45f * hit.normal + 0.8f * out.normalized()).normalized();
        snow *= 0.75f;
      } else {
        look.normal = (0.5f * hit.normal + Vector3f(0.0f, 0.0f, 0.8f)).normalized();
        snow *= 0.5f;
        // Grass is of the meadow that it stands in.
        if (asset.kind == AssetKind::kGrassTuft)
          look.albedo = Blend(look.albedo, 1.15f * GroundColorAt(asset.x_m, asset.y_m), 0.6f);
      }
      const float size_m = crown ? 0.5f : 0.08f;
      look.albedo *= 1.0f + 0.22f * DetailNoise(point_m.x() + 0.7f * point_m.z(),
                                                point_m.y() - 0.6f * point_m.z(), size_m, 3, 0.7f,
                                                footprint_m, 351);
      break;
    }
    case MeshPart::kBark:
      snow *= 0.5f;
      look.albedo *=
          1.0f + 0.25f * DetailNoise(6.0f * point_m.x() + 5.0f * point_m.y(), point_m.z(), 0.4f, 3,
                                     0.7f, 3.0f * footprint_m, 355);
      break;
    case MeshPart::kStone:
      look.albedo *= 1.0f + 0.24f * DetailNoise(point_m.x() + 0.8f * point_m.z(),
                                                point_m.y() + 0.6f * point_m.z(), 0.8f, 4, 0.5f,
                                                2.0f * footprint_m, 361);
      break;
    case MeshPart::kWindow:
      SetWindow(asset, point_m, hit, &look);
      break;
    case MeshPart::kRoof:
      look.albedo *=
          1.0f + 0.14f * DetailNoise(point_m.x(), point_m.y(), 0.35f, 3, 0.7f, footprint_m, 371);
      break;
    case MeshPart::kWall:
      look.albedo *= 1.0f + 0.07f * DetailNoise(point_m.x() + point_m.y(), point_m.z(), 1.2f, 4,
                                                0.6f, footprint_m, 381);
      break;
    case MeshPart::kBlossom:
      look.translucency = 0.3f;
      break;
    case MeshPart::kDoor:
    case MeshPart::kTrim:
      break;
  }
  if (snow > 0.0f) {
    const float lies = std::clamp(2.2f * (hit.normal.z() - 0.25f), 0.0f, 1.0f);
    look.albedo = Blend(look.albedo, kSnow, 0.95f * snow * lies);
  }
  return look;
}

SurfaceLook RayMaterials::AgentAt(const RayHit& hit) const {
  return LookOfBody(scene_.agents[hit.index].category, scene_.environment.coarse.artistic_style,
                    hit);
}

SurfaceLook RayMaterials::EarthAt(const Vector3f& point_m, const Vector3f& normal, float below_m,
                                  float block_m) const {
  const float depth = below_m / block_m;
  const float across_m = point_m.x() + point_m.y();
  Color color = FromRgb(92, 70, 50);
  if (depth > 0.07f) {
    const float wave = 1.6f * ValueNoise(across_m / (1.6f * block_m), 0.0f, 391) + 4.0f * depth;
    const float layer =
        std::sin(22.0f * depth + 1.4f * wave) + 0.6f * std::sin(57.0f * depth + wave);
    color = FromRgb(150, 124, 98) * (1.0f + 0.07f * layer - 0.22f * std::min(1.0f, depth));
  }
  color *= 1.0f + 0.08f * DetailNoise(across_m, point_m.z(), 0.25f * block_m, 5, 0.6f,
                                      0.002f * block_m, 395);
  SurfaceLook look;
  look.normal = normal;
  look.albedo = LightOf(InStyle(scene_.environment.coarse.artistic_style, color));
  return look;
}

}  // namespace latticeworld
