#include "latticeworld_ros/node/parameters.h"

#include <cstdlib>
#include <memory>
#include <string_view>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld_ros/node/parameter_binding.h"

namespace latticeworld {
namespace {

using XmlRpc::XmlRpcValue;

// Parameters of the simulation, of sensors and of what is published.
BoundParameters BindSimulation(WorldServerOptions* options) {
  return {
      // These are the simulation's.
      {"real_time_factor", Bind(&options->real_time_factor)},
      {"start_paused", Bind(&options->start_paused)},
      {"step", Bind(&options->simulator.step_s)},
      {"command_timeout", Bind(&options->simulator.command_timeout_s)},
      {"pursuit_distance", Bind(&options->simulator.pursuit_distance_m)},
      {"physics_threads", Bind(&options->simulator.physics_threads)},
      {"day_length", Bind(&options->simulator.day_length_s)},
      {"species", Bind(&options->species)},
      {"robot_species", Bind(&options->simulator.robot_species)},
      // These are the sensors', and say where a world lies that does not say it.
      {"sensors", Bind(&options->sensors)},
      {"sensor_suite", Bind(&options->sensor_suite)},
      {"sensor_threads", Bind(&options->sensor_threads)},
      {"sensor_seed", Bind(&options->sensor_seed)},
      {"longitude", Bind(&options->longitude_deg)},
      {"altitude", Bind(&options->altitude_m)},
      {"geoid_undulation", Bind(&options->geoid_undulation_m)},
      {"point_times", Bind(&options->point_times)},
      // These say which frames are published, and how often what.
      {"publish_map_to_odom", Bind(&options->frames.map_to_odom)},
      {"publish_odom_to_base", Bind(&options->frames.odom_to_base)},
      {"localised_elsewhere", Bind(&options->frames.localised_elsewhere)},
      {"odometry_elsewhere", Bind(&options->frames.odometry_elsewhere)},
      {"clock_rate", Bind(&options->clock_rate_hz)},
      {"state_rate", Bind(&options->state_rate_hz)},
      {"marker_rate", Bind(&options->marker_rate_hz)},
      {"state_hash_rate", Bind(&options->state_hash_rate_hz)},
      {"marker_terrain_cells", Bind(&options->marker_terrain_cells)},
      {"marker_max_assets", Bind(&options->marker_max_assets)},
  };
}

// Parameters that say who reads instructions and generates: the rules, a model on a server, one in
// this process.
BoundParameters BindLanguage(WorldServerOptions* options) {
  return {
      {"reader", Bind(&options->reader)},
      {"generator", Bind(&options->generator)},
      {"remote_url", Bind(&options->remote.server.url)},
      {"remote_model", Bind(&options->remote.server.model)},
      {"remote_dialect", Bind(&options->remote.server.dialect)},
      {"remote_sees", Bind(&options->remote.server.sees)},
      {"remote_api_key_variable", Bind(&options->remote.server.api_key_variable)},
      {"remote_ca_file", Bind(&options->remote.server.ca_file)},
      {"remote_connect_timeout", Bind(&options->remote.server.connect_timeout_s)},
      {"remote_first_token_timeout", Bind(&options->remote.server.first_token_timeout_s)},
      {"remote_total_timeout", Bind(&options->remote.server.total_timeout_s)},
      {"remote_max_retries", Bind(&options->remote.server.max_retries)},
      {"remote_backoff", Bind(&options->remote.server.backoff_s)},
      {"remote_max_answer_bytes", Bind(&options->remote.server.max_answer_bytes)},
      {"remote_repair_turns", Bind(&options->remote.model.repair_turns)},
      {"remote_temperature", Bind(&options->remote.model.temperature)},
      {"remote_layout_max_tokens", Bind(&options->remote.model.layout_max_tokens)},
      {"remote_environment_max_tokens", Bind(&options->remote.model.environment_max_tokens)},
      {"remote_fallback", Bind(&options->remote.fallback)},
      {"local_layout_model", Bind(&options->local.layout_model)},
      {"local_environment_model", Bind(&options->local.environment_model)},
      {"local_temperature", Bind(&options->local.temperature)},
      {"local_tries", Bind(&options->local.tries)},
      {"local_threads", Bind(&options->local.threads)},
      {"local_fallback", Bind(&options->local.fallback)},
      {"reader_model", Bind(&options->reader_model.model)},
      {"reader_threads", Bind(&options->reader_model.threads)},
  };
}

BoundParameters BindFilesAndMaps(WorldServerOptions* options) {
  return {
      // These name files that are read and written.
      {"worlds_directory", Bind(&options->worlds_directory)},
      {"visual_directories", Bind(&options->visual_directories)},
      {"catalogue", Bind(&options->catalogue)},
      {"sketch_model", Bind(&options->sketch_model)},
      // These describe maps, and the robot that they are for.
      {"octomap_resolution", Bind(&options->octomap_resolution_m)},
      {"octomap_thickness", Bind(&options->octomap_thickness_m)},
      {"map_values", Bind(&options->map_values)},
      {"most_message_bytes", Bind(&options->most_message_bytes)},
      {"robot_radius", Bind(&options->robot_radius_m)},
      {"robot_max_slope", Bind(&options->robot.max_slope_rad)},
      {"robot_max_step", Bind(&options->robot.max_step_m)},
      {"robot_max_fording_depth", Bind(&options->robot.max_fording_depth_m)},
      {"robot_clearance", Bind(&options->robot.clearance_m)},
      {"robot_mass", Bind(&options->robot.mass_kg)},
      {"robot_grip", Bind(&options->robot.grip)},
      {"robot_on_wheels", Bind(&options->robot.on_wheels)},
  };
}

BoundParameters BindAll(WorldServerOptions* options) {
  BoundParameters all = BindSimulation(options);
  all.merge(BindLanguage(options));
  all.merge(BindFilesAndMaps(options));
  return all;
}

// The radius that maps are made for: the one that is said, or that of the world's robots.
double RadiusOf(const WorldServerOptions& options) {
  if (options.robot_radius_m != WorldServerOptions::kRadiusOfSpecies) return options.robot_radius_m;
  return options.simulator.species->Find(options.simulator.robot_species)->radius_m;
}

}  // namespace

Result<WorldServerOptions> OptionsFromParameters(const XmlRpcValue& parameters) {
  WorldServerOptions options;
  std::vector<Violation> violations;
  ReadParameters(parameters, BindAll(&options), &violations);

  if (!options.species.empty()) {
    Result<std::shared_ptr<const SpeciesCatalogue>> species =
        SpeciesCatalogue::Load(ExpandHome(options.species));
    if (species.ok()) {
      options.simulator.species = std::move(species).value();
    } else {
      violations.push_back(
          {"unusable", "species", species.status().message(), Quote(options.species)});
    }
  }
  if (!options.sensors.empty()) {
    Result<std::shared_ptr<const SensorCatalogue>> sensors =
        SensorCatalogue::Load({ExpandHome(options.sensors)});
    if (sensors.ok()) {
      options.sensor_catalogue = std::move(sensors).value();
    } else {
      violations.push_back(
          {"unusable", "sensors", sensors.status().message(), Quote(options.sensors)});
    }
  }
  for (Violation& violation : Validate(options)) {
    violations.push_back(std::move(violation));
  }
  if (!violations.empty()) {
    return Status::FromViolations("parameters of world_server", std::move(violations));
  }
  options.robot.radius_m = RadiusOf(options);
  return options;
}

std::filesystem::path ExpandHome(const std::string& path) {
  constexpr std::string_view kRos = "~/.ros";
  const char* ros_home = std::getenv("ROS_HOME");
  const bool in_ros = path == kRos || StartsWith(path, std::string(kRos) + "/");
  if (ros_home != nullptr && *ros_home != '\0' && in_ros)
    return ros_home + path.substr(kRos.size());
  const char* home = std::getenv("HOME");
  if (home == nullptr || path.empty() || path[0] != '~') return path;
  if (path.size() == 1) return home;
  return path[1] == '/' ? std::filesystem::path(home) / path.substr(2)
                        : std::filesystem::path(path);
}

}  // namespace latticeworld
