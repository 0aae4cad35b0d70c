#include "latticeworld_ros/running/map_follower.h"

#include <ros/console.h>

#include <chrono>
#include <exception>
#include <utility>

#include "latticeworld_ros/node/step_back.h"

namespace latticeworld {
namespace {

constexpr std::chrono::seconds kLeastPause(2);

}  // namespace

WishStanding StandingOf(const MapWish& wish, const PublishedWorld* published) {
  const std::shared_ptr<const World> world = wish.world.lock();
  if (world == nullptr) return WishStanding::kDone;
  if (published == nullptr || published->world != world) return WishStanding::kWaits;
  return published->changes == wish.changes ? WishStanding::kDone : WishStanding::kOpen;
}

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

void MapFollower::Follow(const std::shared_ptr<const World>& world, SceneChanges changes,
                         ros::Time now) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    wish_ = MapWish{world, std::move(changes), now};
  }
  changed_.notify_all();
}

void MapFollower::Run() {
  StepBack();
  std::unique_lock<std::mutex> lock(mutex_);
  for (;;) {
    changed_.wait(lock, [this] { return stopping_ || wish_.has_value(); });
    if (stopping_) return;
    MapWish wish = *std::move(wish_);
    wish_.reset();
    lock.unlock();
    const bool done = Fulfil(wish);
    lock.lock();
    if (!done && !wish_.has_value()) wish_ = std::move(wish);
    changed_.wait_for(lock, kLeastPause, [this] { return stopping_; });
  }
}

bool MapFollower::Fulfil(const MapWish& wish) {
  const std::shared_ptr<const PublishedWorld> before = current_->Get();
  const WishStanding standing = StandingOf(wish, before.get());
  if (standing != WishStanding::kOpen) return standing == WishStanding::kDone;
  try {
    Result<WorldMessages> messages = RebuildMaps(*before->world, options_, wish.changes, wish.now,
                                                 progress_, {before->messages, before->changes});
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
    // If another world has begun meanwhile, its own maps are right.
    (void)maps_->PublishInPlaceOf(before.get(), std::move(next));
  } catch (const std::exception& error) {  // memory that ended
    ROS_ERROR_STREAM("maps do not follow: " << error.what());
  }
  return true;
}

}  // namespace latticeworld
