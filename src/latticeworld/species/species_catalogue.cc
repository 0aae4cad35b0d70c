#include "latticeworld/species/species_catalogue.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>

#include "latticeworld/common/check.h"
#include "latticeworld/common/data_files.h"
#include "latticeworld/common/files.h"
#include "latticeworld/common/schema_check.h"
#include "latticeworld/common/strict_json.h"
#include "latticeworld/common/text.h"
#include "latticeworld/species/species_file.h"

namespace latticeworld {

std::string_view SpeciesData(std::string_view file_name);  // embedded

namespace {

namespace fs = std::filesystem;

constexpr const char* kBuiltInFiles[] = {"animals.json", "characters.json", "robots.json",
                                         "vehicles.json"};
constexpr std::size_t kMaxFileBytes = 1 << 20;
constexpr std::size_t kMaxFiles = 256;
constexpr std::size_t kMaxSpecies = 4096;

using ByName = std::map<std::string, Species>;

// Safe to stand in messages.
std::string Printable(const std::string& file_name) {
  const std::string quoted = Quote(file_name, 255);
  return quoted.substr(1, quoted.size() - 2);
}

// Adds the species of the files; those of a name that is in `species` take its place.
std::vector<Violation> AddFiles(const std::vector<std::pair<std::string, std::string>>& files,
                                ByName* species) {
  std::vector<Violation> violations;
  static const SchemaChecker checker(SpeciesCatalogue::schema());  // immutable
  std::map<std::string, std::string> added_at;                     // name -> pointer
  for (const auto& [file_name, text] : files) {
    for (SpeciesEntry& entry : ReadSpeciesFile(Printable(file_name), text, checker, &violations)) {
      const std::string name = entry.species.name;
      const auto [first, fresh] = added_at.emplace(name, entry.pointer);
      if (!fresh) {
        violations.push_back({"duplicate_value", entry.pointer + "/name",
                              "a species of this name stands at " + first->second, Quote(name)});
        continue;
      }
      const auto known = species->find(name);
      if (known != species->end() && known->second.category != entry.species.category) {
        violations.push_back({"unknown_value", entry.pointer + "/category",
                              "what takes the place of " + Quote(name) + " must be a " +
                                  std::string(NameOf(known->second.category)),
                              Quote(NameOf(entry.species.category))});
        continue;
      }
      (*species)[name] = std::move(entry.species);
    }
  }
  if (species->size() > kMaxSpecies) {
    violations.push_back({"wrong_count", "",
                          "at most " + std::to_string(kMaxSpecies) + " species are legal",
                          std::to_string(species->size())});
  }
  return violations;
}

std::vector<Species> Sorted(ByName species) {
  std::vector<Species> all;
  for (auto& entry : species) all.push_back(std::move(entry.second));
  return all;
}

}  // namespace

std::shared_ptr<const SpeciesCatalogue> SpeciesCatalogue::BuiltIn() {
  static const std::shared_ptr<const SpeciesCatalogue> built_in = [] {  // immutable
    std::vector<std::pair<std::string, std::string>> files;
    for (const char* name : kBuiltInFiles) files.emplace_back(name, std::string(SpeciesData(name)));
    ByName species;
    const std::vector<Violation> violations = AddFiles(files, &species);
    LW_CHECK(violations.empty(), Status::FromViolations("built-in species", violations).ToString());
    for (const auto& category : EnumNames(AgentCategory{})) {
      LW_CHECK(species.count(std::string(category.name)) == 1, "a species for every category");
    }
    std::shared_ptr<SpeciesCatalogue> catalogue(new SpeciesCatalogue);
    catalogue->all_ = Sorted(std::move(species));
    return std::shared_ptr<const SpeciesCatalogue>(std::move(catalogue));
  }();
  return built_in;
}

Result<std::shared_ptr<const SpeciesCatalogue>> SpeciesCatalogue::Load(const fs::path& path) {
  return Load(std::vector<fs::path>{path});
}

Result<std::shared_ptr<const SpeciesCatalogue>> SpeciesCatalogue::Load(
    const std::vector<fs::path>& paths) {
  std::vector<std::pair<std::string, std::string>> files;
  for (const fs::path& path : paths) {
    LW_ASSIGN_OR_RETURN(const std::vector<fs::path> found, JsonFilesAt(path, kMaxFiles));
    for (const fs::path& file : found) {
      LW_ASSIGN_OR_RETURN(std::string text, ReadFile(file, kMaxFileBytes));
      files.emplace_back(file.filename().string(), std::move(text));
    }
  }
  return Extended(files);
}

Result<std::shared_ptr<const SpeciesCatalogue>> SpeciesCatalogue::Extended(
    const std::vector<std::pair<std::string, std::string>>& files) {
  ByName species;
  for (const Species& known : BuiltIn()->all()) species[known.name] = known;
  std::vector<Violation> violations = AddFiles(files, &species);
  if (!violations.empty()) {
    LimitViolations(&violations);
    return Status::FromViolations("illegal species files", std::move(violations));
  }
  std::shared_ptr<SpeciesCatalogue> catalogue(new SpeciesCatalogue);
  catalogue->all_ = Sorted(std::move(species));
  catalogue->added_files_ = files;
  return std::shared_ptr<const SpeciesCatalogue>(std::move(catalogue));
}

std::string_view SpeciesCatalogue::schema() { return SpeciesData("schema.json"); }

const Species* SpeciesCatalogue::Find(std::string_view name) const {
  std::string spaced(name);
  std::replace(spaced.begin(), spaced.end(), '_', ' ');
  const auto found =
      std::lower_bound(all_.begin(), all_.end(), spaced,
                       [](const Species& a, const std::string& b) { return a.name < b; });
  return found != all_.end() && found->name == spaced ? &*found : nullptr;
}

const Species& SpeciesCatalogue::Of(AgentCategory category) const {
  const Species* species = Find(NameOf(category));
  LW_CHECK(species != nullptr, "a species for every category");
  return *species;
}

}  // namespace latticeworld
