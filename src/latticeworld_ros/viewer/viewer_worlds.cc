#include "latticeworld_ros/viewer/viewer_worlds.h"

#include <ros/ros.h>

#include <chrono>
#include <exception>
#include <utility>
#include <vector>

#include "latticeworld/common/text.h"
#include "latticeworld/episode/journal_json.h"
#include "latticeworld/episode/world_files.h"
#include "latticeworld_ros/conversion/messages.h"

namespace latticeworld {
namespace {

constexpr std::chrono::seconds kRetryPause(1);

}  // namespace

ViewerWorlds::ViewerWorlds(OnWorld on_world, OnProgress on_progress, OnFailure on_failure)
    : on_world_(std::move(on_world)),
      on_progress_(std::move(on_progress)),
      on_failure_(std::move(on_failure)),
      thread_([this] { Run(); }) {}

void ViewerWorlds::Want(const std::string& world_id) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (wanted_ == world_id) return;
    wanted_ = world_id;
    is_due_ = !world_id.empty();
    if (under_way_ != nullptr) under_way_->Cancel();
  }
  changed_.notify_all();
}

void ViewerWorlds::Stop() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stop_ = true;
    if (under_way_ != nullptr) under_way_->Cancel();
  }
  changed_.notify_all();
  if (thread_.joinable()) thread_.join();
}

Result<std::shared_ptr<const WorldPayloads>> ViewerWorlds::Fetch(const Progress& progress) const {
  latticeworld_msgs::GetWorldBundle bundle;
  bundle.request.files = true;
  if (!ros::service::call("get_world_bundle", bundle)) {
    return Unavailable("get_world_bundle gave no answer");
  }
  const latticeworld_msgs::Status& status = bundle.response.status;
  if (status.code != 0) return Status(static_cast<StatusCode>(status.code), status.message);
  LW_RETURN_IF_ERROR(progress.CheckCancelled());
  LW_ASSIGN_OR_RETURN(const SimulatorOptions options,
                      DecodeSimulatorOptions(bundle.response.options));
  std::vector<WorldFile> files;
  for (latticeworld_msgs::WorldFile& file : bundle.response.world) {
    files.push_back({file.path, std::string(file.data.begin(), file.data.end())});
    std::vector<std::uint8_t>().swap(file.data);
  }
  LW_ASSIGN_OR_RETURN(const std::shared_ptr<const World> world, UnpackWorld(files));
  return MakeWorldPayloads(*world, *options.species, /*moves=*/true, progress);
}

void ViewerWorlds::Run() {
  for (;;) {
    Progress progress([this](std::string_view stage, double fraction) {
      on_progress_(std::string(stage), fraction);
    });
    {
      std::unique_lock<std::mutex> lock(mutex_);
      changed_.wait(lock, [this] { return stop_ || is_due_; });
      if (stop_) return;
      is_due_ = false;
      under_way_ = &progress;
    }
    Result<std::shared_ptr<const WorldPayloads>> made = Unavailable("not asked for");
    try {
      made = Fetch(progress);
    } catch (const std::exception& error) {  // the middleware's, and memory that ends
      made = Internal(error.what());
    }
    std::unique_lock<std::mutex> lock(mutex_);
    under_way_ = nullptr;
    if (stop_) return;
    if (progress.cancelled()) continue;
    // Between the world's beginning and the answer world_server may have gone on to another.
    const bool is_wanted = made.ok() && (*made)->world_id == wanted_;
    lock.unlock();
    if (is_wanted) {
      on_world_(*std::move(made));
      continue;
    }
    if (!made.ok()) on_failure_(made.status());
    lock.lock();
    changed_.wait_for(lock, kRetryPause, [this] { return stop_ || is_due_; });
    is_due_ = !wanted_.empty();
  }
}

}  // namespace latticeworld
