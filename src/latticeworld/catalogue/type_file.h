#ifndef LATTICEWORLD_CATALOGUE_TYPE_FILE_H_
#define LATTICEWORLD_CATALOGUE_TYPE_FILE_H_

#include <optional>
#include <string>
#include <vector>

#include "latticeworld/catalogue/catalogue.h"
#include "latticeworld/common/schema_check.h"

namespace latticeworld {

// A SeasonVariant or Material as a file has it.
template <typename Value>
struct ValueEntry {
  Value value;                           // without `models`
  std::vector<std::string> model_names;  // empty: every model of the type
  std::string pointer;                   // "trees.json#/materials/0"
};

struct ModelEntry {
  AssetModel model;
  std::string pointer;
};

struct DensityEntry {
  KindDensity density;
  std::string pointer;
};

// What one file says, as far as it can be read.
struct TypeFile {
  AssetType type = AssetType::kGrass;
  std::vector<ValueEntry<SeasonVariant>> season_variants;
  std::vector<ValueEntry<Material>> materials;
  std::vector<ModelEntry> models;
  std::vector<DensityEntry> densities;
  // Names of the models that cannot be read: a reference to one is no further error.
  std::vector<std::string> unread_models;
};

// Reads one file and adds all its violations: JSON, schema, and what a schema cannot say about one
// entry, where that entry keeps to the schema. What can be read is, even when other parts cannot.
// nullopt: nothing can.
std::optional<TypeFile> ReadTypeFile(const CatalogueFile& file, const SchemaChecker& checker,
                                     std::vector<Violation>* violations);

}  // namespace latticeworld

#endif  // LATTICEWORLD_CATALOGUE_TYPE_FILE_H_
