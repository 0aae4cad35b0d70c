#include "latticeworld/simulation/journaled_simulator.h"

#include <algorithm>
#include <utility>

namespace latticeworld {

struct JournaledSimulator::Snapshot : SimulatorSnapshot {
  Snapshot(std::uint64_t number_of, std::uint64_t last_call,
           std::shared_ptr<const SimulatorSnapshot> of, const JournaledSimulator* by)
      : number(number_of), after(last_call), inner(std::move(of)), owner(by) {}
  const std::uint64_t number;
  const std::uint64_t after;  // the number of the call before it
  const std::shared_ptr<const SimulatorSnapshot> inner;
  const JournaledSimulator* const owner;  // compared, never followed
};

namespace {

// What an entry takes in memory, roughly; texts are short.
std::size_t BytesOf(const JournalCall& call) {
  constexpr std::size_t kTexts = 64;
  std::size_t bytes = sizeof(JournalEntry) + kTexts;
  if (const auto* joints = std::get_if<CommandJointsCall>(&call)) {
    bytes += joints->commands.size() * (sizeof(JointCommand) + kTexts);
  }
  return bytes;
}

}  // namespace

JournaledSimulator::JournaledSimulator(std::unique_ptr<Simulator> simulator, std::uint64_t run,
                                       std::size_t max_bytes)
    : simulator_(std::move(simulator)), run_(run), max_bytes_(max_bytes) {
  beginning_.seed = simulator_->seed();
}

JournaledSimulator::~JournaledSimulator() = default;

void JournaledSimulator::Add(JournalCall call) const {
  const std::size_t bytes = BytesOf(call);
  JournalEntry entry{++last_number_, steps_, std::move(call)};
  new_bytes_ += bytes;
  if (new_bytes_ > max_bytes_) {
    new_.clear();
    new_bytes_ = bytes;
  }
  new_.push_back(entry);
  if (!complete_) return;
  entries_bytes_ += bytes;
  if (entries_bytes_ > max_bytes_) {
    Forget();
    return;
  }
  entries_.push_back(std::move(entry));
}

void JournaledSimulator::Forget() const {
  complete_ = false;
  entries_ = {};
  entries_bytes_ = 0;
}

Status JournaledSimulator::Told(Status status, JournalCall call) const {
  if (status.ok()) Add(std::move(call));
  return status;
}

std::vector<JournalEntry> JournaledSimulator::TakeNew() {
  new_bytes_ = 0;
  return std::exchange(new_, {});
}

Status JournaledSimulator::Command(const std::string& agent, const VelocityCommand& command) {
  return Told(simulator_->Command(agent, command), CommandCall{agent, command});
}

Status JournaledSimulator::CommandJoints(const std::string& agent,
                                         const std::vector<JointCommand>& commands) {
  return Told(simulator_->CommandJoints(agent, commands), CommandJointsCall{agent, commands});
}

Status JournaledSimulator::Strike(const std::string& agent) {
  return Told(simulator_->Strike(agent), StrikeCall{agent});
}

Status JournaledSimulator::SetPolicy(const PolicyChange& change) {
  return Told(simulator_->SetPolicy(change), SetPolicyCall{change});
}

void JournaledSimulator::Step() {
  // Counted although it may throw: whoever plays the journal makes the same step.
  ++steps_;
  simulator_->Step();
}

Result<std::string> JournaledSimulator::Spawn(const SpawnRequest& request) {
  Result<std::string> name = simulator_->Spawn(request);
  if (name.ok()) Add(SpawnCall{request, *name});
  return name;
}

Status JournaledSimulator::Remove(const std::string& agent) {
  return Told(simulator_->Remove(agent), RemoveCall{agent});
}

Result<std::string> JournaledSimulator::SpawnProp(const Prop& prop) {
  Result<std::string> name = simulator_->SpawnProp(prop);
  if (name.ok()) Add(SpawnPropCall{prop, *name});
  return name;
}

Status JournaledSimulator::RemoveProp(const std::string& prop) {
  return Told(simulator_->RemoveProp(prop), RemovePropCall{prop});
}

Status JournaledSimulator::OpenGate(const std::string& prop, double opening_rad) {
  return Told(simulator_->OpenGate(prop, opening_rad), OpenGateCall{prop, opening_rad});
}

Status JournaledSimulator::SetWeather(const WeatherChange& change) {
  return Told(simulator_->SetWeather(change), SetWeatherCall{change});
}

bool JournaledSimulator::HasOldSnapshots() const {
  snapshots_.erase(std::remove_if(snapshots_.begin(), snapshots_.end(),
                                  [](const auto& snapshot) { return snapshot.expired(); }),
                   snapshots_.end());
  return !snapshots_.empty();
}

void JournaledSimulator::Reset(std::uint64_t seed) {
  simulator_->Reset(seed);
  Add(ResetCall{seed});
  if (complete_ && HasOldSnapshots()) return;
  entries_.clear();
  entries_bytes_ = 0;
  complete_ = true;
  beginning_ = {seed, last_number_, steps_};
}

std::shared_ptr<const SimulatorSnapshot> JournaledSimulator::Save() const {
  auto snapshot =
      std::make_shared<const Snapshot>(++last_snapshot_, last_number_, simulator_->Save(), this);
  (void)HasOldSnapshots();
  snapshots_.push_back(snapshot);
  Add(SaveCall{snapshot->number});
  return snapshot;
}

Status JournaledSimulator::Restore(const SimulatorSnapshot& snapshot) {
  const auto* of = dynamic_cast<const Snapshot*>(&snapshot);
  if (of == nullptr || of->owner != this) {
    return InvalidArgument("the snapshot is of another simulator");
  }
  LW_RETURN_IF_ERROR(simulator_->Restore(*of->inner));
  if (of->after < beginning_.number) Forget();  // of before what the entries begin with
  Add(RestoreCall{of->number});
  return Status();
}

}  // namespace latticeworld
