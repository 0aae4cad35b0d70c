#include "latticeworld/simulation/ode/ode_world.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "latticeworld/common/check.h"
#include "latticeworld/common/enum_names.h"
#include "latticeworld/simulation/ode/ode_library.h"
#include "latticeworld/simulation/ode/ode_math.h"
#include "latticeworld/simulation/ode/ode_world_impl.h"

namespace latticeworld {
namespace {

constexpr std::size_t kGroups = 64;  // enough to share among cores, not too many to step
constexpr double kPlacingClearance_m = 0.002;
constexpr double kWakingFriction = 0.02;  // a change of friction that what rests may feel
constexpr double kWakingReach_m = 0.05;

constexpr double kFarthest_m = 1e7;  // from the middle of the world

// Of finite numbers, near enough to be reckoned with.
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
    : scene_(std::move(scene)),
      ground_(scene_->atmosphere.ground()),
      surfaces_(*scene_, ground_),
      threads_(threads) {
  ReadyOde();
  for (std::size_t i = 0; i < kGroups; ++i) groups_.push_back(std::make_unique<IslandGroup>());
  for (const auto& entry : EnumNames(SurfaceClass{})) {
    woken_friction_[static_cast<std::size_t>(entry.value)] = surfaces_.Of(entry.value).friction;
  }
}

OdeWorld::~OdeWorld() = default;

std::size_t OdeWorld::IndexOf(BodyId id) const {
  const auto found =
      std::lower_bound(bodies_.begin(), bodies_.end(), id,
                       [](const Entry& entry, BodyId key) { return entry.id < key; });
  LW_CHECK(found != bodies_.end() && found->id == id, "no such body");
  return static_cast<std::size_t>(found - bodies_.begin());
}

OdeBody& OdeWorld::At(BodyId id) const { return *bodies_[IndexOf(id)].body; }

BodyId OdeWorld::Place(const BodySpec& spec, const BodyMotion& motion, bool lift) {
  ReadyOde();
  CheckSpec(spec);
  const BodyId id = ++last_id_;
  auto shared = std::make_shared<const BodySpec>(spec);
  const std::size_t home = HomeOf(id);
  const dWorldID world = groups_[home]->world();
  bodies_.push_back({id, std::make_unique<OdeBody>(world, id, std::move(shared)), home, {}});
  OdeBody* body = bodies_.back().body.get();
  // What is put nowhere begins in the middle of the world, and has strayed.
  const bool finite = IsSomewhere(motion);
  body->SetMotion(finite ? motion : BodyMotion());
  if (lift || !finite) LiftOutOfGround(body);
  if (body->ball_radius_m() >= 0.0) sweep_.Add(body);
  if (!finite) body->Spoil();
  return id;
}

BodyId OdeWorld::Add(const BodySpec& spec, const Eigen::Vector3d& position_m, double yaw_rad) {
  BodyMotion motion;
  motion.position_m = position_m;
  const Eigen::AngleAxisd heading(yaw_rad, Eigen::Vector3d::UnitZ());
  motion.orientation = heading;
  if (!spec.upright && !spec.wheels.empty() && position_m.allFinite()) {
    const Eigen::Vector3d normal = ground().NormalAt({position_m.x(), position_m.y()});
    motion.orientation =
        Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), normal) * heading;
  }
  return Place(spec, motion, !spec.anchor);
}

BodyId OdeWorld::Add(const BodySpec& spec, const BodyMotion& motion) {
  return Place(spec, motion, false);
}

void OdeWorld::Remove(BodyId id) {
  OdeBody* body = &At(id);
  WakeAround(body);
  sweep_.Remove(body);
  bodies_.erase(std::find_if(bodies_.begin(), bodies_.end(),
                             [id](const Entry& entry) { return entry.id == id; }));
}

const BodySpec& OdeWorld::SpecOf(BodyId body) const { return At(body).spec(); }

void OdeWorld::SetWalkVelocity(BodyId body, const Eigen::Vector3d& velocity_mps) {
  At(body).SetWalkVelocity(velocity_mps);
}

