#include "latticeworld_ros/parameters.h"

#include <cstdlib>
#include <functional>
#include <map>
#include <memory>
#include <utility>

#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

using XmlRpc::XmlRpcValue;

// Each reads one value; false: of another type. XmlRpcValue's own conversions are not const.
bool Read(XmlRpcValue value, double* out) {
  if (value.getType() == XmlRpcValue::TypeInt) return *out = static_cast<int>(value), true;
  if (value.getType() == XmlRpcValue::TypeDouble) return *out = static_cast<double>(value), true;
  return false;
}
bool Read(XmlRpcValue value, int* out) {
  if (value.getType() != XmlRpcValue::TypeInt) return false;
  *out = static_cast<int>(value);
  return true;
}
bool Read(XmlRpcValue value, bool* out) {
  if (value.getType() != XmlRpcValue::TypeBoolean) return false;
  *out = static_cast<bool>(value);
  return true;
}
bool Read(XmlRpcValue value, std::string* out) {
  if (value.getType() != XmlRpcValue::TypeString) return false;
  *out = static_cast<std::string>(value);
  return true;
}
bool Read(XmlRpcValue value, std::vector<std::string>* out) {
  if (value.getType() != XmlRpcValue::TypeArray) return false;
  out->assign(static_cast<std::size_t>(value.size()), std::string());
  for (int i = 0; i < value.size(); ++i) {
    if (!Read(value[i], &(*out)[static_cast<std::size_t>(i)])) return false;
  }
  return true;
}

bool Read(XmlRpcValue value, std::size_t* out) {
  int number = 0;
  if (!Read(std::move(value), &number) || number < 0) return false;
  *out = static_cast<std::size_t>(number);
  return true;
}
bool Read(XmlRpcValue value, ChatDialect* out) {
  std::string name;
  if (!Read(std::move(value), &name)) return false;
  const auto dialect = FromName<ChatDialect>(name);
  if (dialect) *out = *dialect;
  return dialect.has_value();
}

const char* TypeName(const double&) { return "a number"; }
const char* TypeName(const int&) { return "a whole number"; }
const char* TypeName(const bool&) { return "true or false"; }
const char* TypeName(const std::string&) { return "a text"; }
const char* TypeName(const std::vector<std::string>&) { return "a list of texts"; }
const char* TypeName(const std::size_t&) { return "a whole number of at least 0"; }
std::string TypeName(const ChatDialect&) { return "one of " + LegalNames<ChatDialect>(); }

struct Parameter {
  std::function<bool(const XmlRpcValue&)> read;
  std::string type;
};

template <typename T>
Parameter Bind(T* field) {
  return {[field](const XmlRpcValue& value) { return Read(value, field); }, TypeName(*field)};
}

std::map<std::string, Parameter> BindAll(WorldServerOptions* options) {
  return {
      {"real_time_factor", Bind(&options->real_time_factor)},
      {"start_paused", Bind(&options->start_paused)},
      {"step", Bind(&options->simulator.step_s)},
      {"command_timeout", Bind(&options->simulator.command_timeout_s)},
      {"pursuit_distance", Bind(&options->simulator.pursuit_distance_m)},
      {"day_length", Bind(&options->simulator.day_length_s)},
      {"species", Bind(&options->species)},
      {"robot_species", Bind(&options->simulator.robot_species)},
      {"sensors", Bind(&options->sensors)},
      {"sensor_suite", Bind(&options->sensor_suite)},
      {"sensor_threads", Bind(&options->sensor_threads)},
      {"sensor_seed", Bind(&options->sensor_seed)},
      {"longitude", Bind(&options->longitude_deg)},
      {"altitude", Bind(&options->altitude_m)},
      {"clock_rate", Bind(&options->clock_rate_hz)},
      {"state_rate", Bind(&options->state_rate_hz)},
      {"marker_rate", Bind(&options->marker_rate_hz)},
      {"state_hash_rate", Bind(&options->state_hash_rate_hz)},
      {"marker_terrain_cells", Bind(&options->marker_terrain_cells)},
      {"marker_max_assets", Bind(&options->marker_max_assets)},
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
      {"worlds_directory", Bind(&options->worlds_directory)},
      {"visual_directories", Bind(&options->visual_directories)},
      {"catalogue", Bind(&options->catalogue)},
      {"sketch_model", Bind(&options->sketch_model)},
      {"octomap_resolution", Bind(&options->octomap_resolution_m)},
      {"octomap_thickness", Bind(&options->octomap_thickness_m)},
      {"robot_radius", Bind(&options->robot.radius_m)},
      {"robot_max_slope", Bind(&options->robot.max_slope_rad)},
      {"robot_max_step", Bind(&options->robot.max_step_m)},
      {"robot_max_fording_depth", Bind(&options->robot.max_fording_depth_m)},
      {"robot_clearance", Bind(&options->robot.clearance_m)},
  };
}

}  // namespace

Result<WorldServerOptions> OptionsFromParameters(const XmlRpcValue& parameters) {
  WorldServerOptions options;
  const std::map<std::string, Parameter> known = BindAll(&options);
  std::vector<Violation> violations;

  XmlRpcValue given = parameters;
  if (given.getType() == XmlRpcValue::TypeStruct) {
    for (const auto& [name, value] : given) {
      const auto parameter = known.find(name);
      if (parameter == known.end()) {
        std::vector<std::string> names;
        for (const auto& entry : known) names.push_back(entry.first);
        violations.push_back({"unknown_key", name,
                              "there is no such parameter; there are " + Join(names, ", "), name});
      } else if (!parameter->second.read(value)) {
        violations.push_back(
            {"wrong_type", name, "must be " + parameter->second.type, value.toXml()});
      }
    }
  } else if (given.valid()) {
    violations.push_back({"wrong_type", "", "the parameters are no dictionary", given.toXml()});
  }

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
  return options;
}

std::filesystem::path ExpandHome(const std::string& path) {
  const char* home = std::getenv("HOME");
  if (home == nullptr || path.empty() || path[0] != '~') return path;
  if (path.size() == 1) return home;
  return path[1] == '/' ? std::filesystem::path(home) / path.substr(2)
                        : std::filesystem::path(path);
}

}  // namespace latticeworld
