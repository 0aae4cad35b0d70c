#include "latticeworld_ros/running/loop_meter.h"

#include <algorithm>

namespace latticeworld {
namespace {

constexpr std::chrono::seconds kPeriod(1);

double Seconds(LoopClock::TimePoint::duration duration) {
  return std::chrono::duration<double>(duration).count();
}

}  // namespace

void LoopMeter::AddStep(LoopClock::TimePoint::duration took) {
  ++steps_;
  steps_total_s_ += Seconds(took);
  steps_max_s_ = std::max(steps_max_s_, Seconds(took));
}

bool LoopMeter::IsDue(LoopClock::TimePoint now) const { return now - begin_ >= kPeriod; }

void LoopMeter::Take(LoopClock::TimePoint now, LoopStatistics* statistics) {
  statistics->real_time_factor = static_cast<double>(advances_) * step_s_ / Seconds(now - begin_);
  statistics->mean_step_s = steps_ > 0 ? steps_total_s_ / static_cast<double>(steps_) : 0.0;
  statistics->max_step_s = steps_max_s_;
  *this = LoopMeter(step_s_, now);
}

}  // namespace latticeworld
