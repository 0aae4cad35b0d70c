#ifndef LATTICEWORLD_EPISODE_REPLAY_PLAN_H_
#define LATTICEWORLD_EPISODE_REPLAY_PLAN_H_

#include <string>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/episode/replay.h"

namespace latticeworld {

// What was heard of a simulation: in any order, some of it perhaps twice, some perhaps lost.
struct RecordedSimulation {
  JournalBeginning beginning;
  std::vector<JournalEntry> calls;
  std::vector<RecordedHash> hashes;
  RecordedSteps steps;
};

// The part of it that can be simulated again and is compared with most hashes: all of it where no
// call is missing; else what lies between two gaps, from the beginning or a reset on. warnings:
// gets what is left out, and why. Errors: DATA_LOSS (there is no such part, or no hash).
Result<ReplayPlan> MakeReplayPlan(RecordedSimulation recorded, std::vector<std::string>* warnings);

}  // namespace latticeworld

#endif  // LATTICEWORLD_EPISODE_REPLAY_PLAN_H_
