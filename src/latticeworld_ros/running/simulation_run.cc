#include "latticeworld_ros/running/simulation_run.h"

#include <ros/console.h>

#include <optional>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld_ros/node/guarded.h"

namespace latticeworld {

Status SimulationRun::Check() const {
  if (running_.simulator == nullptr) {
    return FailedPrecondition("no world is running; call generate_world or load_world first");
  }
  return failure_.empty() ? Status() : FailedPrecondition(failure_);
}

void SimulationRun::Swap(LaunchedWorld* world) {
  std::swap(running_, *world);
  snapshots_.clear();
  failure_.clear();
  ++episode_;
}

Status SimulationRun::Step() {
  LW_RETURN_IF_ERROR(Check());
  return Guard("in a step", [this] {
    running_.simulator->Step();
    return Status();
  });
}

Result<std::string> SimulationRun::Apply(
    const std::function<Result<std::string>(Simulator*)>& change) {
  LW_RETURN_IF_ERROR(Check());
  std::string name;
  LW_RETURN_IF_ERROR(Guard("while it was changed", [&]() -> Status {
    LW_ASSIGN_OR_RETURN(name, change(running_.simulator.get()));
    return Status();
  }));
  return name;
}

Status SimulationRun::SetWeather(const WeatherChange& change) {
  LW_RETURN_IF_ERROR(Check());
  return Guard("in a change of weather", [&] { return running_.simulator->SetWeather(change); });
}

void SimulationRun::Command(AgentCommands* commands) {
  if (!failure_.empty()) ROS_WARN_STREAM_THROTTLE(1.0, "a command is not heard: " << failure_);
  (void)Guard("in a command", [&] {
    commands->Apply(simulator());
    return Status();
  });
}

Status SimulationRun::Reset(std::uint64_t seed) {
  if (running_.simulator == nullptr) return Check();
  LW_RETURN_IF_ERROR(Guard("in a reset", [&] {
    running_.simulator->Reset(seed != 0 ? seed : running_.simulator->seed());
    return Status();
  }));
  failure_.clear();
  ++episode_;
  return Status();
}

Status SimulationRun::Save(const std::string& name) {
  if (name.empty() || name.size() > kMaxSnapshotName) {
    return InvalidArgument("name has " + std::to_string(name.size()) +
                           " characters; legal are 1 .. " + std::to_string(kMaxSnapshotName));
  }
  LW_RETURN_IF_ERROR(Check());
  if (snapshots_.size() >= kMaxSnapshots && snapshots_.count(name) == 0) {
    return ResourceExhausted("there are " + std::to_string(kMaxSnapshots) +
                             " snapshots, as many as are kept: " + Join(SnapshotNames(), ", ") +
                             "; one of their names replaces it");
  }
  snapshots_[name] = running_.simulator->Save();
  return Status();
}

Status SimulationRun::Restore(const std::string& name) {
  if (running_.simulator == nullptr) return Check();
  const auto snapshot = snapshots_.find(name);
  if (snapshot == snapshots_.end()) {
    return NotFound("there is no snapshot " + Quote(name) + "; " +
                    (snapshots_.empty() ? "there are none: save_snapshot makes one"
                                        : "there are " + Join(SnapshotNames(), ", ")));
  }
  LW_RETURN_IF_ERROR(Guard("while a snapshot was restored", [&] {
    // A simulator that has failed has everything made anew first: a snapshot may build on parts
    // that are gone.
    if (!failure_.empty()) running_.simulator->Reset(running_.simulator->seed());
    return running_.simulator->Restore(*snapshot->second);
  }));
  failure_.clear();
  ++episode_;
  return Status();
}

SimulationMoment SimulationRun::Look(bool hash) const {
  const Simulator& simulator = *running_.simulator;
  const std::shared_ptr<const WorldState> state = simulator.State();
  SimulationMoment moment;
  moment.world = running_.world;
  moment.seed = simulator.seed();
  moment.episode = episode_;
  moment.step = state->step;
  moment.episode_step = state->episode_step;
  moment.state = state;
  moment.atmosphere = state->atmosphere;
  if (hash) moment.state_hash = simulator.StateHash();
  moment.snapshots = SnapshotNames();
  moment.species = simulator.options().species;
  return moment;
}

Status SimulationRun::Guard(const std::string& doing, const std::function<Status()>& change) {
  Status status;
  const std::optional<std::string> words = ExceptionOf([&] { status = change(); });
  if (!words.has_value()) return status;
  failure_ = "the simulation failed " + doing + " (" + *words +
             "); reset_world, restore_snapshot or another world let it go on";
  ROS_ERROR_STREAM(failure_);
  return Internal(failure_);
}

std::vector<std::string> SimulationRun::SnapshotNames() const {
  std::vector<std::string> names;
  for (const auto& entry : snapshots_) names.push_back(entry.first);
  return names;
}

}  // namespace latticeworld
