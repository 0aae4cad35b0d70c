#include "tools/commands/query_command.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "latticeworld/generation/bundle/bundle.h"
#include "latticeworld/simulation/found_things.h"
#include "tools/arguments.h"

namespace latticeworld::tools {
namespace {

double HeadingOf_deg(const FoundThing& thing) {
  const Eigen::Vector3d front = thing.orientation * Eigen::Vector3d::UnitX();
  return std::atan2(front.y(), front.x()) * 180.0 / M_PI;
}

nlohmann::ordered_json Encode(const FoundThing& thing) {
  return {{"name", thing.name},
          {"kind", thing.kind},
          {"model", thing.model},
          {"x_m", thing.position_m.x()},
          {"y_m", thing.position_m.y()},
          {"z_m", thing.position_m.z()},
          {"yaw_deg", HeadingOf_deg(thing)},
          {"length_m", thing.size_m.x()},
          {"width_m", thing.size_m.y()},
          {"height_m", thing.size_m.z()}};
}

std::string Padded(std::string text, std::size_t width) {
  text.resize(std::max(text.size(), width), ' ');
  return text + "  ";
}

void PrintTable(const std::vector<FoundThing>& things) {
  std::size_t name = 4, kind = 4;
  for (const FoundThing& thing : things) {
    name = std::max(name, thing.name.size());
    kind = std::max(kind, thing.kind.size());
  }
  std::cout << Padded("name", name) << Padded("kind", kind)
            << "    x [m]     y [m]    z [m]  yaw [deg]  length x width x height [m]\n";
  for (const FoundThing& thing : things) {
    char numbers[160];
    std::snprintf(numbers, sizeof(numbers), "%9.2f %9.2f %8.2f %10.1f  %.2f x %.2f x %.2f\n",
                  thing.position_m.x(), thing.position_m.y(), thing.position_m.z(),
                  HeadingOf_deg(thing), thing.size_m.x(), thing.size_m.y(), thing.size_m.z());
    std::cout << Padded(thing.name, name) << Padded(thing.kind, kind) << numbers;
  }
}

Status Query(const CLI::App& command) {
  LW_ASSIGN_OR_RETURN(const auto world, LoadBundle(*ValueOf(command, "DIR")));
  LW_ASSIGN_OR_RETURN(const std::vector<FoundThing> things,
                      FindThings(*world->scene, nullptr, command.get_option("NAME")->results()));
  if (command.count("--json") == 0) {
    PrintTable(things);
    return Status();
  }
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const FoundThing& thing : things) all.push_back(Encode(thing));
  std::cout << all.dump(2) << "\n";
  return Status();
}

}  // namespace

void AddQueryCommand(CLI::App* app, int* exit_status) {
  CLI::App* command = app->add_subcommand(
      "query", "Tells where the things of a bundle's world stand that have names.");
  AddValueOption(command, "DIR", "DIR", "The bundle.");
  command->get_option("DIR")->required();
  command
      ->add_option_function<std::vector<std::string>>(
          "NAME", [](const std::vector<std::string>&) {},
          "Names of single things and elements, such as well_1 [all].")
      ->type_name("NAME");
  command->add_flag("--json", "Answers as JSON, for programs.");
  command->callback([command, exit_status] {
    const Status status = Query(*command);
    if (!status.ok()) *exit_status = ReportFailure("query", status);
  });
}

}  // namespace latticeworld::tools
