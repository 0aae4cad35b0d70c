#include "latticeworld/catalogue/catalogue_reader.h"

#include <algorithm>
#include <cstddef>

#include "latticeworld/catalogue/limits.h"
#include "latticeworld/common/schema_check.h"
#include "latticeworld/common/strict_json.h"
#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

std::size_t IndexOf(AssetType type) { return static_cast<std::size_t>(type); }

// The continuous parameters of the method's table; the code that acts on them knows no others.
void SetParameters(AssetType type, AssetTypeValues* values) {
  values->has_rotation =
      type != AssetType::kGrass && type != AssetType::kRoad && type != AssetType::kLake;
  values->has_scale = type == AssetType::kArchitecture;
  values->has_height = type == AssetType::kLake;
  values->has_wind = type == AssetType::kDesert;
  values->has_slope = type == AssetType::kSnowMountain;
}

// Above it a variant is seen only where snow lies, which winter alone can promise.
constexpr double kNeedsSnow = 0.5;

bool IsSeenIn(const SeasonVariant& variant, Season season) {
  return variant.seasons[static_cast<std::size_t>(season)] &&
         (variant.snow <= kNeedsSnow || season == Season::kWinter);
}

std::string Describe(Season season) {
  return std::string(NameOf(season)) + (season == Season::kWinter ? "" : " without snow");
}

template <typename Value>
auto FindByName(std::vector<Value>* values, const std::string& name) {
  return std::find_if(values->begin(), values->end(),
                      [&](const Value& value) { return value.name == name; });
}

// Names stand in messages and in bundles.
bool IsPlainName(const std::string& name) {
  return !name.empty() && ValidateText("name", name, kMaxNameBytes).ok() &&
         std::none_of(name.begin(), name.end(),
                      [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; });
}

void CheckFiles(const std::vector<CatalogueFile>& files, std::vector<Violation>* violations) {
  if (files.size() > kMaxCatalogueFiles) {
    violations->push_back({"wrong_count", "",
                           std::to_string(files.size()) + " files; legal are at most " +
                               std::to_string(kMaxCatalogueFiles),
                           std::to_string(files.size())});
  }
  std::size_t bytes = 0;
  for (const CatalogueFile& file : files) bytes += file.text.size();
  if (bytes > kMaxCatalogueBytes) {
    violations->push_back({"too_long", "",
                           std::to_string(bytes) + " bytes in all; legal are at most " +
                               std::to_string(kMaxCatalogueBytes),
                           std::to_string(bytes)});
  }
  std::set<std::string> names;
  for (const CatalogueFile& file : files) {
    if (!IsPlainName(file.name)) {
      violations->push_back({"bad_format", "",
                             "a file is named " + Quote(file.name) +
                                 "; legal are 1 to 255 bytes of UTF-8 without control characters",
                             Quote(file.name)});
    } else if (!names.insert(file.name).second) {
      violations->push_back({"duplicate_file", file.name + "#",
                             "two files are named " + Quote(file.name), Quote(file.name)});
    }
  }
}

}  // namespace

Result<std::shared_ptr<const Catalogue>> CatalogueReader::Read(
    const Catalogue* base, const std::vector<CatalogueFile>& files) {
  CatalogueReader reader(base);
  CheckFiles(files, &reader.violations_);
  std::size_t unread = 0;
  if (reader.violations_.empty()) {
    static const SchemaChecker checker(CatalogueSchema());  // immutable
    std::vector<TypeFile> read;
    for (const CatalogueFile& file : files) {
      if (reader.violations_.size() > kMaxCatalogueViolations) {
        ++unread;
      } else if (auto type_file = ReadTypeFile(file, checker, &reader.violations_)) {
        read.push_back(*std::move(type_file));
      }
    }
    if (unread == 0) reader.Merge(read);  // what they say may refer to what was not read
    reader.Finish(files);
    // What is missing from the whole is the files' fault only when all of them were read.
    if (reader.violations_.empty()) reader.CheckWhole();
  }
  std::vector<Violation>& violations = reader.violations_;
  LimitViolations(&violations);
  if (unread > 0) {
    violations.push_back({"unread_files", "",
                          std::to_string(unread) + " further files were not read",
                          std::to_string(unread)});
  }
  if (!violations.empty()) {
    return Status::FromViolations("illegal catalogue", std::move(violations));
  }
  return std::shared_ptr<const Catalogue>(std::move(reader.catalogue_));
}

