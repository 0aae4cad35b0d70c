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

// Gathers violations under the names of the parameters.
class Checker {
 public:
  explicit Checker(std::vector<Violation>* violations) : violations_(*violations) {}

  void Refuse(const char* name, const std::string& given, const std::string& legal) {
    violations_.push_back(
        {"out_of_range", name, given + " is not legal; legal is " + legal, given});
  }
  void CheckIn(const char* name, double value, double low, double high) {
    if (value >= low && value <= high) return;
    Refuse(name, FormatDouble(value), FormatDouble(low) + " .. " + FormatDouble(high));
  }
  // Zero has a meaning of its own.
  void CheckZeroOrIn(const char* name, double value, double low, double high) {
    if (value == 0.0 || (value >= low && value <= high)) return;
    Refuse(name, FormatDouble(value), "0 or " + FormatDouble(low) + " .. " + FormatDouble(high));
  }
  void Add(std::vector<Violation> violations) {
    for (Violation& violation : violations) violations_.push_back(std::move(violation));
  }

 private:
  std::vector<Violation>& violations_;
};

void CheckTimeAndSensors(const WorldServerOptions& options, Checker* checker) {
  if (!CheckRealTimeFactor(options.real_time_factor).ok()) {
    checker->Refuse("real_time_factor", FormatDouble(options.real_time_factor),
                    "0 or 0.01 .. 1000");
  }
  if (options.sensor_catalogue->FindSuite(options.sensor_suite) == nullptr) {
    std::vector<std::string> names;
    for (const SensorSuite& suite : options.sensor_catalogue->suites()) names.push_back(suite.name);
    checker->Refuse("sensor_suite", Quote(options.sensor_suite), Join(names, ", "));
  }
  checker->CheckZeroOrIn("sensor_threads", options.sensor_threads, 1, 64);
  checker->CheckIn("sensor_seed", options.sensor_seed, 0, std::numeric_limits<int>::max());
  checker->CheckIn("longitude", options.longitude_deg, -180.0, 180.0);
  checker->CheckIn("altitude", options.altitude_m, -1000.0, 9000.0);
  checker->CheckIn("geoid_undulation", options.geoid_undulation_m, -120.0, 100.0);
}

void CheckPublishing(const WorldServerOptions& options, Checker* checker) {
  checker->CheckIn("clock_rate", options.clock_rate_hz, 1.0, 1000.0);
  checker->CheckIn("state_rate", options.state_rate_hz, 1.0, 1000.0);
  checker->CheckIn("marker_rate", options.marker_rate_hz, 0.1, 1000.0);
  checker->CheckZeroOrIn("state_hash_rate", options.state_hash_rate_hz, 0.001, 1000.0);
  checker->CheckIn("marker_terrain_cells", options.marker_terrain_cells, 16, 512);
  checker->CheckIn("marker_max_assets", options.marker_max_assets, 0, 500000);
  checker->CheckIn("most_message_bytes", static_cast<double>(options.most_message_bytes), 1e6,
                   static_cast<double>(kMostMessageBytes));
}

void CheckMaps(const WorldServerOptions& options, Checker* checker) {
  checker->CheckZeroOrIn("octomap_resolution", options.octomap_resolution_m, 0.05, 16.0);
  checker->CheckIn("octomap_thickness", options.octomap_thickness_m, 0.0, 100.0);
  const double radius_m = options.robot_radius_m;
  if (radius_m != WorldServerOptions::kRadiusOfSpecies && !(radius_m >= 0.0 && radius_m <= 10.0)) {
    checker->Refuse("robot_radius", FormatDouble(radius_m),
                    "-1 (that of robot_species) or 0 .. 10");
  }
  checker->CheckIn("robot_max_slope", options.robot.max_slope_rad, 0.01, 1.5);
  checker->CheckIn("robot_max_step", options.robot.max_step_m, 0.0, 10.0);
  checker->CheckIn("robot_max_fording_depth", options.robot.max_fording_depth_m, 0.0, 10.0);
  checker->CheckIn("robot_clearance", options.robot.clearance_m, 0.0, 100.0);
  checker->CheckIn("robot_mass", options.robot.mass_kg, 0.0, 1e6);
  checker->CheckIn("robot_grip", options.robot.grip, 0.05, 10.0);
}

void CheckLanguage(const WorldServerOptions& options, Checker* checker) {
  const bool remote = options.remote.is_wanted();
  const bool local = options.local.is_wanted();
  const bool model = options.reader_model.is_wanted();
  const std::string& reader = options.reader;
  if (!(reader.empty() || reader == "rules" || reader == "controlled" ||
        (model && (reader == "model" || reader == "checked")) || (remote && reader == "remote"))) {
    checker->Refuse("reader", Quote(reader),
                    std::string("rules, controlled, model, checked") +
                        (model ? "" : " (where reader_model is set)") + ", remote" +
                        (remote ? "" : " (where remote_url is set)"));
  }
  const std::string& generator = options.generator;
  if (!(generator.empty() || generator == "grounded" || (remote && generator == "remote") ||
        (local && generator == "local"))) {
    checker->Refuse("generator", Quote(generator),
                    std::string("grounded, remote") + (remote ? "" : " (where remote_url is set)") +
                        ", local" + (local ? "" : " (where local_layout_model is set)"));
  }
  checker->Add(Named("remote", Validate(options.remote)));
  checker->Add(Named("local", Validate(options.local)));
  checker->Add(Named("reader", Validate(options.reader_model)));
}

void CheckNames(const WorldServerOptions& options, Checker* checker) {
  for (const auto& [name, robots] :
       {std::pair("localised_elsewhere", &options.frames.localised_elsewhere),
        std::pair("odometry_elsewhere", &options.frames.odometry_elsewhere)}) {
    const bool nameless = std::find(robots->begin(), robots->end(), "") != robots->end();
    if (nameless) checker->Refuse(name, "\"\"", "names of robots");
  }
  if (options.worlds_directory.empty()) {
    checker->Refuse("worlds_directory", "\"\"", "a directory");
  }
  for (const std::string& directory : options.visual_directories) {
    if (directory.empty()) checker->Refuse("visual_directories", "\"\"", "directories");
  }
}

}  // namespace

std::vector<Violation> Validate(const WorldServerOptions& options) {
  std::vector<Violation> violations = Validate(options.simulator);
  Checker checker(&violations);
  CheckTimeAndSensors(options, &checker);
  CheckPublishing(options, &checker);
  CheckMaps(options, &checker);
  CheckLanguage(options, &checker);
  CheckNames(options, &checker);
  return violations;
}

}  // namespace latticeworld
