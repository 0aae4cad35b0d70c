#include "tools/commands/sensors_command.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "latticeworld/common/text.h"
#include "latticeworld/sensing/sensor_suite.h"
#include "tools/arguments.h"

namespace latticeworld::tools {
namespace {

double Degrees(double angle_rad) { return std::round(angle_rad * 1800.0 / M_PI) / 10.0; }

std::string SizeOf(const LidarModel& lidar) {
  return std::to_string(lidar.ring_elevations_rad.size()) + " x " + std::to_string(lidar.columns);
}

std::string PicturesOf(const CameraOutputs& outputs) {
  std::vector<std::string> names;
  if (outputs.colour) names.push_back("color");
  if (outputs.depth) names.push_back("depth");
  if (outputs.class_labels) names.push_back("classes");
  if (outputs.instance_labels) names.push_back("instances");
  return Join(names, ", ");
}

// What a sensor is, in a few words.
std::string KindOf(const SensorSpec& sensor) {
  if (const auto* lidar = std::get_if<LidarModel>(&sensor.model)) {
    return "lidar " + lidar->name + ", " + SizeOf(*lidar);
  }
  if (const auto* camera = std::get_if<CameraSensor>(&sensor.model)) {
    return "camera " + std::to_string(camera->model.width) + " x " +
           std::to_string(camera->model.height) + ": " + PicturesOf(camera->outputs);
  }
  if (std::holds_alternative<ImuModel>(sensor.model)) return "imu";
  if (std::holds_alternative<GnssModel>(sensor.model)) return "gnss";
  if (std::holds_alternative<MagnetometerModel>(sensor.model)) return "magnetometer";
  if (std::holds_alternative<WheelOdometryModel>(sensor.model)) return "wheel odometry";
  return "bumper";
}

void PrintSuites(const SensorCatalogue& catalogue, std::ostream* out) {
  *out << "suite       sensor           Hz  kind\n";
  for (const SensorSuite& suite : catalogue.suites()) {
    std::string name = suite.name;
    if (suite.sensors.empty()) *out << name << "\n";
    for (const SensorSpec& sensor : suite.sensors) {
      *out << std::left << std::setw(12) << name << std::setw(15) << sensor.name << std::right
           << std::setw(4) << FormatDouble(sensor.rate_hz) << "  " << KindOf(sensor) << "\n";
      name.clear();
    }
  }
}

void PrintLidars(const SensorCatalogue& catalogue, std::ostream* out) {
  *out << "\nlidar                 rings x columns  degrees  range [m]\n";
  for (const LidarModel& lidar : catalogue.lidars()) {
    *out << std::left << std::setw(22) << lidar.name << std::right << std::setw(15) << SizeOf(lidar)
         << std::setw(9) << FormatDouble(Degrees(lidar.field_of_view_rad)) << "  "
         << FormatDouble(lidar.min_range_m) << " .. " << FormatDouble(lidar.max_range_m) << "\n";
  }
}

// Which suites and lidars the built-in catalogue does not have.
void PrintAdded(const SensorCatalogue& catalogue, std::ostream* out) {
  const auto built_in = SensorCatalogue::BuiltIn();
  std::vector<std::string> added;
  for (const SensorSuite& suite : catalogue.suites()) {
    if (built_in->FindSuite(suite.name) == nullptr) added.push_back(suite.name);
  }
  for (const LidarModel& lidar : catalogue.lidars()) {
    if (built_in->FindLidar(lidar.name) == nullptr) added.push_back(lidar.name);
  }
  if (!added.empty()) *out << "\nadded: " << Join(added, ", ") << "\n";
}

Status PrintSensors(const std::vector<std::string>& files) {
  LW_ASSIGN_OR_RETURN(
      const auto catalogue,
      SensorCatalogue::Load(std::vector<std::filesystem::path>(files.begin(), files.end())));
  PrintSuites(*catalogue, &std::cout);
  PrintLidars(*catalogue, &std::cout);
  if (!files.empty()) PrintAdded(*catalogue, &std::cout);
  return Status();
}

Status PrintSchema() {
  std::cout << SensorCatalogue::schema();
  return Status();
}

}  // namespace

void AddSensorsCommand(CLI::App* app, int* exit_status) {
  CLI::App* command = app->add_subcommand(
      "sensors",
      "Lists the suites of sensors that robots can carry, or checks files that add to them.");
  const auto files = std::make_shared<std::vector<std::string>>();
  command
      ->add_option("FILE", *files, "A file of suites and lidars, or a directory of them (*.json).")
      ->type_name("");
  command->add_flag("--schema", "Prints the JSON Schema of such files.");
  command->callback([command, files, exit_status] {
    const bool wants_schema = !command->get_option("--schema")->empty();
    const Status status = wants_schema ? PrintSchema() : PrintSensors(*files);
    if (status.ok()) return;
    ReportFailure("sensors", status);
    *exit_status = kExitFailure;  // the arguments were usable; what they lead to is wrong
  });
}

}  // namespace latticeworld::tools
