#ifndef LATTICEWORLD_SIMULATION_ODE_CONTACTS_GROUND_CONTACT_H_
#define LATTICEWORLD_SIMULATION_ODE_CONTACTS_GROUND_CONTACT_H_

#include <Eigen/Core>
#include <array>

#include "latticeworld/geometry/height_field.h"

namespace latticeworld {

struct GroundContact {
  Eigen::Vector3d position_m;
  Eigen::Vector3d normal;  // unit, out of the ground
  double depth_m;          // > 0
};
struct GroundContacts {
  std::array<GroundContact, 3> contact;
  int count = 0;
};

// Contacts of a ball (radius 0: a point) with the triangles of the ground around it: up to three
// planes that it touches (so that it holds in folds), or the nearest crest point.
GroundContacts TouchGround(const HeightField& ground, const Eigen::Vector3d& center_m,
                           double radius_m);

// How deep the ball is in the ground, along its normal [m]; 0 above it.
double DepthBelowGround(const HeightField& ground, const Eigen::Vector3d& center_m,
                        double radius_m);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_ODE_CONTACTS_GROUND_CONTACT_H_