CatalogueReader::CatalogueReader(const Catalogue* base)
    : catalogue_(new Catalogue()), has_base_(base != nullptr) {
  if (base == nullptr) return;
  catalogue_->types_ = base->types_;
  catalogue_->models_ = base->models_;
  catalogue_->densities_ = base->densities_;
}

void CatalogueReader::Merge(const std::vector<TypeFile>& files) {
  // Models of all files first: values refer to them.
  for (const TypeFile& file : files) {
    for (const std::string& name : file.unread_models) unread_models_.emplace(file.type, name);
    for (const ModelEntry& entry : file.models) MergeModel(entry);
  }
  for (const TypeFile& file : files) {
    auto& type = catalogue_->types_[IndexOf(file.type)];
    for (const auto& entry : file.season_variants) {
      MergeValue(file.type, "season_variants", entry, &type.season_variants);
    }
    for (const auto& entry : file.materials) {
      MergeValue(file.type, "materials", entry, &type.materials);
    }
    for (const DensityEntry& entry : file.densities) MergeDensity(entry);
  }
}

void CatalogueReader::MergeModel(const ModelEntry& entry) {
  const auto leave_out = [&] { unread_models_.emplace(entry.model.type, entry.model.name); };
  if (!ClaimName("model", entry.model.name, entry.pointer)) return leave_out();
  std::vector<AssetModel>& models = catalogue_->models_;
  const auto same = FindByName(&models, entry.model.name);
  if (same == models.end()) {
    if (!HasRoom(models.size(), "models", entry.pointer)) return leave_out();
    models.push_back(entry.model);
  } else if (same->kind != entry.model.kind) {
    violations_.push_back({"wrong_kind", entry.pointer + "/kind",
                           "takes the place of " + Quote(same->name) + ", which is a " +
                               std::string(NameOf(same->kind)) + ", and must be one",
                           Quote(NameOf(entry.model.kind))});
    leave_out();
  } else {
    *same = entry.model;
  }
}

void CatalogueReader::MergeDensity(const DensityEntry& entry) {
  const KindDensity& given = entry.density;
  const std::string cell =
      std::string(NameOf(given.kind)) + "/" + given.vocabulary + "/" + std::string(1, given.letter);
  if (!ClaimName("density", cell, entry.pointer)) return;
  for (KindDensity& density : catalogue_->densities_) {
    if (density.kind == given.kind && density.vocabulary == given.vocabulary &&
        density.letter == given.letter) {
      density = given;
      return;
    }
  }
  catalogue_->densities_.push_back(given);
}

template <typename Value>
void CatalogueReader::MergeValue(AssetType type, const char* list, const ValueEntry<Value>& entry,
                                 std::vector<Value>* values) {
  const std::string scope = std::string(NameOf(type)) + "/" + list;
  if (!ClaimName(scope, entry.value.name, entry.pointer)) return;
  Value value = entry.value;
  value.models = ModelsNamed(type, entry.model_names, entry.pointer);
  const auto same = FindByName(values, value.name);
  if (same != values->end()) {
    *same = std::move(value);
  } else if (HasRoom(values->size(), list, entry.pointer)) {
    values->push_back(std::move(value));
  }
}

std::vector<std::uint8_t> CatalogueReader::ModelsNamed(AssetType type,
                                                       const std::vector<std::string>& names,
                                                       const std::string& pointer) {
  const std::vector<AssetModel>& models = catalogue_->models_;
  std::vector<std::uint8_t> indices;
  for (std::size_t i = 0; i < names.size(); ++i) {
    std::vector<std::string> legal;
    bool is_found = unread_models_.count({type, names[i]}) > 0;
    for (std::size_t m = 0; m < models.size(); ++m) {
      if (models[m].type != type) continue;
      legal.push_back(models[m].name);
      if (models[m].name != names[i]) continue;
      indices.push_back(static_cast<std::uint8_t>(m));
      is_found = true;
    }
    if (is_found) continue;
    violations_.push_back(
        {"unknown_value", pointer + "/models/" + std::to_string(i),
         Quote(names[i]) + " is no model of " + std::string(NameOf(type)) +
             "; legal: " + (legal.empty() ? "none, it is ground" : Join(legal, ", ")),
         Quote(names[i])});
  }
  std::sort(indices.begin(), indices.end());
  return indices;
}

