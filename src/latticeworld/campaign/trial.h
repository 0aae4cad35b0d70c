#ifndef LATTICEWORLD_CAMPAIGN_TRIAL_H_
#define LATTICEWORLD_CAMPAIGN_TRIAL_H_

#include <cstdint>
#include <memory>
#include <string>

#include "latticeworld/campaign/campaign.h"
#include "latticeworld/campaign/stacks/robot_stack.h"
#include "latticeworld/campaign/trial_recorder.h"
#include "latticeworld/common/result.h"
#include "latticeworld/navigation/trial_metrics.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {

// All that a trial depends on.
struct TrialSetup {
  std::shared_ptr<const Scene> scene;
  const CampaignRobot& robot;
  const CampaignCondition& condition;
  const NavigationTask& task;
  const Grid<std::int8_t>& occupancy;  // of the scene and the robot's limits
  std::uint64_t seed = 1;              // of the simulation
  double step_s = 0.01;
  double control_hz = 10.0;
};

struct TrialOutcome {
  TrialRecord record;
  TrialGoal goal;
  TrialMetrics metrics;
  Interventions interventions;
  std::string ended_by;  // "arrived", "stack failed", "time limit", "died"
  std::string why;       // of "stack failed" and "died"
  double time_limit_s = 0.0;
};

// Puts the robot at the task's start, lets the stack drive it until it says that it arrived or
// failed, the robot dies or time is over, and measures. The same setup: the same outcome, bit for
// bit. Errors: FAILED_PRECONDITION (no place to begin for the robot or its adversaries).
Result<TrialOutcome> RunTrial(const TrialSetup& setup, RobotStack* stack);

}  // namespace latticeworld

#endif  // LATTICEWORLD_CAMPAIGN_TRIAL_H_
