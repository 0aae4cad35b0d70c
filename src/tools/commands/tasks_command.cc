#include "tools/commands/tasks_command.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/common/range.h"
#include "latticeworld/common/text.h"
#include "latticeworld/generation/bundle/bundle.h"
#include "latticeworld/navigation/task_picture.h"
#include "latticeworld/navigation/tasks.h"
#include "latticeworld/navigation/tasks_json.h"
#include "latticeworld/species/species_catalogue.h"
#include "tools/arguments.h"
#include "tools/interrupt.h"
#include "tools/output_file.h"
#include "tools/progress_display.h"

namespace latticeworld::tools {
namespace {

// Options that say what ways are wanted.
struct RangeOption {
  const char* name;
  DifficultyRange TaskWishes::*range;
  const char* meaning;
};
constexpr RangeOption kRanges[] = {
    {"--length", &TaskWishes::length_m, "Length of the shortest way [m]; without it at least 20."},
    {"--climb", &TaskWishes::climb_m, "What the way goes up in all [m]."},
    {"--density", &TaskWishes::density, "Share of the ground beside the way that is not free."},
    {"--detour", &TaskWishes::detour, "Length of the way by the straight distance."},
    {"--agents", &TaskWishes::agents, "Agents that begin within 20 m of the way."}};

// Options that say what robot the tasks are for.
struct RobotOption {
  const char* name;
  double RobotLimits::*limit;
  Range legal;
  const char* meaning;
};
constexpr RobotOption kRobot[] = {
    {"--robot-radius",
     &RobotLimits::radius_m,
     {0.0, 10.0},
     "Of the robot [m], 0 to 10 [that of --robot-species]."},
    {"--robot-max-slope",
     &RobotLimits::max_slope_rad,
     {0.01, 1.5},
     "Steepest ground that it climbs [rad], 0.01 to 1.5 [0.5236]."},
    {"--robot-max-step",
     &RobotLimits::max_step_m,
     {0.0, 10.0},
     "Highest step that it climbs [m], 0 to 10 [0.25]."},
    {"--robot-max-fording-depth",
     &RobotLimits::max_fording_depth_m,
     {0.0, 10.0},
     "Deepest water that it fords [m], 0 to 10 [0.2]."},
    {"--robot-clearance",
     &RobotLimits::clearance_m,
     {0.0, 100.0},
     "Height that it needs free below crowns [m], 0 to 100 [0.5]."},
    {"--robot-mass",
     &RobotLimits::mass_kg,
     {0.0, 1e6},
     "Its mass, for bridges [kg], 0 to 1e+06 [50]."},
    {"--robot-grip",
     &RobotLimits::grip,
     {0.05, 10.0},
     "What it pushes with, times the ground's friction, 0.05 to 10 [1]."}};

// What the options ask for. Errors: INVALID_ARGUMENT with every violation.
Result<TaskWishes> ReadWishes(const CLI::App& command) {
  ArgumentReader arguments(&command);
  TaskWishes wishes;
  wishes.count = arguments.Whole("--count", wishes.count);
  wishes.seed = arguments.Unsigned("--seed", wishes.seed);
  wishes.goal_radius_m = arguments.Number("--goal-radius", wishes.goal_radius_m);
  for (const RangeOption& option : kRanges) {
    if (const auto pair = arguments.NumberPair(option.name))
      wishes.*option.range = {pair->first, pair->second};
  }
  std::vector<Violation> violations;
  const std::string name = ValueOf(command, "--robot-species").value_or("wheeled robot");
  if (const Species* species = SpeciesCatalogue::BuiltIn()->Find(name)) {
    wishes.robot.radius_m = species->radius_m;
  } else {
    violations.push_back(
        {"unknown_value", "--robot-species",
         "is " + Quote(name) + ", no built-in species; `latticeworld species` lists them",
         Quote(name)});
  }
  for (const RobotOption& option : kRobot) {
    double& limit = wishes.robot.*option.limit;
    limit = arguments.Number(option.name, limit);
    CheckRange(option.name, limit, option.legal, "", &violations);
  }
  wishes.robot.on_wheels = command.count("--robot-walks") == 0;
  arguments.AddIllegal({}, std::move(violations));
  // Asked before the world is loaded, which takes longer.
  arguments.AddIllegal({{"count", "--count"},
                        {"goal_radius_m", "--goal-radius"},
                        {"length_m", "--length"},
                        {"climb_m", "--climb"},
                        {"density", "--density"},
                        {"detour", "--detour"},
                        {"agents", "--agents"}},
                       Validate(wishes).violations());
  LW_RETURN_IF_ERROR(arguments.status());
  return wishes;
}

void Print(const std::vector<NavigationTask>& tasks) {
  std::printf("  task   length m   climb m   density   detour   agents\n");
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    const TaskDifficulty& difficulty = tasks[i].difficulty;
    std::printf("%6zu %10.1f %9.1f %9.3f %8.2f %8d\n", i, difficulty.length_m, difficulty.climb_m,
                difficulty.density, difficulty.detour, difficulty.agents);
  }
  std::fflush(stdout);
}

Status SampleAndWrite(const CLI::App& command) {
  LW_ASSIGN_OR_RETURN(const TaskWishes wishes, ReadWishes(command));
  LW_ASSIGN_OR_RETURN(const auto world, LoadBundle(*ValueOf(command, "DIR")));
  ProgressDisplay display;
  Progress progress(
      [&display](std::string_view stage, double fraction) { display.Show(stage, fraction); });
  const CancelOnInterrupt cancel_on_interrupt(&progress);
  auto tasks = SampleTasks(*world->scene, wishes, progress);
  display.Clear();
  if (!tasks.ok()) return tasks.status();
  const TaskSet set{world->id, wishes.seed, wishes.robot, *std::move(tasks)};
  LW_RETURN_IF_ERROR(
      ReplaceFile(*ValueOf(command, "--out"), EncodeTasks(set)).WithContext("--out"));
  Print(set.tasks);
  const auto picture = ValueOf(command, "--picture");
  if (!picture) return Status();
  LW_ASSIGN_OR_RETURN(const std::string png, DrawTasks(*world->scene, set.tasks, PictureOptions()));
  return ReplaceFile(*picture, png).WithContext("--picture");
}

}  // namespace

