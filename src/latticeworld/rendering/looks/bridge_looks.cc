#include "latticeworld/rendering/looks/bridge_looks.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "latticeworld/rendering/looks/body_looks.h"
#include "latticeworld/rendering/looks/bridge_colors.h"
#include "latticeworld/rendering/looks/picture_style.h"
#include "latticeworld/rendering/ray/ray_noise.h"

namespace latticeworld {
namespace {

// Returns how far along the bridge's line the point lies [m], by the piece of the line that is
// nearest to it.
float AlongBridge(const Bridge& bridge, const Eigen::Vector3f& point_m) {
  double nearest_m = std::numeric_limits<double>::infinity(), along_m = 0.0, passed_m = 0.0;
  for (std::size_t i = 0; i + 1 < bridge.line.size(); ++i) {
    const WorldPoint from = bridge.line[i], to = bridge.line[i + 1];
    const double length_m = std::hypot(to.x_m - from.x_m, to.y_m - from.y_m);
    const double ux = (to.x_m - from.x_m) / length_m, uy = (to.y_m - from.y_m) / length_m;
    const double dx = point_m.x() - from.x_m, dy = point_m.y() - from.y_m;
    const double t = ux * dx + uy * dy;
    const double beyond_m = std::max({-t, t - length_m, 0.0});
    const double away_m = std::hypot(beyond_m, ux * dy - uy * dx);
    if (away_m < nearest_m) {
      nearest_m = away_m;
      along_m = passed_m + t;
    }
    passed_m += length_m;
  }
  return static_cast<float>(along_m);
}

float Draw(float a, float b, std::uint32_t salt) {
  return UnitHash(static_cast<std::uint32_t>(static_cast<int>(a) + 4096),
                  static_cast<std::uint32_t>(static_cast<int>(b) + 4096), salt);
}

// Courses of stone with joints between them, every other one shifted by half a stone.
float StoneCourses(float along_m, float up_m, float footprint_m) {
  constexpr float kLength_m = 0.7f, kHeight_m = 0.35f, kJoint_m = 0.02f;
  if (footprint_m > 0.5f * kHeight_m) return 1.0f;
  const float course = std::floor(up_m / kHeight_m);
  const float place = along_m / kLength_m + (std::fmod(course, 2.0f) == 0.0f ? 0.0f : 0.5f);
  const float stone = std::floor(place);
  const float beside_m = std::min(place - stone, 1.0f - (place - stone)) * kLength_m;
  const float above = up_m / kHeight_m - course;
  const float over_m = std::min(above, 1.0f - above) * kHeight_m;
  const float shade = 0.86f + 0.28f * Draw(stone, course, 601);
  return std::min(beside_m, over_m) < kJoint_m ? 0.6f * shade : shade;
}

float Planks(float along_m, float footprint_m) {
  constexpr float kPlank_m = 0.2f, kJoint_m = 0.01f;
  if (footprint_m > 0.5f * kPlank_m) return 1.0f;
  const float place = along_m / kPlank_m, board = std::floor(place);
  const float beside_m = std::min(place - board, 1.0f - (place - board)) * kPlank_m;
  return (beside_m < kJoint_m ? 0.5f : 1.0f) * (0.9f + 0.2f * Draw(board, 0.0f, 602));
}

}  // namespace

Rgb RgbOfBridge(BridgeKind kind, BridgePartKind part, bool top) {
  const bool carries = top && part == BridgePartKind::kDeck;
  switch (kind) {
    case BridgeKind::kPlank:
      return carries ? Rgb{150, 118, 82} : Rgb{112, 86, 60};
    case BridgeKind::kStoneArch:
      return carries ? Rgb{150, 142, 128} : Rgb{168, 156, 134};
    case BridgeKind::kGirder:
      break;
  }
  if (part == BridgePartKind::kRailing) return Rgb{116, 122, 128};
  return carries ? Rgb{112, 110, 108} : Rgb{176, 174, 168};
}

Color ColorOfBridge(BridgeKind kind, BridgePartKind part, bool top) {
  const Rgb rgb = RgbOfBridge(kind, part, top);
  return FromRgb(rgb.r, rgb.g, rgb.b);
}

SurfaceLook LookOfBridge(const Bridge& bridge, ArtisticStyle style, const RayHit& hit,
                         const Eigen::Vector3f& point_m, float footprint_m) {
  const auto part = static_cast<BridgePartKind>(hit.part);
  const bool top = hit.normal.z() > 0.5f;
  Color color = ColorOfBridge(bridge.kind, part, top);
  const float along_m = AlongBridge(bridge, point_m);
  const bool upright = std::abs(hit.normal.z()) < 0.5f;
  if (bridge.kind == BridgeKind::kPlank && part == BridgePartKind::kDeck)
    color *= Planks(along_m, footprint_m);
  if (bridge.kind == BridgeKind::kStoneArch && upright)
    color *= StoneCourses(along_m, point_m.z(), footprint_m);
  // Upright faces are stained from above, level ones all over.
  color *=
      1.0f +
      0.12f * (upright ? DetailNoise(along_m, 0.25f * point_m.z(), 0.9f, 4, 0.6f, footprint_m, 603)
                       : DetailNoise(point_m.x(), point_m.y(), 0.9f, 4, 0.6f, footprint_m, 603));
  // Wet stone and weed where the water stands.
  const float above_m = point_m.z() - static_cast<float>(bridge.water_level_m);
  if (upright && above_m < 0.3f) color *= 0.7f;
  SurfaceLook look;
  look.normal = hit.normal;
  look.albedo = LightOf(InStyle(style, color));
  return look;
}

}  // namespace latticeworld
