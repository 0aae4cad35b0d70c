#ifndef LATTICEWORLD_SIMULATION_JOURNALED_SIMULATOR_H_
#define LATTICEWORLD_SIMULATION_JOURNALED_SIMULATOR_H_

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "latticeworld/simulation/journal.h"
#include "latticeworld/simulation/simulator.h"

namespace latticeworld {

// Most that is kept of a journal [bytes, roughly]; 100 robots commanded at 20 Hz fill it in two
// minutes, one robot in some three hours.
inline constexpr std::size_t kMaxJournalBytes = 64u << 20;

// A simulator that writes down every call that changes it, so that the same states can be reached
// again from the start state that they began with. Forgets what came before a Reset, unless a
// snapshot of before it is still there to be restored.
class JournaledSimulator : public Simulator {
 public:
  // simulator: not null, and fresh: no call has changed it. run: tells it from others of its
  // process.
  explicit JournaledSimulator(std::unique_ptr<Simulator> simulator, std::uint64_t run = 1,
                              std::size_t max_bytes = kMaxJournalBytes);
  ~JournaledSimulator() override;

  std::uint64_t run() const { return run_; }
  // The start state that entries() go on from.
  const JournalBeginning& beginning() const { return beginning_; }
  // Returns the calls in order; none while the journal is not complete.
  const std::vector<JournalEntry>& entries() const { return entries_; }
  // False: there were more calls than are kept, until the next Reset.
  bool complete() const { return complete_; }
  // Returns the number of the last call.
  std::uint64_t last_number() const { return last_number_; }
  // Steps since the simulator was made.
  std::uint64_t steps() const { return steps_; }
  bool has_new() const { return !new_.empty(); }
  // The calls since this was asked last, in order; a number is missing where they were too many.
  std::vector<JournalEntry> TakeNew();

  Status Command(const std::string& agent, const VelocityCommand& command) override;
  Status CommandJoints(const std::string& agent,
                       const std::vector<JointCommand>& commands) override;
  Status Strike(const std::string& agent) override;
  Status SetPolicy(const PolicyChange& change) override;
  void Step() override;
  std::shared_ptr<const WorldState> State() const override { return simulator_->State(); }
  std::vector<Event> TakeEvents() override { return simulator_->TakeEvents(); }
  Result<std::string> Spawn(const SpawnRequest& request) override;
  Status Remove(const std::string& agent) override;
  Result<std::string> SpawnProp(const Prop& prop) override;
  Status RemoveProp(const std::string& prop) override;
  Status OpenGate(const std::string& prop, double opening_rad) override;
  Status SetWeather(const WeatherChange& change) override;
  const Atmosphere& WeatherTarget() const override { return simulator_->WeatherTarget(); }
  void Reset(std::uint64_t seed) override;
  std::shared_ptr<const SimulatorSnapshot> Save() const override;
  Status Restore(const SimulatorSnapshot& snapshot) override;
  std::string StateHash() const override { return simulator_->StateHash(); }
  const Scene& scene() const override { return simulator_->scene(); }
  const SimulatorOptions& options() const override { return simulator_->options(); }
  std::uint64_t seed() const override { return simulator_->seed(); }

 private:
  struct Snapshot;

  void Add(JournalCall call) const;
  // Adds the call where it succeeded, and hands on its status.
  Status Told(Status status, JournalCall call) const;
  void Forget() const;
  bool HasOldSnapshots() const;

  const std::unique_ptr<Simulator> simulator_;
  const std::uint64_t run_;
  const std::size_t max_bytes_;
  std::uint64_t steps_ = 0;
  JournalBeginning beginning_;
  // Taking a snapshot changes no state of the simulator, but is told as well.
  mutable std::uint64_t last_number_ = 0;
  mutable std::uint64_t last_snapshot_ = 0;
  mutable bool complete_ = true;
  mutable std::vector<JournalEntry> entries_, new_;
  mutable std::size_t entries_bytes_ = 0, new_bytes_ = 0;
  mutable std::vector<std::weak_ptr<const Snapshot>> snapshots_;  // that may be restored
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_JOURNALED_SIMULATOR_H_