void AddTasksCommand(CLI::App* app, int* exit_status) {
  CLI::App* command = app->add_subcommand(
      "tasks",
      "Draws navigation tasks in a bundle's world, each with a way that the robot can go, and says "
      "how hard they are.");
  AddValueOption(command, "DIR", "DIR", "The bundle.");
  command->get_option("DIR")->required();
  AddValueOption(command, "--out", "FILE", "The tasks as JSON; an existing file is replaced.");
  command->get_option("--out")->required();
  AddValueOption(command, "--picture", "FILE.png",
                 "Their ways on the world's map; an existing file is replaced.");
  AddValueOption(command, "--count", "N", "How many, 1 to 1000 [10].");
  AddValueOption(command, "--seed", "N", "The same seed draws the same tasks [1].");
  AddValueOption(command, "--goal-radius", "M", "Of the goals, above 0 and at most 100 [0.5].");
  for (const RangeOption& option : kRanges)
    AddValueOption(command, option.name, "LOW,HIGH", option.meaning);
  AddValueOption(command, "--robot-species", "NAME",
                 "The built-in species whose radius it has [wheeled robot].");
  for (const RobotOption& option : kRobot)
    AddValueOption(command, option.name, "X", option.meaning);
  command->add_flag("--robot-walks",
                    "It goes on feet: the ground's rolling resistance is nothing to it.");
  command->callback([command, exit_status] {
    const Status status = SampleAndWrite(*command);
    if (!status.ok()) *exit_status = ReportFailure("tasks", status);
  });
}

}  // namespace latticeworld::tools
