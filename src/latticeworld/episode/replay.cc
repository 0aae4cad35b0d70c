#include "latticeworld/episode/replay.h"

#include <exception>
#include <string>
#include <utility>

namespace latticeworld {
namespace {

constexpr std::uint64_t kStepsPerReport = 256;

Status CheckOrder(const ReplayPlan& plan) {
  std::uint64_t number = plan.beginning.number, step = plan.beginning.step;
  for (const JournalEntry& entry : plan.calls) {
    if (entry.number != number + 1) {
      return DataLoss("call " + std::to_string(number + 1) + " is missing: after call " +
                      std::to_string(number) + " comes call " + std::to_string(entry.number));
    }
    if (entry.step < step) {
      return DataLoss("call " + std::to_string(entry.number) + " is of step " +
                      std::to_string(entry.step) + ", before that of the call before it");
    }
    number = entry.number;
    step = entry.step;
  }
  const RecordedHash* before = nullptr;
  for (const RecordedHash& hash : plan.hashes) {
    if (before != nullptr && (hash.step < before->step || hash.calls < before->calls)) {
      return DataLoss("the hash of step " + std::to_string(hash.step) +
                      " comes after that of step " + std::to_string(before->step));
    }
    if (hash.calls > number) {
      return DataLoss("call " + std::to_string(number + 1) + " is missing: the hash of step " +
                      std::to_string(hash.step) + " is of after call " +
                      std::to_string(hash.calls));
    }
    before = &hash;
  }
  return Status();
}

// A simulation that follows a plan.
class Run {
 public:
  Run(Simulator* simulator, const ReplayPlan& plan, const Progress& progress)
      : simulator_(simulator),
        plan_(plan),
        progress_(progress),
        player_(simulator, RestoredSnapshots(plan.calls)),
        step_(plan.beginning.step),
        last_step_(plan.hashes.empty() ? step_ : plan.hashes.back().step) {}

  Result<ReplayReport> Go() {
    for (const RecordedHash& hash : plan_.hashes) {
      if (hash.calls < plan_.beginning.number || hash.step < plan_.beginning.step) {
        ++report_.skipped;
        continue;
      }
      std::string failure;
      LW_RETURN_IF_ERROR(Reach(hash, &failure));
      const std::string state_hash = failure.empty() ? simulator_->StateHash() : std::string();
      if (state_hash != hash.state_hash) {
        report_.divergence = Divergence{hash, state_hash, failure, report_.agreed};
        break;
      }
      ++report_.hashes;
      report_.agreed = hash;
    }
    report_.calls_after = plan_.calls.size() - next_call_;
    return report_;
  }

 private:
  // Goes up to the moment of a hash. failure: what a call on the way there was refused for, if one
  // was.
  Status Reach(const RecordedHash& hash, std::string* failure) {
    for (; next_call_ < plan_.calls.size(); ++next_call_) {
      const JournalEntry& entry = plan_.calls[next_call_];
      if (entry.number > hash.calls) break;
      LW_RETURN_IF_ERROR(StepTo(entry.step));
      const Status applied = player_.Apply(entry.call);
      if (!applied.ok()) {
        *failure = "call " + std::to_string(entry.number) + " fails: " + applied.ToString();
        return Status();
      }
      ++report_.calls;
    }
    return StepTo(hash.step);
  }

  Status StepTo(std::uint64_t step) {
    for (; step_ < step; ++step_) {
      simulator_->Step();
      (void)simulator_->TakeEvents();
      if (++report_.steps % kStepsPerReport != 0) continue;
      LW_RETURN_IF_ERROR(progress_.CheckCancelled());
      progress_.Report("replay", static_cast<double>(step_ - plan_.beginning.step) /
                                     static_cast<double>(last_step_ - plan_.beginning.step));
    }
    return Status();
  }

  Simulator* const simulator_;
  const ReplayPlan& plan_;
  const Progress& progress_;
  JournalPlayer player_;
  ReplayReport report_;
  std::uint64_t step_;
  const std::uint64_t last_step_;
  std::size_t next_call_ = 0;
};

}  // namespace

Result<ReplayReport> Replay(std::shared_ptr<const Scene> scene, const SimulatorOptions& options,
                            const ReplayPlan& plan, const Progress& progress) {
  LW_RETURN_IF_ERROR(CheckOrder(plan));
  LW_ASSIGN_OR_RETURN(const std::unique_ptr<Simulator> simulator,
                      Simulator::Create(std::move(scene), options, plan.beginning.seed));
  try {
    return Run(simulator.get(), plan, progress).Go();
  } catch (const std::exception& error) {
    return Internal(std::string("the simulation failed: ") + error.what());
  }
}

bool IsProven(const ReplayReport& report, const RecordedSteps& steps) {
  if (report.divergence || !report.agreed) return false;
  const bool beyond_beginning =
      report.agreed->step > steps.first || report.agreed->calls > steps.first_call;
  const bool more_is_recorded = steps.last > steps.first || report.calls_after != 0;
  return beyond_beginning || !more_is_recorded;
}

std::string ProofText(const ReplayReport& report, const RecordedSteps& steps) {
  const std::uint64_t recorded = steps.last - steps.first;
  if (!IsProven(report, steps)) {
    return "NO PROOF: no hash of a state after the beginning can be compared; nothing shows what "
           "the " +
           std::to_string(recorded) + " recorded steps did";
  }
  std::string text = "PROVEN: " + std::to_string(report.hashes) + " of " +
                     std::to_string(report.hashes) +
                     " recorded states are the same, bit for bit; the last of them is after " +
                     std::to_string(report.agreed->step - steps.first) + " of " +
                     std::to_string(recorded) + " recorded steps";
  if (report.calls_after != 0) {
    text += "; calls after it: " + std::to_string(report.calls_after);
  }
  return text;
}

}  // namespace latticeworld
