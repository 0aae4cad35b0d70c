#include "latticeworld/simulation/ode/ode_body.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <utility>

#include "latticeworld/simulation/ode/ode_math.h"

namespace latticeworld {
namespace {

// Upright bodies turn about z alone: pitch and roll meet this many times their inertia.
constexpr double kUprightInertiaFactor = 1e4;
constexpr double kPartSpin_radps = 400.0;

// What each spring carries of the mass at rest [N]: the least uneven shares that hold the centre of
// mass, which lies over the origin of base_link.
Eigen::VectorXd LoadsOf(const BodySpec& spec, double sprung_kg) {
  const auto count = static_cast<Eigen::Index>(spec.wheels.size());
  Eigen::MatrixXd balance(3, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Eigen::Vector3d& center = spec.wheels[static_cast<std::size_t>(i)].center_m;
    balance.col(i) << 1.0, center.x(), center.y();
  }
  const Eigen::Vector3d wanted(sprung_kg * kGravity_mps2, 0.0, 0.0);
  return balance.completeOrthogonalDecomposition().solve(wanted).cwiseMax(0.0);
}

dBodyID MakePart(dWorldID world, const dMass& mass, const Eigen::Vector3d& center_m,
                 double max_spin_radps) {
  const dBodyID part = dBodyCreate(world);
  dBodySetMass(part, &mass);
  dBodySetMaxAngularSpeed(part, max_spin_radps);
  SetPosition(part, center_m);
  return part;
}

}  // namespace

OdeBody::OdeBody(dWorldID world, BodyId id, std::shared_ptr<const BodySpec> spec)
    : id_(id), spec_(std::move(spec)), mass_kg_(spec_->total_mass_kg()) {
  Make(world);
  control_.wheels.resize(wheels_.size());
  control_.joints.resize(links_.size());
  control_.upright = spec_->upright;
  SetInertia();
  before_.resize(parts_.size());
  MakeSolids();
  if (spec_->anchor) SetAnchored(true);
}

OdeBody::~OdeBody() { Unmake(); }

void OdeBody::MoveTo(dWorldID world) {
  const BodyState state = Save();
  Unmake();
  Make(world);
  Restore(state);
}

void OdeBody::Make(dWorldID world) {
  dMass mass;
  dMassSetParameters(&mass, spec_->mass_kg, 0.0, 0.0, 0.0, spec_->inertia_kgm2.x(),
                     spec_->inertia_kgm2.y(), spec_->inertia_kgm2.z(), 0.0, 0.0, 0.0);
  const Eigen::Vector3d trunk_m(0.0, 0.0, spec_->center_height_m);
  parts_.push_back(MakePart(world, mass, trunk_m, kTrunkSpin_radps));
  double sprung_kg = mass_kg_;
  for (const WheelSpec& wheel : spec_->wheels) {
    sprung_kg -= wheel.mass_kg;
    dMassSetSphereTotal(&mass, wheel.mass_kg, wheel.radius_m);
    parts_.push_back(MakePart(world, mass, wheel.center_m, kPartSpin_radps));
    dBodySetGyroscopicMode(parts_.back(), 0);
    dBodySetFiniteRotationMode(parts_.back(), 1);
  }
  for (const LinkSpec& link : spec_->links) {
    dMassSetParameters(&mass, link.mass_kg, 0.0, 0.0, 0.0, link.inertia_kgm2.x(),
                       link.inertia_kgm2.y(), link.inertia_kgm2.z(), 0.0, 0.0, 0.0);
    parts_.push_back(MakePart(world, mass, link.center_m, kPartSpin_radps));
  }

  const Eigen::VectorXd loads_n =
      spec_->wheels.empty() ? Eigen::VectorXd() : LoadsOf(*spec_, sprung_kg);
  for (std::size_t i = 0; i < spec_->wheels.size(); ++i) {
    wheels_.push_back(std::make_unique<WheelJoint>(
        world, spec_->wheels[i], loads_n[static_cast<Eigen::Index>(i)], trunk(), parts_[1 + i]));
  }
  for (std::size_t i = 0; i < spec_->links.size(); ++i) {
    const LinkSpec& link = spec_->links[i];
    const std::size_t first = 1 + spec_->wheels.size();
    const dBodyID parent =
        link.parent < 0 ? trunk() : parts_[first + static_cast<std::size_t>(link.parent)];
    links_.push_back(std::make_unique<LinkJoint>(world, link, parent, parts_[first + i]));
  }
  if (spec_->anchor && spec_->anchor->kind == AnchorKind::kHinge) {
    anchor_ = dJointCreateHinge(world, nullptr);
    dJointAttach(anchor_, trunk(), nullptr);
    dJointSetHingeParam(anchor_, dParamHiStop, spec_->anchor->high_rad);
    dJointSetHingeParam(anchor_, dParamLoStop, spec_->anchor->low_rad);
    dJointSetHingeParam(anchor_, dParamHiStop, spec_->anchor->high_rad);
    dJointSetHingeParam(anchor_, dParamFMax, spec_->anchor->friction_nm);
    dJointDisable(anchor_);
  }
}

void OdeBody::Unmake() {
  if (anchor_ != nullptr) dJointDestroy(anchor_);
  anchor_ = nullptr;
  links_.clear();
  wheels_.clear();
  for (const dBodyID part : parts_) dBodyDestroy(part);
  parts_.clear();
}

void OdeBody::MakeSolids() {
  for (const BodyShape& shape : spec_->shapes) {
    BodyShape of_trunk = shape;
    of_trunk.center_m.z() -= spec_->center_height_m;
    solids_.push_back({Solid(of_trunk), 0});
  }
  for (std::size_t i = 0; i < wheels_.size(); ++i) {
    BodyShape ball;
    ball.radius_m = spec_->wheels[i].radius_m;
    solids_.push_back({Solid(ball), 1 + i});
  }
  MakeBall();
}

// However wheels move on their springs and links on their hinges, it holds them all.
void OdeBody::MakeBall() {
  if (solids_.empty()) return;
  Bounds bounds = PosedSolids().front().solid.bounds();
  for (const BodySolid& one : PosedSolids()) bounds.Include(one.solid.bounds());
  const auto include = [&bounds](const Eigen::Vector3d& center_m, double radius_m) {
    const Eigen::Vector3d extent = Eigen::Vector3d::Constant(radius_m);
    bounds.Include({center_m - extent, center_m + extent});
  };
  for (const GroundSample& sample : spec_->ground_samples)
    include(sample.offset_m, sample.radius_m);
  std::vector<double> reach_m;  // from the first hinge of its chain to a link's own
  std::vector<std::size_t> root;
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const LinkSpec& link = spec_->links[i];
    const bool on_trunk = link.parent < 0;
    const auto parent = static_cast<std::size_t>(std::max(link.parent, 0));
    root.push_back(on_trunk ? i : root[parent]);
    reach_m.push_back(
        on_trunk ? 0.0 : reach_m[parent] + (link.anchor_m - spec_->links[parent].anchor_m).norm());
    for (const GroundSample& sample : link.ground_samples) {
      include(spec_->links[root[i]].anchor_m,
              reach_m[i] + (sample.offset_m - link.anchor_m).norm() + sample.radius_m);
    }
  }
  ball_center_m_ = 0.5 * (bounds.low_m + bounds.high_m);
  ball_radius_m_ = 0.5 * (bounds.high_m - bounds.low_m).norm();
  double travel_m = 0.0;
  for (const WheelSpec& wheel : spec_->wheels) {
    travel_m = std::max(travel_m, wheel.spring_npm > 0.0 ? 2.0 * wheel.travel_m : 0.0);
  }
  ball_radius_m_ += travel_m;
  Moved();
}