bool CatalogueReader::ClaimName(const std::string& scope, const std::string& name,
                                const std::string& pointer) {
  const auto [claim, is_new] = claimed_.emplace(scope + "/" + name, pointer);
  if (is_new) return true;
  violations_.push_back({"duplicate_name", pointer,
                         Quote(name) + " is given at " + claim->second + " already", Quote(name)});
  return false;
}

bool CatalogueReader::HasRoom(std::size_t count, const char* what, const std::string& pointer) {
  if (count < kMaxCatalogueEntries) return true;
  violations_.push_back({"wrong_count", pointer,
                         "is one more than the " + std::to_string(kMaxCatalogueEntries) + " " +
                             what + " that a catalogue holds, those built in included",
                         ""});
  return false;
}

void CatalogueReader::Finish(const std::vector<CatalogueFile>& files) {
  for (const auto& type : EnumNames(AssetType{})) {
    auto& entry = catalogue_->types_[IndexOf(type.value)];
    entry.values = {};
    entry.values.type = type.value;
    SetParameters(type.value, &entry.values);
    for (const SeasonVariant& value : entry.season_variants) {
      entry.values.season_variants.push_back(value.name);
    }
    for (const Material& value : entry.materials) entry.values.materials.push_back(value.name);
  }
  for (std::size_t m = 0; m < catalogue_->models_.size(); ++m) {
    const auto kind = static_cast<std::size_t>(catalogue_->models_[m].kind);
    catalogue_->models_of_[kind].push_back(static_cast<std::uint8_t>(m));
  }
  if (has_base_) catalogue_->added_files_ = files;
}

void CatalogueReader::CheckWhole() {
  for (const auto& type : EnumNames(AssetType{})) {
    const auto& entry = catalogue_->types_[IndexOf(type.value)];
    const std::string name(type.name);
    for (const auto& season : EnumNames(Season{})) {
      if (std::any_of(entry.season_variants.begin(), entry.season_variants.end(),
                      [&](const SeasonVariant& v) { return IsSeenIn(v, season.value); })) {
        continue;
      }
      violations_.push_back(
          {"incomplete", name, "has no seasonal value for " + Describe(season.value), ""});
    }
  }
  for (std::size_t m = 0; m < catalogue_->models_.size(); ++m) {
    CheckModelWears(static_cast<std::uint8_t>(m));
  }
}

void CatalogueReader::CheckModelWears(std::uint8_t model) {
  const AssetModel& given = catalogue_->models_[model];
  const std::vector<SeasonVariant>& variants = catalogue_->season_variants(given.type);
  for (const auto& season : EnumNames(Season{})) {
    bool is_found = false;
    for (std::size_t v = 0; v < variants.size() && !is_found; ++v) {
      is_found = catalogue_->CanWear(model, v) && IsSeenIn(variants[v], season.value);
    }
    if (is_found) continue;
    violations_.push_back(
        {"incomplete", PointerTo(given),
         Quote(given.name) + " has no seasonal value that it may wear in " + Describe(season.value),
         Quote(given.name)});
  }
  const std::size_t materials = catalogue_->materials(given.type).size();
  bool is_found = false;
  for (std::size_t i = 0; i < materials && !is_found; ++i) is_found = catalogue_->CanBeOf(model, i);
  if (!is_found) {
    violations_.push_back({"incomplete", PointerTo(given),
                           Quote(given.name) + " has no material value that it may be of",
                           Quote(given.name)});
  }
}

std::string CatalogueReader::PointerTo(const AssetModel& model) const {
  const auto claim = claimed_.find("model/" + model.name);
  return claim == claimed_.end() ? model.name : claim->second;
}

}  // namespace latticeworld
