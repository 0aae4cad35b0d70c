#include "latticeworld/campaign/world_source.h"

#include <string>
#include <system_error>
#include <utility>

#include "latticeworld/campaign/reports/result_files.h"
#include "latticeworld/common/files.h"
#include "latticeworld/generation/bundle/bundle.h"
#include "latticeworld/generation/world_generator.h"

namespace latticeworld {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxTasksBytes = 256u << 20;

GenerationRequest RequestOf(const CampaignWorld& world) {
  GenerationRequest request;
  request.layout_instruction = world.layout;
  request.environment_instruction = world.environment;
  request.vocabulary = world.vocabulary;
  request.seed = world.seed;
  request.size_m = world.size_m;
  request.resolution_m = world.resolution_m;
  return request;
}

}  // namespace

Status CheckWorldRequest(const CampaignWorld& world) {
  if (!world.bundle.empty()) return Status();
  return MakeDefaultWorldGenerator().Validate(RequestOf(world));
}

Result<std::shared_ptr<const World>> ProvideWorld(const CampaignWorld& world, const fs::path& out,
                                                  const Progress& progress) {
  if (!world.bundle.empty()) return LoadBundle(world.bundle);
  const fs::path kept = out / "worlds" / world.name;
  std::error_code error;
  if (!fs::is_directory(kept, error)) {
    LW_ASSIGN_OR_RETURN(const auto made,
                        MakeDefaultWorldGenerator().Generate(RequestOf(world), progress));
    const Status saved = SaveBundle(*made, kept);
    // Another process may have been faster; its world is the same.
    if (!saved.ok() && saved.code() != StatusCode::kAlreadyExists) return saved;
  }
  return LoadBundle(kept);
}

Result<TaskSet> ProvideTasks(const Campaign& campaign, const World& world, std::size_t world_index,
                             std::size_t robot_index, const fs::path& out,
                             const Progress& progress) {
  const CampaignRobot& robot = campaign.robots[robot_index];
  const fs::path file =
      out / "tasks" / (campaign.worlds[world_index].name + "." + robot.name + ".json");
  std::error_code error;
  if (fs::exists(file, error)) {
    LW_ASSIGN_OR_RETURN(const std::string text, ReadFile(file, kMaxTasksBytes));
    LW_ASSIGN_OR_RETURN(TaskSet set, DecodeTasks(text));
    if (set.world_id == world.id) return set;
    return FailedPrecondition("the tasks in " + file.string() + " were drawn in " + set.world_id +
                              ", and the world is " + world.id + "; use another folder");
  }
  TaskWishes wishes = campaign.tasks;
  wishes.robot = robot.limits;
  LW_ASSIGN_OR_RETURN(auto tasks, SampleTasks(*world.scene, wishes, progress));
  TaskSet set{world.id, wishes.seed, wishes.robot, std::move(tasks)};
  LW_RETURN_IF_ERROR(WriteWhole(file, EncodeTasks(set)));
  return set;
}

}  // namespace latticeworld
