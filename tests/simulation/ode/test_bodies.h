#ifndef LATTICEWORLD_TESTS_SIMULATION_ODE_TEST_BODIES_H_
#define LATTICEWORLD_TESTS_SIMULATION_ODE_TEST_BODIES_H_

#include <Eigen/Core>

#include "latticeworld/simulation/physics_world.h"

// Plain bodies, in a namespace of their own: the program's rooms have makers of like names.
namespace latticeworld::test_bodies {

inline BodySpec Ball(double mass_kg, double radius_m) {
  BodySpec ball;
  ball.mass_kg = mass_kg;
  ball.inertia_kgm2 = Eigen::Vector3d::Constant(0.4 * mass_kg * radius_m * radius_m);
  ball.center_height_m = radius_m;
  ball.shapes.resize(1);
  ball.shapes[0].center_m = {0.0, 0.0, radius_m};
  ball.shapes[0].radius_m = radius_m;
  ball.ground_samples = {{{0.0, 0.0, radius_m}, radius_m}};
  return ball;
}

inline Eigen::Vector3d BoxInertia(double mass_kg, const Eigen::Vector3d& half_m) {
  const Eigen::Vector3d squares = half_m.cwiseAbs2();
  return mass_kg / 3.0 *
         Eigen::Vector3d(squares.y() + squares.z(), squares.x() + squares.z(),
                         squares.x() + squares.y());
}

// Its base is the middle of its underside; corners meet the ground.
inline BodySpec Box(double mass_kg, const Eigen::Vector3d& half_m) {
  BodySpec box;
  box.mass_kg = mass_kg;
  box.inertia_kgm2 = BoxInertia(mass_kg, half_m);
  box.center_height_m = half_m.z();
  box.shapes.resize(1);
  box.shapes[0].form = ShapeForm::kBox;
  box.shapes[0].center_m = {0.0, 0.0, half_m.z()};
  box.shapes[0].half_extents_m = half_m;
  for (const double x : {-half_m.x(), half_m.x()}) {
    for (const double y : {-half_m.y(), half_m.y()}) {
      for (const double z : {0.0, 2.0 * half_m.z()}) box.ground_samples.push_back({{x, y, z}, 0.0});
    }
  }
  return box;
}

// Walks on one foot, upright.
inline BodySpec Walker(double mass_kg, double radius_m = 0.4, double height_m = 1.6) {
  BodySpec walker;
  walker.mass_kg = mass_kg;
  walker.inertia_kgm2 = BoxInertia(mass_kg, {radius_m, radius_m, 0.5 * height_m});
  walker.center_height_m = 0.5 * height_m;
  walker.shapes.resize(1);
  walker.shapes[0].form = ShapeForm::kCapsule;
  walker.shapes[0].center_m = {0.0, 0.0, 0.5 * height_m};
  walker.shapes[0].radius_m = radius_m;
  walker.shapes[0].half_length_m = 0.5 * height_m - radius_m;
  walker.ground_samples = {{Eigen::Vector3d::Zero(), 0.0}};
  walker.upright = true;
  return walker;
}

// 30 kg on four driven wheels of 12 cm, 0.5 m by 0.4 m.
inline BodySpec Robot() {
  BodySpec robot;
  robot.mass_kg = 26.0;
  const Eigen::Vector3d half(0.3, 0.2, 0.08);
  robot.inertia_kgm2 = BoxInertia(robot.mass_kg, half);
  robot.center_height_m = 0.16;
  robot.shapes.resize(1);
  robot.shapes[0].form = ShapeForm::kBox;
  robot.shapes[0].center_m = {0.0, 0.0, 0.18};
  robot.shapes[0].half_extents_m = half;
  for (const double x : {-0.2, 0.2}) {
    for (const double y : {-0.22, 0.22}) {
      WheelSpec wheel;
      wheel.center_m = {x, y, 0.12};
      wheel.radius_m = 0.12;
      wheel.max_torque_nm = 15.0;
      robot.wheels.push_back(wheel);
    }
  }
  return robot;
}

inline BodySpec BallInTheAir(double mass_kg, double radius_m) {
  BodySpec ball;
  ball.mass_kg = mass_kg;
  ball.inertia_kgm2 = Eigen::Vector3d::Constant(0.4 * mass_kg * radius_m * radius_m);
  BodyShape shape;
  shape.radius_m = radius_m;
  ball.shapes = {shape};
  return ball;
}

inline BodyMotion At(const Eigen::Vector3d& position_m,
                     const Eigen::Vector3d& velocity_mps = Eigen::Vector3d::Zero()) {
  BodyMotion motion;
  motion.position_m = position_m;
  motion.linear_velocity_mps = velocity_mps;
  return motion;
}

}  // namespace latticeworld::test_bodies

#endif  // LATTICEWORLD_TESTS_SIMULATION_ODE_TEST_BODIES_H_
