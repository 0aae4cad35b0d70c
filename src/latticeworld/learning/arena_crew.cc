#include "latticeworld/learning/arena_crew.h"

#include <exception>
#include <memory>

namespace latticeworld {

namespace {

// What `work` answers; INTERNAL in the words of what it throws: memory that ended, or the physics.
template <typename Work>
Status Caught(const Work& work) {
  try {
    return work();
  } catch (const std::exception& error) {
    return Internal(error.what());
  }
}

}  // namespace

std::vector<Status> ArenaCrew::Advance(const std::vector<Arena*>& arenas,
                                       const std::vector<int>& steps, const CrewArrays& arrays) {
  std::vector<Status> statuses(arenas.size());
  crew_.Run(static_cast<int>(arenas.size()), [&](int part) {
    const auto i = static_cast<std::size_t>(part);
    statuses[i] =
        Caught([&] { return AdvanceOne(arenas[i], i * layout_.robots.size(), steps[i], arrays); });
  });
  return statuses;
}

Status ArenaCrew::Reset(const std::vector<Arena*>& arenas,
                        const std::vector<std::uint64_t>& seeds) {
  std::vector<Status> statuses(arenas.size());
  crew_.Run(static_cast<int>(arenas.size()), [&](int part) {
    const auto i = static_cast<std::size_t>(part);
    statuses[i] = Caught([&] {
      arenas[i]->Reset(seeds[i]);
      return Status();
    });
  });
  for (const Status& status : statuses) LW_RETURN_IF_ERROR(status);
  return Status();
}

Status ArenaCrew::AdvanceOne(Arena* arena, std::size_t first_row, int steps,
                             const CrewArrays& arrays) const {
  std::vector<std::string> acting;
  for (std::size_t i = 0; i < layout_.robots.size(); ++i) {
    const std::size_t row = first_row + i;
    if (arrays.acting[row] == 0) continue;
    acting.push_back(layout_.robots[i]);
    VelocityCommand command;
    command.linear_mps.x() = arrays.actions[2 * row];
    command.yaw_rate_radps = arrays.actions[2 * row + 1];
    LW_RETURN_IF_ERROR(arena->simulator()->Command(layout_.robots[i], command));
  }
  if (acting.empty()) return Status();
  const bool scans = layout_.sectors > 0;
  LW_RETURN_IF_ERROR(arena->Advance(steps, scans ? acting : std::vector<std::string>()));

  const std::shared_ptr<const WorldState> state = arena->simulator()->State();
  for (std::size_t i = 0; i < layout_.robots.size(); ++i) {
    const std::size_t row = first_row + i;
    if (arrays.acting[row] == 0) continue;
    const AgentSnapshot* agent = FindAgent(*state, layout_.robots[i]);
    if (agent == nullptr) {
      arrays.views[row].alive = -1.0;
      continue;
    }
    arrays.views[row] = ViewOf(*agent);
    if (!scans) continue;
    NearestInSectors(arena->SweepOf(agent->name), arena->scanner()->min_range_m, layout_.sectors,
                     layout_.max_range_m, arrays.scans + row * arrays.scan_stride);
  }
  return Status();
}

}  // namespace latticeworld
