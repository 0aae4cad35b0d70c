#include "latticeworld/campaign/trial.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "latticeworld/campaign/stacks/trial_sensors.h"
#include "latticeworld/common/random.h"
#include "latticeworld/simulation/simulator.h"

namespace latticeworld {
namespace {

constexpr char kRobot[] = "tested_robot";
constexpr int kAdversaryTeam = 2;
constexpr double kLeastAdversaryDistance_m = 10.0;  // from the start, as far as the world allows it
constexpr int kAdversaryTries = 400;

// Spawns the robot at the start, or as near to it as there is a place: animals may stand where it
// is.
Status SpawnRobot(const TrialSetup& setup, Simulator* simulator) {
  SpawnRequest request;
  request.name = kRobot;
  request.species = setup.robot.species;
  request.controllable = true;
  request.heading_rad = setup.task.start_heading_rad;
  Status first;
  for (const double radius_m : {0.0, 0.5, 1.0, 1.5}) {
    for (int i = 0; i < (radius_m > 0.0 ? 8 : 1); ++i) {
      const double angle = 2.0 * M_PI * i / 8;
      const WorldPoint place = {setup.task.start.x_m + radius_m * std::cos(angle),
                                setup.task.start.y_m + radius_m * std::sin(angle)};
      const GridGeometry& geometry = setup.scene->geometry();
      if (!geometry.Contains(place) || setup.occupancy[geometry.CellAt(place)] >= 100) continue;
      request.position = place;
      const auto name = simulator->Spawn(request);
      if (name.ok()) return Status();
      if (first.ok()) first = name.status();
    }
  }
  return FailedPrecondition("the robot finds no place at its start: " + first.message());
}

// Spawns the adversaries around places of the robot's way, from the end of its first third on.
Status SpawnAdversaries(const TrialSetup& setup, Simulator* simulator) {
  const CampaignAdversaries& wanted = setup.condition.adversaries;
  RandomStream random(setup.seed, "campaign adversaries");
  const auto& way = setup.task.way.points_m;
  for (int k = 0; k < wanted.count; ++k) {
    Status last = FailedPrecondition("every place is too near the robot's start");
    bool placed = false;
    for (int i = 0; i < kAdversaryTries && !placed; ++i) {
      const double along = random.Uniform(0.3, 1.0) * static_cast<double>(way.size() - 1);
      const auto leg = std::min(static_cast<std::size_t>(along), way.size() - 1);
      const Eigen::Vector3d& from = way[leg];
      const Eigen::Vector3d& to = way[std::min(leg + 1, way.size() - 1)];
      const Eigen::Vector3d middle = from + (along - static_cast<double>(leg)) * (to - from);
      const double angle = random.Uniform(0.0, 2.0 * M_PI);
      const double off_m = wanted.reach_m * std::sqrt(random.Uniform());
      SpawnRequest request;
      request.species = wanted.species;
      request.policy = wanted.policy;
      request.team = kAdversaryTeam;
      request.heading_rad = random.Uniform(-M_PI, M_PI);
      request.position = {
          {middle.x() + off_m * std::cos(angle), middle.y() + off_m * std::sin(angle)}};
      const double away_m = std::hypot(request.position->x_m - setup.task.start.x_m,
                                       request.position->y_m - setup.task.start.y_m);
      if (away_m < std::min(kLeastAdversaryDistance_m, 0.4 * setup.task.difficulty.length_m))
        continue;
      const auto name = simulator->Spawn(request);
      placed = name.ok();
      if (!placed) last = name.status();
    }
    if (!placed) return FailedPrecondition("an adversary finds no place: " + last.message());
  }
  return Status();
}

double TimeLimitOf(const TrialSetup& setup) {
  return std::max(setup.condition.least_time_limit_s, setup.condition.time_limit_factor *
                                                          setup.task.difficulty.length_m /
                                                          setup.robot.top_speed_mps);
}

// One trial under way.
class Run {
 public:
  Run(const TrialSetup& setup, RobotStack* stack, Simulator* simulator, TrialSensors sensors)
      : setup_(setup),
        stack_(stack),
        simulator_(simulator),
        sensors_(std::move(sensors)),
        recorder_(kRobot, simulator->options().species) {}

