#include "latticeworld/campaign/campaign.h"

#include <cstdio>

namespace latticeworld {

std::vector<PlannedTrial> PlanOf(const Campaign& campaign) {
  std::vector<PlannedTrial> plan;
  for (std::size_t world = 0; world < campaign.worlds.size(); ++world) {
    for (std::size_t robot = 0; robot < campaign.robots.size(); ++robot) {
      for (std::size_t task = 0; task < static_cast<std::size_t>(campaign.tasks.count); ++task) {
        for (std::size_t condition = 0; condition < campaign.conditions.size(); ++condition) {
          for (const std::uint64_t seed : campaign.conditions[condition].seeds) {
            char number[24];
            std::snprintf(number, sizeof(number), "%02zu", task);
            plan.push_back({campaign.worlds[world].name + "." + campaign.robots[robot].name + ".t" +
                                number + "." + campaign.conditions[condition].name + ".s" +
                                std::to_string(seed),
                            world, robot, task, condition, seed});
          }
        }
      }
    }
  }
  return plan;
}

}  // namespace latticeworld
