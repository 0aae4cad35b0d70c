#include "latticeworld/simulation/ode/ode_bodies.h"

#include <algorithm>
#include <utility>

#include "latticeworld/common/check.h"

namespace latticeworld {
namespace {

constexpr double kWakingReach_m = 0.05;

}  // namespace

std::size_t OdeBodies::IndexOf(BodyId id) const {
  const auto found =
      std::lower_bound(entries_.begin(), entries_.end(), id,
                       [](const Entry& entry, BodyId key) { return entry.id < key; });
  LW_CHECK(found != entries_.end() && found->id == id, "no such body");
  return static_cast<std::size_t>(found - entries_.begin());
}

OdeBody* OdeBodies::Add(BodyId id, std::shared_ptr<const BodySpec> spec, const GroupPlace& place) {
  Entry& entry = entries_.emplace_back();
  entry.id = id;
  entry.body = std::make_unique<OdeBody>(place.world, id, std::move(spec));
  entry.group = place.group;
  OdeBody* body = entry.body.get();
  if (body->ball_radius_m() >= 0.0) sweep_.Add(body);
  return body;
}

void OdeBodies::Remove(BodyId id) {
  const std::size_t index = IndexOf(id);
  sweep_.Remove(entries_[index].body.get());
  entries_.erase(entries_.begin() + static_cast<std::ptrdiff_t>(index));
}

void OdeBodies::Clear() {
  sweep_.Clear();
  entries_.clear();
}

void OdeBodies::Move(std::size_t index, const GroupPlace& place) {
  entries_[index].group = place.group;
  entries_[index].body->MoveTo(place.world);
}

void OdeBodies::WakeNear(const Bounds& bounds) {
  for (Entry& entry : entries_) {
    if (!entry.body->resting()) continue;
    // Its whole ball: feet have no solids of their own.
    const Eigen::Vector3d center = entry.body->BallCenter();
    const Eigen::Vector3d nearest = center.cwiseMax(bounds.low_m).cwiseMin(bounds.high_m);
    const double radius_m = entry.body->ball_radius_m();
    if (radius_m < 0.0 || (nearest - center).squaredNorm() > radius_m * radius_m) continue;
    entry.body->Wake();
  }
}

void OdeBodies::WakeAround(OdeBody* body) {
  for (const BodySolid& one : body->PosedSolids()) {
    Bounds bounds = one.solid.bounds();
    bounds.low_m.array() -= kWakingReach_m;
    bounds.high_m.array() += kWakingReach_m;
    WakeNear(bounds);
  }
}

}  // namespace latticeworld
