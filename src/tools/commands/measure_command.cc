#include "tools/commands/measure_command.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/common/range.h"
#include "latticeworld/geomorphology/realism.h"
#include "latticeworld/relief/relief.h"
#include "tools/arguments.h"
#include "tools/land_reading.h"
#include "tools/realism_json.h"
#include "tools/realism_tables.h"

namespace latticeworld::tools {
namespace {

constexpr double kMinLandSize_m = 1.0;
constexpr double kMaxLandSize_m = 1e7;

Result<LandOptions> ReadOptions(const CLI::App& command) {
  ArgumentReader arguments(&command);
  LandOptions options;
  HeightMapOptions height_map;
  const bool has_size = ValueOf(command, "--size").has_value();
  options.size_m = arguments.Number("--size", kMinLandSize_m);
  arguments.RequireBeside("--height-scale", "--size");
  options.height_scale_m = height_map.height_scale_m =
      arguments.Number("--height-scale", height_map.height_scale_m);
  options.elevation_unit =
      *FromName<ElevationUnit>(arguments.Choice("--elevation-unit", {"degrees", "metres"}, ""));
  std::vector<Violation> violations = Validate(height_map);
  CheckRange("--size", options.size_m, {kMinLandSize_m, kMaxLandSize_m}, " m", &violations);
  // Asked before any file is read, of which there may be many.
  arguments.AddIllegal({{"height_scale", "--height-scale"}}, std::move(violations));
  LW_RETURN_IF_ERROR(arguments.status());
  if (!has_size) options.size_m = 0.0;
  return options;
}

Status Measure(const CLI::App& command) {
  LW_ASSIGN_OR_RETURN(const LandOptions options, ReadOptions(command));
  ArgumentReader arguments(&command);
  const auto kind = *FromName<LandKind>(
      arguments.Choice("--kind", {"any", "plain", "hills", "mountains"}, "any"));
  LW_RETURN_IF_ERROR(arguments.status());
  const bool json = command.count("--json") > 0;
  std::vector<MeasuredLand> lands;
  for (const std::string& path : command.get_option("PATH")->results()) {
    LW_ASSIGN_OR_RETURN(const Land land, ReadLand(path, options));
    for (const std::string& warning : land.warnings) {
      std::cerr << "warning: " << path << ": " << warning << "\n";
    }
    MeasuredLand measured;
    measured.path = path;
    measured.rows = land.height_m.rows();
    measured.cols = land.height_m.cols();
    measured.kind = kind;
    measured.resolution_m = land.resolution_m;
    measured.measures = MeasureRealism(land.height_m, land.resolution_m, &land.water);
    lands.push_back(std::move(measured));
  }
  if (json) {
    std::cout << LandsToJson(lands) << "\n";
  } else if (lands.size() == 1) {
    PrintLand(lands.front(), &std::cout);
  } else {
    PrintLands(lands, &std::cout);
  }
  return Status();
}

}  // namespace

void AddMeasureCommand(CLI::App* app, int* exit_status) {
  CLI::App* command = app->add_subcommand(
      "measure",
      "Measures how much land is like nature's: slopes, hypsometry, channels, spectra. Where there "
      "is water, rivers end in it and only the dry land is measured.");
  command
      ->add_option_function<std::vector<std::string>>(
          "PATH", [](const std::vector<std::string>&) {},
          "Bundles, elevation (GeoTIFF, SRTM .hgt, Arc/Info ASCII) or height maps (PNG, PGM; TIFF "
          "when --size is given), each of at least 64 x 64 cells.")
      ->type_name("FILE_OR_DIR")
      ->required();
  AddValueOption(command, "--size", "METRES", "Width of the height maps, west to east.");
  AddValueOption(command, "--height-scale", "METRES",
                 "Height from a black to a white pixel of the height maps, 0 to 9000 [100].");
  AddValueOption(command, "--elevation-unit", "NAME",
                 "degrees or metres: of ASCII grids, which name no coordinate system [judged by "
                 "their numbers].");
  AddValueOption(command, "--kind", "NAME",
                 "any, plain, hills or mountains: how steep nature's are that it is held against "
                 "[any].");
  command->add_flag("--json", "Answers as JSON, for programs.");
  command->callback([command, exit_status] {
    const Status status = Measure(*command);
    if (!status.ok()) *exit_status = ReportFailure("measure", status);
  });
}

}  // namespace latticeworld::tools
