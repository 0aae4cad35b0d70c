#include "tools/commands/show_command.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <iostream>
#include <string>

#include "latticeworld/generation/bundle/bundle.h"
#include "tools/arguments.h"
#include "tools/world_summary.h"

namespace latticeworld::tools {
namespace {

Status Show(const CLI::App& command) {
  LW_ASSIGN_OR_RETURN(const auto world, LoadBundle(*ValueOf(command, "DIR")));
  PrintSummary(*world, StandardOutputIsTerminal(), &std::cout);
  return Status();
}

}  // namespace

void AddShowCommand(CLI::App* app, int* exit_status) {
  CLI::App* command = app->add_subcommand("show", "Checks a bundle and says what is in it.");
  AddValueOption(command, "DIR", "DIR", "The bundle.");
  command->get_option("DIR")->required();
  command->callback([command, exit_status] {
    const Status status = Show(*command);
    if (!status.ok()) *exit_status = ReportFailure("show", status);
  });
}

}  // namespace latticeworld::tools
