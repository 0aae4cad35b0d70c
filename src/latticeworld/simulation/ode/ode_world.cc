#include "latticeworld/simulation/ode/ode_world.h"

#include <cmath>
#include <utility>

#include "latticeworld/common/check.h"
#include "latticeworld/geometry/upright.h"
#include "latticeworld/simulation/ode/ode_library.h"
#include "latticeworld/simulation/ode/ode_math.h"
#include "latticeworld/simulation/ode/ode_world_impl.h"

namespace latticeworld {
namespace {

constexpr double kFarthest_m = 1e7;  // from the middle of the world

// Returns whether a motion has finite numbers, and is near enough to be reckoned with.
bool IsSomewhere(const BodyMotion& motion) {
  const double norm = motion.orientation.coeffs().stableNorm();
  return motion.position_m.allFinite() && motion.position_m.cwiseAbs().maxCoeff() < kFarthest_m &&
         std::isfinite(norm) && norm > 1e-6 && norm < 1e6 &&
         motion.linear_velocity_mps.allFinite() && motion.angular_velocity_radps.allFinite();
}

void CheckSpec(const BodySpec& spec) {
  const auto check = [](double mass_kg, const Eigen::Vector3d& inertia_kgm2) {
    LW_CHECK(std::isfinite(mass_kg) && mass_kg > 0.0, "a part of a body has no mass");
    LW_CHECK(inertia_kgm2.allFinite() && inertia_kgm2.minCoeff() > 0.0,
             "a part of a body has no inertia");
  };
  check(spec.mass_kg, spec.inertia_kgm2);
  for (const WheelSpec& wheel : spec.wheels) {
    check(wheel.mass_kg, Eigen::Vector3d::Constant(wheel.radius_m));
  }
  for (const LinkSpec& link : spec.links) check(link.mass_kg, link.inertia_kgm2);
}

}  // namespace

OdeWorld::OdeWorld(std::shared_ptr<const Scene> scene, int threads)
    : scene_(std::move(scene)), ground_(scene_), assets_(scene_), groups_(threads) {}

BodyId OdeWorld::Add(const BodySpec& spec, const BodyMotion& motion) {
  ReadyOde();
  CheckSpec(spec);
  const BodyId id = ++last_id_;
  OdeBody* body = bodies_.Add(id, std::make_shared<const BodySpec>(spec), groups_.HomeOf(id));
  if (IsSomewhere(motion)) {
    body->SetMotion(motion);
    return id;
  }
  // What is put nowhere begins in the middle of the world, and has strayed.
  body->SetMotion(BodyMotion());
  ground_.LiftOut(body);
  body->Spoil();
  return id;
}

BodyId OdeWorld::Add(const BodySpec& spec, const Eigen::Vector3d& position_m, double yaw_rad) {
  BodyMotion motion;
  motion.position_m = position_m;
  const Eigen::AngleAxisd heading(yaw_rad, Eigen::Vector3d::UnitZ());
  motion.orientation = heading;
  if (!spec.upright && !spec.wheels.empty() && position_m.allFinite()) {
    const Eigen::Vector3d normal =
        scene_->terrain->ground.NormalAt({position_m.x(), position_m.y()});
    motion.orientation = TurnFromUp(normal) * heading;
  }
  const BodyId id = Add(spec, motion);
  if (!spec.anchor && IsSomewhere(motion)) ground_.LiftOut(&bodies_.At(id));
  return id;
}

void OdeWorld::Remove(BodyId id) {
  bodies_.WakeAround(&bodies_.At(id));
  bodies_.Remove(id);
}

const BodySpec& OdeWorld::SpecOf(BodyId body) const { return bodies_.At(body).spec(); }

void OdeWorld::SetWalkVelocity(BodyId body, const Eigen::Vector3d& velocity_mps) {
  bodies_.At(body).SetWalkVelocity(velocity_mps);
}

void OdeWorld::SetWheel(BodyId body, std::size_t wheel, double rate_radps, double steer_rad) {
  WheelCommand command;
  command.rate_radps = rate_radps;
  command.steer_rad = steer_rad;
  bodies_.At(body).SetWheel(wheel, command);
}

JointReading OdeWorld::WheelOf(BodyId body, std::size_t wheel) const {
  return bodies_.At(body).parts().wheel_joint(wheel).Reading();
}

JointReading OdeWorld::SteeringOf(BodyId body, std::size_t wheel) const {
  return bodies_.At(body).parts().wheel_joint(wheel).Steering();
}

void OdeWorld::SetJoint(BodyId body, std::size_t link, const JointTarget& target) {
  bodies_.At(body).SetJoint(link, target);
}

JointReading OdeWorld::JointOf(BodyId body, std::size_t link) const {
  return bodies_.At(body).parts().link_joint(link).Reading();
}

BodyMotion OdeWorld::LinkMotionOf(BodyId body, std::size_t link) const {
  return bodies_.At(body).parts().LinkMotion(link);
}

void OdeWorld::AddForce(BodyId id, const Eigen::Vector3d& force_n) {
  OdeBody& body = bodies_.At(id);
  if (!body.TakesForce(force_n, Eigen::Vector3d::Zero())) return;
  dBodyAddForce(body.parts().trunk(), force_n.x(), force_n.y(), force_n.z());
}

void OdeWorld::AddForceAt(BodyId id, const Eigen::Vector3d& force_n,
                          const Eigen::Vector3d& point_m) {
  OdeBody& body = bodies_.At(id);
  if (!body.TakesForce(force_n, point_m)) return;
  dBodyAddForceAtPos(body.parts().trunk(), force_n.x(), force_n.y(), force_n.z(), point_m.x(),
                     point_m.y(), point_m.z());
}

void OdeWorld::AddTorque(BodyId id, const Eigen::Vector3d& torque_nm) {
  OdeBody& body = bodies_.At(id);
  if (!body.TakesForce(torque_nm, Eigen::Vector3d::Zero())) return;
  dBodyAddTorque(body.parts().trunk(), torque_nm.x(), torque_nm.y(), torque_nm.z());
}

void OdeWorld::AddImpulse(BodyId body, const Eigen::Vector3d& impulse_ns,
                          const Eigen::Vector3d& point_m) {
  bodies_.At(body).AddImpulse(impulse_ns, point_m);
}

void OdeWorld::SetUpright(BodyId id, bool upright) {
  OdeBody& body = bodies_.At(id);
  const bool rises = upright && !body.control().upright;
  body.SetUpright(upright);
  if (rises) ground_.LiftOut(&body);
}

bool OdeWorld::IsUpright(BodyId body) const { return bodies_.At(body).control().upright; }

void OdeWorld::SetAnchored(BodyId id, bool anchored) {
  OdeBody& body = bodies_.At(id);
  if (body.control().anchored && !anchored) bodies_.WakeAround(&body);
  body.SetAnchored(anchored);
}

bool OdeWorld::IsAnchored(BodyId body) const { return bodies_.At(body).control().anchored; }

double OdeWorld::AnchorAngleOf(BodyId body) const { return bodies_.At(body).AnchorAngle(); }

void OdeWorld::SetAssetPresent(std::uint32_t asset, bool present) {
  if (assets_.SetPresent(asset, present)) bodies_.WakeNear(assets_.BoundsOf(asset));
}

void OdeWorld::SetGround(const GroundState& ground) {
  if (!ground_.SetWeathered(ground)) return;
  for (const OdeBodies::Entry& entry : bodies_.all()) entry.body->Wake();
}

void OdeWorld::Place(BodyId id, const BodyMotion& motion) {
  OdeBody& body = bodies_.At(id);
  if (!IsSomewhere(motion)) return body.Spoil();
  bodies_.WakeAround(&body);
  body.SetMotion(motion);
}

BodyMotion OdeWorld::MotionOf(BodyId body) const { return bodies_.At(body).parts().Motion(); }
double OdeWorld::SinkageOf(BodyId body) const { return ground_.SinkageOf(bodies_.At(body)); }
bool OdeWorld::IsResting(BodyId body) const { return bodies_.At(body).stands(); }
double OdeWorld::EnergyOf(BodyId body) const { return bodies_.At(body).energy().Total(); }

std::unique_ptr<PhysicsWorld> MakeOdeWorld(std::shared_ptr<const Scene> scene, int threads) {
  return std::make_unique<OdeWorld>(std::move(scene), threads);
}

std::chrono::nanoseconds CollisionTime(const PhysicsWorld& world) {
  const auto* ode = dynamic_cast<const OdeWorld*>(&world);
  return ode != nullptr ? ode->collision_time() : std::chrono::nanoseconds(0);
}

}  // namespace latticeworld
