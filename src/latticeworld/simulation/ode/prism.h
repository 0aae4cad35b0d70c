#ifndef LATTICEWORLD_SIMULATION_ODE_PRISM_H_
#define LATTICEWORLD_SIMULATION_ODE_PRISM_H_

#include <Eigen/Core>
#include <array>

namespace latticeworld {

// An upright solid over a round or rectangular footprint: how bodies, trunks, stones and buildings
// meet each other.
struct Prism {
  Eigen::Vector2d center_m = Eigen::Vector2d::Zero();
  Eigen::Vector2d forward = Eigen::Vector2d::UnitX();  // unit, along half_length
  double half_length_m = 0.0;                          // 0: round
  double half_width_m = 0.0;
  double radius_m = 0.0;  // round: of the circle; rectangle: of the circumscribed circle
  double low_m = 0.0;
  double high_m = 0.0;

  bool round() const { return half_length_m <= 0.0; }
  static Prism Round(Eigen::Vector2d center_m, double radius_m, double low_m, double high_m);
  static Prism Box(Eigen::Vector2d center_m, double yaw_rad, double half_length_m,
                   double half_width_m, double low_m, double high_m);
};

struct PrismContact {
  Eigen::Vector3d position_m;
  Eigen::Vector3d normal;  // unit, out of b into a
  double depth_m;          // > 0
};
struct PrismContacts {
  std::array<PrismContact, 8> contact;
  int count = 0;
};

// Where two prisms overlap: pushes a out of b sideways by the shortest way, or up when a stands on
// top of b.
PrismContacts Overlap(const Prism& a, const Prism& b);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_ODE_PRISM_H_
