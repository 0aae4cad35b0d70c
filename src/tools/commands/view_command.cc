#include "tools/commands/view_command.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

#include "latticeworld/generation/bundle/bundle.h"
#include "latticeworld/species/species_catalogue.h"
#include "latticeworld/viewer/payloads/still_view.h"
#include "latticeworld/viewer/server/page_files.h"
#include "latticeworld/viewer/server/viewer_server.h"
#include "latticeworld/viewer/viewer_feed.h"
#include "tools/arguments.h"
#include "tools/interrupt.h"
#include "tools/progress_display.h"

namespace latticeworld::tools {
namespace {

constexpr int kUsualPort = 8080;
constexpr std::chrono::milliseconds kPollPeriod(100);

// The page of --page, or the program's own; where that is missing, what says so.
Result<PayloadMap> PageFor(const CLI::App& command) {
  if (const auto given = ValueOf(command, "--page")) {
    Result<PayloadMap> page = ReadPage(*given);
    return page.ok() ? std::move(page) : page.status().WithContext("--page");
  }
  const Result<std::filesystem::path> found = FindPage();
  if (found.ok()) return ReadPage(*found);
  std::cerr << "latticeworld view: " << found.status().message() << "\n";
  return PageMissing(found.status().message());
}

std::string AddressOf(const std::string& host, int port) {
  const std::string name = host.find(':') == std::string::npos ? host : "[" + host + "]";
  return "http://" + name + ":" + std::to_string(port) + "/";
}

Status View(const CLI::App& command) {
  ArgumentReader arguments(&command);
  ViewerServerOptions options;
  options.moves = false;
  options.port = arguments.Whole("--port", kUsualPort);
  options.host = ValueOf(command, "--host").value_or(options.host);
  // Asked before the world is loaded, which takes longer.
  arguments.AddIllegal({{"port", "--port"}, {"host", "--host"}}, Validate(options));
  LW_RETURN_IF_ERROR(arguments.status());
  LW_ASSIGN_OR_RETURN(PayloadMap page, PageFor(command));
  LW_ASSIGN_OR_RETURN(const auto world, LoadBundle(*ValueOf(command, "DIR")));

  ProgressDisplay display;
  Progress progress(
      [&display](std::string_view stage, double fraction) { display.Show(stage, fraction); });
  const CancelOnInterrupt interrupt(&progress);
  const auto species = SpeciesCatalogue::BuiltIn();
  LW_ASSIGN_OR_RETURN(auto payloads,
                      MakeWorldPayloads(*world, *species, /*moves=*/false, progress));
  display.Clear();
  StillBackend backend;
  LW_ASSIGN_OR_RETURN(const auto server, ViewerServer::Start(options, std::move(page), &backend));
  server->SetWorld(std::move(payloads), "");
  ViewerFeed feed(server.get());
  ShowStart(*world, *species, &feed);
  std::cout << world->id << " is at " << AddressOf(options.host, server->port()) << " (Ctrl-C ends)"
            << std::endl;
  while (!progress.cancelled()) std::this_thread::sleep_for(kPollPeriod);
  return Status();
}

}  // namespace

void AddViewCommand(CLI::App* app, int* exit_status) {
  CLI::App* command =
      app->add_subcommand("view", "Shows a bundle's world, as it begins, in a browser.");
  AddValueOption(command, "DIR", "DIR", "The bundle.");
  command->get_option("DIR")->required();
  AddValueOption(command, "--port", "N", "To listen at, 0 to 65535; 0: any that is free [8080].");
  AddValueOption(command, "--host", "ADDRESS",
                 "Numeric address to listen at; 0.0.0.0: every one [127.0.0.1].");
  AddValueOption(command, "--page", "DIR", "The page in place of the program's own.");
  command->callback([command, exit_status] {
    const Status status = View(*command);
    if (!status.ok()) *exit_status = ReportFailure("view", status);
  });
}

}  // namespace latticeworld::tools
