#include <algorithm>
#include <cmath>
#include <map>

#include "latticeworld/simulation/props/blows.h"
#include "latticeworld/simulation/props/prop_body.h"
#include "latticeworld/simulation/props/props.h"

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

}  // namespace

bool Props::GivesWay(const Contact& contact) {
  if (contact.kind != ContactKind::kBody) return false;
  const auto post_of = [this](BodyId body) -> const Running* {
    const auto name = names_.find(body);
    if (name == names_.end()) return nullptr;
    const Running& running = state_.at(name->second);
    return running.prop.kind == PropKind::kPost && !running.broken ? &running : nullptr;
  };
  const bool hit_other = post_of(contact.other) != nullptr;
  const Running* const post = hit_other ? post_of(contact.other) : post_of(contact.body);
  if (post == nullptr) return false;
  if (blows_.count(post->prop.name) != 0) return true;
  const BodyId by = hit_other ? contact.body : contact.other;
  if (physics_->IsAnchored(by)) return false;
  const Eigen::Vector2d level = (hit_other ? 1.0 : -1.0) * contact.normal.head<2>();  // into `by`
  const double approach_mps = contact.approach_mps * level.norm();
  if (approach_mps <= 0.0) return false;
  const double mass_kg = HittingMass(*physics_, by, contact.position_m, contact.normal);
  const double stiffness = StiffnessMet(mass_kg, PostStiffness(post->prop));
  const double strength_nm = post->prop.strength;
  if (ImpactMoment(mass_kg, approach_mps, stiffness) < strength_nm) return false;
  const double after_mps = SpeedAfterBreaking(mass_kg, approach_mps, stiffness, strength_nm);
  const Eigen::Vector2d push = mass_kg * (approach_mps - after_mps) * level.normalized();
  blows_[post->prop.name] = {by, mass_kg, {push.x(), push.y(), 0.0}, contact.position_m};
  return true;
}

void Props::TurnGate(Running* running, double step_s) {
  const double angle_rad = physics_->AnchorAngleOf(running->body);
  const double left_rad = *running->wanted_rad - angle_rad;
  const double rate_radps = physics_->MotionOf(running->body).angular_velocity_radps.z();
  if (std::abs(left_rad) < kThere_rad) {
    running->wanted_rad.reset();
    return;
  }
  const BodySpec& spec = physics_->SpecOf(running->body);
  const double half_m = 0.5 * running->prop.size_m.x();
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

void Props::Act(const Atmosphere& atmosphere, double step_s) {
  for (auto& [name, running] : state_) {
    if (running.wanted_rad) TurnGate(&running, step_s);
    if (physics_->IsAnchored(running.body)) continue;
    ActOfWater(*scene_.terrain, atmosphere, PropBuoyancyOf(running.prop), running.body, physics_);
  }
}

void Props::AddLoads(double step_s) {
  std::map<BodyId, double> now;
  const auto add = [&](BodyId body, const Contact& contact, const Eigen::Vector3d& force_n) {
    const auto name = names_.find(body);
    if (name == names_.end()) return;
    const Running& running = state_.at(name->second);
    if (running.broken) return;
    if (running.prop.kind == PropKind::kBridge) {
      const BodyId load = contact.body == body ? contact.other : contact.body;
      const double weight_n = physics_->SpecOf(load).total_mass_kg() * kGravity_mps2;
      now[body] += std::clamp(-force_n.z(), 0.0, kMostLoad * weight_n);
      // What sleeps has no contacts, and would weigh nothing.
      if (physics_->IsResting(load)) physics_->AddForce(load, kWakingForce_n);
    } else if (running.prop.kind == PropKind::kPost && contact.approach_mps <= kFastestPush_mps) {
      const double height_m = contact.position_m.z() - running.prop.z_m;
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
    const bool is_bridge = running.prop.kind == PropKind::kBridge;
    const double bears = running.prop.strength * (is_bridge ? kGravity_mps2 : 1.0);
    running.overload_s = running.load > bears ? running.overload_s + step_s : 0.0;
  }
}

void Props::Break(Running* running) {
  running->broken = true;
  running->on_maps.reset();
  running->load = running->overload_s = 0.0;
  if (running->prop.kind != PropKind::kBridge) {
    physics_->SetAnchored(running->body, false);
    return;
  }
  // The middle of the deck breaks out; its ends would hold on to the banks.
  const BodyMotion motion = physics_->MotionOf(running->body);
  names_.erase(running->body);
  physics_->Remove(running->body);
  running->prop = BrokenDeckOf(running->prop);
  BodySpec spec = PropBodyOf(running->prop);
  spec.anchor.reset();
  running->body = physics_->Add(spec, motion);
  names_[running->body] = running->prop.name;
}

bool Props::TellGate(Running* running) {
  const double opening_rad = std::abs(physics_->AnchorAngleOf(running->body));
  const bool open = running->open ? opening_rad > kClosed_rad : opening_rad > kOpen_rad;
  if (open == running->open) return false;
  running->open = open;
  return true;
}

bool Props::Step(double step_s, std::uint64_t step, std::vector<Event>* events) {
  AddLoads(step_s);
  bool broke = false;
  for (auto& entry : state_) {
    const std::string& name = entry.first;
    auto& running = entry.second;
    const auto tell = [&](EventKind kind, const std::string& other) {
      events->push_back({step, kind, name, other,
                         PropPoseOf(running.prop, physics_->MotionOf(running.body)).position_m});
    };
    if (running.prop.kind == PropKind::kGate) {
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
    const double post_kg = running.prop.mass_kg;
    physics_->AddImpulse(running.body, -hit.impulse_ns * std::min(1.0, post_kg / hit.by_kg),
                         hit.point_m);
  }
  blows_.clear();
  if (broke) ListStanding();
  return broke;
}

}  // namespace latticeworld
