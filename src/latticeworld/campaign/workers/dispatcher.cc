#include "latticeworld/campaign/workers/dispatcher.h"

#include <poll.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <deque>
#include <fstream>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "latticeworld/campaign/reports/result_files.h"
#include "latticeworld/campaign/workers/worker_process.h"
#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kTries = 2;
constexpr int kPoll_ms = 200;  // between two looks at the clock and at a wish to end
// Workers that cannot begin end with these statuses: another try would end alike.
constexpr int kCannotStart = 127, kUnusableArguments = 2;

double SecondsSince(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

// A worker, and the world that it has loaded.
struct Seat {
  std::optional<WorkerProcess> process;
  std::optional<std::size_t> world;
};

class Dispatcher {
 public:
  Dispatcher(const CampaignFolder& folder, const std::vector<std::size_t>& trials,
             const DispatchOptions& options, const std::function<void(std::size_t)>& told)
      : folder_(folder),
        options_(options),
        told_(told),
        waiting_(trials.begin(), trials.end()),
        total_(trials.size()),
        seats_(std::min<std::size_t>(static_cast<std::size_t>(options.workers), trials.size())) {}

  Status Run(const Progress& progress) {
    while (done_ < total_) {
      LW_RETURN_IF_ERROR(progress.CheckCancelled());
      for (Seat& seat : seats_) LW_RETURN_IF_ERROR(Employ(&seat));
      LW_RETURN_IF_ERROR(Listen());
      for (Seat& seat : seats_) {
        if (!seat.process || !seat.process->trial()) continue;
        if (SecondsSince(seat.process->since()) < options_.trial_time_s) continue;
        LW_RETURN_IF_ERROR(
            Lose(&seat, "it took longer than " + FormatDouble(options_.trial_time_s) + " s"));
      }
    }
    return Status();
  }

 private:
  // Gives an idle seat a trial, if there is one.
  Status Employ(Seat* seat) {
    if (waiting_.empty() || (seat->process && seat->process->trial())) return Status();
    if (!seat->process) {
      LW_ASSIGN_OR_RETURN(WorkerProcess process, WorkerProcess::Start(options_.command));
      seat->process.emplace(std::move(process));
      seat->world.reset();
    }
    const auto chosen = Choose(*seat);
    const std::size_t index = *chosen;
    waiting_.erase(chosen);
    seat->world = folder_.plan[index].world;
    if (!seat->process->Give(index)) return Lose(seat, "");
    return Status();
  }

  // A trial in the world that the worker has; else in one that nobody has; else the first.
  std::deque<std::size_t>::iterator Choose(const Seat& seat) {
    const auto world_of = [&](std::size_t index) { return folder_.plan[index].world; };
    std::set<std::size_t> taken;
    for (const Seat& other : seats_) {
      if (other.world && &other != &seat) taken.insert(*other.world);
    }
    auto free = waiting_.end();
    for (auto it = waiting_.begin(); it != waiting_.end(); ++it) {
      if (seat.world && world_of(*it) == *seat.world) return it;
      if (free == waiting_.end() && taken.count(world_of(*it)) == 0) free = it;
    }
    return free != waiting_.end() ? free : waiting_.begin();
  }

  Status Listen() {
    std::vector<pollfd> descriptors;
    std::vector<Seat*> speakers;
    for (Seat& seat : seats_) {
      if (!seat.process) continue;
      descriptors.push_back({seat.process->descriptor(), POLLIN, 0});
      speakers.push_back(&seat);
    }
    if (::poll(descriptors.data(), descriptors.size(), kPoll_ms) <= 0) return Status();
    for (std::size_t i = 0; i < descriptors.size(); ++i) {
      if (descriptors[i].revents == 0) continue;
      std::vector<std::string> lines;
      const bool there = speakers[i]->process->Read(&lines);
      for (const std::string& line : lines) LW_RETURN_IF_ERROR(Hear(line, speakers[i]));
      if (!there) LW_RETURN_IF_ERROR(Lose(speakers[i], ""));
    }
    return Status();
  }

  // "done <index>", "failed <index> <why>".
  Status Hear(const std::string& line, Seat* seat) {
    const auto& trial = seat->process->trial();
    if (trial && line == "done " + std::to_string(*trial)) {
      LW_RETURN_IF_ERROR(NoteTime(*trial, SecondsSince(seat->process->since())));
      seat->process->Done();
      told_(++done_);
      return Status();
    }
    if (!StartsWith(line, "failed ")) return Status();  // not ours: a library's chatter
    const std::string why = "a trial's result cannot be kept: " + line.substr(7);
    return line.find("RESOURCE_EXHAUSTED") != std::string::npos ? ResourceExhausted(why)
                                                                : Internal(why);
  }

  // The process of a seat is gone, or has to go for that reason; its trial is tried again or has
  // failed.
  Status Lose(Seat* seat, const std::string& reason) {
    const std::optional<std::size_t> trial = seat->process->trial();
    const ProcessEnd end = seat->process->End();
    seat->process.reset();
    if (end.exit_status == kCannotStart || end.exit_status == kUnusableArguments) {
      return Internal("workers cannot be started: " + Join(options_.command, " ") + " " +
                      end.ToString());
    }
    if (!trial) return Status();
    if (++tries_[*trial] < kTries) {
      waiting_.push_front(*trial);
      return Status();
    }
    const PlannedTrial& planned = folder_.plan[*trial];
    const std::string error = reason.empty() ? "its process " + end.ToString() : reason;
    LW_RETURN_IF_ERROR(WriteWhole(TrialResultFile(folder_.out, planned.id),
                                  EncodeTrialResult(ErrorOf(planned, error + ", twice"))));
    told_(++done_);
    return Status();
  }

  Status NoteTime(std::size_t trial, double seconds) {
    if (options_.wall_times.empty()) return Status();
    std::ofstream file(options_.wall_times, std::ios::app);
    file << folder_.plan[trial].id << "," << FormatDouble(std::round(seconds * 1000.0) / 1000.0)
         << "\n";
    file.close();
    return file ? Status() : ResourceExhausted("cannot write to " + options_.wall_times.string());
  }

  const CampaignFolder& folder_;
  const DispatchOptions& options_;
  const std::function<void(std::size_t)>& told_;
  std::deque<std::size_t> waiting_;
  std::size_t total_, done_ = 0;
  std::map<std::size_t, int> tries_;
  std::vector<Seat> seats_;
};

}  // namespace

Status Dispatch(const CampaignFolder& folder, const std::vector<std::size_t>& trials,
                const DispatchOptions& options, const Progress& progress,
                const std::function<void(std::size_t)>& told) {
  if (trials.empty()) return Status();
  return Dispatcher(folder, trials, options, told).Run(progress);
}

}  // namespace latticeworld
