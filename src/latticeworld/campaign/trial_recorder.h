#ifndef LATTICEWORLD_CAMPAIGN_TRIAL_RECORDER_H_
#define LATTICEWORLD_CAMPAIGN_TRIAL_RECORDER_H_

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/navigation/trial_metrics.h"
#include "latticeworld/simulation/world_state.h"
#include "latticeworld/species/species_catalogue.h"

namespace latticeworld {

// A contact counts from this force on, as bumpers do [N], and is another one once nothing pressed
// for this long [s].
inline constexpr double kContactForce_n = 5.0;
inline constexpr double kContactPause_s = 0.5;

// What adversaries did to the robot.
struct Interventions {
  int pursuits = 0;  // times that one went after it
  int attacks = 0;   // blows that were tried
  int hits = 0;      // blows that it took
};

// Watches one robot step by step and makes its record.
class TrialRecorder {
 public:
  // catalogue: not null; of the simulator.
  TrialRecorder(std::string robot, std::shared_ptr<const SpeciesCatalogue> catalogue)
      : robot_(std::move(robot)), catalogue_(std::move(catalogue)) {}

  // Records a step of step_s seconds: the state after it and the events within it.
  void Watch(const WorldState& state, const std::vector<Event>& events, double step_s);
  // Adds a sample of the state: power is the mean since the last one.
  void Sample(const WorldState& state);

  bool alive() const { return record_.survived; }
  // What the events say of its end: "drowned", "died by goblin_1"; empty while it lives.
  const std::string& death() const { return death_; }
  const Interventions& interventions() const { return interventions_; }
  const TrialRecord& record() const { return record_; }
  TrialRecord* mutable_record() { return &record_; }

 private:
  double TimeToCollisionOf(const WorldState& state, const AgentSnapshot& robot) const;

  std::string robot_;
  std::shared_ptr<const SpeciesCatalogue> catalogue_;
  TrialRecord record_;
  Interventions interventions_;
  std::string death_;
  double work_j_ = 0.0;         // of the motors since the last sample
  double last_press_s_ = -1e9;  // when something last pressed on it
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_CAMPAIGN_TRIAL_RECORDER_H_
