#include "latticeworld/catalogue/type_file.h"

#include <array>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "latticeworld/catalogue/kind_rules.h"
#include "latticeworld/catalogue/limits.h"
#include "latticeworld/common/strict_json.h"
#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

using Json = nlohmann::json;

// The functions below read what has been found to keep to the schema.

Rgb ReadColor(const Json& json) {
  const std::string text = json.get<std::string>();  // "#rrggbb"
  const auto rgb = static_cast<unsigned>(std::stoul(text.substr(1), nullptr, 16));
  return {static_cast<std::uint8_t>(rgb >> 16), static_cast<std::uint8_t>(rgb >> 8),
          static_cast<std::uint8_t>(rgb)};
}

ColorRange ReadColorRange(const Json& json) { return {ReadColor(json[0]), ReadColor(json[1])}; }

Reflectivity ReadReflectivity(const Json& json) {
  return {json.at("lidar_reflectance").get<double>(), json.at("radar_sigma0_db").get<double>()};
}

GroundEffect ReadGround(const Json& json) {
  if (!json.contains("ground")) return {};
  const Json& ground = json.at("ground");
  return {ground.at("friction").get<double>(), ground.at("rolling_resistance").get<double>(),
          ground.at("cone_index").get<double>()};
}

Preference ReadPreference(const Json& json) {
  return {json.at("low").get<double>(), json.at("high").get<double>(),
          json.at("fade").get<double>()};
}

SizeRange ReadSize(const Json& json) {
  return {json.at("mean").get<double>(), json.at("deviation").get<double>(),
          json.at("low").get<double>(), json.at("high").get<double>()};
}

Habitat ReadHabitat(const Json& json) {
  Habitat habitat;
  if (!json.contains("habitat")) return habitat;
  const Json& from = json.at("habitat");
  if (from.contains("altitude")) habitat.altitude = ReadPreference(from.at("altitude"));
  if (from.contains("slope_deg")) habitat.slope_deg = ReadPreference(from.at("slope_deg"));
  if (from.contains("wetness")) habitat.wetness = ReadPreference(from.at("wetness"));
  if (from.contains("northness")) habitat.northness = ReadPreference(from.at("northness"));
  habitat.shade_tolerance = from.value("shade_tolerance", habitat.shade_tolerance);
  habitat.clumping = from.value("clumping", habitat.clumping);
  return habitat;
}

Wood ReadWood(const Json& json) {
  if (!json.contains("wood")) return {};
  const Json& wood = json.at("wood");
  return {wood.at("density_kgpm3").get<double>(), wood.at("elastic_modulus_pa").get<double>(),
          wood.at("bending_strength_pa").get<double>()};
}

template <typename Enum>
Enum ReadName(const Json& json) {
  return *FromName<Enum>(json.get<std::string>());
}

std::vector<ModelPart> ReadParts(const Json& json) {
  std::vector<ModelPart> parts;
  for (const Json& from : json) {
    ModelPart part;
    part.form = ReadName<PartForm>(from.at("form"));
    part.look = ReadName<PartLook>(from.at("look"));
    part.base_m = from.at("base_m").get<std::array<double, 3>>();
    part.size_m = from.at("size_m").get<std::array<double, 3>>();
    parts.push_back(part);
  }
  return parts;
}

// Whether a value that has such a violation still is what its key asks for.
bool IsReadable(std::string_view code) {
  return code == "unknown_key" || code == "duplicate_key" || code == "duplicate_value" ||
         code == "out_of_range";
}

// Reads the parts of one file that can be read.
class TypeFileReader {
 public:
  TypeFileReader(const Json& json, std::string origin, std::vector<Violation>* violations)
      : json_(json), origin_(std::move(origin)), violations_(violations) {}

  TypeFile Read() {
    file_.type = ReadName<AssetType>(json_.at("type"));
    ReadEach("season_variants", &TypeFileReader::ReadSeasonVariant);
    ReadEach("materials", &TypeFileReader::ReadMaterial);
    ReadEach("models", &TypeFileReader::ReadModel);
    ReadEach("density", &TypeFileReader::ReadDensity);
    CollectUnreadModels();
    return std::move(file_);
  }

 private:
  void ReadEach(const char* key, void (TypeFileReader::*read)(const Json&, std::string)) {
    if (!json_.contains(key) || !json_.at(key).is_array()) return;
    for (std::size_t i = 0; i < json_.at(key).size(); ++i) {
      std::string pointer = origin_ + "/" + key + "/" + std::to_string(i);
      if (IsSound(pointer)) (this->*read)(json_.at(key)[i], std::move(pointer));
    }
  }