void OdeWorld::SetWheel(BodyId body, std::size_t wheel, double rate_radps, double steer_rad) {
  At(body).SetWheel(wheel, {rate_radps, steer_rad});
}

JointReading OdeWorld::WheelOf(BodyId body, std::size_t wheel) const {
  return At(body).WheelReading(wheel);
}

JointReading OdeWorld::SteeringOf(BodyId body, std::size_t wheel) const {
  return At(body).SteeringReading(wheel);
}

void OdeWorld::SetJoint(BodyId body, std::size_t link, const JointTarget& target) {
  At(body).SetJoint(link, target);
}

JointReading OdeWorld::JointOf(BodyId body, std::size_t link) const {
  return At(body).LinkReading(link);
}

BodyMotion OdeWorld::LinkMotionOf(BodyId body, std::size_t link) const {
  return At(body).LinkMotion(link);
}

void OdeWorld::AddForce(BodyId id, const Eigen::Vector3d& force_n) {
  OdeBody& body = At(id);
  if (!body.TakesForce(force_n, Eigen::Vector3d::Zero())) return;
  dBodyAddForce(body.trunk(), force_n.x(), force_n.y(), force_n.z());
}

void OdeWorld::AddForceAt(BodyId id, const Eigen::Vector3d& force_n,
                          const Eigen::Vector3d& point_m) {
  OdeBody& body = At(id);
  if (!body.TakesForce(force_n, point_m)) return;
  dBodyAddForceAtPos(body.trunk(), force_n.x(), force_n.y(), force_n.z(), point_m.x(), point_m.y(),
                     point_m.z());
}

void OdeWorld::AddTorque(BodyId id, const Eigen::Vector3d& torque_nm) {
  OdeBody& body = At(id);
  if (!body.TakesForce(torque_nm, Eigen::Vector3d::Zero())) return;
  dBodyAddTorque(body.trunk(), torque_nm.x(), torque_nm.y(), torque_nm.z());
}

void OdeWorld::AddImpulse(BodyId body, const Eigen::Vector3d& impulse_ns,
                          const Eigen::Vector3d& point_m) {
  At(body).AddImpulse(impulse_ns, point_m);
}

void OdeWorld::SetUpright(BodyId id, bool upright) {
  OdeBody& body = At(id);
  const bool rises = upright && !body.control().upright;
  body.SetUpright(upright);
  if (rises) LiftOutOfGround(&body);
}

bool OdeWorld::IsUpright(BodyId body) const { return At(body).control().upright; }

void OdeWorld::SetAnchored(BodyId id, bool anchored) {
  OdeBody& body = At(id);
  if (body.control().anchored && !anchored) WakeAround(&body);
  body.SetAnchored(anchored);
}

bool OdeWorld::IsAnchored(BodyId body) const { return At(body).control().anchored; }

double OdeWorld::AnchorAngleOf(BodyId body) const { return At(body).AnchorAngle(); }

void OdeWorld::SetAssetPresent(std::uint32_t index, bool present) {
  if (index >= scene_->assets.size()) return;
  if (present) {
    gone_assets_.erase(index);
    return;
  }
  if (!gone_assets_.insert(index).second) return;
  const Asset& asset = scene_->assets[index];
  const double reach_m = SolidRadius(asset);
  const Eigen::Vector3d base(asset.x_m, asset.y_m, asset.z_m);
  WakeNear({base - Eigen::Vector3d(reach_m, reach_m, 1.0),
            base + Eigen::Vector3d(reach_m, reach_m, asset.height_m + reach_m)});
}

