#ifndef LATTICEWORLD_SIMULATION_SIMULATION_CLOCK_H_
#define LATTICEWORLD_SIMULATION_SIMULATION_CLOCK_H_

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace latticeworld {

// How many steps of that length come nearest to a time. seconds: not negative.
inline std::uint64_t WholeSteps(double seconds, double step_s) {
  return static_cast<std::uint64_t>(seconds / step_s + 0.5);
}

// Simulated time in fixed steps: those of the whole run, which never go back, and those of the
// episode, which begin again at 0 and are restored with a snapshot.
class SimulationClock {
 public:
  explicit SimulationClock(double step_s)
      : step_s_(step_s),
        turn_steps_(static_cast<std::uint64_t>(std::max(1.0, std::round(kTurn_s / step_s)))) {}

  void Advance() {
    ++step_;
    ++episode_step_;
  }
  // Goes to that step of an episode; 0 begins a new one. The step of the run stays.
  void SetEpisodeStep(std::uint64_t episode_step) { episode_step_ = episode_step; }

  double step_s() const { return step_s_; }
  std::uint64_t step() const { return step_; }
  std::uint64_t episode_step() const { return episode_step_; }
  double time_s() const { return static_cast<double>(step_) * step_s_; }
  double episode_time_s() const { return static_cast<double>(episode_step_) * step_s_; }

  std::uint64_t StepsIn(double seconds) const { return WholeSteps(seconds, step_s_); }
  // The step of the episode that is so far ahead.
  std::uint64_t In(double seconds) const { return episode_step_ + StepsIn(seconds); }

  // What need not be done in every step is done in turns: each number has one in a tenth of a
  // second, so that those of many agents, by their ids, spread over the steps between.
  bool HasTurn(std::uint64_t number) const { return (episode_step_ + number) % turn_steps_ == 0; }
  // Returns the number of steps from one turn of a number to its next.
  std::uint64_t turn_steps() const { return turn_steps_; }

 private:
  static constexpr double kTurn_s = 0.1;

  double step_s_;
  std::uint64_t turn_steps_;
  std::uint64_t step_ = 0;
  std::uint64_t episode_step_ = 0;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_SIMULATION_CLOCK_H_
