#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "latticeworld/simulation/props/prop_body.h"
#include "latticeworld/simulation/props/props.h"

namespace latticeworld {
namespace {

// Slower than this it stands still: what stands on a bridge never rests for the physics.
constexpr double kStill_mps = 0.02, kStill_radps = 0.05;

// How far the corner of one that is farthest from all corners of the other is from them [m].
double FarthestCorner(const Footprint& from, const Footprint& to) {
  double farthest_m = 0.0;
  for (const WorldPoint& corner : from.Corners()) {
    double nearest_m = std::numeric_limits<double>::infinity();
    for (const WorldPoint& other : to.Corners()) {
      nearest_m = std::min(nearest_m, std::hypot(corner.x_m - other.x_m, corner.y_m - other.y_m));
    }
    farthest_m = std::max(farthest_m, nearest_m);
  }
  return farthest_m;
}

bool HasMoved(const std::optional<PropBlock>& before, const std::optional<PropBlock>& after,
              double least_m) {
  if (before.has_value() != after.has_value()) return true;
  if (!before) return false;
  return FarthestCorner(before->footprint, after->footprint) > least_m ||
         FarthestCorner(after->footprint, before->footprint) > least_m ||
         std::abs(after->top_m - before->top_m) > least_m;
}

}  // namespace

bool Props::Follow() {
  const double least_m = 0.5 * scene_.geometry().resolution_m();
  bool moved = false;
  for (auto& [name, running] : state_) {
    if (running.broken || running.prop.kind == PropKind::kBridge) continue;
    const BodyMotion motion = physics_->MotionOf(running.body);
    const bool rests = physics_->IsResting(running.body);
    if (rests && running.open == running.open_on_maps && running.looked_at &&
        motion.position_m == running.looked_at->position_m &&
        motion.orientation.coeffs() == running.looked_at->orientation.coeffs()) {
      continue;
    }
    running.looked_at = motion;
    const bool still = motion.linear_velocity_mps.norm() < kStill_mps &&
                       motion.angular_velocity_radps.norm() < kStill_radps;
    if (!still && !rests) continue;
    const BodyMotion pose = PropPoseOf(running.prop, motion);
    const std::optional<PropBlock> now = BlockOf(running.prop, pose.position_m, pose.orientation);
    if (running.open == running.open_on_maps && !HasMoved(running.on_maps, now, least_m)) continue;
    running.on_maps = now;
    running.open_on_maps = running.open;
    moved = true;
  }
  if (moved) ListStanding();
  return moved;
}

void Props::ListStanding() {
  auto standing = std::make_shared<StandingProps>();
  for (const auto& [name, running] : state_) {
    if (running.on_maps) standing->blocks.push_back(*running.on_maps);
    if (running.prop.kind == PropKind::kBridge && !running.broken) {
      standing->decks.push_back(DeckOf(running.prop));
    }
  }
  AddBridges(*scene_.terrain, standing.get());
  is_as_begun_ = *standing == StandingAtBegin(scene_);
  standing_ = std::move(standing);
}

}  // namespace latticeworld
