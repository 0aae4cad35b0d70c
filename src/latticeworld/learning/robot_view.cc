#include "latticeworld/learning/robot_view.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace latticeworld {

const AgentSnapshot* FindAgent(const WorldState& state, const std::string& name) {
  const auto found = std::lower_bound(
      state.agents.begin(), state.agents.end(), name,
      [](const AgentSnapshot& agent, const std::string& wanted) { return agent.name < wanted; });
  return found != state.agents.end() && found->name == name ? &*found : nullptr;
}

RobotView ViewOf(const AgentSnapshot& agent) {
  const Eigen::Quaterniond& q = agent.orientation;
  RobotView view;
  view.x_m = agent.position_m.x();
  view.y_m = agent.position_m.y();
  view.z_m = agent.position_m.z();
  view.yaw_rad = std::atan2(2.0 * (q.w() * q.z() + q.x() * q.y()),
                            1.0 - 2.0 * (q.y() * q.y() + q.z() * q.z()));
  view.forward_mps = agent.linear_velocity_mps.x();
  view.yaw_rate_radps = agent.angular_velocity_radps.z();
  view.health = agent.health;
  view.contact_n = agent.contact_force_n;
  view.alive = agent.behaviour == Behaviour::kDead ? 0.0 : 1.0;
  return view;
}

void NearestInSectors(const LidarSweep* sweep, double min_range_m, int sectors, float max_range_m,
                      float* sectors_m) {
  std::fill(sectors_m, sectors_m + sectors, max_range_m);
  if (sweep == nullptr || sweep->ranges_m.empty()) return;
  const int beams = static_cast<int>(sweep->ranges_m.size());
  const auto least = static_cast<float>(min_range_m);
  const double step = static_cast<double>(beams) / sectors;
  for (int sector = 0; sector < sectors; ++sector) {
    const int begin = static_cast<int>(sector * step);
    const int next = sector + 1 < sectors ? static_cast<int>((sector + 1) * step) : beams;
    for (int beam = begin; beam < std::max(next, begin + 1); ++beam) {
      const float range_m = sweep->ranges_m[static_cast<std::size_t>(beam)];
      // NaN is not.
      if (range_m >= least) sectors_m[sector] = std::min(sectors_m[sector], range_m);
    }
  }
}

}  // namespace latticeworld
