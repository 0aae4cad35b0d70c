#include "latticeworld/simulation/simulator/event_log.h"

#include <utility>

namespace latticeworld {
namespace {

constexpr std::size_t kMaxEvents = 65536;  // kept for a caller who does not take them

}  // namespace

void EventLog::Tell(EventKind kind, const std::string& who, const std::string& other,
                    const Eigen::Vector3d& position_m) {
  Event event;
  event.step = clock_->step();
  event.kind = kind;
  event.agent = who;
  event.other = other;
  event.position_m = position_m;
  events_.push_back(std::move(event));
  Bound();
}

std::vector<Event> EventLog::Take() { return std::exchange(events_, {}); }

void EventLog::Bound() {
  if (events_.size() <= kMaxEvents) return;
  events_.erase(events_.begin(), events_.end() - static_cast<std::ptrdiff_t>(kMaxEvents / 2));
}

}  // namespace latticeworld
