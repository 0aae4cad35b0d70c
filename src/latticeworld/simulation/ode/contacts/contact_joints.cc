#include "latticeworld/simulation/ode/contacts/contact_joints.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "latticeworld/simulation/ode/ode_math.h"

namespace latticeworld {
namespace {

constexpr int kMaxBodyContacts = 24;
constexpr double kErrorReduction = 0.3;    // share of a contact's depth undone in a step
constexpr double kContactSoftness = 1e-6;  // CFM
// These limits keep a deep contact from shooting bodies off.
constexpr double kMaxCorrectingSpeed_mps = 2.0;
constexpr double kMaxPartingSpeed_mps = 1.0;  // of two bodies
constexpr double kMaxSpringSpeed_mps = 10.0;

// Below this speed a contact holds rather than slides.
constexpr double kSliding_mps = 0.01;

// ODE limits friction along two directions each by itself: where the first one is not that of the
// force, a contact holds up to sqrt(2) times too much. It is the direction of sliding or, where it
// holds, of the pull of gravity along the surface.
Eigen::Vector3d FrictionDirection(const ContactJoint& joint) {
  const Eigen::Vector3d& normal = joint.normal;
  Eigen::Vector3d sliding = VelocityAt(joint.a.id(), joint.position_m);
  if (joint.b.body != nullptr) sliding -= VelocityAt(joint.b.id(), joint.position_m);
  sliding -= sliding.dot(normal) * normal;
  const double speed_mps = sliding.norm();
  if (speed_mps > kSliding_mps) return sliding / speed_mps;
  const Eigen::Vector3d downhill = normal.z() * normal - Eigen::Vector3d::UnitZ();
  const double slope = downhill.norm();
  if (slope > 1e-3) return downhill / slope;
  const Eigen::Vector3d other =
      std::abs(normal.x()) < 0.7 ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitY();
  return other.cross(normal).normalized();
}

}  // namespace

ContactJoints::ContactJoints(dWorldID world) : world_(world), group_(dJointGroupCreate(0)) {}

ContactJoints::~ContactJoints() { dJointGroupDestroy(group_); }

// Bodies with too many contacts are rare: a crate in a heap.
void ContactJoints::DropBeyondLimit() {
  const auto for_each_body = [](const ContactJoint& joint, auto&& visit) {
    if (joint.counts) visit(joint.a.body);
    if (joint.counts && joint.b.body != nullptr) visit(joint.b.body);
  };
  bool too_many = false;
  for (const ContactJoint& joint : found_) {
    for_each_body(joint, [&](OdeBody* body) {
      too_many = ++*body->contact_count() > kMaxBodyContacts || too_many;
    });
  }
  if (too_many) {
    std::vector<std::size_t> order(found_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return found_[a].depth_m < found_[b].depth_m;
    });
    std::vector<bool> dropped(found_.size(), false);
    for (const std::size_t i : order) {
      bool over = false;
      for_each_body(found_[i], [&](OdeBody* body) {
        over = over || *body->contact_count() > kMaxBodyContacts;
      });
      if (!over) continue;
      dropped[i] = true;
      for_each_body(found_[i], [](OdeBody* body) { --*body->contact_count(); });
    }
    std::size_t kept = 0;
    for (std::size_t i = 0; i < found_.size(); ++i) {
      if (!dropped[i]) found_[kept++] = found_[i];
    }
    found_.erase(found_.begin() + static_cast<std::ptrdiff_t>(kept), found_.end());
  }
  for (const ContactJoint& joint : found_) {
    for_each_body(joint, [](OdeBody* body) { *body->contact_count() = 0; });
  }
}

void ContactJoints::Join(double step_s) {
  found_.erase(std::remove_if(found_.begin(), found_.end(),
                              [](const ContactJoint& joint) { return joint.gives_way; }),
               found_.end());
  DropBeyondLimit();
  std::size_t reported = 0;
  for (const ContactJoint& joint : found_) reported += joint.reported >= 0 ? 1 : 0;
  feedback_.resize(reported);  // joints keep addresses of these until Finish
  std::size_t next = 0;
  for (const ContactJoint& joint : found_) {
    JoinOne(joint, step_s, joint.reported >= 0 ? &feedback_[next++] : nullptr);
  }
}

void ContactJoints::JoinOne(const ContactJoint& joint, double step_s, dJointFeedback* feedback) {
  const Traction& traction = joint.traction;
  dContact contact;
  dSurfaceParameters& surface = contact.surface;
  surface.mode = dContactApprox1 | dContactMu2 | dContactFDir1 | dContactSoftERP | dContactSoftCFM;
  surface.mu = traction.friction_along;
  surface.mu2 = traction.friction_across;
  // The contact has the usual hardness, or is a spring and damper if it has a compliance.
  double max_speed_mps = joint.b.body == nullptr ? kMaxCorrectingSpeed_mps : kMaxPartingSpeed_mps;
  surface.soft_erp = kErrorReduction;
  surface.soft_cfm = kContactSoftness;
  if (joint.compliance.stiffness_npm > 0.0) {
    const double stiff = step_s * joint.compliance.stiffness_npm;
    const double softness = 1.0 / (stiff + joint.compliance.damping_nspm);
    surface.soft_erp = stiff * softness;
    surface.soft_cfm = std::max(softness, kContactSoftness);
    max_speed_mps = kMaxSpringSpeed_mps;
  }
  // A surface may move along, and slip may grow with the force.
  if (traction.speed_mps != 0.0) {
    surface.mode |= dContactMotion1;
    surface.motion1 = traction.speed_mps;
  }
  if (traction.slip_mps_per_n > 0.0) {
    surface.mode |= dContactSlip1;
    surface.slip1 = traction.slip_mps_per_n;
  }
  // Friction acts along the first direction and across it.
  const double length = traction.along.norm();
  const Eigen::Vector3d along =
      length > 1e-9 ? Eigen::Vector3d(traction.along / length) : FrictionDirection(joint);
  for (int i = 0; i < 3; ++i) {
    contact.geom.pos[i] = joint.position_m[i];
    contact.geom.normal[i] = joint.normal[i];
    contact.fdir1[i] = along[i];
  }
  contact.geom.pos[3] = contact.geom.normal[3] = contact.fdir1[3] = 0.0;
  // The depth is cut, so that the contact does not part bodies faster than it may.
  contact.geom.depth = std::min(joint.depth_m, max_speed_mps * step_s / surface.soft_erp);
  contact.geom.g1 = contact.geom.g2 = nullptr;
  contact.geom.side1 = contact.geom.side2 = 0;
  const dJointID made = dJointCreateContact(world_, group_, &contact);
  dJointAttach(made, joint.a.id(), joint.b.id());
  if (feedback != nullptr) {
    *feedback = {};
    dJointSetFeedback(made, feedback);
  }
}

void ContactJoints::Finish(std::vector<Contact>* of_two, std::vector<Contact>* of_one) {
  std::size_t next = 0;
  for (const ContactJoint& joint : found_) {
    if (joint.reported < 0) continue;
    const dReal* force = feedback_[next++].f1;
    std::vector<Contact>* contacts = joint.of_two ? of_two : of_one;
    (*contacts)[static_cast<std::size_t>(joint.reported)].force_n =
        Eigen::Vector3d(force[0], force[1], force[2]);
  }
  dJointGroupEmpty(group_);
  found_.clear();
}

}  // namespace latticeworld
