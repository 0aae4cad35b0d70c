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
#include "latticeworld/simulation/felling.h"

namespace latticeworld {
namespace {

// Most that one contact of a body counts for on a bridge, in weights of the body: it may land.
constexpr double kMostLoad = 3.0;
const Eigen::Vector3d kWakingForce_n(0.0, 0.0, -1e-9);

constexpr double kLoadTime_s = 0.2;
constexpr double kOverload_s = 0.3;       // that bridges and posts hold more than they bear
constexpr double kFastestPush_mps = 0.5;  // what comes faster onto a post is a blow
// Gates: as a person opens them.
constexpr double kGateRate_radps = 1.0;
constexpr double kGateGain_hz = 3.0;   // of the wanted rate on what is left to turn
constexpr double kMotorGain_hz = 8.0;  // of the torque on the error in rate
constexpr double kMotorTorque = 4.0;   // largest, over the hinge's friction
constexpr double kThere_rad = 0.02;
constexpr double kOpen_rad = 0.5, kClosed_rad = 0.1;

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
}

void Elements::Begin(const Element& element) {
  Running running;
  running.element = element;
  const BodySpec spec = ElementBodyOf(element);
  BodyMotion motion = BeginningOf(element);
  // What stands loose stands square to the ground.
  if (!spec.anchor) motion = OnGround(*scene_.terrain, element);
  running.body = physics_->Add(spec, motion);
  names_[running.body] = element.name;
  state_.emplace(element.name, std::move(running));
}

Status Elements::CheckPlace(const Element& element) const {
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
    const bool overlaps = asset.kind == AssetKind::kBuilding
                              ? GapBetween(footprint, latticeworld::FootprintOf(asset)) < 0.0
                              : GapTo(footprint, asset.position()) < SolidRadius(asset);
    if (overlaps) in_the_way = latticeworld::NameOf(asset.kind);
  });
  for (const auto& [name, running] : state_) {
    Element there = running.element;
    const BodyMotion pose = ElementPoseOf(there, physics_->MotionOf(running.body));
    there.position = {pose.position_m.x(), pose.position_m.y()};
    there.yaw_rad = pose.yaw_rad();
    if (GapBetween(footprint, FootprintOf(there)) < 0.0) in_the_way = name;
  }
  if (in_the_way.empty()) return Status();
  return FailedPrecondition("a " + std::string(latticeworld::NameOf(element.kind)) + " at (" +
                            FormatDouble(element.position.x_m) + ", " +
                            FormatDouble(element.position.y_m) + ") would stand in: " + in_the_way);
}

Result<std::string> Elements::Add(const Element& element) {
  LW_RETURN_IF_ERROR(Status::FromViolations("illegal element", Validate(element)));
  if (state_.size() >= static_cast<std::size_t>(kMaxElements)) {
    return ResourceExhausted("a world holds at most " + std::to_string(kMaxElements) +
                             " elements, and there are as many");
  }
  LW_RETURN_IF_ERROR(CheckPlace(element));
  Element standing = element;
  standing.z_m = GroundUnder(*scene_.terrain, element);
  Begin(standing);
  return element.name;
}

