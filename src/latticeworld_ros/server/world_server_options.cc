#include "latticeworld_ros/server/world_server_options.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld_ros/running/simulation_loop.h"

namespace latticeworld {

namespace {

// The violations of a back end's options, under the names of the parameters.
std::vector<Violation> Named(const char* backend, std::vector<Violation> violations) {
  for (Violation& violation : violations) {
    std::string& name = violation.pointer;
    if (name.size() > 2 && name.compare(name.size() - 2, 2, "_s") == 0)
      name.resize(name.size() - 2);
    name = std::string(backend) + "_" + name;
  }
  return violations;
}

}  // namespace

std::vector<Violation> Validate(const WorldServerOptions& options) {
  std::vector<Violation> violations = Validate(options.simulator);
  const auto refuse = [&](const char* name, const std::string& given, const std::string& legal) {
    violations.push_back({"out_of_range", name, given + " is not legal; legal is " + legal, given});
  };
  const auto check_range = [&](const char* name, double value, double low, double high) {
    if (value >= low && value <= high) return;
    refuse(name, FormatDouble(value), FormatDouble(low) + " .. " + FormatDouble(high));
  };
  // Zero has a meaning of its own.
  const auto check_zero_or_range = [&](const char* name, double value, double low, double high) {
    if (value == 0.0 || (value >= low && value <= high)) return;
    refuse(name, FormatDouble(value), "0 or " + FormatDouble(low) + " .. " + FormatDouble(high));
  };

  if (!CheckRealTimeFactor(options.real_time_factor).ok()) {
    refuse("real_time_factor", FormatDouble(options.real_time_factor), "0 or 0.01 .. 1000");
  }
  if (options.sensor_catalogue->FindSuite(options.sensor_suite) == nullptr) {
    std::vector<std::string> names;
    for (const SensorSuite& suite : options.sensor_catalogue->suites()) names.push_back(suite.name);
    refuse("sensor_suite", Quote(options.sensor_suite), Join(names, ", "));
  }
  check_range("sensor_threads", options.sensor_threads, 1, 64);
  check_range("sensor_seed", options.sensor_seed, 0, std::numeric_limits<int>::max());
  check_range("longitude", options.longitude_deg, -180.0, 180.0);
  check_range("altitude", options.altitude_m, -1000.0, 9000.0);
  check_range("geoid_undulation", options.geoid_undulation_m, -120.0, 100.0);
  check_range("clock_rate", options.clock_rate_hz, 1.0, 1000.0);
  check_range("state_rate", options.state_rate_hz, 1.0, 1000.0);
  check_range("marker_rate", options.marker_rate_hz, 0.1, 1000.0);
  check_zero_or_range("state_hash_rate", options.state_hash_rate_hz, 0.001, 1000.0);
  check_range("marker_terrain_cells", options.marker_terrain_cells, 16, 512);
  check_range("marker_max_assets", options.marker_max_assets, 0, 500000);
  check_zero_or_range("octomap_resolution", options.octomap_resolution_m, 0.05, 16.0);
  check_range("octomap_thickness", options.octomap_thickness_m, 0.0, 100.0);
  const double radius_m = options.robot_radius_m;
  if (radius_m != WorldServerOptions::kRadiusOfSpecies && !(radius_m >= 0.0 && radius_m <= 10.0))
    refuse("robot_radius", FormatDouble(radius_m), "-1 (that of robot_species) or 0 .. 10");
  check_range("robot_max_slope", options.robot.max_slope_rad, 0.01, 1.5);
  check_range("robot_max_step", options.robot.max_step_m, 0.0, 10.0);
  check_range("robot_max_fording_depth", options.robot.max_fording_depth_m, 0.0, 10.0);
  check_range("robot_clearance", options.robot.clearance_m, 0.0, 100.0);
  check_range("robot_mass", options.robot.mass_kg, 0.0, 1e6);
  check_range("robot_grip", options.robot.grip, 0.05, 10.0);
  const bool remote = options.remote.is_wanted();
  const bool local = options.local.is_wanted();
  const bool model = options.reader_model.is_wanted();
  const std::string& reader = options.reader;
  if (!(reader.empty() || reader == "rules" || reader == "controlled" ||
        (model && (reader == "model" || reader == "checked")) || (remote && reader == "remote"))) {
    refuse("reader", Quote(reader),
           std::string("rules, controlled, model, checked") +
               (model ? "" : " (where reader_model is set)") + ", remote" +
               (remote ? "" : " (where remote_url is set)"));
  }
  const std::string& generator = options.generator;
  if (!(generator.empty() || generator == "grounded" || (remote && generator == "remote") ||
        (local && generator == "local"))) {
    refuse("generator", Quote(generator),
           std::string("grounded, remote") + (remote ? "" : " (where remote_url is set)") +
               ", local" + (local ? "" : " (where local_layout_model is set)"));
  }
  for (Violation& violation : Named("remote", Validate(options.remote)))
    violations.push_back(std::move(violation));
  for (Violation& violation : Named("local", Validate(options.local)))
    violations.push_back(std::move(violation));
  for (Violation& violation : Named("reader", Validate(options.reader_model)))
    violations.push_back(std::move(violation));
  for (const auto& [name, robots] :
       {std::pair("localised_elsewhere", &options.frames.localised_elsewhere),
        std::pair("odometry_elsewhere", &options.frames.odometry_elsewhere)}) {
    const bool nameless = std::find(robots->begin(), robots->end(), "") != robots->end();
    if (nameless) refuse(name, "\"\"", "names of robots");
  }
  if (options.worlds_directory.empty()) refuse("worlds_directory", "\"\"", "a directory");
  for (const std::string& directory : options.visual_directories) {
    if (directory.empty()) refuse("visual_directories", "\"\"", "directories");
  }
  return violations;
}

}  // namespace latticeworld
