#ifndef LATTICEWORLD_SIMULATION_ODE_ODE_MATH_H_
#define LATTICEWORLD_SIMULATION_ODE_ODE_MATH_H_

#include <ode/ode.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace latticeworld {

inline Eigen::Vector3d ToEigen(const dReal* v) { return {v[0], v[1], v[2]}; }

inline Eigen::Vector3d PositionOf(dBodyID body) { return ToEigen(dBodyGetPosition(body)); }

inline Eigen::Quaterniond OrientationOf(dBodyID body) {
  const dReal* q = dBodyGetQuaternion(body);
  return {q[0], q[1], q[2], q[3]};
}

// A direction or point of the body's own axes in those of the map.
inline Eigen::Vector3d Turned(dBodyID body, const Eigen::Vector3d& v) {
  const dReal* r = dBodyGetRotation(body);
  return {r[0] * v.x() + r[1] * v.y() + r[2] * v.z(), r[4] * v.x() + r[5] * v.y() + r[6] * v.z(),
          r[8] * v.x() + r[9] * v.y() + r[10] * v.z()};
}

inline void SetPosition(dBodyID body, const Eigen::Vector3d& at) {
  dBodySetPosition(body, at.x(), at.y(), at.z());
}

inline void SetOrientation(dBodyID body, const Eigen::Quaterniond& orientation) {
  const dQuaternion q = {orientation.w(), orientation.x(), orientation.y(), orientation.z()};
  dBodySetQuaternion(body, q);
}

inline void SetVelocities(dBodyID body, const Eigen::Vector3d& linear,
                          const Eigen::Vector3d& angular) {
  dBodySetLinearVel(body, linear.x(), linear.y(), linear.z());
  dBodySetAngularVel(body, angular.x(), angular.y(), angular.z());
}

// A vector of that direction, no longer than that; also where its square is beyond all numbers.
inline Eigen::Vector3d Within(const Eigen::Vector3d& v, double most) {
  if (v.cwiseAbs().maxCoeff() * 2.0 <= most) return v;
  const double length = v.stableNorm();
  return length <= most ? v : Eigen::Vector3d(v * (most / length));
}

// Velocity of the point that moves with the body, map frame.
inline Eigen::Vector3d VelocityAt(dBodyID body, const Eigen::Vector3d& point_m) {
  return ToEigen(dBodyGetLinearVel(body)) +
         ToEigen(dBodyGetAngularVel(body)).cross(point_m - PositionOf(body));
}

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_ODE_ODE_MATH_H_
