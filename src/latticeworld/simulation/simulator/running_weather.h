#ifndef LATTICEWORLD_SIMULATION_SIMULATOR_RUNNING_WEATHER_H_
#define LATTICEWORLD_SIMULATION_SIMULATOR_RUNNING_WEATHER_H_

#include <Eigen/Core>
#include <cstdint>

#include "latticeworld/scene/surface_table.h"
#include "latticeworld/scene/weather/weather_change.h"
#include "latticeworld/scene/weather/wind.h"

namespace latticeworld {

class Digest;

// The weather of a run: what it is, what it moves to, the hour of the day, and what the ground is
// like under it.
class RunningWeather {
 public:
  // Begins as the scene has it. scene: outlives this. day_length_s: simulated time in which the
  // hour goes round once; 0: it stands still.
  RunningWeather(const Scene* scene, double day_length_s, std::uint64_t seed);

  // Moves from the weather of the moment to what the change ends in. Without a transition what it
  // says is there at once, and what it leaves alone goes on to move as before. change: valid.
  void Change(const WeatherChange& change);
  // What a step did: the weather moved, and a change is complete with this step.
  struct Outcome {
    bool moved = false;
    bool complete = false;
  };
  Outcome Step(double step_s);

  const Atmosphere& now() const { return now_; }
  const Atmosphere& target() const { return to_; }
  bool moving() const { return transition_s_ > 0.0; }
  double remaining_s() const { return moving() ? transition_s_ - elapsed_s_ : 0.0; }
  const GustField& gusts() const { return gusts_; }
  const Eigen::Vector2d& drift_m() const { return drift_m_; }
  // What every surface is like in the weather of the moment.
  const SurfaceTable& surfaces() const { return surfaces_; }

  // True when it is no longer the scene's own, whatever the hour that goes round has come to.
  bool HasChanged() const;
  // All that its future depends on.
  void AddTo(Digest* digest) const;

 private:
  const Scene* scene_;
  double day_length_s_;
  GustField gusts_;
  Eigen::Vector2d drift_m_ = Eigen::Vector2d::Zero();  // of the air with the mean wind
  Atmosphere now_, from_, to_;
  double heading_rad_;         // where the wind of to_ blows to, or would if it is calm
  double transition_s_ = 0.0;  // 0: nothing moves
  double elapsed_s_ = 0.0;     // of it
  SurfaceTable surfaces_;      // under now_
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_SIMULATOR_RUNNING_WEATHER_H_
