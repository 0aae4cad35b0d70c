#ifndef LATTICEWORLD_SIMULATION_ODE_CONTACTS_SOLID_H_
#define LATTICEWORLD_SIMULATION_ODE_CONTACTS_SOLID_H_

#include <ode/ode.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>

#include "latticeworld/scene/asset.h"
#include "latticeworld/simulation/body_spec.h"

namespace latticeworld {

// An upright box around something, map frame.
struct Bounds {
  Eigen::Vector3d low_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d high_m = Eigen::Vector3d::Zero();

  bool Meets(const Bounds& other) const {
    return (low_m.array() <= other.high_m.array()).all() &&
           (other.low_m.array() <= high_m.array()).all();
  }
  void Include(const Bounds& other) {
    low_m = low_m.cwiseMin(other.low_m);
    high_m = high_m.cwiseMax(other.high_m);
  }
};

// Contacts of two solids: at most so many of a pair.
inline constexpr int kMaxPairContacts = 8;
struct SolidContacts {
  std::array<dContactGeom, 3 * kMaxPairContacts> contact;  // normals into the first solid
  int count = 0;
};

// A ball, capsule or box as a geom of ODE that belongs to no space and no body: its pose is set
// where it is needed.
class Solid {
 public:
  // Takes a shape in the frame of the part that it belongs to.
  explicit Solid(const BodyShape& shape);
  ~Solid();
  Solid(Solid&& other) noexcept;
  Solid& operator=(Solid&&) = delete;

  const BodyShape& shape() const { return shape_; }
  // Poses it with its part, r being the part's rotation as ODE has it.
  void SetPose(const Eigen::Vector3d& position_m, const dReal* r);
  const Bounds& bounds() const { return bounds_; }
  dGeomID geom() const { return geom_; }

 private:
  BodyShape shape_;
  Eigen::Matrix3d part_from_shape_;
  dGeomID geom_ = nullptr;
  Bounds bounds_;
};

// The solid part of an asset: the box of a building, for others an upright capsule as wide as the
// trunk or stone. It reaches into the ground, so that slopes leave no gap below it, and its side is
// upright for at least half of its height.
BodyShape SolidShapeOf(const Asset& asset);

// What a touches of b, both posed; nothing is allocated.
void Collide(const Solid& a, const Solid& b, SolidContacts* contacts);

// Returns whether a ball or point of a foot stands on the top of a level enough box, both posed; if
// so, contact gets the place and the normal out of the box. A foot further below the top than a
// step stands beside it.
bool StandsOn(const Solid& box, const Eigen::Vector3d& center_m, double radius_m,
              dContactGeom* contact);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_ODE_CONTACTS_SOLID_H_
