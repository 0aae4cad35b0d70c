#ifndef LATTICEWORLD_SPECIES_SPECIES_CATALOGUE_H_
#define LATTICEWORLD_SPECIES_SPECIES_CATALOGUE_H_

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/species/species.h"

namespace latticeworld {

// The species that agents can be of. Immutable and shared. The built-in ones are data files of this
// room; users add or replace species with files of the same schema.
class SpeciesCatalogue {
 public:
  // The built-in species: one for every category of the method, of the category's name, and
  // vehicles of every drive.
  static std::shared_ptr<const SpeciesCatalogue> BuiltIn();
  // The built-in ones and those of a file, or of every *.json of a folder in the order of their
  // names. A species of a name that there is takes its place, and must keep its category.
  // Errors: NOT_FOUND, INVALID_ARGUMENT with every violation, each beginning with the file's name.
  static Result<std::shared_ptr<const SpeciesCatalogue>> Load(const std::filesystem::path& path);
  static Result<std::shared_ptr<const SpeciesCatalogue>> Load(
      const std::vector<std::filesystem::path>& paths);
  // The same from texts: {name of the file, its text}.
  static Result<std::shared_ptr<const SpeciesCatalogue>> Extended(
      const std::vector<std::pair<std::string, std::string>>& files);

  // JSON Schema (draft 7) of a file.
  static std::string_view schema();

  // Sorted by name.
  const std::vector<Species>& all() const { return all_; }
  // What Extended makes the same catalogue of; empty: the built-in one.
  const std::vector<std::pair<std::string, std::string>>& added_files() const {
    return added_files_;
  }
  // nullptr: there is none. '_' may stand for ' '.
  const Species* Find(std::string_view name) const;
  // The species that a category is unless said otherwise: the one of its name. Never missing.
  const Species& Of(AgentCategory category) const;

 private:
  SpeciesCatalogue() = default;
  std::vector<Species> all_;
  std::vector<std::pair<std::string, std::string>> added_files_;  // {name, text}
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SPECIES_SPECIES_CATALOGUE_H_
