#include "latticeworld/generation/bundle/assets_csv.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>

#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

struct Column {
  std::string_view name;
  float Asset::*member;
  float low;
};
constexpr float kAny = -1e6f;  // bounds what a file can say, far outside every world
constexpr float kHighest = 1e6f;
constexpr std::array<Column, 9> kColumns = {{{"x_m", &Asset::x_m, kAny},
                                             {"y_m", &Asset::y_m, kAny},
                                             {"z_m", &Asset::z_m, kAny},
                                             {"yaw_rad", &Asset::yaw_rad, kAny},
                                             {"scale", &Asset::scale, 0.0f},
                                             {"height_m", &Asset::height_m, 0.0f},
                                             {"half_length_m", &Asset::half_length_m, 0.0f},
                                             {"half_width_m", &Asset::half_width_m, 0.0f},
                                             {"trunk_radius_m", &Asset::trunk_radius_m, 0.0f}}};

std::string HeaderLine() {
  std::string line = "kind,model,season_variant,material";
  for (const Column& column : kColumns) line.append(",").append(column.name);
  return line;
}

void AppendFloat(float value, std::string* out) {
  char buffer[32];
  const auto result = std::to_chars(buffer, buffer + sizeof(buffer), value);
  out->append(buffer, result.ptr);
}

// Cuts `text` at the first separator: gives what is before it and leaves what is after it.
std::string_view TakeUntil(char separator, std::string_view* text) {
  const std::size_t end = std::min(text->find(separator), text->size());
  const std::string_view field = text->substr(0, end);
  text->remove_prefix(std::min(end + 1, text->size()));
  return field;
}

Result<std::uint8_t> IndexOf(std::string_view name, const std::vector<std::string_view>& names,
                             std::string_view what) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<std::uint8_t>(found - names.begin());
  std::string legal;
  for (const std::string_view other : names) {
    legal.append(legal.empty() ? "" : ", ").append(other);
  }
  return DataLoss(std::string(what) + " is " + Quote(name) + "; legal are " + legal);
}

Result<std::uint8_t> ModelOf(AssetKind kind, std::string_view name, const Catalogue& catalogue) {
  for (const std::uint8_t model : catalogue.models_of(kind)) {
    if (catalogue.models()[model].name == name) return model;
  }
  std::vector<std::string_view> legal;
  for (const std::uint8_t model : catalogue.models_of(kind))
    legal.push_back(catalogue.models()[model].name);
  return IndexOf(name, legal, "model").status();
}

Result<Asset> DecodeAsset(std::string_view line, const GridGeometry& geometry,
                          const Catalogue& catalogue) {
  const auto commas = static_cast<std::size_t>(std::count(line.begin(), line.end(), ','));
  if (commas != kColumns.size() + 3) {
    return DataLoss("has " + std::to_string(commas + 1) + " fields, not " +
                    std::to_string(kColumns.size() + 4));
  }
  Asset asset;
  const std::string_view kind_name = TakeUntil(',', &line);
  const auto kind = FromName<AssetKind>(kind_name);
  if (!kind) {
    return DataLoss("kind is " + Quote(kind_name) + "; legal are " + LegalNames<AssetKind>());
  }
  asset.kind = *kind;
  LW_ASSIGN_OR_RETURN(asset.model, ModelOf(*kind, TakeUntil(',', &line), catalogue));
  const AssetTypeValues& values = catalogue.ValuesOf(TypeOf(*kind));
  LW_ASSIGN_OR_RETURN(asset.season_variant,
                      IndexOf(TakeUntil(',', &line), values.season_variants, "season_variant"));
  LW_ASSIGN_OR_RETURN(asset.material, IndexOf(TakeUntil(',', &line), values.materials, "material"));
  for (const Column& column : kColumns) {
    const std::string_view field = TakeUntil(',', &line);
    float& value = asset.*column.member;
    const auto result = std::from_chars(field.data(), field.data() + field.size(), value);
    if (result.ec != std::errc() || result.ptr != field.data() + field.size() ||
        !(value >= column.low && value <= kHighest)) {
      return DataLoss(std::string(column.name) + " is " + Quote(field) +
                      "; legal are numbers from " + FormatDouble(column.low) + " to " +
                      FormatDouble(kHighest));
    }
  }
  if (!geometry.Contains(asset.position())) {
    return DataLoss("stands outside the world at x " + FormatDouble(asset.x_m) + " m, y " +
                    FormatDouble(asset.y_m) + " m");
  }
  return asset;
}

}  // namespace

Result<std::string> EncodeAssets(const std::vector<Asset>& assets, const Catalogue& catalogue) {
  std::string content = HeaderLine() + "\n";
  content.reserve(content.size() + 100 * assets.size());
  for (const Asset& asset : assets) {
    const AssetTypeValues& values = catalogue.ValuesOf(TypeOf(asset.kind));
    if (asset.model >= catalogue.models().size() ||
        catalogue.models()[asset.model].kind != asset.kind ||
        asset.season_variant >= values.season_variants.size() ||
        asset.material >= values.materials.size()) {
      return Internal("asset " + std::to_string(&asset - assets.data()) + ", a " +
                      std::string(NameOf(asset.kind)) +
                      ", has a model, variant or material that its kind has not");
    }
    content.append(NameOf(asset.kind)).append(",");
    content.append(catalogue.models()[asset.model].name).append(",");
    content.append(values.season_variants[asset.season_variant]).append(",");
    content.append(values.materials[asset.material]);
    for (const Column& column : kColumns) {
      content.push_back(',');
      AppendFloat(asset.*column.member, &content);
    }
    content.push_back('\n');
  }
  return content;
}

Result<std::vector<Asset>> DecodeAssets(std::string_view content, const GridGeometry& geometry,
                                        const Catalogue& catalogue) {
  if (TakeUntil('\n', &content) != HeaderLine()) {
    return DataLoss("line 1 is not \"" + HeaderLine() + "\"");
  }
  std::vector<Asset> assets;
  while (!content.empty()) {
    const Result<Asset> asset = DecodeAsset(TakeUntil('\n', &content), geometry, catalogue);
    if (!asset.ok()) {
      return asset.status().WithContext("line " + std::to_string(assets.size() + 2));
    }
    assets.push_back(*asset);
  }
  return assets;
}

}  // namespace latticeworld
