#ifndef LATTICEWORLD_SPECIES_SPECIES_FILE_H_
#define LATTICEWORLD_SPECIES_SPECIES_FILE_H_

#include <string>
#include <vector>

#include "latticeworld/common/schema_check.h"
#include "latticeworld/species/species.h"

namespace latticeworld {

struct SpeciesEntry {
  Species species;
  std::string pointer;  // "user.json#/species/0"
};

// Reads one file and adds all its violations: JSON, schema, and what a schema cannot say about one
// species, where that species keeps to the schema. file_name: what their pointers begin with.
std::vector<SpeciesEntry> ReadSpeciesFile(const std::string& file_name, const std::string& text,
                                          const SchemaChecker& checker,
                                          std::vector<Violation>* violations);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SPECIES_SPECIES_FILE_H_