  // Whether it can be read: has all its keys, and of the right type.
  bool IsSound(const std::string& pointer) const {
    for (const Violation& violation : *violations_) {
      if (IsReadable(violation.code)) continue;
      if (violation.pointer == pointer || StartsWith(violation.pointer, pointer + "/")) {
        return false;
      }
    }
    return true;
  }

  void ReadSeasonVariant(const Json& json, std::string pointer) {
    ValueEntry<SeasonVariant> entry;
    SeasonVariant& value = entry.value;
    value.name = json.at("name").get<std::string>();
    value.seasons.fill(false);
    CheckEachOnce(json.at("seasons"), pointer + "/seasons");
    const Json& color = json.at("color");
    std::optional<ColorRange> any;
    for (const Json& name : json.at("seasons")) {
      const auto season = static_cast<std::size_t>(ReadName<Season>(name));
      value.seasons[season] = true;
      if (color.contains(name.get<std::string>())) {
        value.color[season] = ReadColorRange(color.at(name.get<std::string>()));
        if (!any) any = value.color[season];
      }
    }
    CheckColorSeasons(value, color, pointer);
    for (std::size_t season = 0; any && season < value.color.size(); ++season) {
      if (!value.seasons[season]) value.color[season] = *any;  // never seen, but never undefined
    }
    value.foliage = json.at("foliage").get<double>();
    value.growth = json.at("growth").get<double>();
    value.snow = json.at("snow").get<double>();
    value.reflectivity = ReadReflectivity(json);
    value.ground = ReadGround(json);
    entry.model_names = ReadModelNames(json, pointer);
    entry.pointer = std::move(pointer);
    file_.season_variants.push_back(std::move(entry));
  }

  std::vector<std::string> ReadModelNames(const Json& json, const std::string& pointer) {
    if (!json.contains("models")) return {};
    CheckEachOnce(json.at("models"), pointer + "/models");
    return json.at("models").get<std::vector<std::string>>();
  }

  // Checks what is not left to the schema: its checker compares all pairs and reports each that is
  // equal.
  void CheckEachOnce(const Json& names, const std::string& pointer) {
    std::set<std::string> known;
    for (const Json& name : names) {
      if (known.insert(name.get<std::string>()).second) continue;
      const std::string given = Quote(name.get<std::string>());
      violations_->push_back({"duplicate_value", pointer, "has " + given + " twice", given});
      return;
    }
  }

  void CheckColorSeasons(const SeasonVariant& value, const Json& color,
                         const std::string& pointer) {
    for (const auto& season : EnumNames(Season{})) {
      const bool is_seen = value.seasons[static_cast<std::size_t>(season.value)];
      const bool is_colored = color.contains(std::string(season.name));
      const std::string at = pointer + "/color/" + std::string(season.name);
      if (is_seen && !is_colored) {
        violations_->push_back(
            {"missing_key", at, "is missing; each of the seasons needs its colours", ""});
      } else if (!is_seen && is_colored) {
        violations_->push_back({"unknown_key", at,
                                Quote(season.name) + " is not one of the seasons in which it is "
                                                     "seen",
                                Quote(season.name)});
      }
    }
  }

  void ReadMaterial(const Json& json, std::string pointer) {
    ValueEntry<Material> entry;
    Material& value = entry.value;
    value.name = json.at("name").get<std::string>();
    value.color = ReadColorRange(json.at("color"));
    value.density_kgpm3 = json.at("density_kgpm3").get<double>();
    value.elastic_modulus_pa = json.at("elastic_modulus_pa").get<double>();
    value.bending_strength_pa = json.at("bending_strength_pa").get<double>();
    value.reflectivity = ReadReflectivity(json);
    value.ground = ReadGround(json);
    entry.model_names = ReadModelNames(json, pointer);
    entry.pointer = std::move(pointer);
    file_.materials.push_back(std::move(entry));
  }

