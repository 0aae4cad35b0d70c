#ifndef LATTICEWORLD_CATALOGUE_KIND_RULES_H_
#define LATTICEWORLD_CATALOGUE_KIND_RULES_H_

#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/catalogue/catalogue.h"

namespace latticeworld {

// "bush, grass_tuft": kinds whose type it is; "none" for types of ground.
std::string KindsOf(AssetType type);

// Adds a violation for each of kind, shape and collision that does not go with the model's type
// and kind. pointer: of the model.
void CheckModelKind(const AssetModel& model, const std::string& pointer,
                    std::vector<Violation>* violations);

// Adds a violation where the shape needs parts and there are none, or has none and there are.
void CheckModelParts(const AssetModel& model, const std::string& pointer,
                     std::vector<Violation>* violations);

// A key of a model that only some kinds have.
struct ModelKey {
  const char* name;
  bool is_required;  // by those kinds
  bool (*is_for)(AssetKind kind);
};
inline bool IsWoody(AssetKind kind) { return kind == AssetKind::kTree || kind == AssetKind::kBush; }
inline constexpr ModelKey kModelKeys[] = {
    {"crown_per_trunk", true, [](AssetKind kind) { return kind == AssetKind::kTree; }},
    {"half_length_m", true, [](AssetKind kind) { return kind == AssetKind::kBuilding; }},
    {"half_width_m", true, [](AssetKind kind) { return kind == AssetKind::kBuilding; }},
    {"storey_m", false, [](AssetKind kind) { return kind == AssetKind::kBuilding; }},
    {"spread", true,
     [](AssetKind kind) { return kind != AssetKind::kTree && kind != AssetKind::kBuilding; }},
    {"wood", false, IsWoody},
    {"crown_base", false, IsWoody},
    {"crown_widest", false, IsWoody},
    {"droop", false, IsWoody},
};

// Adds a violation when the key is missing where the kind needs it or given where it means nothing.
void CheckModelKey(const ModelKey& key, AssetKind kind, bool is_given, const std::string& pointer,
                   std::vector<Violation>* violations);

// Adds a violation for letters that are no classes of the vocabulary.
void CheckLetters(std::string_view letters, std::string_view vocabulary, const std::string& pointer,
                  std::vector<Violation>* violations);

}  // namespace latticeworld

#endif  // LATTICEWORLD_CATALOGUE_KIND_RULES_H_
