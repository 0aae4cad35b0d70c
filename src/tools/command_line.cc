#include "tools/command_line.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <exception>
#include <iostream>
#include <string>

#include "tools/arguments.h"
#include "tools/commands/campaign_command.h"
#include "tools/commands/catalogue_command.h"
#include "tools/commands/dataset_command.h"
#include "tools/commands/export_command.h"
#include "tools/commands/generate_command.h"
#include "tools/commands/measure_command.h"
#include "tools/commands/picture_command.h"
#include "tools/commands/query_command.h"
#include "tools/commands/rebuild_command.h"
#include "tools/commands/score_command.h"
#include "tools/commands/sensors_command.h"
#include "tools/commands/show_command.h"
#include "tools/commands/sketch_pairs_command.h"
#include "tools/commands/species_command.h"
#include "tools/commands/tasks_command.h"
#include "tools/commands/view_command.h"

namespace latticeworld::tools {
namespace {

constexpr char kFooter[] =
    "\nlatticeworld COMMAND --help tells a command's options.\n"
    "Exit status: 0 success, 1 failure, 2 unusable arguments, texts or pictures.\n\n"
    "  latticeworld generate --layout 'A lake in the center and a forest in the upper left.' "
    "--environment 'A rainy autumn morning, five sheep graze.' --out lake\n"
    "  latticeworld picture lake --out lake.png";

// "--layout, --environment, ...": what the command that was called accepts.
std::string LegalOptions(const CLI::App& command) {
  std::string names;
  for (const CLI::Option* option : command.get_options()) {
    names += (names.empty() ? "" : ", ") + option->get_name();
  }
  return names;
}

// "generate, show, ...": every command that there is.
std::string Commands(const CLI::App& app) {
  std::string names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    names += (names.empty() ? "" : ", ") + command->get_name();
  }
  return names;
}

int ReportUsage(const CLI::App& app, const CLI::ParseError& error) {
  const auto commands = app.get_subcommands();
  const std::string called = commands.empty() ? "" : " " + commands.front()->get_name();
  std::cerr << "latticeworld" << called << ": " << error.what() << "\n";
  if (commands.empty()) {
    std::cerr << "legal are the commands " << Commands(app) << ", --help and --version\n";
  } else {
    std::cerr << "legal are " << LegalOptions(*commands.front()) << "; each at most once\n";
  }
  return kExitUsage;
}

int Run(int argc, const char* const* argv) {
  CLI::App app("Turns text into living physical worlds for robots.", "latticeworld");
  app.set_version_flag("--version", "latticeworld " LATTICEWORLD_VERSION);
  app.set_help_flag("--help", "Tells what there is and ends.");
  int exit_status = kExitSuccess;
  AddGenerateCommand(&app, &exit_status);
  AddShowCommand(&app, &exit_status);
  AddQueryCommand(&app, &exit_status);
  AddPictureCommand(&app, &exit_status);
  AddExportCommand(&app, &exit_status);
  AddMeasureCommand(&app, &exit_status);
  AddScoreCommand(&app, &exit_status);
  AddRebuildCommand(&app, &exit_status);
  AddCatalogueCommand(&app, &exit_status);
  AddSpeciesCommand(&app, &exit_status);
  AddTasksCommand(&app, &exit_status);
  AddCampaignCommand(&app, &exit_status);
  AddDatasetCommand(&app, &exit_status);
  AddSketchPairsCommand(&app, &exit_status);
  AddSensorsCommand(&app, &exit_status);
  AddViewCommand(&app, &exit_status);
  app.footer(kFooter);  // after the commands, which would inherit it
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {  // --help, --version
    return app.exit(success, std::cout, std::cerr);
  } catch (const CLI::ParseError& error) {
    return ReportUsage(app, error);
  }
  if (app.get_subcommands().empty()) return ReportUsage(app, CLI::RequiredError("a command"));
  std::cout.flush();
  if (!std::cout) {
    std::cerr << "latticeworld: cannot write to standard output\n";
    return kExitFailure;
  }
  return exit_status;
}

}  // namespace

int RunCommandLine(int argc, const char* const* argv) {
  try {
    return Run(argc, argv);
  } catch (const std::exception& error) {  // what the standard library throws: no memory
    std::cerr << "latticeworld: " << error.what() << "\n";
    return kExitFailure;
  }
}

}  // namespace latticeworld::tools
