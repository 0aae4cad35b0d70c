#include "tools/commands/catalogue_command.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/catalogue/catalogue.h"
#include "latticeworld/common/text.h"
#include "tools/arguments.h"

namespace latticeworld::tools {
namespace {

using Names = std::vector<std::string>;

Names NamesOfModels(const Catalogue& catalogue, AssetType type) {
  Names names;
  for (const AssetModel& model : catalogue.models()) {
    if (model.type == type) names.push_back(model.name);
  }
  return names;
}

Names Strings(const std::vector<std::string_view>& views) { return {views.begin(), views.end()}; }

std::string ContinuousOf(const AssetTypeValues& values) {
  Names names = {"density"};
  if (values.has_rotation) names.emplace_back("rotation");
  if (values.has_scale) names.emplace_back("scale");
  if (values.has_height) names.emplace_back("height");
  if (values.has_wind) names.emplace_back("wind");
  if (values.has_slope) names.emplace_back("slope");
  return Join(names, ", ");
}

void PrintRow(std::string_view name, std::size_t seasonal, std::size_t materials,
              std::size_t models, std::string_view continuous, std::ostream* out) {
  *out << std::left << std::setw(15) << name << std::right << std::setw(8) << seasonal
       << std::setw(10) << materials << std::setw(8) << models;
  if (!continuous.empty()) *out << "  " << continuous;
  *out << "\n";
}

void PrintTable(const Catalogue& catalogue, std::ostream* out) {
  *out << "asset type     seasonal  material  models  continuous\n";
  std::size_t seasonal = 0, materials = 0;
  for (const auto& type : EnumNames(AssetType{})) {
    const AssetTypeValues& values = catalogue.ValuesOf(type.value);
    PrintRow(type.name, values.season_variants.size(), values.materials.size(),
             NamesOfModels(catalogue, type.value).size(), ContinuousOf(values), out);
    seasonal += values.season_variants.size();
    materials += values.materials.size();
  }
  PrintRow("total", seasonal, materials, catalogue.models().size(), "", out);
}

void PrintNames(const char* what, const Names& names, std::ostream* out) {
  if (!names.empty()) *out << "  " << what << ": " << Join(names, ", ") << "\n";
}

void PrintValues(const Catalogue& catalogue, std::ostream* out) {
  for (const auto& type : EnumNames(AssetType{})) {
    const AssetTypeValues& values = catalogue.ValuesOf(type.value);
    *out << "\n" << type.name << "\n";
    PrintNames("seasonal", Strings(values.season_variants), out);
    PrintNames("material", Strings(values.materials), out);
    PrintNames("models", NamesOfModels(catalogue, type.value), out);
  }
}

// What comes after the names that `base` has; additions always do.
Names Added(const Names& names, const Names& base) {
  return {names.begin() + static_cast<std::ptrdiff_t>(base.size()), names.end()};
}

void PrintAdded(const Catalogue& catalogue, std::ostream* out) {
  const Catalogue& base = *Catalogue::BuiltIn();
  for (const auto& type : EnumNames(AssetType{})) {
    const AssetTypeValues& values = catalogue.ValuesOf(type.value);
    const AssetTypeValues& before = base.ValuesOf(type.value);
    const Names seasonal = Added(Strings(values.season_variants), Strings(before.season_variants));
    const Names materials = Added(Strings(values.materials), Strings(before.materials));
    const Names models =
        Added(NamesOfModels(catalogue, type.value), NamesOfModels(base, type.value));
    if (seasonal.empty() && materials.empty() && models.empty()) continue;
    *out << "\nadded to " << type.name << "\n";
    PrintNames("seasonal", seasonal, out);
    PrintNames("material", materials, out);
    PrintNames("models", models, out);
  }
}

// Names of a list of a file that the built-in type has already.
Names Replaced(const nlohmann::json& file, const char* list, const Names& base) {
  Names names;
  if (!file.contains(list)) return names;
  for (const nlohmann::json& entry : file.at(list)) {
    const std::string name = entry.at("name").get<std::string>();
    if (std::find(base.begin(), base.end(), name) != base.end()) names.push_back(name);
  }
  return names;
}

// "tree wild/F 3" for each density that a file gives.
Names Densities(const nlohmann::json& file) {
  Names densities;
  if (!file.contains("density")) return densities;
  for (const nlohmann::json& entry : file.at("density")) {
    const std::string kind = entry.at("kind").get<std::string>();
    for (const char* vocabulary : {"suburb", "wild"}) {
      if (!entry.contains(vocabulary)) continue;
      for (const auto& [letter, per_hectare] : entry.at(vocabulary).items()) {
        densities.push_back(kind + " " + vocabulary + "/" + letter + " " +
                            FormatDouble(per_hectare.get<double>()));
      }
    }
  }
  return densities;
}

void PrintDensities(const Catalogue& catalogue, std::ostream* out) {
  for (const CatalogueFile& added : catalogue.added_files()) {
    const auto file = nlohmann::json::parse(added.text);  // legal, or it would not be there
    const Names densities = Densities(file);
    if (densities.empty()) continue;
    *out << "\ndensities in " << file.at("type").get<std::string>() << ": " << Join(densities, ", ")
         << "\n";
  }
}

void PrintReplaced(const Catalogue& catalogue, std::ostream* out) {
  const Catalogue& base = *Catalogue::BuiltIn();
  for (const CatalogueFile& added : catalogue.added_files()) {
    const auto file = nlohmann::json::parse(added.text);  // legal, or it would not be there
    const AssetType type = *FromName<AssetType>(file.at("type").get<std::string>());
    const AssetTypeValues& values = base.ValuesOf(type);
    const Names seasonal = Replaced(file, "season_variants", Strings(values.season_variants));
    const Names materials = Replaced(file, "materials", Strings(values.materials));
    const Names models = Replaced(file, "models", NamesOfModels(base, type));
    if (seasonal.empty() && materials.empty() && models.empty()) continue;
    *out << "\nreplaced in " << NameOf(type) << " by " << added.name << "\n";
    PrintNames("seasonal", seasonal, out);
    PrintNames("material", materials, out);
    PrintNames("models", models, out);
  }
}

Status PrintSchema() {
  std::cout << CatalogueSchema();
  return Status();
}

Status PrintCatalogue(const std::vector<std::string>& files) {
  LW_ASSIGN_OR_RETURN(const auto catalogue, Catalogue::Load({files.begin(), files.end()}));
  PrintTable(*catalogue, &std::cout);
  if (files.empty()) {
    PrintValues(*catalogue, &std::cout);
  } else {
    PrintAdded(*catalogue, &std::cout);
    PrintReplaced(*catalogue, &std::cout);
    PrintDensities(*catalogue, &std::cout);
  }
  return Status();
}

}  // namespace

void AddCatalogueCommand(CLI::App* app, int* exit_status) {
  CLI::App* command = app->add_subcommand(
      "catalogue",
      "Lists what worlds can be furnished with, or checks files that add to it and says what.");
  const auto files = std::make_shared<std::vector<std::string>>();
  command->add_option("FILE", *files, "A catalogue file, or a directory of them (*.json).")
      ->type_name("");
  command->add_flag("--schema", "Prints the JSON Schema of catalogue files.");
  command->callback([command, files, exit_status] {
    const bool wants_schema = !command->get_option("--schema")->empty();
    const Status status = wants_schema ? PrintSchema() : PrintCatalogue(*files);
    if (status.ok()) return;
    ReportFailure("catalogue", status);
    *exit_status = kExitFailure;  // the arguments were usable; what they lead to is wrong
  });
}

}  // namespace latticeworld::tools
