#include "latticeworld/mapping/prop_boxes.h"

#include <algorithm>
#include <cmath>

namespace latticeworld {
namespace {

MappedAsset BoxFrom(const Footprint& footprint, double bottom_m, double top_m,
                    double least_half_m) {
  MappedAsset mapped;
  Asset& box = mapped.asset;
  box.kind = AssetKind::kBuilding;
  box.x_m = static_cast<float>(footprint.centre.x_m);
  box.y_m = static_cast<float>(footprint.centre.y_m);
  box.z_m = static_cast<float>(bottom_m);
  box.yaw_rad = static_cast<float>(footprint.yaw_rad);
  box.height_m = static_cast<float>(top_m - bottom_m);
  box.half_length_m = static_cast<float>(std::max(footprint.half_length_m, least_half_m));
  box.half_width_m = static_cast<float>(std::max(footprint.half_width_m, least_half_m));
  return mapped;
}

}  // namespace

MappedAsset BoxOf(const PropBlock& block, double least_half_m) {
  MappedAsset mapped = BoxFrom(block.footprint, block.bottom_m, block.top_m, least_half_m);
  mapped.hangs = block.hangs;
  return mapped;
}

MappedAsset BoxOf(const PropDeck& deck, double least_half_m) {
  MappedAsset mapped = BoxFrom(deck.footprint, deck.bottom_m, deck.top_m, least_half_m);
  mapped.hangs = true;
  return mapped;
}

double LeastHalfOf(const RobotLimits& limits, double resolution_m) {
  return std::max(0.0, 0.5 * resolution_m - limits.radius_m);
}

bool IsInTheWay(const PropBlock& block, const RobotLimits& limits, double ground_m) {
  if (!block.hangs || limits.clearance_m <= 0.0 || block.carries_kg >= limits.mass_kg) return true;
  return block.bottom_m - ground_m < limits.clearance_m;
}

DeckEffect EffectOf(const PropDeck& deck, const RobotLimits& limits, double cell_m,
                    WorldPoint point, double ground_m) {
  const Footprint& footprint = deck.footprint;
  const double dx = point.x_m - footprint.centre.x_m, dy = point.y_m - footprint.centre.y_m;
  const double cosine = std::cos(footprint.yaw_rad), sine = std::sin(footprint.yaw_rad);
  const double along_m = std::abs(cosine * dx + sine * dy) - footprint.half_length_m;
  const double across_m = std::abs(-sine * dx + cosine * dy);
  const double beside_m = across_m - footprint.half_width_m;
  if (along_m > 0.5 * cell_m || beside_m > limits.radius_m) return DeckEffect::kNone;
  // Who is not carried goes below where there is room.
  const bool carries = deck.carries_kg >= limits.mass_kg;
  if (!carries && limits.clearance_m > 0.0 && deck.bottom_m - ground_m >= limits.clearance_m)
    return DeckEffect::kNone;
  const bool bears = carries && footprint.half_width_m >= 0.5 * limits.radius_m;
  // Cells that the middle line crosses have their centres within half of their shadow on the
  // line's normal.
  const double strip_m = 0.5 * cell_m * (std::abs(cosine) + std::abs(sine));
  const double free_m =
      std::max(footprint.half_width_m - limits.radius_m, std::min(strip_m, footprint.half_width_m));
  if (bears && along_m <= 0.5 * cell_m && across_m <= free_m) return DeckEffect::kCarries;
  if (along_m > 0.0) return DeckEffect::kNone;
  const bool is_step = deck.top_m - ground_m <= limits.max_step_m;
  return bears && is_step ? DeckEffect::kNone : DeckEffect::kBlocks;
}

}  // namespace latticeworld
