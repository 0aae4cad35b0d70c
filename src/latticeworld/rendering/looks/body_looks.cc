#include "latticeworld/rendering/looks/body_looks.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "latticeworld/rendering/looks/asset_looks.h"
#include "latticeworld/rendering/looks/picture_style.h"
#include "latticeworld/rendering/ray/ray_noise.h"
#include "latticeworld/sensing/solids/agent_body.h"

namespace latticeworld {

Light LightOf(const Color& bgr) { return {ToLinear(bgr[2]), ToLinear(bgr[1]), ToLinear(bgr[0])}; }

SurfaceLook LookOfBody(AgentCategory category, ArtisticStyle style, const RayHit& hit) {
  const auto part = static_cast<BodyPart>(hit.part);
  Color color = AgentColor(category);
  switch (category) {
    case AgentCategory::kSheep:
      color = part == BodyPart::kCoat ? FromRgb(232, 226, 210) : FromRgb(64, 56, 52);
      break;
    case AgentCategory::kHorse:
      color = part == BodyPart::kCoat || part == BodyPart::kHead ? FromRgb(122, 74, 42)
                                                                 : FromRgb(52, 36, 28);
      break;
    case AgentCategory::kEagle:
      color = part == BodyPart::kHead ? FromRgb(238, 234, 222) : FromRgb(74, 54, 40);
      break;
    case AgentCategory::kWhale:
      color = FromRgb(66, 78, 96);
      break;
    case AgentCategory::kAncientWarrior:
      color = part == BodyPart::kHead     ? FromRgb(196, 160, 96)
              : part == BodyPart::kDetail ? FromRgb(150, 104, 52)
                                          : Mix(color, FromRgb(90, 60, 50), 0.35f);
      break;
    case AgentCategory::kGoblin:
      if (part == BodyPart::kCoat) color = FromRgb(110, 82, 52);
      break;
    case AgentCategory::kHumanoidRobot:
    case AgentCategory::kRoboticDog:
    case AgentCategory::kAerialRobot:
    case AgentCategory::kWheeledRobot:
      if (part == BodyPart::kLimb) color = FromRgb(48, 50, 56);
      if (part == BodyPart::kDetail) color = FromRgb(30, 32, 38);
      break;
  }
  SurfaceLook look;
  look.normal = hit.normal;
  look.albedo = LightOf(InStyle(style, color));
  return look;
}

SurfaceLook LookOfProp(PropKind kind, ArtisticStyle style, const RayHit& hit,
                       const Eigen::Vector3f& in_prop_m, float footprint_m) {
  Color color = FromRgb(168, 124, 76);  // sawn wood
  float plank_m = 0.14f;
  Eigen::Vector3f across = in_prop_m;
  switch (kind) {
    case PropKind::kCrate:
      across.x() = in_prop_m.z();
      break;
    case PropKind::kBridge:
      color = FromRgb(132, 104, 74);
      break;
    case PropKind::kGate:
      color = FromRgb(142, 98, 58);
      break;
    case PropKind::kPost:
      color = FromRgb(120, 96, 70);
      plank_m = 0.0f;
      break;
    case PropKind::kLooseStone:
      color = FromRgb(140, 134, 126);
      plank_m = 0.0f;
      break;
  }
  const bool is_wood = kind != PropKind::kLooseStone;
  color *= 1.0f + (is_wood ? 0.10f : 0.22f) *
                      DetailNoise((is_wood ? 9.0f : 1.0f) * (in_prop_m.x() + in_prop_m.z()),
                                  in_prop_m.y() - in_prop_m.z(), 0.3f, 4, 0.6f, footprint_m, 397);
  if (plank_m > 0.0f && footprint_m < 0.5f * plank_m) {
    // Planks of slightly different boards, with dark joints.
    const float place = across.x() / plank_m;
    const float board = std::floor(place), within = place - board;
    color *= 0.92f + 0.16f * UnitHash(static_cast<std::uint32_t>(static_cast<int>(board) + 512),
                                      hit.index, 398);
    if (std::min(within, 1.0f - within) * plank_m < 0.008f) color *= 0.55f;
  }
  SurfaceLook look;
  look.normal = hit.normal;
  look.albedo = LightOf(InStyle(style, color));
  return look;
}

}  // namespace latticeworld
