// How a step of OdeWorld finds what stands on the ground.

#include <algorithm>
#include <cmath>

#include "latticeworld/simulation/ode/ode_math.h"
#include "latticeworld/simulation/ode/ode_world_impl.h"
#include "latticeworld/simulation/ode/wheel_ground.h"

namespace latticeworld {
namespace {

constexpr std::size_t kMaxSampleContacts = 24;

void AddGroundContact(IslandGroup* group, const ContactSide& side, const GroundContact& touch,
                      const Traction& traction) {
  group->contacts.push_back({side.body->id(), ContactKind::kGround, 0, touch.position_m,
                             touch.normal, touch.depth_m, 0.0});
  group->joints()->Add({side, {}, touch.position_m, touch.normal, touch.depth_m, traction});
}

}  // namespace

const SurfaceProperties& OdeWorld::SurfaceAt(const Eigen::Vector3d& at) const {
  return surfaces_.Of(scene_->terrain->SurfaceAt({at.x(), at.y()}));
}

void OdeWorld::TouchGroundOf(IslandGroup* group, OdeBody* body, double step_s) const {
  if (!body->spec().wheels.empty()) TouchGroundWithWheels(group, body, step_s);
  TouchGroundWithSamples(group, body);
}

void OdeWorld::TouchGroundWithWheels(IslandGroup* group, OdeBody* body, double step_s) const {
  const BodySpec& spec = body->spec();
  std::vector<GroundContacts>& touches = group->wheel_touch;
  touches.clear();
  int carrying = 0;
  for (std::size_t i = 0; i < spec.wheels.size(); ++i) {
    const Eigen::Vector3d center = PositionOf(body->wheel(i));
    touches.push_back(TouchGround(ground(), center, spec.wheels[i].radius_m));
    if (touches.back().count > 0) ++carrying;
  }
  for (std::size_t i = 0; i < spec.wheels.size(); ++i) {
    const GroundContacts& touch = touches[i];
    if (touch.count == 0) continue;
    const WheelLoad load{body->mass_kg() / carrying, spec.wheels[i]};
    const Eigen::Vector3d axis = body->WheelAxis(i);
    const double rate_radps = ToEigen(dBodyGetAngularVel(body->wheel(i))).dot(axis);
    for (int k = 0; k < touch.count; ++k) {
      const GroundContact& one = touch.contact[static_cast<std::size_t>(k)];
      const SurfaceProperties& surface = SurfaceAt(one.position_m);
      const double friction = surface.friction * spec.grip;
      Traction traction;
      traction.along = axis.cross(one.normal);
      traction.friction_along = friction;
      traction.friction_across = friction * spec.wheels[i].side_grip;
      traction.slip_mps_per_n = SlipPerForce(load, surface, friction, rate_radps) * touch.count;
      AddGroundContact(group, {body, 1 + i}, one, traction);
      ResistRolling(body->wheel(i), load, surface, one.normal, traction.along, step_s,
                    1.0 / touch.count);
    }
  }
}

void OdeWorld::TouchGroundWithSamples(IslandGroup* group, OdeBody* body) const {
  const BodySpec& spec = body->spec();
  std::vector<IslandGroup::SampleTouch>& touches = group->sample_touch;
  touches.clear();
  const auto touch = [&](const GroundSample& sample, const Eigen::Vector3d& at, std::size_t part,
                         bool walks) {
    const GroundContacts found = TouchGround(ground(), at, sample.radius_m);
    for (int k = 0; k < found.count; ++k) {
      touches.push_back({found.contact[static_cast<std::size_t>(k)], part, walks});
    }
  };
  const auto touch_all = [&](const std::vector<GroundSample>& samples, std::size_t part,
                             const Eigen::Vector3d& center_in_base_m, bool walks) {
    if (samples.empty()) return;
    const dReal* r = dBodyGetRotation(body->part(part));
    Eigen::Matrix3d map_from_part;
    map_from_part << r[0], r[1], r[2], r[4], r[5], r[6], r[8], r[9], r[10];
    const Eigen::Vector3d base_m = PositionOf(body->part(part)) - map_from_part * center_in_base_m;
    for (const GroundSample& sample : samples) {
      touch(sample, base_m + map_from_part * sample.offset_m, part, walks);
    }
  };
  const Eigen::Vector3d trunk_m(0.0, 0.0, spec.center_height_m);
  touch_all(spec.ground_samples, 0, trunk_m, true);
  for (std::size_t i = 0; i < spec.links.size(); ++i) {
    const std::size_t part = 1 + spec.wheels.size() + i;
    touch_all(spec.links[i].ground_samples, part, spec.links[i].center_m, false);
  }
  // A trunk that lies along the ground: its deepest points hold it.
  using SampleTouch = IslandGroup::SampleTouch;
  if (touches.size() > kMaxSampleContacts) {
    std::stable_sort(touches.begin(), touches.end(),
                     [](const SampleTouch& a, const SampleTouch& b) {
                       return a.contact.depth_m > b.contact.depth_m;
                     });
    touches.resize(kMaxSampleContacts);
  }
  for (const SampleTouch& one : touches) {
    AddGroundContact(group, {body, one.part}, one.contact,
                     GroundTraction(*body, one.contact.position_m, one.contact.normal, one.walks));
  }
}

// Feet push the ground away: friction acts towards the wanted velocity along the surface.
Traction OdeWorld::GroundTraction(const OdeBody& body, const Eigen::Vector3d& at,
                                  const Eigen::Vector3d& normal, bool walks) const {
  Traction traction;
  traction.friction_along = SurfaceAt(at).friction * body.spec().grip;
  traction.friction_across = traction.friction_along;
  if (!walks) return traction;
  const Eigen::Vector3d& wanted = body.control().walk_velocity_mps;
  const Eigen::Vector3d along = wanted - wanted.dot(normal) * normal;
  if (along.squaredNorm() > 1e-12) {
    traction.along = along;
    traction.speed_mps = wanted.norm();
  }
  return traction;
}

}  // namespace latticeworld
