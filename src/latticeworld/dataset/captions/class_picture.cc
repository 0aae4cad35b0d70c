#include "latticeworld/dataset/captions/class_picture.h"

#include <cstdint>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "latticeworld/common/strict_json.h"
#include "latticeworld/common/text.h"
#include "latticeworld/dataset/sources/downsample.h"
#include "latticeworld/relief/height_map/colour_picture.h"

namespace latticeworld {
namespace {

constexpr std::size_t kMostNamed = 8;  // foreign colours in a message

std::uint32_t KeyOf(int r, int g, int b) {
  return static_cast<std::uint32_t>(r) << 16 | static_cast<std::uint32_t>(g) << 8 |
         static_cast<std::uint32_t>(b);
}

// "value 9", "colour #ff8000".
std::string NameOfColour(std::uint32_t key) {
  const unsigned r = key >> 16, g = key >> 8 & 0xffu, b = key & 0xffu;
  if (r == g && g == b) return "value " + std::to_string(r);
  char text[24];
  std::snprintf(text, sizeof(text), "colour #%02x%02x%02x", r, g, b);
  return text;
}

// Counts the pixels of a colour that the legend does not have, and where it was met first.
struct Foreign {
  CellIndex first;
  std::size_t pixels = 0;
};

Status ForeignColours(const std::map<std::uint32_t, Foreign>& foreign, const Grid<char>& mask,
                      const PictureLegend& legend, const std::string& what) {
  std::string legal;
  for (const PictureLegend::Entry& entry : legend.entries) {
    if (!legal.empty()) legal += ", ";
    legal += NameOfColour(KeyOf(entry.color.r, entry.color.g, entry.color.b));
  }
  std::vector<Violation> violations;
  for (const auto& [key, where] : foreign) {
    if (violations.size() == kMostNamed) break;
    const std::string name = NameOfColour(key);
    violations.push_back({"unknown_value",
                          "row " + std::to_string(where.first.row + 1) + ", column " +
                              std::to_string(where.first.col + 1),
                          name + " (" + std::to_string(where.pixels) + " of " +
                              std::to_string(mask.size()) + " pixels); legal are " + legal,
                          name});
  }
  return Status::FromViolations(
      what + ": the segmentation has " + std::to_string(foreign.size()) + " unknown value(s)",
      std::move(violations));
}

// "7" or "#00ff7f".
std::optional<Rgb> ColourOf(const std::string& text, bool by_value) {
  const std::string_view digits = by_value ? "0123456789" : "0123456789abcdef";
  const std::string lower = ToLowerAscii(text);
  const std::string number = by_value ? lower : lower.substr(lower.empty() ? 0 : 1);
  const bool legal_size = by_value ? !number.empty() && number.size() <= 3 : number.size() == 6;
  if (!legal_size || number.find_first_not_of(digits) != std::string::npos) return std::nullopt;
  if (!by_value && lower[0] != '#') return std::nullopt;
  const unsigned long value = std::stoul(number, nullptr, by_value ? 10 : 16);
  if (by_value && value > 255) return std::nullopt;
  const auto channel = [value, by_value](int shift) {
    return static_cast<std::uint8_t>(by_value ? value : value >> shift & 0xffu);
  };
  return Rgb{channel(16), channel(8), channel(0)};
}

// The object of values or of colours.
void ReadEntries(const nlohmann::json& json, bool by_value, PictureLegend* legend,
                 std::vector<Violation>* violations) {
  const std::string pointer = by_value ? "/values" : "/colors";
  if (!json.is_object() || json.empty()) {
    violations->push_back({"wrong_type", pointer, "must be an object with at least one key", ""});
    return;
  }
  for (const auto& [key, value] : json.items()) {
    const std::string where = pointer + "/" + PointerToken(key);
    const std::optional<Rgb> color = ColourOf(key, by_value);
    if (!color) {
      violations->push_back(
          {"illegal_key", where,
           by_value ? "keys are grey values from 0 to 255" : "keys are colours as \"#00ff7f\"",
           Quote(key)});
      continue;
    }
    const std::string letter = value.is_string() ? value.get<std::string>() : "?";
    if (letter.size() > 1 ||
        (letter.size() == 1 && FindClass(legend->vocabulary, letter[0]) == nullptr)) {
      violations->push_back({"unknown_letter", where,
                             "legal are \"\" (no data) and the letters " +
                                 std::string(LegalLetters(legend->vocabulary)),
                             Quote(value.dump())});
      continue;
    }
    legend->entries.push_back({*color, letter.empty() ? kNoData : letter[0]});
  }
}

}  // namespace

PictureLegend PaletteLegend(Vocabulary vocabulary) {
  PictureLegend legend;
  legend.vocabulary = vocabulary;
  for (const LayoutClass& entry : ClassesOf(vocabulary)) {
    legend.entries.push_back({entry.color, entry.letter});
  }
  return legend;
}

Result<PictureLegend> ReadLegend(std::string_view json, const std::string& what) {
  JsonLimits limits;
  limits.max_keys = 256;
  nlohmann::json document;
  std::vector<Violation> violations;
  const bool parsed = ParseStrictly(json, "", limits, &document, &violations);
  if (parsed && violations.empty() && !document.is_object()) {
    violations.push_back({"wrong_type", "", "must be an object", ""});
  }
  if (!violations.empty()) return Status::FromViolations(what, std::move(violations));

  // Texts are taken; any other key is illegal, but for those read below.
  PictureLegend legend;
  for (const auto& [key, value] : document.items()) {
    if (key == "vocabulary" || key == "values" || key == "colors") continue;
    if (key == "licence" || key == "citation") {
      std::string* text = key == "licence" ? &legend.licence : &legend.citation;
      if (value.is_string()) {
        *text = value.get<std::string>();
      } else {
        violations.push_back({"wrong_type", "/" + key, "must be a string", Quote(value.dump())});
      }
      continue;
    }
    violations.push_back({"unknown_key", "/" + PointerToken(key),
                          "legal are vocabulary, either values or colors, licence and citation",
                          Quote(key)});
  }
  // The vocabulary says which classes the entries may name.
  const auto vocabulary = document.find("vocabulary");
  const std::optional<Vocabulary> named = vocabulary != document.end() && vocabulary->is_string()
                                              ? FromName<Vocabulary>(vocabulary->get<std::string>())
                                              : std::nullopt;
  if (named) {
    legend.vocabulary = *named;
  } else {
    violations.push_back({"unknown_vocabulary", "/vocabulary",
                          "must be one of " + LegalNames<Vocabulary>(),
                          vocabulary == document.end() ? "" : Quote(vocabulary->dump())});
  }
  // Pixels mean classes by value or by colour, not both.
  if (document.contains("values") == document.contains("colors")) {
    violations.push_back({"missing_key", "/values", "needs values or colors, one of them", ""});
  } else if (named) {
    const bool by_value = document.contains("values");
    ReadEntries(document.at(by_value ? "values" : "colors"), by_value, &legend, &violations);
  }
  LW_RETURN_IF_ERROR(Status::FromViolations(what, std::move(violations)));
  return legend;
}

Result<Grid<char>> ReadClassPicture(std::string_view bytes, const PictureLegend& legend,
                                    const std::string& what) {
  Result<Grid<internal::Rgb>> picture = internal::ReadColourPicture(bytes, "segmentation");
  if (!picture.ok()) return DataLoss(what + ": " + picture.status().message());
  std::map<std::uint32_t, char> letters;
  for (const PictureLegend::Entry& entry : legend.entries) {
    letters[KeyOf(entry.color.r, entry.color.g, entry.color.b)] = entry.letter;
  }

  Grid<char> mask(picture->rows(), picture->cols(), kNoData);
  std::map<std::uint32_t, Foreign> foreign;
  // Neighbours are mostly alike.
  std::uint32_t last_key = 0;
  char last_letter = kNoData;
  bool last_known = false;
  for (int r = 0; r < mask.rows(); ++r) {
    for (int c = 0; c < mask.cols(); ++c) {
      const internal::Rgb& pixel = (*picture)(r, c);
      const std::uint32_t key = KeyOf(pixel[0], pixel[1], pixel[2]);
      if (!last_known || key != last_key) {
        const auto found = letters.find(key);
        last_known = found != letters.end();
        if (!last_known) {
          Foreign& entry = foreign.try_emplace(key, Foreign{{r, c}, 0}).first->second;
          ++entry.pixels;
          continue;
        }
        last_key = key;
        last_letter = found->second;
      }
      mask(r, c) = last_letter;
    }
  }
  if (!foreign.empty()) return ForeignColours(foreign, mask, legend, what);
  return mask;
}

}  // namespace latticeworld
