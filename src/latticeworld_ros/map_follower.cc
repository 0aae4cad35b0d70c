#include "latticeworld_ros/map_follower.h"

#include <ros/console.h>

#include <chrono>
#include <exception>
#include <utility>

namespace latticeworld {
namespace {

constexpr std::chrono::seconds kLeastPause(2);

bool SameChanges(const SceneChanges& a, const SceneChanges& b) {
  if (a.gone != b.gone || a.fallen.size() != b.fallen.size()) return false;
  for (std::size_t i = 0; i < a.fallen.size(); ++i) {
    const FallenTree &one = a.fallen[i], &other = b.fallen[i];
    if (one.asset != other.asset || one.foot_m != other.foot_m || one.tip_m != other.tip_m) {
      return false;
    }
  }
  return true;
}

}  // namespace

MapFollower::MapFollower(const WorldServerOptions& options, const CurrentWorld* current,
                         MapPublisher* maps)
    : options_(options), current_(current), maps_(maps), thread_([this] { Run(); }) {}

MapFollower::~MapFollower() { Stop(); }

void MapFollower::Stop() {
  progress_.Cancel();
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stopping_ = true;
  }
  changed_.notify_all();
  if (thread_.joinable()) thread_.join();
}

void MapFollower::Follow(const std::string& world_id, SceneChanges changes, ros::Time now) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    wish_ = Wish{world_id, std::move(changes), now};
  }
  changed_.notify_all();
}

void MapFollower::Run() {
  std::unique_lock<std::mutex> lock(mutex_);
  for (;;) {
    changed_.wait(lock, [this] { return stopping_ || wish_.has_value(); });
    if (stopping_) return;
    Wish wish = *std::move(wish_);
    wish_.reset();
    lock.unlock();
    const bool done = Fulfil(wish);
    lock.lock();
    if (!done && !wish_.has_value()) wish_ = std::move(wish);
    changed_.wait_for(lock, kLeastPause, [this] { return stopping_; });
  }
}

bool MapFollower::Fulfil(const Wish& wish) {
  const std::shared_ptr<const PublishedWorld> before = current_->Get();
  if (before == nullptr || before->world->id != wish.world_id) return false;
  if (SameChanges(before->changes, wish.changes)) return true;
  try {
    Result<WorldMessages> messages =
        RebuildMaps(*before->world, options_, wish.changes, wish.now, progress_, before->messages);
    if (!messages.ok()) {
      if (!progress_.cancelled()) {
        ROS_ERROR_STREAM("maps do not follow: " << messages.status().ToString());
      }
      return true;
    }
    auto next = std::make_shared<PublishedWorld>();
    next->world = before->world;
    next->messages = std::move(messages).value();
    next->changes = wish.changes;
    // Where another world has begun meanwhile, its own maps are right.
    (void)maps_->PublishInPlaceOf(before.get(), std::move(next));
  } catch (const std::exception& error) {  // memory that ended
    ROS_ERROR_STREAM("maps do not follow: " << error.what());
  }
  return true;
}

}  // namespace latticeworld