std::vector<OdeBody::BodySolid>& OdeBody::PosedSolids() {
  if (posed_) return solids_;
  for (BodySolid& one : solids_) {
    const dBodyID part = parts_[one.part];
    one.solid.SetPose(PositionOf(part), dBodyGetRotation(part));
  }
  posed_ = true;
  return solids_;
}

Eigen::Vector3d OdeBody::TrunkInertia() const {
  const double lock = control_.upright ? kUprightInertiaFactor : 1.0;
  return spec_->inertia_kgm2.cwiseProduct(Eigen::Vector3d(lock, lock, 1.0));
}

void OdeBody::SetInertia() {
  const Eigen::Vector3d inertia = TrunkInertia();
  dMass mass;
  dMassSetParameters(&mass, spec_->mass_kg, 0.0, 0.0, 0.0, inertia.x(), inertia.y(), inertia.z(),
                     0.0, 0.0, 0.0);
  dBodySetMass(trunk(), &mass);
  dBodySetGyroscopicMode(trunk(), control_.upright ? 0 : 1);
}

BodyMotion OdeBody::Motion() const {
  BodyMotion motion;
  motion.orientation = OrientationOf(trunk());
  motion.position_m = TrunkPoint(Eigen::Vector3d::Zero());
  motion.angular_velocity_radps = ToEigen(dBodyGetAngularVel(trunk()));
  motion.linear_velocity_mps = VelocityAt(trunk(), motion.position_m);
  return motion;
}

void OdeBody::SetMotion(const BodyMotion& motion) {
  const Eigen::Vector3d velocity_mps = Within(motion.linear_velocity_mps, spec_->max_speed_mps);
  const Eigen::Vector3d spin_radps = Within(motion.angular_velocity_radps, kTrunkSpin_radps);
  const Eigen::Vector3d old_base_m = TrunkPoint(Eigen::Vector3d::Zero());
  const Eigen::Quaterniond wanted = motion.orientation.normalized();
  const Eigen::Quaterniond turn = wanted * OrientationOf(trunk()).conjugate();
  for (const dBodyID part : parts_) {
    const bool is_trunk = part == trunk();
    const Eigen::Vector3d arm =
        is_trunk ? Eigen::Vector3d(wanted * Eigen::Vector3d(0.0, 0.0, spec_->center_height_m))
                 : Eigen::Vector3d(turn * (PositionOf(part) - old_base_m));
    SetPosition(part, motion.position_m + arm);
    SetOrientation(part, is_trunk ? wanted : turn * OrientationOf(part));
    SetVelocities(part, velocity_mps + spin_radps.cross(arm), spin_radps);
  }
  Moved();
  if (control_.anchored) Anchor();
  Wake();
}

