#include "latticeworld/simulation/ode/contacts/ode_ground.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "latticeworld/common/digest.h"
#include "latticeworld/common/enum_names.h"
#include "latticeworld/simulation/ode/contacts/wheel_ground.h"
#include "latticeworld/simulation/ode/ode_math.h"

namespace latticeworld {
namespace {

constexpr std::size_t kMaxSampleContacts = 24;
constexpr double kPlacingClearance_m = 0.002;
constexpr double kWakingFriction = 0.02;  // a change of friction that what rests may feel

std::array<double, kSurfaceClassCount> FrictionOf(const SurfaceTable& surfaces) {
  std::array<double, kSurfaceClassCount> friction{};
  for (const auto& entry : EnumNames(SurfaceClass{})) {
    friction[static_cast<std::size_t>(entry.value)] = surfaces.Of(entry.value).friction;
  }
  return friction;
}

void AddGroundContact(const ContactSide& side, const GroundContact& touch, const Traction& traction,
                      IslandGroup* group) {
  Contact contact;
  contact.body = side.body->id();
  contact.kind = ContactKind::kGround;
  contact.position_m = touch.position_m;
  contact.normal = touch.normal;
  contact.depth_m = touch.depth_m;
  group->contacts.push_back(contact);
  ContactJoint joint;
  joint.a = side;
  joint.position_m = touch.position_m;
  joint.normal = touch.normal;
  joint.depth_m = touch.depth_m;
  joint.traction = traction;
  group->joints()->Add(joint);
}

// A part of a body with samples that the ground holds up.
struct SampledPart {
  std::size_t index = 0;     // of the part
  Eigen::Vector3d center_m;  // of its mass, in base_link with all joints at 0
  const std::vector<GroundSample>* samples = nullptr;
  bool walks = false;
};

void TouchSamples(const HeightField& heights, const BodyParts& parts, const SampledPart& sampled,
                  std::vector<IslandGroup::SampleTouch>* touches) {
  if (sampled.samples->empty()) return;
  const dBodyID part = parts.part(sampled.index);
  const dReal* r = dBodyGetRotation(part);
  Eigen::Matrix3d map_from_part;
  map_from_part << r[0], r[1], r[2], r[4], r[5], r[6], r[8], r[9], r[10];
  const Eigen::Vector3d base_m = PositionOf(part) - map_from_part * sampled.center_m;
  IslandGroup::SampleTouch touch;
  touch.part = sampled.index;
  touch.walks = sampled.walks;
  for (const GroundSample& sample : *sampled.samples) {
    const Eigen::Vector3d at = base_m + map_from_part * sample.offset_m;
    const GroundContacts found = TouchGround(heights, at, sample.radius_m);
    for (int k = 0; k < found.count; ++k) {
      touch.contact = found.contact[static_cast<std::size_t>(k)];
      touches->push_back(touch);
    }
  }
}

}  // namespace

OdeGround::OdeGround(std::shared_ptr<const Scene> scene)
    : scene_(std::move(scene)),
      state_{scene_->atmosphere.ground(), {}},
      surfaces_(*scene_, state_.weathered) {
  state_.woken_friction = FrictionOf(surfaces_);
}

bool OdeGround::SetWeathered(const GroundState& weathered) {
  state_.weathered = weathered;
  surfaces_ = SurfaceTable(*scene_, weathered);
  const std::array<double, kSurfaceClassCount> friction = FrictionOf(surfaces_);
  bool changed = false;
  for (std::size_t i = 0; i < friction.size(); ++i) {
    changed = changed || std::abs(friction[i] - state_.woken_friction[i]) > kWakingFriction;
  }
  // Weather that moves slowly shall not keep everybody awake.
  if (changed) state_.woken_friction = friction;
  return changed;
}

void OdeGround::Restore(const State& state) {
  state_ = state;
  surfaces_ = SurfaceTable(*scene_, state_.weathered);
}

void OdeGround::AddTo(Digest* digest) const {
  digest->Add(state_.weathered.wetness);
  digest->Add(state_.weathered.snow_depth_m);
  digest->Add(state_.weathered.blown_sand);
  for (const double friction : state_.woken_friction) digest->Add(friction);
}

double OdeGround::SinkageOf(const OdeBody& body) const {
  const BodySpec& spec = body.spec();
  const BodyParts& parts = body.parts();
  double depth_m = 0.0;
  const auto include = [&](const Eigen::Vector3d& at, double radius_m) {
    depth_m = std::max(depth_m, DepthBelowGround(heights(), at, radius_m));
  };
  for (std::size_t i = 0; i < spec.wheels.size(); ++i) {
    include(PositionOf(parts.wheel(i)), spec.wheels[i].radius_m);
  }
  for (const GroundSample& sample : spec.ground_samples) {
    include(parts.TrunkPoint(sample.offset_m), sample.radius_m);
  }
  for (std::size_t i = 0; i < spec.links.size(); ++i) {
    for (const GroundSample& sample : spec.links[i].ground_samples) {
      include(parts.LinkPoint(i, sample.offset_m), sample.radius_m);
    }
  }
  return depth_m;
}

void OdeGround::LiftOut(OdeBody* body) const {
  constexpr int kTries = 32;  // each undoes most of the depth even on steep ground
  for (int i = 0; i < kTries; ++i) {
    const double depth_m = SinkageOf(*body);
    if (depth_m <= 0.0) return;
    BodyMotion motion = body->parts().Motion();
    motion.position_m.z() += depth_m + kPlacingClearance_m;
    body->SetMotion(motion);
  }
}

const SurfaceProperties& OdeGround::SurfaceAt(const Eigen::Vector3d& at) const {
  return surfaces_.Of(scene_->terrain->SurfaceAt({at.x(), at.y()}));
}

void OdeGround::Touch(OdeBody* body, double step_s, IslandGroup* group) const {
  if (!body->spec().wheels.empty()) TouchWithWheels(body, step_s, group);
  TouchWithSamples(body, group);
}

void OdeGround::TouchWithWheels(OdeBody* body, double step_s, IslandGroup* group) const {
  const BodySpec& spec = body->spec();
  const BodyParts& parts = body->parts();
  std::vector<GroundContacts>& touches = group->wheel_touch;
  touches.clear();
  int carrying = 0;
  for (std::size_t i = 0; i < spec.wheels.size(); ++i) {
    touches.push_back(TouchGround(heights(), PositionOf(parts.wheel(i)), spec.wheels[i].radius_m));
    if (touches.back().count > 0) ++carrying;
  }
  for (std::size_t i = 0; i < spec.wheels.size(); ++i) {
    const GroundContacts& touch = touches[i];
    if (touch.count == 0) continue;
    const WheelLoad load{parts.mass_kg() / carrying, spec.wheels[i]};
    const Eigen::Vector3d axis = parts.wheel_joint(i).Axis();
    const double rate_radps = ToEigen(dBodyGetAngularVel(parts.wheel(i))).dot(axis);
    for (int k = 0; k < touch.count; ++k) {
      const GroundContact& one = touch.contact[static_cast<std::size_t>(k)];
      const SurfaceProperties& surface = SurfaceAt(one.position_m);
      const double friction = surface.friction * spec.grip;
      Traction traction;
      traction.along = axis.cross(one.normal);
      traction.friction_along = friction;
      traction.friction_across = friction * spec.wheels[i].side_grip;
      traction.slip_mps_per_n = SlipPerForce(load, surface, friction, rate_radps) * touch.count;
      AddGroundContact({body, 1 + i}, one, traction, group);
      RollingContact rolling;
      rolling.wheel = parts.wheel(i);
      rolling.load_kg = load.mass_kg;
      rolling.share = 1.0 / touch.count;
      rolling.normal = one.normal;
      rolling.forward = traction.along;
      ResistRolling(rolling, surface, step_s);
    }
  }
}

void OdeGround::TouchWithSamples(OdeBody* body, IslandGroup* group) const {
  using SampleTouch = IslandGroup::SampleTouch;
  const BodySpec& spec = body->spec();
  std::vector<SampleTouch>& touches = group->sample_touch;
  touches.clear();
  SampledPart sampled;
  sampled.center_m = Eigen::Vector3d(0.0, 0.0, spec.center_height_m);
  sampled.samples = &spec.ground_samples;
  sampled.walks = true;
  TouchSamples(heights(), body->parts(), sampled, &touches);
  sampled.walks = false;
  for (std::size_t i = 0; i < spec.links.size(); ++i) {
    sampled.index = 1 + spec.wheels.size() + i;
    sampled.center_m = spec.links[i].center_m;
    sampled.samples = &spec.links[i].ground_samples;
    TouchSamples(heights(), body->parts(), sampled, &touches);
  }
  // A trunk that lies along the ground: its deepest points hold it.
  if (touches.size() > kMaxSampleContacts) {
    std::stable_sort(touches.begin(), touches.end(),
                     [](const SampleTouch& a, const SampleTouch& b) {
                       return a.contact.depth_m > b.contact.depth_m;
                     });
    touches.resize(kMaxSampleContacts);
  }
  for (const SampleTouch& one : touches) {
    AddGroundContact({body, one.part}, one.contact, SampleTraction(*body, one.contact, one.walks),
                     group);
  }
}

Traction OdeGround::SampleTraction(const OdeBody& body, const GroundContact& contact,
                                   bool walks) const {
  Traction traction;
  traction.friction_along = SurfaceAt(contact.position_m).friction * body.spec().grip;
  traction.friction_across = traction.friction_along;
  if (walks) traction.WalkAt(body.control().walk_velocity_mps, contact.normal);
  return traction;
}

}  // namespace latticeworld
