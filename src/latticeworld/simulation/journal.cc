#include "latticeworld/simulation/journal.h"

#include <utility>

#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

template <typename... Functions>
struct Overloaded : Functions... {
  using Functions::operator()...;
};
template <typename... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>;

Status CheckName(const Result<std::string>& made, const std::string& recorded) {
  LW_RETURN_IF_ERROR(made.status());
  if (*made == recorded) return Status();
  return DataLoss("what was made is called " + Quote(*made) + ", and was called " +
                  Quote(recorded) + " when it was recorded");
}

}  // namespace

JournalPlayer::JournalPlayer(Simulator* simulator, std::set<std::uint64_t> restored)
    : simulator_(simulator), restored_(std::move(restored)) {}

Status JournalPlayer::Apply(const JournalCall& call) {
  return std::visit(
      Overloaded{
          [&](const CommandCall& it) { return simulator_->Command(it.agent, it.command); },
          [&](const CommandJointsCall& it) {
            return simulator_->CommandJoints(it.agent, it.commands);
          },
          [&](const StrikeCall& it) { return simulator_->Strike(it.agent); },
          [&](const SetPolicyCall& it) { return simulator_->SetPolicy(it.change); },
          [&](const SpawnCall& it) { return CheckName(simulator_->Spawn(it.request), it.answer); },
          [&](const RemoveCall& it) { return simulator_->Remove(it.agent); },
          [&](const SpawnPropCall& it) {
            return CheckName(simulator_->SpawnProp(it.prop), it.answer);
          },
          [&](const RemovePropCall& it) { return simulator_->RemoveProp(it.prop); },
          [&](const OpenGateCall& it) { return simulator_->OpenGate(it.prop, it.opening_rad); },
          [&](const SetWeatherCall& it) { return simulator_->SetWeather(it.change); },
          [&](const ResetCall& it) {
            simulator_->Reset(it.seed);
            return Status();
          },
          [&](const SaveCall& it) {
            if (restored_.count(it.snapshot) != 0) snapshots_[it.snapshot] = simulator_->Save();
            return Status();
          },
          [&](const RestoreCall& it) {
            const auto snapshot = snapshots_.find(it.snapshot);
            if (snapshot == snapshots_.end()) {
              return NotFound("snapshot " + std::to_string(it.snapshot) +
                              " was taken before the record begins");
            }
            return simulator_->Restore(*snapshot->second);
          }},
      call);
}

std::set<std::uint64_t> RestoredSnapshots(const std::vector<JournalEntry>& entries) {
  std::set<std::uint64_t> restored;
  for (const JournalEntry& entry : entries) {
    if (const auto* restore = std::get_if<RestoreCall>(&entry.call)) {
      restored.insert(restore->snapshot);
    }
  }
  return restored;
}

}  // namespace latticeworld