Eigen::Vector3d OdeBody::TrunkPoint(const Eigen::Vector3d& in_base_m) const {
  return PositionOf(trunk()) +
         Turned(trunk(), in_base_m - Eigen::Vector3d(0.0, 0.0, spec_->center_height_m));
}

Eigen::Vector3d OdeBody::LinkPoint(std::size_t i, const Eigen::Vector3d& in_base_m) const {
  return PositionOf(link(i)) + Turned(link(i), in_base_m - spec_->links[i].center_m);
}

BodyMotion OdeBody::LinkMotion(std::size_t i) const {
  BodyMotion motion;
  motion.position_m = LinkPoint(i, spec_->links[i].anchor_m);
  motion.orientation = OrientationOf(link(i));
  motion.linear_velocity_mps = VelocityAt(link(i), motion.position_m);
  motion.angular_velocity_radps = ToEigen(dBodyGetAngularVel(link(i)));
  return motion;
}

double OdeBody::AnchorAngle() const {
  return anchor_ != nullptr && control_.anchored ? dJointGetHingeAngle(anchor_) : 0.0;
}

void OdeBody::SetWalkVelocity(const Eigen::Vector3d& velocity_mps) {
  if (!velocity_mps.allFinite()) return Spoil();
  if (velocity_mps == control_.walk_velocity_mps) return;
  control_.walk_velocity_mps = velocity_mps;
  Wake();
}

void OdeBody::SetWheel(std::size_t i, const WheelCommand& command) {
  if (!std::isfinite(command.rate_radps) || !std::isfinite(command.steer_rad)) return Spoil();
  WheelCommand& known = control_.wheels[WheelIndex(i)];
  if (command.rate_radps == known.rate_radps && command.steer_rad == known.steer_rad) return;
  known = command;
  Wake();
}

void OdeBody::SetJoint(std::size_t i, const JointTarget& target) {
  if (!std::isfinite(target.value)) return Spoil();
  JointTarget& known = control_.joints[LinkIndex(i)];
  if (target.mode == known.mode && target.value == known.value) return;
  known = target;
  Wake();
}

void OdeBody::SetUpright(bool upright) {
  if (upright == control_.upright) return;
  control_.upright = upright;
  SetInertia();
  if (upright) {
    BodyMotion motion = Motion();
    motion.orientation = Eigen::AngleAxisd(motion.yaw_rad(), Eigen::Vector3d::UnitZ());
    motion.angular_velocity_radps.head<2>().setZero();
    SetMotion(motion);
  }
  Wake();
}

void OdeBody::SetAnchored(bool anchored) {
  if (anchored == control_.anchored) return;
  control_.anchored = anchored;
  if (anchored) {
    Anchor();
  } else if (anchor_ != nullptr) {
    dJointDisable(anchor_);
  }
  SetEnabled(!stands());
  Wake();
}

void OdeBody::AddImpulse(const Eigen::Vector3d& impulse_ns, const Eigen::Vector3d& point_m) {
  if (!impulse_ns.allFinite() || !point_m.allFinite()) return Spoil();
  if (fixed() || impulse_ns.isZero(0.0)) return;
  const Eigen::Matrix3d map_from_base = OrientationOf(trunk()).toRotationMatrix();
  const Eigen::Vector3d turning = (point_m - PositionOf(trunk())).cross(impulse_ns);
  const Eigen::Vector3d spin =
      ToEigen(dBodyGetAngularVel(trunk())) +
      map_from_base * (map_from_base.transpose() * turning).cwiseQuotient(TrunkInertia());
  const Eigen::Vector3d velocity =
      ToEigen(dBodyGetLinearVel(trunk())) + impulse_ns / spec_->mass_kg;
  if (!velocity.allFinite() || !spin.allFinite()) return Spoil();
  Wake();
  SetVelocities(trunk(), Within(velocity, spec_->max_speed_mps), Within(spin, kTrunkSpin_radps));
}

bool OdeBody::TakesForce(const Eigen::Vector3d& force_n, const Eigen::Vector3d& point_m) {
  if (!force_n.allFinite() || !point_m.allFinite()) {
    Spoil();
    return false;
  }
  if (fixed() || force_n.isZero(0.0)) return false;
  // What floats is pushed in every step and shall come to rest all the same.
  if (control_.resting) Wake();
  return true;
}

}  // namespace latticeworld
