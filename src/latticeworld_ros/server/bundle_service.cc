#include "latticeworld_ros/server/bundle_service.h"

#include <string>
#include <utility>

#include "latticeworld/episode/journal_json.h"
#include "latticeworld/generation/bundle/manifest.h"
#include "latticeworld/simulation/journaled_simulator.h"
#include "latticeworld_ros/conversion/journal_conversion.h"
#include "latticeworld_ros/conversion/status_conversion.h"

namespace latticeworld {
namespace {

using latticeworld_msgs::GetWorldBundle;

constexpr int kTries = 5;

std::vector<std::string> Versions() {
  return {std::string("latticeworld ") + LATTICEWORLD_VERSION,
          std::string("compiler ") + __VERSION__,
          "bundle format " + std::to_string(kBundleFormatVersion)};
}

// What the simulator is at, read on the loop's thread.
struct Look {
  const Scene* scene = nullptr;  // compared, never followed
  std::uint64_t run = 0, seed = 0, calls = 0, step = 0, episode_step = 0;
  std::string state_hash;
  JournalBeginning beginning;
  std::vector<JournalEntry> journal;
  bool complete = false;
  SimulatorOptions options;
};

Result<std::string> LookAt(Simulator* simulator, Look* look) {
  const auto* journaled = dynamic_cast<const JournaledSimulator*>(simulator);
  if (journaled == nullptr) return Internal("the simulator keeps no journal");
  look->scene = &journaled->scene();
  look->run = journaled->run();
  look->seed = journaled->seed();
  look->calls = journaled->last_number();
  look->step = journaled->steps();
  look->episode_step = journaled->State()->episode_step;
  look->state_hash = journaled->StateHash();
  look->beginning = journaled->beginning();
  look->journal = journaled->entries();
  look->complete = journaled->complete();
  look->options = journaled->options();
  return std::string();
}

void Fill(const Look& look, const SimulationLoop::Moment& moment,
          GetWorldBundle::Response* response) {
  response->world_id = moment.world->id;
  response->run = look.run;
  response->stamp = moment.now;
  response->seed = look.seed;
  response->step = look.step;
  response->episode_step = look.episode_step;
  response->calls = look.calls;
  response->state_hash = look.state_hash;
  response->options = EncodeSimulatorOptions(look.options);
  response->versions = Versions();
  response->beginning_seed = look.beginning.seed;
  response->beginning_number = look.beginning.number;
  response->beginning_step = look.beginning.step;
  response->journal_complete = look.complete;
  response->journal.reserve(look.journal.size());
  for (const JournalEntry& entry : look.journal) {
    response->journal.push_back(
        ToJournalEntryMessage(entry, moment.now, moment.world->id, look.run));
  }
}

Status CheckSize(const std::vector<WorldFile>& files, std::uint64_t most_bytes) {
  std::uint64_t bytes = 0;
  for (const WorldFile& file : files) bytes += file.data.size();
  if (bytes < most_bytes) return Status();
  return ResourceExhausted("the files of the world have " + std::to_string(bytes) +
                           " bytes; a message has less than " + std::to_string(most_bytes) +
                           " (most_message_bytes): save_world writes them to a directory");
}

}  // namespace

BundleService::BundleService(SimulationLoop* loop, std::uint64_t most_message_bytes,
                             ServiceQueue* queue)
    : loop_(loop), most_message_bytes_(most_message_bytes) {
  queue->Advertise<GetWorldBundle>(
      "get_world_bundle",
      [this](const GetWorldBundle::Request& request, GetWorldBundle::Response* response) {
        response->status = ToStatusMessage(Answer(request, response));
      });
}

Status BundleService::Answer(const GetWorldBundle::Request& request,
                             GetWorldBundle::Response* response) {
  for (int i = 0; i < kTries; ++i) {
    Look look;
    const auto looked =
        loop_->Apply([&look](Simulator* simulator) { return LookAt(simulator, &look); });
    LW_RETURN_IF_ERROR(looked.status());
    LW_ASSIGN_OR_RETURN(const SimulationLoop::Moment moment, loop_->Inspect(/*hash=*/false));
    // These are two tasks of the loop: another world may have come between.
    if (moment.world->scene.get() != look.scene) continue;
    Fill(look, moment, response);
    if (!request.files) return Status();
    LW_ASSIGN_OR_RETURN(const auto files, FilesOf(moment.world));
    LW_RETURN_IF_ERROR(CheckSize(*files, most_message_bytes_));
    response->world = ToWorldFileMessages(*files);
    return Status();
  }
  return Unavailable("one world after another takes the place of the one before");
}

Result<std::shared_ptr<const std::vector<WorldFile>>> BundleService::FilesOf(
    const std::shared_ptr<const World>& world) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (packed_files_ != nullptr && packed_world_.lock() == world) return packed_files_;
  packed_files_.reset();
  LW_ASSIGN_OR_RETURN(std::vector<WorldFile> files, PackWorld(*world));
  packed_files_ = std::make_shared<const std::vector<WorldFile>>(std::move(files));
  packed_world_ = world;
  return packed_files_;
}

}  // namespace latticeworld