  Result<TrialOutcome> Drive() {
    TrialOutcome outcome;
    outcome.time_limit_s = TimeLimitOf(setup_);
    outcome.goal = {{setup_.task.goal.x_m, setup_.task.goal.y_m},
                    setup_.task.goal_radius_m,
                    setup_.task.difficulty.length_m,
                    setup_.robot.top_speed_mps};
    LW_RETURN_IF_ERROR(Begin(&outcome));
    while (outcome.ended_by.empty()) LW_RETURN_IF_ERROR(Step(&outcome));
    outcome.record = recorder_.record();
    outcome.interventions = recorder_.interventions();
    LW_RETURN_IF_ERROR(Validate(outcome.record, outcome.goal));
    outcome.metrics = Measure(outcome.record, outcome.goal);
    return outcome;
  }

 private:
  double NextControl() const { return static_cast<double>(controls_) / setup_.control_hz; }

  Status Begin(TrialOutcome* outcome) {
    const auto state = simulator_->State();
    recorder_.Sample(*state);
    LW_RETURN_IF_ERROR(sensors_.Step(*state, NextControl()));
    const StackTask task = {setup_.robot,
                            *simulator_->options().species->Find(setup_.robot.species),
                            setup_.scene->geometry(),
                            setup_.occupancy,
                            setup_.task,
                            setup_.control_hz};
    const Status begun = stack_->Begin(task, sensors_.Take());
    if (begun.ok()) return Status();
    outcome->ended_by = "stack failed";
    outcome->why = begun.ToString();
    return Status();
  }

  Status Step(TrialOutcome* outcome) {
    simulator_->Step();
    const auto state = simulator_->State();
    recorder_.Watch(*state, simulator_->TakeEvents(), setup_.step_s);
    const double now_s = state->episode_time_s;
    if (!recorder_.alive()) {
      recorder_.Sample(*state);
      outcome->ended_by = "died";
      outcome->why = recorder_.death();
      return Status();
    }
    LW_RETURN_IF_ERROR(sensors_.Step(*state, NextControl()));
    if (now_s < NextControl() - 0.5 * setup_.step_s) return Status();
    ++controls_;
    recorder_.Sample(*state);
    const StackOutput output = stack_->Update(sensors_.Take());
    if (output.state == StackState::kArrived) outcome->ended_by = "arrived";
    if (output.state == StackState::kFailed) {
      outcome->ended_by = "stack failed";
      outcome->why = output.why;
    }
    if (!outcome->ended_by.empty()) return Status();
    if (now_s >= outcome->time_limit_s) {
      outcome->ended_by = "time limit";
      recorder_.mutable_record()->timed_out = true;
      return Status();
    }
    VelocityCommand command;
    command.linear_mps.x() = output.speed_mps;
    command.yaw_rate_radps = output.yaw_rate_radps;
    return simulator_->Command(kRobot, command);
  }

  const TrialSetup& setup_;
  RobotStack* stack_;
  Simulator* simulator_;
  TrialSensors sensors_;
  TrialRecorder recorder_;
  std::uint64_t controls_ = 1;  // number of the next control
};

}  // namespace

Result<TrialOutcome> RunTrial(const TrialSetup& setup, RobotStack* stack) {
  SimulatorOptions options;
  options.step_s = setup.step_s;
  options.physics_threads = 1;  // trials run beside each other
  LW_ASSIGN_OR_RETURN(const auto simulator, Simulator::Create(setup.scene, options, setup.seed));
  if (!IsEmpty(setup.condition.weather))
    LW_RETURN_IF_ERROR(simulator->SetWeather(setup.condition.weather));
  LW_RETURN_IF_ERROR(SpawnRobot(setup, simulator.get()));
  LW_RETURN_IF_ERROR(SpawnAdversaries(setup, simulator.get()));
  simulator->TakeEvents();
  TrialSensorsOptions sensing;
  sensing.robot = kRobot;
  sensing.suite = setup.robot.suite;
  sensing.seed = setup.condition.sensor_seed != 0 ? setup.condition.sensor_seed
                                                  : StreamSeed(setup.seed, "sensors");
  sensing.step_s = setup.step_s;
  sensing.control_hz = setup.control_hz;
  sensing.scans = stack->UsesScans();
  LW_ASSIGN_OR_RETURN(TrialSensors sensors,
                      TrialSensors::Create(setup.scene, simulator->options().species, sensing));
  return Run(setup, stack, simulator.get(), std::move(sensors)).Drive();
}

}  // namespace latticeworld
