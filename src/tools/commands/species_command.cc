#include "tools/commands/species_command.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <iomanip>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "latticeworld/common/text.h"
#include "latticeworld/species/species_catalogue.h"
#include "tools/arguments.h"

namespace latticeworld::tools {
namespace {

void PrintTable(const SpeciesCatalogue& catalogue, std::ostream* out) {
  *out << "species             category         plan           kg   m/s  hit points\n";
  for (const Species& species : catalogue.all()) {
    std::string plan(NameOf(species.plan));
    if (species.vehicle) plan = NameOf(species.vehicle->drive);
    *out << std::left << std::setw(20) << species.name << std::setw(17) << NameOf(species.category)
         << std::setw(12) << plan << std::right << std::setw(5) << FormatDouble(species.mass_kg)
         << std::setw(6) << FormatDouble(species.top_speed_mps) << std::setw(12)
         << FormatDouble(species.hit_points) << "\n";
  }
}

// Which species the built-in catalogue does not have.
void PrintAdded(const SpeciesCatalogue& catalogue, std::ostream* out) {
  std::vector<std::string> added;
  for (const Species& species : catalogue.all()) {
    if (SpeciesCatalogue::BuiltIn()->Find(species.name) == nullptr) added.push_back(species.name);
  }
  if (!added.empty()) *out << "\nadded: " << Join(added, ", ") << "\n";
}

Status PrintSpecies(const std::vector<std::string>& files) {
  LW_ASSIGN_OR_RETURN(
      const auto catalogue,
      SpeciesCatalogue::Load(std::vector<std::filesystem::path>(files.begin(), files.end())));
  PrintTable(*catalogue, &std::cout);
  if (!files.empty()) PrintAdded(*catalogue, &std::cout);
  return Status();
}

Status PrintSchema() {
  std::cout << SpeciesCatalogue::schema();
  return Status();
}

}  // namespace

void AddSpeciesCommand(CLI::App* app, int* exit_status) {
  CLI::App* command = app->add_subcommand(
      "species", "Lists the kinds of agents that there are, or checks files that add to them.");
  const auto files = std::make_shared<std::vector<std::string>>();
  command->add_option("FILE", *files, "A species file, or a directory of them (*.json).")
      ->type_name("");
  command->add_flag("--schema", "Prints the JSON Schema of species files.");
  command->callback([command, files, exit_status] {
    const bool wants_schema = !command->get_option("--schema")->empty();
    const Status status = wants_schema ? PrintSchema() : PrintSpecies(*files);
    if (status.ok()) return;
    ReportFailure("species", status);
    *exit_status = kExitFailure;  // the arguments were usable; what they lead to is wrong
  });
}

}  // namespace latticeworld::tools
