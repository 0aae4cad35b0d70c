#include "latticeworld/catalogue/catalogue.h"

#include <algorithm>

#include "latticeworld/catalogue/catalogue_reader.h"
#include "latticeworld/common/check.h"

namespace latticeworld {

std::string_view CatalogueData(std::string_view file_name);  // embedded

namespace {

std::shared_ptr<const Catalogue> ReadBuiltIn() {
  std::vector<CatalogueFile> files;
  for (const auto& type : EnumNames(AssetType{})) {
    const std::string name = std::string(type.name) + ".json";
    files.push_back({name, std::string(CatalogueData(name))});
  }
  // Last, so that the models of the types keep their indices.
  files.push_back({"things.json", std::string(CatalogueData("things.json"))});
  auto catalogue = CatalogueReader::Read(nullptr, files);
  LW_CHECK(catalogue.ok(), catalogue.status().ToString());
  return *catalogue;
}

bool Contains(const std::vector<std::uint8_t>& models, std::uint8_t model) {
  return models.empty() || std::find(models.begin(), models.end(), model) != models.end();
}

}  // namespace

std::shared_ptr<const Catalogue> Catalogue::BuiltIn() {
  static const std::shared_ptr<const Catalogue> catalogue = ReadBuiltIn();  // immutable
  return catalogue;
}

Result<std::shared_ptr<const Catalogue>> Catalogue::Extended(std::vector<CatalogueFile> files) {
  return CatalogueReader::Read(BuiltIn().get(), files);
}

const std::vector<SeasonVariant>& Catalogue::season_variants(AssetType type) const {
  return types_[static_cast<std::size_t>(type)].season_variants;
}

const std::vector<Material>& Catalogue::materials(AssetType type) const {
  return types_[static_cast<std::size_t>(type)].materials;
}

const AssetTypeValues& Catalogue::ValuesOf(AssetType type) const {
  return types_[static_cast<std::size_t>(type)].values;
}

const std::vector<std::uint8_t>& Catalogue::models_of(AssetKind kind) const {
  return models_of_[static_cast<std::size_t>(kind)];
}

bool Catalogue::CanWear(std::uint8_t model, std::size_t season_variant) const {
  return Contains(season_variants(models_[model].type)[season_variant].models, model);
}

bool Catalogue::CanBeOf(std::uint8_t model, std::size_t material) const {
  return Contains(materials(models_[model].type)[material].models, model);
}

double Catalogue::PerHectare(AssetKind kind, std::string_view vocabulary, char letter) const {
  for (const KindDensity& density : densities_) {
    if (density.kind == kind && density.letter == letter && density.vocabulary == vocabulary) {
      return density.per_hectare;
    }
  }
  return 0.0;
}

std::string_view CatalogueSchema() { return CatalogueData("schema.json"); }

const AssetTypeValues& ValuesOf(AssetType type) { return Catalogue::BuiltIn()->ValuesOf(type); }

}  // namespace latticeworld
