#include "latticeworld/episode/replay_plan.h"

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>

namespace latticeworld {
namespace {

// Calls that follow one another, from a start state on.
struct Stretch {
  JournalBeginning beginning;
  std::size_t begin = 0, end = 0;  // of the calls
  std::uint64_t last_number = 0;
  std::size_t hashes = 0;

  bool Holds(const RecordedHash& hash) const {
    return hash.calls >= beginning.number && hash.calls <= last_number &&
           hash.step >= beginning.step;
  }
};

void SortAndUnite(RecordedSimulation* recorded) {
  auto& calls = recorded->calls;
  std::stable_sort(calls.begin(), calls.end(), [](const JournalEntry& a, const JournalEntry& b) {
    return a.number < b.number;
  });
  calls.erase(std::unique(calls.begin(), calls.end(),
                          [](const JournalEntry& a, const JournalEntry& b) {
                            return a.number == b.number;
                          }),
              calls.end());
  // What came before the start state does not matter.
  calls.erase(calls.begin(), std::find_if(calls.begin(), calls.end(), [&](const auto& call) {
                return call.number > recorded->beginning.number;
              }));
  auto& hashes = recorded->hashes;
  const auto key = [](const RecordedHash& hash) {
    return std::tie(hash.step, hash.calls, hash.state_hash);
  };
  std::sort(hashes.begin(), hashes.end(),
            [&key](const auto& a, const auto& b) { return key(a) < key(b); });
  // Two that contradict each other stay: one of them is found to differ.
  hashes.erase(std::unique(hashes.begin(), hashes.end(),
                           [&key](const auto& a, const auto& b) { return key(a) == key(b); }),
               hashes.end());
}

// The stretches between gaps; those that follow a gap begin with a reset.
std::vector<Stretch> StretchesOf(const RecordedSimulation& recorded) {
  std::vector<Stretch> stretches;
  const std::vector<JournalEntry>& calls = recorded.calls;
  stretches.push_back({recorded.beginning, 0, 0, recorded.beginning.number, 0});
  bool open = true;
  std::uint64_t before = recorded.beginning.number;
  for (std::size_t i = 0; i < calls.size(); ++i) {
    if (calls[i].number != before + 1) open = false;
    before = calls[i].number;
    const auto* reset = std::get_if<ResetCall>(&calls[i].call);
    if (!open && reset != nullptr) {
      stretches.push_back({{reset->seed, before, calls[i].step}, i + 1, i + 1, before, 0});
      open = true;
    } else if (open) {
      stretches.back().end = i + 1;
      stretches.back().last_number = before;
    }
  }
  return stretches;
}

}  // namespace

Result<ReplayPlan> MakeReplayPlan(RecordedSimulation recorded, std::vector<std::string>* warnings) {
  SortAndUnite(&recorded);
  std::vector<Stretch> stretches = StretchesOf(recorded);
  for (Stretch& stretch : stretches) {
    for (const RecordedHash& hash : recorded.hashes) stretch.hashes += stretch.Holds(hash);
  }
  const Stretch& best =
      *std::max_element(stretches.begin(), stretches.end(),
                        [](const Stretch& a, const Stretch& b) { return a.hashes < b.hashes; });
  if (best.hashes == 0) {
    return DataLoss(
        "there is no hash that a simulation from a known start state on could be "
        "compared with");
  }
  ReplayPlan plan;
  plan.beginning = best.beginning;
  plan.steps = recorded.steps;
  plan.calls.assign(recorded.calls.begin() + static_cast<std::ptrdiff_t>(best.begin),
                    recorded.calls.begin() + static_cast<std::ptrdiff_t>(best.end));
  for (const RecordedHash& hash : recorded.hashes) {
    if (best.Holds(hash)) plan.hashes.push_back(hash);
  }
  const std::size_t left_out = recorded.hashes.size() - plan.hashes.size();
  if (left_out != 0) {
    warnings->push_back("calls are missing in the record: only what lies between call " +
                        std::to_string(best.beginning.number) + " and call " +
                        std::to_string(best.last_number) + " can be simulated again, and " +
                        std::to_string(left_out) + " hashes cannot be compared");
  }
  return plan;
}

}  // namespace latticeworld
