#include "latticeworld/simulation/elements.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "latticeworld/common/digest.h"
#include "latticeworld/common/text.h"
#include "latticeworld/scene/elements.h"
#include "latticeworld/scene/footprint.h"
#include "latticeworld/simulation/agent_names.h"
#include "latticeworld/simulation/element_body.h"

namespace latticeworld {
namespace {

// Where it begins on sloping ground.
BodyMotion OnGround(const Terrain& terrain, const Element& element) {
  constexpr double kGap_m = 0.003;
  BodyMotion motion = BeginningOf(element);
  const Eigen::Vector3d normal = terrain.ground.NormalAt(element.position);
  motion.orientation =
      Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), normal) * motion.orientation;
  motion.position_m += kGap_m * normal;
  return motion;
}

}  // namespace

Elements::Elements(const Scene& scene, PhysicsWorld* physics) : scene_(scene), physics_(physics) {
  for (const Element& element : scene.elements) Begin(element);
  ListStanding();
}

void Elements::Begin(const Element& element) {
  Running running;
  running.element = element;
  const BodySpec spec = ElementBodyOf(element);
  BodyMotion motion = BeginningOf(element);
  // What stands loose stands square to the ground.
  if (!spec.anchor) motion = OnGround(*scene_.terrain, element);
  running.body = physics_->Add(spec, motion);
  running.on_maps =
      BlockOf(element, {element.position.x_m, element.position.y_m, element.z_m},
              Eigen::Quaterniond(Eigen::AngleAxisd(element.yaw_rad, Eigen::Vector3d::UnitZ())));
  names_[running.body] = element.name;
  state_.emplace(element.name, std::move(running));
}

Status Elements::CheckPlace(const Element& element, const SceneChanges& changes) const {
  const Footprint footprint = FootprintOf(element);
  for (const WorldPoint& corner : footprint.Corners()) {
    if (!scene_.geometry().Contains(corner)) {
      return Status(StatusCode::kOutOfRange,
                    "a " + std::string(latticeworld::NameOf(element.kind)) + " at (" +
                        FormatDouble(element.position.x_m) + ", " +
                        FormatDouble(element.position.y_m) + ") would not be wholly in the world");
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
  return FailedPrecondition("a " + std::string(latticeworld::NameOf(element.kind)) + " at (" +
                            FormatDouble(element.position.x_m) + ", " +
                            FormatDouble(element.position.y_m) + ") would stand in: " + in_the_way);
}

ElementBlock Elements::BoxNow(const Running& running) const {
  const BodyMotion pose = ElementPoseOf(running.element, physics_->MotionOf(running.body));
  return BoxAround(running.element, pose.position_m, pose.orientation);
}

Result<std::string> Elements::Add(const Element& element, const SceneChanges& changes) {
  LW_RETURN_IF_ERROR(Status::FromViolations("illegal element", Validate(element)));
  if (state_.size() >= static_cast<std::size_t>(kMaxElements)) {
    return ResourceExhausted("a world holds at most " + std::to_string(kMaxElements) +
                             " elements, and there are as many");
  }
  LW_RETURN_IF_ERROR(CheckPlace(element, changes));
  Element standing = element;
  standing.z_m = GroundUnder(*scene_.terrain, element);
  Begin(standing);
  ListStanding();
  return element.name;
}

Status Elements::Remove(const std::string& name) {
  const auto found = state_.find(name);
  if (found == state_.end()) return NoneNamed("element", name, state_);
  physics_->Remove(found->second.body);
  names_.erase(found->second.body);
  blows_.erase(name);
  state_.erase(found);
  ListStanding();
  return Status();
}

Status Elements::OpenGate(const std::string& name, double opening_rad) {
  const auto found = state_.find(name);
  if (found == state_.end()) return NoneNamed("element", name, state_);
  if (found->second.element.kind != ElementKind::kGate) {
    return FailedPrecondition(Quote(name) + " is no gate but a " +
                              std::string(latticeworld::NameOf(found->second.element.kind)));
  }
  if (!(std::abs(opening_rad) <= kWidestOpening_rad)) {
    return Status(StatusCode::kOutOfRange, "a gate opens by [" + FormatDouble(-kWidestOpening_rad) +
                                               ", " + FormatDouble(kWidestOpening_rad) +
                                               "] rad, not by " + FormatDouble(opening_rad));
  }
  found->second.wanted_rad = opening_rad;
  return Status();
}

std::string Elements::NameOf(BodyId body) const {
  const auto found = names_.find(body);
  return found == names_.end() ? "" : found->second;
}

void Elements::Restore(const State& state) {
  state_ = state;
  names_.clear();
  blows_.clear();
  for (const auto& [name, running] : state_) names_[running.body] = name;
  ListStanding();
}

std::vector<ElementSnapshot> Elements::Snapshots() const {
  std::vector<ElementSnapshot> snapshots;
  snapshots.reserve(state_.size());
  for (const auto& [name, running] : state_) {
    const BodyMotion pose = ElementPoseOf(running.element, physics_->MotionOf(running.body));
    ElementSnapshot snapshot;
    snapshot.name = name;
    snapshot.kind = running.element.kind;
    snapshot.position_m = pose.position_m;
    snapshot.orientation = pose.orientation;
    snapshot.size_m = running.element.size_m;
    snapshot.broken = running.broken;
    if (running.element.kind == ElementKind::kGate) {
      snapshot.opening_rad = physics_->AnchorAngleOf(running.body);
    }
    snapshots.push_back(std::move(snapshot));
  }
  return snapshots;
}

void Elements::AddTo(Digest* digest) const {
  digest->Add<std::uint64_t>(state_.size());
  for (const auto& [name, running] : state_) {
    const Element& element = running.element;
    digest->AddText(name);
    digest->Add(element.kind);
    digest->Add(element.z_m);
    for (int i = 0; i < 3; ++i) digest->Add(element.size_m[i]);
    digest->Add(element.mass_kg);
    digest->Add(element.strength);
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
    const ElementBlock& block = *running.on_maps;
    for (const double number : {block.footprint.centre.x_m, block.footprint.centre.y_m,
                                block.footprint.yaw_rad, block.footprint.half_length_m,
                                block.footprint.half_width_m, block.bottom_m, block.top_m}) {
      digest->Add(number);
    }
  }
}

}  // namespace latticeworld
