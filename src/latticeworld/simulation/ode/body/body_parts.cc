#include "latticeworld/simulation/ode/body/body_parts.h"

#include <Eigen/QR>

namespace latticeworld {
namespace {

// Upright bodies turn about z alone: pitch and roll meet this many times their inertia.
constexpr double kUprightInertiaFactor = 1e4;
constexpr double kPartSpin_radps = 400.0;

// What each spring carries of the mass at rest [N]: the least uneven shares that hold the centre of
// mass, which lies over the origin of base_link.
Eigen::VectorXd LoadsOf(const BodySpec& spec) {
  double sprung_kg = spec.total_mass_kg();
  for (const WheelSpec& wheel : spec.wheels) sprung_kg -= wheel.mass_kg;
  const auto count = static_cast<Eigen::Index>(spec.wheels.size());
  Eigen::MatrixXd balance(3, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Eigen::Vector3d& center = spec.wheels[static_cast<std::size_t>(i)].center_m;
    balance.col(i) << 1.0, center.x(), center.y();
  }
  const Eigen::Vector3d wanted(sprung_kg * kGravity_mps2, 0.0, 0.0);
  return balance.completeOrthogonalDecomposition().solve(wanted).cwiseMax(0.0);
}

dMass MassOf(double mass_kg, const Eigen::Vector3d& inertia_kgm2) {
  dMass mass;
  dMassSetParameters(&mass, mass_kg, 0.0, 0.0, 0.0, inertia_kgm2.x(), inertia_kgm2.y(),
                     inertia_kgm2.z(), 0.0, 0.0, 0.0);
  return mass;
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

BodyParts::BodyParts(dWorldID world, const BodySpec& spec)
    : spec_(spec), mass_kg_(spec.total_mass_kg()), trunk_inertia_kgm2_(spec.inertia_kgm2) {
  Make(world);
}

BodyParts::~BodyParts() { Unmake(); }

void BodyParts::MakeAnew(dWorldID world) {
  Unmake();
  Make(world);
}

void BodyParts::Make(dWorldID world) {
  parts_.push_back(MakePart(world, MassOf(spec_.mass_kg, trunk_inertia_kgm2_),
                            {0.0, 0.0, spec_.center_height_m}, kTrunkSpin_radps));
  for (const WheelSpec& wheel : spec_.wheels) {
    dMass mass;
    dMassSetSphereTotal(&mass, wheel.mass_kg, wheel.radius_m);
    parts_.push_back(MakePart(world, mass, wheel.center_m, kPartSpin_radps));
    dBodySetGyroscopicMode(parts_.back(), 0);
    dBodySetFiniteRotationMode(parts_.back(), 1);
  }
  for (const LinkSpec& link : spec_.links) {
    parts_.push_back(
        MakePart(world, MassOf(link.mass_kg, link.inertia_kgm2), link.center_m, kPartSpin_radps));
  }
  MakeJoints(world);
}

void BodyParts::MakeJoints(dWorldID world) {
  const Eigen::VectorXd loads_n = spec_.wheels.empty() ? Eigen::VectorXd() : LoadsOf(spec_);
  for (std::size_t i = 0; i < spec_.wheels.size(); ++i) {
    wheels_.push_back(std::make_unique<WheelJoint>(
        world, spec_.wheels[i], loads_n[static_cast<Eigen::Index>(i)], trunk(), parts_[1 + i]));
  }
  for (std::size_t i = 0; i < spec_.links.size(); ++i) {
    const LinkSpec& link = spec_.links[i];
    const std::size_t first = 1 + spec_.wheels.size();
    const dBodyID parent =
        link.parent < 0 ? trunk() : parts_[first + static_cast<std::size_t>(link.parent)];
    links_.push_back(std::make_unique<LinkJoint>(world, link, parent, parts_[first + i]));
  }
  if (spec_.anchor && spec_.anchor->kind == AnchorKind::kHinge) {
    anchor_ = std::make_unique<AnchorHinge>(world, *spec_.anchor, trunk());
  }
}

void BodyParts::Unmake() {
  anchor_.reset();
  links_.clear();
  wheels_.clear();
  for (const dBodyID part : parts_) dBodyDestroy(part);
  parts_.clear();
}

void BodyParts::SetUpright(bool upright) {
  const double lock = upright ? kUprightInertiaFactor : 1.0;
  trunk_inertia_kgm2_ = spec_.inertia_kgm2.cwiseProduct(Eigen::Vector3d(lock, lock, 1.0));
  const dMass mass = MassOf(spec_.mass_kg, trunk_inertia_kgm2_);
  dBodySetMass(trunk(), &mass);
  dBodySetGyroscopicMode(trunk(), upright ? 0 : 1);
}

BodyMotion BodyParts::Motion() const {
  BodyMotion motion;
  motion.orientation = OrientationOf(trunk());
  motion.position_m = TrunkPoint(Eigen::Vector3d::Zero());
  motion.angular_velocity_radps = ToEigen(dBodyGetAngularVel(trunk()));
  motion.linear_velocity_mps = VelocityAt(trunk(), motion.position_m);
  return motion;
}

BodyMotion BodyParts::LinkMotion(std::size_t i) const {
  BodyMotion motion;
  motion.position_m = LinkPoint(i, spec_.links[i].anchor_m);
  motion.orientation = OrientationOf(link(i));
  motion.linear_velocity_mps = VelocityAt(link(i), motion.position_m);
  motion.angular_velocity_radps = ToEigen(dBodyGetAngularVel(link(i)));
  return motion;
}

void BodyParts::SetMotion(const BodyMotion& motion) {
  const Eigen::Vector3d velocity_mps = Within(motion.linear_velocity_mps, spec_.max_speed_mps);
  const Eigen::Vector3d spin_radps = Within(motion.angular_velocity_radps, kTrunkSpin_radps);
  const Eigen::Vector3d old_base_m = TrunkPoint(Eigen::Vector3d::Zero());
  const Eigen::Quaterniond wanted = motion.orientation.normalized();
  const Eigen::Quaterniond turn = wanted * OrientationOf(trunk()).conjugate();
  for (const dBodyID part : parts_) {
    const bool is_trunk = part == trunk();
    const Eigen::Vector3d arm =
        is_trunk ? Eigen::Vector3d(wanted * Eigen::Vector3d(0.0, 0.0, spec_.center_height_m))
                 : Eigen::Vector3d(turn * (PositionOf(part) - old_base_m));
    SetPosition(part, motion.position_m + arm);
    SetOrientation(part, is_trunk ? wanted : turn * OrientationOf(part));
    SetVelocities(part, velocity_mps + spin_radps.cross(arm), spin_radps);
  }
}

void BodyParts::Drive(const BodyControl& control, double step_s) const {
  const Eigen::Vector3d up = Turned(trunk(), Eigen::Vector3d::UnitZ());
  for (std::size_t i = 0; i < wheels_.size(); ++i) {
    const WheelSpec& wheel_spec = spec_.wheels[i];
    const double deflection_m =
        wheel_spec.spring_npm > 0.0
            ? (PositionOf(wheel(i)) - TrunkPoint(wheel_spec.center_m)).dot(up)
            : 0.0;
    const WheelCommand& command = control.wheels[i];
    wheels_[i]->Drive(command.rate_radps, command.steer_rad, step_s, deflection_m);
  }
  for (std::size_t i = 0; i < links_.size(); ++i) links_[i]->Drive(control.joints[i], step_s);
}

void BodyParts::SetEnabled(bool enabled) const {
  for (const dBodyID part : parts_) {
    if (enabled) {
      dBodyEnable(part);
    } else {
      SetVelocities(part, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero());
      dBodySetForce(part, 0.0, 0.0, 0.0);
      dBodySetTorque(part, 0.0, 0.0, 0.0);
      dBodyDisable(part);
    }
  }
}

}  // namespace latticeworld
