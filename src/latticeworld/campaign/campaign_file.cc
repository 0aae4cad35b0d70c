#include "latticeworld/campaign/campaign_file.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <exception>
#include <set>
#include <utility>

#include "latticeworld/campaign/reports/world_section.h"
#include "latticeworld/campaign/stacks/child_process.h"
#include "latticeworld/campaign/stacks/robot_stack.h"
#include "latticeworld/campaign/yaml_reader.h"
#include "latticeworld/common/text.h"
#include "latticeworld/environment/attributes.h"
#include "latticeworld/sensing/sensor_suite.h"
#include "latticeworld/simulation/simulator.h"
#include "latticeworld/species/species_catalogue.h"

namespace latticeworld {
namespace {

// Returns the names of the species that the robot's stacks can drive: bodies on wheels and legs.
std::vector<std::string> DrivenSpeciesNames() {
  std::vector<std::string> names;
  for (const Species& species : SpeciesCatalogue::BuiltIn()->all()) {
    if (species.plan == BodyPlan::kVehicle || species.plan == BodyPlan::kQuadruped)
      names.push_back(species.name);
  }
  return names;
}

std::vector<std::string> SuiteNames() {
  std::vector<std::string> names;
  for (const SensorSuite& suite : SensorCatalogue::BuiltIn()->suites()) names.push_back(suite.name);
  return names;
}

void ReadLimits(const YAML::Node& node, const std::string& path, RobotLimits* limits,
                std::vector<Violation>* violations) {
  YamlMapping mapping(node, path, violations);
  mapping.Number("radius_m", {0.05, 10.0}, " m", &limits->radius_m);
  mapping.Number("max_slope_rad", {0.01, 1.5}, " rad", &limits->max_slope_rad);
  mapping.Number("max_step_m", {0.0, 10.0}, " m", &limits->max_step_m);
  mapping.Number("max_fording_depth_m", {0.0, 10.0}, " m", &limits->max_fording_depth_m);
  mapping.Number("clearance_m", {0.0, 100.0}, " m", &limits->clearance_m);
  mapping.Number("mass_kg", {0.0, 1e6}, " kg", &limits->mass_kg);
  mapping.Number("grip", {0.05, 10.0}, "", &limits->grip);
  mapping.Switch("on_wheels", &limits->on_wheels);
  mapping.Finish();
}

// Sets the robot's limits from its species; a file may then change them.
void TakeBody(CampaignRobot* robot) {
  const Species* species = SpeciesCatalogue::BuiltIn()->Find(robot->species);
  if (species == nullptr) return;
  robot->limits.radius_m = species->radius_m;
  robot->limits.max_slope_rad = std::clamp(species->max_slope_rad, 0.01, 1.5);
  robot->limits.max_fording_depth_m = species->wade_depth_m;
  robot->limits.clearance_m = species->height_m;
  robot->limits.mass_kg = species->mass_kg;
  robot->limits.grip = species->grip;
  robot->limits.on_wheels = species->plan == BodyPlan::kVehicle;
  if (species->vehicle)
    robot->limits.max_step_m = std::min(robot->limits.max_step_m, species->vehicle->wheel_radius_m);
}

// "stack: reference", or "stack: {command: [program, argument, ...], name: mine}".
void ReadStack(YamlMapping* robot_mapping, const std::filesystem::path& folder,
               CampaignRobot* robot) {
  const YAML::Node node = robot_mapping->Get("stack");
  if (!node.IsDefined() || !node.IsMap())
    return robot_mapping->Choice("stack", StackNames(), &robot->stack);
  const std::string path = robot_mapping->PathOf("stack");
  std::vector<Violation>* const violations = robot_mapping->violations();
  StackProgram program;
  program.folder = folder;
  robot->stack = "program";
  YamlMapping mapping(node, path, violations);
  mapping.Require("command");
  mapping.Name("name", &robot->stack);
  mapping.Number("answer_time_s", {0.01, 600.0}, " s", &program.answer_time_s);
  mapping.Switch("scans", &program.scans);
  const YAML::Node command = mapping.Get("command");
  if (mapping.Has("command")) {
    bool legal = command.IsSequence() && command.size() > 0;
    for (std::size_t i = 0; legal && i < command.size(); ++i) {
      legal = command[i].IsScalar();
      if (legal) program.command.push_back(command[i].Scalar());
    }
    if (!legal) {
      AddYamlViolation(command, mapping.PathOf("command"), "wrong_type",
                       "a list is wanted: [program, argument, ...]", violations);
    } else if (!IsProgram(program.command[0], folder)) {
      AddYamlViolation(command[0], mapping.PathOf("command") + "/0", "not_found",
                       "a program is wanted: a path from the campaign's file, or a name in PATH",
                       violations);
    }
  }
  mapping.Finish();
  robot->program = std::move(program);
}

CampaignRobot ReadRobot(const YAML::Node& node, const std::string& path,
                        const std::filesystem::path& folder, std::vector<Violation>* violations) {
  CampaignRobot robot;
  YamlMapping mapping(node, path, violations);
  mapping.Name("name", &robot.name);
  mapping.Choice("species", DrivenSpeciesNames(), &robot.species);
  mapping.Choice("suite", SuiteNames(), &robot.suite);
  ReadStack(&mapping, folder, &robot);
  TakeBody(&robot);
  mapping.Number("top_speed_mps", {0.05, 20.0}, " m/s", &robot.top_speed_mps);
  const YAML::Node limits = mapping.Get("limits");
  if (mapping.Has("limits"))
    ReadLimits(limits, mapping.PathOf("limits"), &robot.limits, violations);
  mapping.Finish();
  return robot;
}

void ReadRange(YamlMapping* mapping, const std::string& key, DifficultyRange* range) {
  const YAML::Node node = mapping->Get(key);
  if (!mapping->Has(key)) return;
  DifficultyRange read;
  const bool pair = node.IsSequence() && node.size() == 2;
  if (!pair || !ReadYamlNumber(node[0], &read.low) || !ReadYamlNumber(node[1], &read.high)) {
    AddYamlViolation(node, mapping->PathOf(key), "bad_range",
                     "two numbers are wanted: [LOW, HIGH], 0 <= LOW <= HIGH",
                     mapping->violations());
    return;
  }
  *range = read;
}

TaskWishes ReadTasks(const YAML::Node& node, std::vector<Violation>* violations) {
  TaskWishes wishes;
  YamlMapping mapping(node, "/tasks", violations);
  mapping.Whole("count", &wishes.count);
  mapping.Seed("seed", &wishes.seed);
  mapping.Number("goal_radius_m", &wishes.goal_radius_m);
  ReadRange(&mapping, "length_m", &wishes.length_m);
  ReadRange(&mapping, "climb_m", &wishes.climb_m);
  ReadRange(&mapping, "density", &wishes.density);
  ReadRange(&mapping, "detour", &wishes.detour);
  ReadRange(&mapping, "agents", &wishes.agents);
  mapping.AddIllegal({}, Validate(wishes).violations());
  mapping.Finish();
  return wishes;
}

WeatherChange ReadWeather(const YAML::Node& node, const std::string& path,
                          std::vector<Violation>* violations) {
  WeatherChange change;
  YamlMapping mapping(node, path, violations);
  std::string weather;
  std::vector<std::string> names;
  for (const auto& entry : EnumNames(Weather{})) names.emplace_back(entry.name);
  mapping.Choice("weather", names, &weather);
  if (!weather.empty()) change.weather = FromName<Weather>(weather);
  mapping.Number("intensity", &change.intensity);
  mapping.Number("wind_speed_mps", &change.wind_speed_mps);
  mapping.Number("wind_heading_rad", &change.wind_heading_rad);
  mapping.Number("gust_mps", &change.gust_mps);
  mapping.Number("visibility_m", &change.visibility_m);
  mapping.Number("ground_wetness", &change.ground_wetness);
  mapping.Number("snow_depth_m", &change.snow_depth_m);
  mapping.Number("hour", &change.hour);
  mapping.AddIllegal({{"wind_speed", "wind_speed_mps"},
                      {"wind_heading", "wind_heading_rad"},
                      {"gust", "gust_mps"},
                      {"visibility", "visibility_m"},
                      {"snow_depth", "snow_depth_m"}},
                     Validate(change));
  mapping.Finish();
  return change;
}

void ReadAdversaries(const YAML::Node& node, const std::string& path,
                     CampaignAdversaries* adversaries, std::vector<Violation>* violations) {
  YamlMapping mapping(node, path, violations);
  adversaries->count = 1;
  mapping.Whole("count", 0, 50, &adversaries->count);
  mapping.Text("species", 1, &adversaries->species);
  mapping.Text("policy", 1, &adversaries->policy);
  mapping.Number("reach_m", {3.0, 200.0}, " m", &adversaries->reach_m);
  SpawnRequest adversary;
  adversary.species = adversaries->species;
  adversary.policy = adversaries->policy;
  mapping.AddIllegal({}, Validate(adversary, *SpeciesCatalogue::BuiltIn()));
  mapping.Finish();
}

CampaignCondition ReadCondition(const YAML::Node& node, const std::string& path,
                                std::vector<Violation>* violations) {
  CampaignCondition condition;
  condition.seeds = {1};
  YamlMapping mapping(node, path, violations);
  mapping.Name("name", &condition.name);
  const YAML::Node seeds = mapping.Get("seeds");
  if (mapping.Has("seeds")) condition.seeds = ReadSeeds(seeds, mapping.PathOf("seeds"), violations);
  mapping.Seed("sensor_seed", &condition.sensor_seed);
  mapping.Number("time_limit_factor", {1.0, 1000.0}, "", &condition.time_limit_factor);
  mapping.Number("least_time_limit_s", {0.0, 86400.0}, " s", &condition.least_time_limit_s);
  const YAML::Node weather = mapping.Get("weather"), adversaries = mapping.Get("adversaries");
  if (mapping.Has("weather"))
    condition.weather = ReadWeather(weather, mapping.PathOf("weather"), violations);
  if (mapping.Has("adversaries")) {
    ReadAdversaries(adversaries, mapping.PathOf("adversaries"), &condition.adversaries, violations);
  }
  mapping.Finish();
  return condition;
}

// The entries of a list; one of defaults where the key is not there.
template <typename Entry, typename Read>
std::vector<Entry> ReadList(YamlMapping* root, const std::string& key, const Read& read) {
  std::vector<Entry> entries;
  const YAML::Node node = root->Get(key);
  if (!root->Has(key)) {
    std::vector<Violation> none;
    return {read(YAML::Node(YAML::NodeType::Map), root->PathOf(key), &none)};
  }
  if (!node.IsSequence() || node.size() == 0) {
    AddYamlViolation(node, root->PathOf(key), "wrong_type", "a list of at least one is wanted",
                     root->violations());
    return entries;
  }
  std::set<std::string> names;
  for (std::size_t i = 0; i < node.size(); ++i) {
    const std::string path = root->PathOf(key) + "/" + std::to_string(i);
    entries.push_back(read(node[i], path, root->violations()));
    if (!names.insert(entries.back().name).second) {
      AddYamlViolation(node[i], path, "duplicate_name",
                       "the name \"" + entries.back().name + "\" is there already; give another",
                       root->violations());
    }
  }
  return entries;
}

Result<Campaign> Parse(const std::string& text, const std::filesystem::path& folder) {
  const YAML::Node document = YAML::Load(text);
  std::vector<Violation> violations;
  Campaign campaign;
  YamlMapping root(document, "", &violations);
  root.Require("name");
  root.Text("name", 1, &campaign.name);
  root.Require("worlds");
  const YAML::Node worlds = root.Get("worlds");
  if (root.Has("worlds")) campaign.worlds = ReadWorldSection(worlds, folder, &violations);
  campaign.robots = ReadList<CampaignRobot>(
      &root, "robots",
      [&folder](const YAML::Node& node, const std::string& path, std::vector<Violation>* found) {
        return ReadRobot(node, path, folder, found);
      });
  const YAML::Node tasks = root.Get("tasks");
  if (root.Has("tasks")) campaign.tasks = ReadTasks(tasks, &violations);
  campaign.conditions = ReadList<CampaignCondition>(&root, "trials", ReadCondition);
  SimulatorOptions simulator;
  root.Number("step_s", &simulator.step_s);
  root.AddIllegal({}, Validate(simulator));
  campaign.step_s = simulator.step_s;
  root.Number("control_hz", {2.0, 100.0}, " Hz", &campaign.control_hz);
  root.Finish();
  double trials =
      static_cast<double>(campaign.worlds.size() * campaign.robots.size()) * campaign.tasks.count;
  std::size_t seeds = 0;
  for (const CampaignCondition& condition : campaign.conditions) seeds += condition.seeds.size();
  trials *= static_cast<double>(seeds);
  if (trials > static_cast<double>(kMaxTrials)) {
    violations.push_back({"too_many", "/", "asks for more than 1000000 trials", ""});
  }
  if (!violations.empty())
    return Status::FromViolations("unusable campaign", std::move(violations));
  return campaign;
}

}  // namespace

Result<Campaign> ParseCampaign(const std::string& text, const std::filesystem::path& folder) {
  LW_RETURN_IF_ERROR(ValidateText("the campaign", text, kMaxCampaignBytes));
  try {
    return Parse(text, folder);
  } catch (const YAML::Exception& error) {
    const std::string line =
        error.mark.is_null() ? "" : "line " + std::to_string(error.mark.line + 1);
    return Status::FromViolations("unusable campaign",
                                  {{"bad_yaml", line, "is no YAML: " + error.msg, ""}});
  }
}

}  // namespace latticeworld