  void ReadModel(const Json& json, std::string pointer) {
    AssetModel model;
    model.name = json.at("name").get<std::string>();
    model.type = file_.type;
    model.kind = ReadName<AssetKind>(json.at("kind"));
    model.shape = ReadName<Shape>(json.at("shape"));
    model.collision = ReadName<Collision>(json.at("collision"));
    ReadModelSize(json, "height_m", pointer, &model.height_m);
    model.crown_per_trunk = json.value("crown_per_trunk", 0.0);
    model.crown_base = json.value("crown_base", model.crown_base);
    model.crown_widest = json.value("crown_widest", model.crown_widest);
    model.droop = json.value("droop", model.droop);
    ReadModelSize(json, "spread", pointer, &model.spread);
    ReadModelSize(json, "half_length_m", pointer, &model.half_length_m);
    ReadModelSize(json, "half_width_m", pointer, &model.half_width_m);
    model.storey_m = json.value("storey_m", 0.0);
    model.share = json.at("share").get<double>();
    model.habitat = ReadHabitat(json);
    CheckHabitat(model.habitat, pointer);
    if (json.contains("letters")) {
      model.letters_suburb = json.at("letters").value("suburb", "");
      model.letters_wild = json.at("letters").value("wild", "");
    }
    CheckLetters(model.letters_suburb, "suburb", pointer + "/letters/suburb", violations_);
    CheckLetters(model.letters_wild, "wild", pointer + "/letters/wild", violations_);
    model.wood = ReadWood(json);
    if (json.contains("parts")) model.parts = ReadParts(json.at("parts"));
    CheckModelKind(model, pointer, violations_);
    CheckModelParts(model, pointer, violations_);
    for (const ModelKey& key : kModelKeys) {
      CheckModelKey(key, model.kind, json.contains(key.name), pointer, violations_);
    }
    file_.models.push_back({std::move(model), std::move(pointer)});
  }

  void ReadModelSize(const Json& json, const char* key, const std::string& pointer,
                     SizeRange* size) {
    if (!json.contains(key)) return;
    *size = ReadSize(json.at(key));
    if (size->low <= size->mean && size->mean <= size->high) return;
    const std::string given =
        FormatDouble(size->low) + ", " + FormatDouble(size->mean) + ", " + FormatDouble(size->high);
    violations_->push_back({"out_of_range", pointer + "/" + key,
                            "low, mean and high must not fall, and are " + given, given});
  }

  void CheckHabitat(const Habitat& habitat, const std::string& pointer) {
    CheckPreference(habitat.altitude, pointer + "/habitat/altitude");
    CheckPreference(habitat.slope_deg, pointer + "/habitat/slope_deg");
    CheckPreference(habitat.wetness, pointer + "/habitat/wetness");
    CheckPreference(habitat.northness, pointer + "/habitat/northness");
  }

  void CheckPreference(const Preference& preference, const std::string& pointer) {
    if (preference.low <= preference.high) return;
    const std::string given = FormatDouble(preference.low) + ", " + FormatDouble(preference.high);
    violations_->push_back(
        {"out_of_range", pointer, "low must not be above high, and they are " + given, given});
  }

  void ReadDensity(const Json& json, std::string pointer) {
    const auto kind = ReadName<AssetKind>(json.at("kind"));
    if (TypeOf(kind) != file_.type) {
      violations_->push_back({"wrong_kind", pointer + "/kind",
                              Quote(NameOf(kind)) + " is not a kind of " +
                                  std::string(NameOf(file_.type)) +
                                  "; legal: " + KindsOf(file_.type),
                              Quote(NameOf(kind))});
      return;
    }
    for (const char* vocabulary : {"suburb", "wild"}) {
      if (!json.contains(vocabulary)) continue;
      for (const auto& [letter, per_hectare] : json.at(vocabulary).items()) {
        file_.densities.push_back({{kind, vocabulary, letter[0], per_hectare.get<double>()},
                                   pointer + "/" + vocabulary + "/" + letter});
      }
    }
  }

  void CollectUnreadModels() {
    if (!json_.contains("models") || !json_.at("models").is_array()) return;
    const Json& models = json_.at("models");
    for (std::size_t i = 0; i < models.size(); ++i) {
      const Json& model = models[i];
      if (!model.is_object() || !model.contains("name") || !model.at("name").is_string()) continue;
      if (IsSound(origin_ + "/models/" + std::to_string(i))) continue;
      file_.unread_models.push_back(model.at("name").get<std::string>());
    }
  }

  const Json& json_;
  std::string origin_;
  std::vector<Violation>* violations_;
  TypeFile file_;
};

}  // namespace

std::optional<TypeFile> ReadTypeFile(const CatalogueFile& file, const SchemaChecker& checker,
                                     std::vector<Violation>* violations) {
  JsonLimits limits;
  limits.max_bytes = kMaxCatalogueFileBytes;
  limits.max_elements = kMaxCatalogueEntries + 1;  // one more than is legal shows the fault
  const std::string origin = file.name + "#";
  std::vector<Violation> own;
  std::optional<TypeFile> read;
  Json json;
  if (ParseStrictly(file.text, origin, limits, &json, &own)) {
    checker.Check(json, origin, &own);
    const bool has_type = json.is_object() && json.contains("type") &&
                          json.at("type").is_string() &&
                          FromName<AssetType>(json.at("type").get<std::string>()).has_value();
    if (has_type) read = TypeFileReader(json, origin, &own).Read();
  }
  violations->insert(violations->end(), own.begin(), own.end());
  return read;
}

}  // namespace latticeworld
