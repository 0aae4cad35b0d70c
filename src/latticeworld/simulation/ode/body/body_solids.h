#ifndef LATTICEWORLD_SIMULATION_ODE_BODY_BODY_SOLIDS_H_
#define LATTICEWORLD_SIMULATION_ODE_BODY_BODY_SOLIDS_H_

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "latticeworld/simulation/ode/body/body_parts.h"
#include "latticeworld/simulation/ode/contacts/solid.h"

namespace latticeworld {

struct BodySolid {
  Solid solid;
  std::size_t part;  // of the body, that it moves with
};

// The solids of one body, in the order of its shapes, then wheels, and a ball around them all.
class BodySolids {
 public:
  // parts: as they begin; outlive it.
  explicit BodySolids(const BodyParts& parts);
  BodySolids(const BodySolids&) = delete;
  BodySolids& operator=(const BodySolids&) = delete;

  // Is called whenever the trunk or another part is elsewhere.
  void Moved() {
    posed_ = false;
    ball_in_map_m_ = parts_.TrunkPoint(ball_center_m_);
  }
  // Posed where the parts are.
  const std::vector<BodySolid>& Posed() {
    if (!posed_) Pose();
    return solids_;
  }
  // Ball around all solids and ground samples, however wheels move on their springs and links on
  // their hinges; center in the map; radius < 0: there are no solids.
  const Eigen::Vector3d& BallCenter() const { return ball_in_map_m_; }
  double ball_radius_m() const { return ball_radius_m_; }

 private:
  void Pose();
  void MakeBall();

  const BodyParts& parts_;
  std::vector<BodySolid> solids_;
  bool posed_ = false;
  Eigen::Vector3d ball_center_m_ = Eigen::Vector3d::Zero();  // in base_link
  Eigen::Vector3d ball_in_map_m_ = Eigen::Vector3d::Zero();  // where that is: asked of all at once
  double ball_radius_m_ = -1.0;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_ODE_BODY_BODY_SOLIDS_H_