Status Elements::Remove(const std::string& name) {
  const auto found = state_.find(name);
  if (found == state_.end()) return NoneNamed("element", name, state_);
  physics_->Remove(found->second.body);
  names_.erase(found->second.body);
  blows_.erase(name);
  state_.erase(found);
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

bool Elements::GivesWay(const Contact& contact) {
  if (contact.kind != ContactKind::kBody) return false;
  const auto post_of = [this](BodyId body) -> const Running* {
    const auto name = names_.find(body);
    if (name == names_.end()) return nullptr;
    const Running& running = state_.at(name->second);
    return running.element.kind == ElementKind::kPost && !running.broken ? &running : nullptr;
  };
  const bool hit_other = post_of(contact.other) != nullptr;
  const Running* const post = hit_other ? post_of(contact.other) : post_of(contact.body);
  if (post == nullptr) return false;
  if (blows_.count(post->element.name) != 0) return true;
  const BodyId by = hit_other ? contact.body : contact.other;
  if (physics_->IsAnchored(by)) return false;
  const Eigen::Vector2d level = (hit_other ? 1.0 : -1.0) * contact.normal.head<2>();  // into `by`
  const double approach_mps = contact.approach_mps * level.norm();
  const double mass_kg = physics_->SpecOf(by).total_mass_kg();
  const double stiffness = StiffnessMet(mass_kg, PostStiffness(post->element));
  const double strength_nm = post->element.strength;
  if (approach_mps <= 0.0 || ImpactMoment(mass_kg, approach_mps, stiffness) < strength_nm) {
    return false;
  }
  const double after_mps = SpeedAfterBreaking(mass_kg, approach_mps, stiffness, strength_nm);
  const Eigen::Vector2d push = mass_kg * (approach_mps - after_mps) * level.normalized();
  blows_[post->element.name] = {by, {push.x(), push.y(), 0.0}, contact.position_m};
  return true;
}

void Elements::TurnGate(Running* running, double step_s) {
  const double angle_rad = physics_->AnchorAngleOf(running->body);
  const double left_rad = *running->wanted_rad - angle_rad;
  const double rate_radps = physics_->MotionOf(running->body).angular_velocity_radps.z();
  if (std::abs(left_rad) < kThere_rad) {
    running->wanted_rad.reset();
    return;
  }
  const BodySpec& spec = physics_->SpecOf(running->body);
  const double half_m = 0.5 * running->element.size_m.x();
  const double about_hinge_kgm2 = spec.inertia_kgm2.z() + spec.mass_kg * half_m * half_m;
  const double friction_nm = spec.anchor->friction_nm;
  const double wanted_radps =
      std::clamp(kGateGain_hz * left_rad, -kGateRate_radps, kGateRate_radps);
  const double gain_hz = std::min(kMotorGain_hz, 0.5 / step_s);
  const double torque_nm = about_hinge_kgm2 * gain_hz * (wanted_radps - rate_radps) +
                           std::copysign(friction_nm, left_rad);
  const double limit_nm = kMotorTorque * friction_nm;
  physics_->AddTorque(running->body, {0.0, 0.0, std::clamp(torque_nm, -limit_nm, limit_nm)});
}

void Elements::Act(const Atmosphere& atmosphere, double step_s) {
  for (auto& [name, running] : state_) {
    if (running.wanted_rad) TurnGate(&running, step_s);
    if (physics_->IsAnchored(running.body)) continue;
    ActOfWater(*scene_.terrain, atmosphere, ElementBuoyancyOf(running.element), running.body,
               physics_);
  }
}

void Elements::AddLoads(double step_s) {
  std::map<BodyId, double> now;
  const auto add = [&](BodyId body, const Contact& contact, const Eigen::Vector3d& force_n) {
    const auto name = names_.find(body);
    if (name == names_.end()) return;
    const Running& running = state_.at(name->second);
    if (running.broken) return;
    if (running.element.kind == ElementKind::kBridge) {
      const BodyId load = contact.body == body ? contact.other : contact.body;
      const double weight_n = physics_->SpecOf(load).total_mass_kg() * kGravity_mps2;
      now[body] += std::clamp(-force_n.z(), 0.0, kMostLoad * weight_n);
      // What sleeps has no contacts, and would weigh nothing.
      if (physics_->IsResting(load)) physics_->AddForce(load, kWakingForce_n);
    } else if (running.element.kind == ElementKind::kPost &&
               contact.approach_mps <= kFastestPush_mps) {
      const double height_m = contact.position_m.z() - running.element.z_m;
      now[body] += std::max(0.0, height_m) * force_n.head<2>().norm();
    }
  };
  for (const Contact& contact : physics_->contacts()) {
    if (contact.kind != ContactKind::kBody || contact.force_n.isZero(0.0) ||
        !contact.force_n.allFinite()) {
      continue;
    }
    add(contact.body, contact, contact.force_n);
    add(contact.other, contact, -contact.force_n);
  }
  const double keep = std::exp(-step_s / kLoadTime_s);
  for (auto& [name, running] : state_) {
    const auto found = now.find(running.body);
    if (found == now.end() && running.load == 0.0) continue;
    running.load *= keep;
    if (found != now.end()) running.load += (1.0 - keep) * std::max(0.0, found->second);
    if (running.load < 1e-3) running.load = 0.0;
    const bool is_bridge = running.element.kind == ElementKind::kBridge;
    const double bears = running.element.strength * (is_bridge ? kGravity_mps2 : 1.0);
    running.overload_s = running.load > bears ? running.overload_s + step_s : 0.0;
  }
}

void Elements::Break(Running* running) {
  running->broken = true;
  running->load = running->overload_s = 0.0;
  if (running->element.kind != ElementKind::kBridge) {
    physics_->SetAnchored(running->body, false);
    return;
  }
  // The middle of the deck breaks out; its ends would hold on to the banks.
  const BodyMotion motion = physics_->MotionOf(running->body);
  names_.erase(running->body);
  physics_->Remove(running->body);
  running->element = BrokenDeckOf(running->element);
  BodySpec spec = ElementBodyOf(running->element);
  spec.anchor.reset();
  running->body = physics_->Add(spec, motion);
  names_[running->body] = running->element.name;
}

bool Elements::TellGate(Running* running) {
  const double opening_rad = std::abs(physics_->AnchorAngleOf(running->body));
  const bool open = running->open ? opening_rad > kClosed_rad : opening_rad > kOpen_rad;
  if (open == running->open) return false;
  running->open = open;
  return true;
}

bool Elements::Step(double step_s, std::uint64_t step, std::vector<Event>* events) {
  AddLoads(step_s);
  bool broke = false;
  for (auto& [name, running] : state_) {
    const auto tell = [&](EventKind kind, const std::string& other) {
      events->push_back(
          {step, kind, name, other,
           ElementPoseOf(running.element, physics_->MotionOf(running.body)).position_m});
    };
    if (running.element.kind == ElementKind::kGate) {
      if (TellGate(&running)) tell(running.open ? EventKind::kOpened : EventKind::kClosed, "");
      continue;
    }
    const auto blow = blows_.find(name);
    if (blow == blows_.end() && running.overload_s < kOverload_s) continue;
    Break(&running);
    broke = true;
    tell(EventKind::kBroke, "");
    if (blow == blows_.end()) continue;
    const Blow& hit = blow->second;
    physics_->AddImpulse(hit.by, hit.impulse_ns, hit.point_m);
    // The post takes no more of it than makes it as fast as what hit it.
    const double post_kg = running.element.mass_kg;
    const double by_kg = physics_->SpecOf(hit.by).total_mass_kg();
    physics_->AddImpulse(running.body, -hit.impulse_ns * std::min(1.0, post_kg / by_kg),
                         hit.point_m);
  }
  blows_.clear();
  return broke;
}

void Elements::Restore(const State& state) {
  state_ = state;
  names_.clear();
  blows_.clear();
  for (const auto& [name, running] : state_) names_[running.body] = name;
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
  }
}

}  // namespace latticeworld