void OdeWorld::SetGround(const GroundState& ground) {
  ground_ = ground;
  surfaces_ = SurfaceTable(*scene_, ground);
  bool changed = false;
  for (const auto& entry : EnumNames(SurfaceClass{})) {
    const double friction = surfaces_.Of(entry.value).friction;
    const double woken = woken_friction_[static_cast<std::size_t>(entry.value)];
    changed = changed || std::abs(friction - woken) > kWakingFriction;
  }
  // Weather that moves slowly shall not keep everybody awake.
  if (!changed) return;
  for (const auto& entry : EnumNames(SurfaceClass{})) {
    woken_friction_[static_cast<std::size_t>(entry.value)] = surfaces_.Of(entry.value).friction;
  }
  for (Entry& entry : bodies_) entry.body->Wake();
}

void OdeWorld::Place(BodyId id, const BodyMotion& motion) {
  OdeBody& body = At(id);
  if (!IsSomewhere(motion)) return body.Spoil();
  WakeAround(&body);
  body.SetMotion(motion);
}

BodyMotion OdeWorld::MotionOf(BodyId body) const { return At(body).Motion(); }
double OdeWorld::SinkageOf(BodyId body) const { return Sinkage(At(body)); }
bool OdeWorld::IsResting(BodyId body) const { return At(body).stands(); }
double OdeWorld::EnergyOf(BodyId body) const { return At(body).Energy(); }

double OdeWorld::Sinkage(const OdeBody& body) const {
  const BodySpec& spec = body.spec();
  double depth_m = 0.0;
  for (std::size_t i = 0; i < spec.wheels.size(); ++i) {
    depth_m = std::max(
        depth_m, DepthBelowGround(ground(), PositionOf(body.wheel(i)), spec.wheels[i].radius_m));
  }
  for (const GroundSample& sample : spec.ground_samples) {
    const Eigen::Vector3d at = body.TrunkPoint(sample.offset_m);
    depth_m = std::max(depth_m, DepthBelowGround(ground(), at, sample.radius_m));
  }
  for (std::size_t i = 0; i < spec.links.size(); ++i) {
    for (const GroundSample& sample : spec.links[i].ground_samples) {
      const Eigen::Vector3d at = body.LinkPoint(i, sample.offset_m);
      depth_m = std::max(depth_m, DepthBelowGround(ground(), at, sample.radius_m));
    }
  }
  return depth_m;
}

// Straight up, until nothing of the body is below the ground.
void OdeWorld::LiftOutOfGround(OdeBody* body) const {
  constexpr int kTries = 32;  // each undoes most of the depth even on steep ground
  for (int i = 0; i < kTries; ++i) {
    const double depth_m = Sinkage(*body);
    if (depth_m <= 0.0) return;
    BodyMotion motion = body->Motion();
    motion.position_m.z() += depth_m + kPlacingClearance_m;
    body->SetMotion(motion);
  }
}

void OdeWorld::WakeNear(const Bounds& bounds) {
  for (Entry& entry : bodies_) {
    if (!entry.body->resting()) continue;
    // Its whole ball: feet have no solids of their own.
    const Eigen::Vector3d center = entry.body->BallCenter();
    const Eigen::Vector3d nearest = center.cwiseMax(bounds.low_m).cwiseMin(bounds.high_m);
    const double radius_m = entry.body->ball_radius_m();
    if (radius_m < 0.0 || (nearest - center).squaredNorm() > radius_m * radius_m) continue;
    entry.body->Wake();
  }
}

void OdeWorld::WakeAround(OdeBody* body) {
  for (const OdeBody::BodySolid& one : body->PosedSolids()) {
    Bounds bounds = one.solid.bounds();
    bounds.low_m.array() -= kWakingReach_m;
    bounds.high_m.array() += kWakingReach_m;
    WakeNear(bounds);
  }
}

std::unique_ptr<PhysicsWorld> MakeOdeWorld(std::shared_ptr<const Scene> scene, int threads) {
  return std::make_unique<OdeWorld>(std::move(scene), threads);
}

std::chrono::nanoseconds CollisionTime(const PhysicsWorld& world) {
  const auto* ode = dynamic_cast<const OdeWorld*>(&world);
  return ode != nullptr ? ode->collision_time() : std::chrono::nanoseconds(0);
}

}  // namespace latticeworld
