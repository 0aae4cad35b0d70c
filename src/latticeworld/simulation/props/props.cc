#include "latticeworld/simulation/props/props.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "latticeworld/common/digest.h"
#include "latticeworld/common/text.h"
#include "latticeworld/geometry/upright.h"
#include "latticeworld/scene/footprint.h"
#include "latticeworld/scene/props/props.h"
#include "latticeworld/simulation/agent_names.h"
#include "latticeworld/simulation/props/prop_body.h"

namespace latticeworld {
namespace {

// Returns where a prop begins on sloping ground.
BodyMotion OnGround(const Terrain& terrain, const Prop& prop) {
  constexpr double kGap_m = 0.003;
  BodyMotion motion = BeginningOf(prop);
  const Eigen::Vector3d normal = terrain.ground.NormalAt(prop.position);
  motion.orientation = TurnFromUp(normal) * motion.orientation;
  motion.position_m += kGap_m * normal;
  return motion;
}

}  // namespace

Props::Props(const Scene& scene, PhysicsWorld* physics) : scene_(scene), physics_(physics) {
  for (const Prop& prop : scene.props) Begin(prop);
  ListStanding();
}

void Props::Begin(const Prop& prop) {
  Running running;
  running.prop = prop;
  const BodySpec spec = PropBodyOf(prop);
  BodyMotion motion = BeginningOf(prop);
  // What stands loose stands square to the ground.
  if (!spec.anchor) motion = OnGround(*scene_.terrain, prop);
  running.body = physics_->Add(spec, motion);
  running.on_maps =
      BlockOf(prop, {prop.position.x_m, prop.position.y_m, prop.z_m},
              Eigen::Quaterniond(Eigen::AngleAxisd(prop.yaw_rad, Eigen::Vector3d::UnitZ())));
  names_[running.body] = prop.name;
  state_.emplace(prop.name, std::move(running));
}

Status Props::CheckPlace(const Prop& prop, const SceneChanges& changes) const {
  const Footprint footprint = FootprintOf(prop);
  for (const WorldPoint& corner : footprint.Corners()) {
    if (!scene_.geometry().Contains(corner)) {
      return Status(StatusCode::kOutOfRange, "a " + std::string(latticeworld::NameOf(prop.kind)) +
                                                 " at (" + FormatDouble(prop.position.x_m) + ", " +
                                                 FormatDouble(prop.position.y_m) +
                                                 ") would not be wholly in the world");
    }
  }
  std::string in_the_way;
  scene_.index.ForEachNear(footprint.centre, footprint.radius_m(), [&](std::uint32_t index) {
    const Asset& asset = scene_.assets[index];
    if (!changes.Stands(index)) return;
    const bool overlaps = asset.kind == AssetKind::kBuilding
                              ? GapBetween(footprint, latticeworld::FootprintOf(asset)) < 0.0
                              : GapTo(footprint, asset.position()) < SolidRadius(asset);
    if (overlaps) in_the_way = latticeworld::NameOf(asset.kind);
  });
  for (const auto& [name, running] : state_) {
    if (GapBetween(footprint, BoxNow(running).footprint) < 0.0) in_the_way = name;
  }
  if (in_the_way.empty()) return Status();
  return FailedPrecondition("a " + std::string(latticeworld::NameOf(prop.kind)) + " at (" +
                            FormatDouble(prop.position.x_m) + ", " +
                            FormatDouble(prop.position.y_m) + ") would stand in: " + in_the_way);
}

PropBlock Props::BoxNow(const Running& running) const {
  const BodyMotion pose = PropPoseOf(running.prop, physics_->MotionOf(running.body));
  return BoxAround(running.prop, pose.position_m, pose.orientation);
}

Result<std::string> Props::Add(const Prop& prop, const SceneChanges& changes) {
  if (state_.size() >= static_cast<std::size_t>(kMaxProps)) {
    return ResourceExhausted("a world holds at most " + std::to_string(kMaxProps) +
                             " elements, and there are as many");
  }
  LW_RETURN_IF_ERROR(CheckPlace(prop, changes));
  Prop standing = prop;
  standing.z_m = GroundUnder(*scene_.terrain, prop);
  Begin(standing);
  ListStanding();
  return prop.name;
}

Status Props::Remove(const std::string& name) {
  const auto found = state_.find(name);
  if (found == state_.end()) return NoneNamed("element", name, state_);
  physics_->Remove(found->second.body);
  names_.erase(found->second.body);
  blows_.erase(name);
  state_.erase(found);
  ListStanding();
  return Status();
}

Status Props::OpenGate(const std::string& name, double opening_rad) {
  const auto found = state_.find(name);
  if (found == state_.end()) return NoneNamed("element", name, state_);
  if (found->second.prop.kind != PropKind::kGate) {
    return FailedPrecondition(Quote(name) + " is no gate but a " +
                              std::string(latticeworld::NameOf(found->second.prop.kind)));
  }
  if (!(std::abs(opening_rad) <= kWidestOpening_rad)) {
    return Status(StatusCode::kOutOfRange, "a gate opens by [" + FormatDouble(-kWidestOpening_rad) +
                                               ", " + FormatDouble(kWidestOpening_rad) +
                                               "] rad, not by " + FormatDouble(opening_rad));
  }
  found->second.wanted_rad = opening_rad;
  return Status();
}

std::string Props::NameOf(BodyId body) const {
  const auto found = names_.find(body);
  return found == names_.end() ? "" : found->second;
}

void Props::Restore(const State& state) {
  state_ = state;
  names_.clear();
  blows_.clear();
  for (const auto& [name, running] : state_) names_[running.body] = name;
  ListStanding();
}

std::vector<PropSnapshot> Props::Snapshots() const {
  std::vector<PropSnapshot> snapshots;
  snapshots.reserve(state_.size());
  for (const auto& [name, running] : state_) {
    const BodyMotion pose = PropPoseOf(running.prop, physics_->MotionOf(running.body));
    PropSnapshot snapshot;
    snapshot.name = name;
    snapshot.kind = running.prop.kind;
    snapshot.position_m = pose.position_m;
    snapshot.orientation = pose.orientation;
    snapshot.size_m = running.prop.size_m;
    snapshot.broken = running.broken;
    if (running.prop.kind == PropKind::kGate) {
      snapshot.opening_rad = physics_->AnchorAngleOf(running.body);
    }
    snapshots.push_back(std::move(snapshot));
  }
  return snapshots;
}

void Props::AddTo(Digest* digest) const {
  digest->Add<std::uint64_t>(state_.size());
  for (const auto& [name, running] : state_) {
    const Prop& prop = running.prop;
    digest->AddText(name);
    digest->Add(prop.kind);
    digest->Add(prop.z_m);
    for (int i = 0; i < 3; ++i) digest->Add(prop.size_m[i]);
    digest->Add(prop.mass_kg);
    digest->Add(prop.strength);
    digest->Add(running.body);
    digest->Add(running.load);
    digest->Add(running.overload_s);
    digest->Add(running.broken);
    digest->Add(running.open);
    digest->Add(running.wanted_rad.has_value());
    digest->Add(running.wanted_rad.value_or(0.0));
    digest->Add(running.open_on_maps);
    digest->Add(running.on_maps.has_value());
    if (!running.on_maps) continue;
    const PropBlock& block = *running.on_maps;
    for (const double number : {block.footprint.centre.x_m, block.footprint.centre.y_m,
                                block.footprint.yaw_rad, block.footprint.half_length_m,
                                block.footprint.half_width_m, block.bottom_m, block.top_m}) {
      digest->Add(number);
    }
  }
}

}  // namespace latticeworld
