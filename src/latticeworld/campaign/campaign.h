#ifndef LATTICEWORLD_CAMPAIGN_CAMPAIGN_H_
#define LATTICEWORLD_CAMPAIGN_CAMPAIGN_H_

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "latticeworld/mapping/traversability.h"
#include "latticeworld/navigation/tasks.h"
#include "latticeworld/scene/weather/weather_change.h"

namespace latticeworld {

// A world of a campaign: made from words, or read from a bundle.
struct CampaignWorld {
  std::string name;              // unique; a part of trials' ids
  std::filesystem::path bundle;  // empty: made from what follows
  std::string layout, environment, vocabulary;
  std::uint64_t seed = 1;
  double size_m = 256.0;
  double resolution_m = 0.5;
};

// A program of the user's that drives a robot; docs/campaigns.md has what is said to it.
struct StackProgram {
  std::vector<std::string> command;  // a path or a name that PATH has, and arguments
  std::filesystem::path folder;      // that it runs in
  double answer_time_s = 30.0;       // by the wall's clock; a longer silence ends the trial
  bool scans = true;                 // whether it is told what its lidars saw
};

// A robot and what drives it.
struct CampaignRobot {
  std::string name = "robot";  // unique; a part of trials' ids
  std::string species = "wheeled robot";
  std::string suite = "scanner";    // of the sensor catalogue
  std::string stack = "reference";  // of StackNames(), or what the program is called
  std::optional<StackProgram> program;
  RobotLimits limits;          // of the map that it is given, and of its tasks
  double top_speed_mps = 1.0;  // that it is driven at, and that times are measured by
};

struct CampaignAdversaries {
  int count = 0;
  std::string species = "goblin";
  std::string policy = "pursuer";
  // How far from the shortest way they begin [m], and at least from the start.
  double reach_m = 15.0;
};

// The conditions under which a task is tried, and the seeds.
struct CampaignCondition {
  std::string name = "trial";        // unique; a part of trials' ids
  std::vector<std::uint64_t> seeds;  // of the simulation; one trial each
  std::uint64_t sensor_seed = 0;     // of noise; 0: it follows from the simulation's
  double time_limit_factor = 8.0;    // times what the shortest way takes at top speed
  double least_time_limit_s = 30.0;
  WeatherChange weather;
  CampaignAdversaries adversaries;
};

// Every robot tries every task of every world under every condition with every seed of it.
struct Campaign {
  std::string name;
  std::vector<CampaignWorld> worlds;
  std::vector<CampaignRobot> robots;
  TaskWishes tasks;  // of each world and robot; `robot` is filled in from the robot
  std::vector<CampaignCondition> conditions;
  double step_s = 0.01;      // of physics
  double control_hz = 10.0;  // of the stack, and of a record's samples
};

// One trial of a campaign.
struct PlannedTrial {
  std::string id;  // "<world>.<robot>.t<task>.<condition>.s<seed>": a file name, unique
  std::size_t world = 0, robot = 0, task = 0, condition = 0;  // indices
  std::uint64_t seed = 1;                                     // of the simulation
};

inline constexpr std::size_t kMaxTrials = 1000000;

// Every trial in the order of the tables: world by world, so that neighbours share one.
std::vector<PlannedTrial> PlanOf(const Campaign& campaign);

}  // namespace latticeworld

#endif  // LATTICEWORLD_CAMPAIGN_CAMPAIGN_H_
