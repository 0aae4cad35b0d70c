#ifndef LATTICEWORLD_CAMPAIGN_WORLD_SOURCE_H_
#define LATTICEWORLD_CAMPAIGN_WORLD_SOURCE_H_

#include <filesystem>
#include <memory>
#include <vector>

#include "latticeworld/campaign/campaign.h"
#include "latticeworld/common/progress.h"
#include "latticeworld/common/result.h"
#include "latticeworld/generation/world.h"
#include "latticeworld/navigation/tasks_json.h"

namespace latticeworld {

// What the generator has against a world's words and sizes, each a violation; OK for bundles.
Status CheckWorldRequest(const CampaignWorld& world);

// The world of a campaign whose results go to `out`: that of its bundle, or the one that is kept in
// out/worlds/<name>, where it is made with the embedded language back end if it is not there yet.
// Two processes may ask at once. Errors: those of WorldGenerator, SaveBundle and LoadBundle.
Result<std::shared_ptr<const World>> ProvideWorld(const CampaignWorld& world,
                                                  const std::filesystem::path& out,
                                                  const Progress& progress);

// The tasks of a robot in a world, kept in out/tasks/<world>.<robot>.json. Errors: those of
// SampleTasks; FAILED_PRECONDITION: they were drawn in another world.
Result<TaskSet> ProvideTasks(const Campaign& campaign, const World& world, std::size_t world_index,
                             std::size_t robot_index, const std::filesystem::path& out,
                             const Progress& progress);

}  // namespace latticeworld

#endif  // LATTICEWORLD_CAMPAIGN_WORLD_SOURCE_H_
