#ifndef LATTICEWORLD_EPISODE_REPLAY_H_
#define LATTICEWORLD_EPISODE_REPLAY_H_

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "latticeworld/common/progress.h"
#include "latticeworld/common/result.h"
#include "latticeworld/scene/scene.h"
#include "latticeworld/simulation/journal.h"

namespace latticeworld {

// What the state was at some moment of a recorded simulation.
struct RecordedHash {
  std::uint64_t step = 0;   // steps since the simulator was made
  std::uint64_t calls = 0;  // number of the last call before it
  std::string state_hash;   // Simulator::StateHash
};

// The steps of an episode, as far as anything in its record tells of them.
struct RecordedSteps {
  std::uint64_t first = 0;       // steps that were done when the episode began
  std::uint64_t first_call = 0;  // number of the last call before it
  std::uint64_t last = 0;
};

// All that a simulation came of, and what it is compared with.
struct ReplayPlan {
  JournalBeginning beginning;
  std::vector<JournalEntry> calls;   // after the beginning, in order
  std::vector<RecordedHash> hashes;  // in order
  RecordedSteps steps;
};

// Says where a simulation went another way than the recorded one.
struct Divergence {
  RecordedHash recorded;
  std::string state_hash;  // as simulated; empty: a call failed
  std::string failure;     // of that call
  std::optional<RecordedHash> last_agreed;
};

struct ReplayReport {
  std::uint64_t steps = 0;
  std::uint64_t calls = 0;
  std::uint64_t hashes = 0;   // that agreed
  std::uint64_t skipped = 0;  // hashes of before the beginning, which nothing can be compared with
  std::uint64_t calls_after = 0;         // calls after the last hash: nothing shows what they did
  std::optional<RecordedHash> agreed;    // the last hash that agreed
  std::optional<Divergence> divergence;  // none: every hash agreed
};

// Simulates anew, as fast as possible, from the plan's beginning up to its last hash, and compares
// every hash on the way. Ends at the first one that differs. Errors: DATA_LOSS (a call is missing,
// or calls or hashes are not in order), INVALID_ARGUMENT (options), CANCELLED, INTERNAL (a step
// failed).
Result<ReplayReport> Replay(std::shared_ptr<const Scene> scene, const SimulatorOptions& options,
                            const ReplayPlan& plan, const Progress& progress);

// Whether hashes that agree show anything of the episode. The hash of its beginning alone does not
// where more is recorded than the beginning.
bool IsProven(const ReplayReport& report, const RecordedSteps& steps);

// What is proven and how far it reaches, or that nothing is, in one line without its end. report:
// without a divergence.
std::string ProofText(const ReplayReport& report, const RecordedSteps& steps);

}  // namespace latticeworld

#endif  // LATTICEWORLD_EPISODE_REPLAY_H_
