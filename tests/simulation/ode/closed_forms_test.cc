// What bodies do against what textbooks say in closed form.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "latticeworld/simulation/ode/ode_world.h"
#include "simulation/ode/closed_form_bodies.h"
#include "simulation/test_scene.h"

namespace latticeworld {
namespace {

constexpr double kStep_s = 0.01;

void StepFor(PhysicsWorld* physics, double seconds, double step_s = kStep_s) {
  const auto steps = std::lround(seconds / step_s);
  for (long i = 0; i < steps; ++i) physics->Step(step_s, static_cast<std::uint64_t>(i));
}

// Semi-implicit Euler sums g t (t + dt) / 2: exact but for rounding.
TEST(ClosedFormsTest, FreeFallAndThrowsAreTheSumOfTheirSteps) {
  for (const double step_s : {0.001, 0.005, 0.01, 0.05}) {
    const auto physics = MakeOdeWorld(TestScene().Build());
    const Eigen::Vector3d from_m(1.0, 2.0, 40.0), velocity_mps(3.0, -2.0, 5.0);
    const BodyId ball = physics->Add(BallInTheAir(2.0, 0.2), At(from_m, velocity_mps));
    const double time_s = 1.5;
    StepFor(physics.get(), time_s, step_s);
    Eigen::Vector3d to_m = from_m + velocity_mps * time_s;
    to_m.z() -= 0.5 * kGravity_mps2 * time_s * (time_s + step_s);
    const BodyMotion motion = physics->MotionOf(ball);
    EXPECT_LT((motion.position_m - to_m).norm(), 1e-9) << step_s;
    EXPECT_NEAR(motion.linear_velocity_mps.z(), velocity_mps.z() - kGravity_mps2 * time_s, 1e-9);
  }
}

struct Slide {
  double way_m = 0.0;              // within the second second
  double acceleration_mps2 = 0.0;  // in it
};

// A body on a plane that rises towards a bearing.
Slide SlideOf(const BodySpec& spec, double slope_rad, double bearing_rad, SurfaceClass surface) {
  const Eigen::Vector2d uphill(std::cos(bearing_rad), std::sin(bearing_rad));
  TestScene scene;
  scene.cells = 64;
  scene.height_m = [=](double x_m, double y_m) {
    return std::tan(slope_rad) * uphill.dot(Eigen::Vector2d(x_m, y_m));
  };
  scene.surface = [surface](double, double) { return surface; };
  const auto physics = MakeOdeWorld(scene.Build());
  BodyMotion motion = At(Eigen::Vector3d::Zero());
  if (!spec.upright) {
    motion.orientation = Eigen::Quaterniond::FromTwoVectors(
        Eigen::Vector3d::UnitZ(),
        Eigen::Vector3d(-uphill.x() * std::sin(slope_rad), -uphill.y() * std::sin(slope_rad),
                        std::cos(slope_rad)));
  }
  const BodyId body = physics->Add(spec, motion);
  StepFor(physics.get(), 1.0);
  const BodyMotion before = physics->MotionOf(body);
  StepFor(physics.get(), 1.0);
  const BodyMotion after = physics->MotionOf(body);
  return {(after.position_m - before.position_m).norm(),
          after.linear_velocity_mps.norm() - before.linear_velocity_mps.norm()};
}

double FrictionOf(SurfaceClass surface) { return DryPropertiesOf(surface).friction; }

// Friction is a pyramid along and across the slope, so that Coulomb's angle holds downhill
// whatever way the slope faces; one degree on either side leaves room for the contacts' softness
// and for the slow creep below the angle that it brings.
TEST(ClosedFormsTest, BoxesAndFeetSlideBeyondTheAngleOfFrictionAlone) {
  BodySpec walker = Box(60.0, {0.2, 0.2, 0.8});
  walker.upright = true;
  walker.ground_samples = {{Eigen::Vector3d::Zero(), 0.0}};
  const BodySpec box = Box(10.0, {0.4, 0.4, 0.05});
  const double degree_rad = M_PI / 180.0;
  for (const SurfaceClass surface :
       {SurfaceClass::kGrass, SurfaceClass::kRoad, SurfaceClass::kSnow}) {
    const double critical_rad = std::atan(FrictionOf(surface));
    for (const double bearing_rad : {0.0, 0.5 * M_PI, 0.6, -2.0}) {
      for (const BodySpec* spec : {&box, static_cast<const BodySpec*>(&walker)}) {
        EXPECT_LT(SlideOf(*spec, critical_rad - degree_rad, bearing_rad, surface).way_m, 0.01)
            << spec->upright << " " << bearing_rad << " " << NameOf(surface);
        EXPECT_GT(SlideOf(*spec, critical_rad + degree_rad, bearing_rad, surface).way_m, 0.1)
            << spec->upright << " " << bearing_rad << " " << NameOf(surface);
      }
    }
  }
}

// g (sin a - mu cos a), within 3 %: the box hops a little on its four corners.
TEST(ClosedFormsTest, SlidingBoxGainsWhatGravityLeavesOverFriction) {
  const double mu = FrictionOf(SurfaceClass::kSnow);
  for (const double slope_rad : {0.35, 0.5}) {
    const double wanted_mps2 = kGravity_mps2 * (std::sin(slope_rad) - mu * std::cos(slope_rad));
    EXPECT_NEAR(
        SlideOf(Box(10.0, {0.4, 0.4, 0.05}), slope_rad, 0.0, SurfaceClass::kSnow).acceleration_mps2,
        wanted_mps2, 0.03 * wanted_mps2);
  }
}

// Period 2 pi sqrt((I + m l^2) / (m g l)) (1 + a^2 / 16), within 1 %: the stepping itself shortens
// it by (w dt)^2 / 24, far less; the hinge holds with ODE's error reduction.
TEST(ClosedFormsTest, PendulumKeepsItsPeriod) {
  for (const double length_m : {0.3, 1.0, 2.0}) {
    BodySpec stand = Box(1e5, {1.0, 1.0, 0.2});  // the bob hardly shakes it
    stand.may_rest = false;
    LinkSpec bob;
    bob.mass_kg = 2.0;
    bob.inertia_kgm2 = Eigen::Vector3d::Constant(0.01);
    bob.anchor_m = {0.0, 0.0, 4.0};
    bob.center_m = {0.0, 0.0, 4.0 - length_m};
    bob.max_effort_nm = 20.0;  // lifts it to the angle
    stand.links = {bob};
    const auto physics = MakeOdeWorld(TestScene().Build());
    const BodyId body = physics->Add(stand, At(Eigen::Vector3d::Zero()));
    const double angle_rad = 0.2;
    physics->SetJoint(body, 0, {JointMode::kPosition, angle_rad});
    StepFor(physics.get(), 3.0);
    ASSERT_NEAR(physics->JointOf(body, 0).angle_rad, angle_rad, 0.02);
    physics->SetJoint(body, 0, {JointMode::kFree, 0.0});
    std::vector<double> crossings_s;
    double before_rad = physics->JointOf(body, 0).angle_rad;
    for (int i = 1; crossings_s.size() < 9 && i < 5000; ++i) {
      physics->Step(kStep_s, static_cast<std::uint64_t>(i));
      const double now_rad = physics->JointOf(body, 0).angle_rad;
      if (before_rad * now_rad < 0.0) {
        crossings_s.push_back(kStep_s * (i - now_rad / (now_rad - before_rad)));
      }
      before_rad = now_rad;
    }
    ASSERT_EQ(crossings_s.size(), 9u);
    const double inertia_kgm2 = bob.inertia_kgm2.y() + bob.mass_kg * length_m * length_m;
    const double wanted_s = 2.0 * M_PI *
                            std::sqrt(inertia_kgm2 / (bob.mass_kg * kGravity_mps2 * length_m)) *
                            (1.0 + angle_rad * angle_rad / 16.0);
    EXPECT_NEAR((crossings_s.back() - crossings_s.front()) / 4.0, wanted_s, 0.01 * wanted_s);
  }
}

// Momentum and angular momentum are kept to rounding whatever the blow, as the solver acts on
// both with one impulse at one point; energy never grows.
TEST(ClosedFormsTest, CollidingBallsKeepTheirMomentum) {
  for (const double offset_m : {0.0, 0.15, 0.3}) {
    const BodySpec light = BallInTheAir(2.0, 0.2), heavy = BallInTheAir(5.0, 0.25);
    const auto physics = MakeOdeWorld(TestScene().Build());
    const BodyId a = physics->Add(light, At({-1.0, offset_m, 20.0}, {3.0, 0.0, 0.0}));
    const BodyId b = physics->Add(heavy, At({0.0, 0.0, 20.0}));
    const auto momentum = [&] {
      return Eigen::Vector3d(light.mass_kg * physics->MotionOf(a).linear_velocity_mps +
                             heavy.mass_kg * physics->MotionOf(b).linear_velocity_mps);
    };
    const auto angular = [&] {
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for (const auto& [id, spec] : {std::pair(a, &light), std::pair(b, &heavy)}) {
        const BodyMotion motion = physics->MotionOf(id);
        sum += spec->mass_kg * (motion.position_m - Eigen::Vector3d(0.0, 0.0, 20.0))
                                   .cross(motion.linear_velocity_mps) +
               spec->inertia_kgm2.cwiseProduct(motion.angular_velocity_radps);
      }
      return sum;
    };
    const Eigen::Vector3d momentum_before = momentum(), angular_before = angular();
    const double energy_before_j = physics->EnergyOf(a) + physics->EnergyOf(b);
    bool met = false;
    for (int i = 0; i < 100; ++i) {
      physics->AddForce(a, {0.0, 0.0, light.mass_kg * kGravity_mps2});  // no weight
      physics->AddForce(b, {0.0, 0.0, heavy.mass_kg * kGravity_mps2});
      physics->Step(kStep_s, static_cast<std::uint64_t>(i));
      met = met || !physics->contacts().empty();
    }
    EXPECT_TRUE(met);
    EXPECT_LT((momentum() - momentum_before).norm(), 1e-9);
    EXPECT_LT((angular() - angular_before).norm(), 1e-9);
    EXPECT_LE(physics->EnergyOf(a) + physics->EnergyOf(b), energy_before_j + 1e-9);
    EXPECT_GT(physics->MotionOf(b).linear_velocity_mps.x(), 0.3);
  }
}

// A panel on a hinge turns by M = I alpha, 1 %: friction acts within the solver, which ends an
// iteration early.
TEST(ClosedFormsTest, GateOpensByTheTorqueThatFrictionLeaves) {
  BodySpec gate = Box(30.0, {0.6, 0.03, 0.5});
  gate.ground_samples.clear();
  AnchorSpec hinge;
  hinge.kind = AnchorKind::kHinge;
  hinge.pivot_m = {-0.6, 0.0, 0.0};
  hinge.friction_nm = 4.0;
  gate.anchor = hinge;
  gate.may_rest = false;
  const double inertia_kgm2 = gate.inertia_kgm2.z() + gate.mass_kg * 0.6 * 0.6;
  for (const double torque_nm : {3.0, 6.0, 12.0}) {
    const auto physics = MakeOdeWorld(TestScene().Build());
    const BodyId body = physics->Add(gate, At({0.0, 0.0, 0.5}));
    const double time_s = 1.0;
    for (int i = 0; i < std::lround(time_s / kStep_s); ++i) {
      physics->AddTorque(body, {0.0, 0.0, torque_nm});
      physics->Step(kStep_s, static_cast<std::uint64_t>(i));
    }
    const double left_nm = std::max(0.0, torque_nm - hinge.friction_nm);
    const double wanted_rad = 0.5 * left_nm / inertia_kgm2 * time_s * (time_s + kStep_s);
    EXPECT_NEAR(physics->AnchorAngleOf(body), wanted_rad, 0.01 * wanted_rad + 1e-3) << torque_nm;
  }
}

}  // namespace
}  // namespace latticeworld
