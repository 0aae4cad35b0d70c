#include "latticeworld/language/grounded/environment/attributes/added_values.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include "latticeworld/environment/rule_book.h"
#include "latticeworld/language/grounded/environment/inflection.h"
#include "latticeworld/language/tokens.h"

namespace latticeworld {
namespace {

// Shorter ones are function words ("a", "in"), with a noun beside them in any text.
constexpr std::size_t kMinNameLength = 3;

bool Has(const std::vector<std::string_view>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// "autumn larch": "larch"; a name that begins with no season has no rest.
std::string_view RestOf(std::string_view name) {
  const std::size_t space = name.find(' ');
  if (space == name.npos || !FromName<Season>(name.substr(0, space))) return {};
  return name.substr(space + 1);
}

// What variants are known by together, and which those are.
std::map<std::string, std::vector<std::string>> CommonNames(const Catalogue& catalogue,
                                                            AssetType type) {
  std::vector<std::string_view> built_in_models;
  for (const AssetModel& model : Catalogue::BuiltIn()->models()) {
    built_in_models.push_back(model.name);
  }
  std::map<std::string, std::vector<std::string>> common;
  for (const SeasonVariant& variant : catalogue.season_variants(type)) {
    std::set<std::string> names;
    if (const std::string_view rest = RestOf(variant.name); !rest.empty()) names.emplace(rest);
    for (const std::uint8_t index : variant.models) {
      const AssetModel& model = catalogue.models()[index];
      if (!Has(built_in_models, model.name)) names.insert(model.name);
    }
    for (const std::string& name : names) common[name].push_back(variant.name);
  }
  return common;
}

class Collector {
 public:
  Collector() : words_(GetEnvironmentWords()) {
    for (std::string& word : AllWords(words_)) told_.insert(std::move(word));
  }

  // Shorter names first: phrases of a longer one are its own.
  void AddNames(AssetType type, VariantKey key, std::vector<std::string_view> values,
                const std::vector<std::string_view>& built_in) {
    std::stable_sort(values.begin(), values.end(),
                     [](std::string_view a, std::string_view b) { return a.size() < b.size(); });
    for (const std::string_view value : values) {
      if (!Has(built_in, value)) AddPhrases(value, {type, key, {std::string(value)}, true});
    }
  }

  // "autumn" said of the forest stands for every autumn variant: added ones that are seen in autumn
  // are among them.
  void AddToSeasons(AssetType type, const Catalogue& catalogue) {
    const std::vector<std::string_view>& built_in = ValuesOf(type).season_variants;
    for (const auto& season : EnumNames(Season{})) {
      std::vector<std::string> of_season;
      for (const std::string_view name : built_in) {
        if (HasWords(name, season.name)) of_season.emplace_back(name);
      }
      if (of_season.empty()) continue;
      for (VariantWord& row : words_.variants.rows) {
        if (row.asset != type || row.key != VariantKey::kSeasonVariant || row.values != of_season) {
          continue;
        }
        for (const SeasonVariant& variant : catalogue.season_variants(type)) {
          if (variant.seasons[static_cast<std::size_t>(season.value)] &&
              !Has(built_in, variant.name)) {
            row.values.push_back(variant.name);
          }
        }
      }
    }
  }

  void AddCommonNames(AssetType type, const Catalogue& catalogue) {
    const std::vector<std::string_view>& built_in = ValuesOf(type).season_variants;
    for (const auto& [name, values] : CommonNames(catalogue, type)) {
      if (std::all_of(values.begin(), values.end(),
                      [&](const std::string& value) { return Has(built_in, value); })) {
        continue;
      }
      VariantWord word{type, VariantKey::kSeasonVariant, values, true};
      if (!Join(name, word)) AddPhrases(name, std::move(word));
    }
  }

  AddedValueWords Take() {
    AddedValueWords added;
    if (known_.empty()) return added;
    added.words = std::move(words_);
    added.known = std::move(known_);
    return added;
  }

 private:
  // If the tables already know values of that name, adds the word's values to theirs: "oak" joins
  // "summer oak" and "winter oak". False: they know none.
  bool Join(std::string_view name, const VariantWord& word) {
    const std::vector<int>* rows = words_.variants.index.RowsOf(name);
    if (rows == nullptr) return false;
    for (const int number : *rows) {
      VariantWord& row = words_.variants.rows[static_cast<std::size_t>(number)];
      const bool of_name =
          std::any_of(row.values.begin(), row.values.end(),
                      [&](const std::string& value) { return HasWords(value, name); });
      if (!IsSameProperty(row, word) || !of_name) continue;
      for (const std::string& value : word.values) {
        if (!Has({row.values.begin(), row.values.end()}, value)) row.values.push_back(value);
      }
      return true;
    }
    return false;
  }

  // Phrases with the name in them that stood for something like it ("larch forest" for pines) stand
  // for it from now on.
  void AddPhrases(std::string_view name, VariantWord word) {
    if (name.size() < kMinNameLength) {
      known_.emplace(name);
      return;
    }
    word.alone =
        name.find(' ') != name.npos || told_.count(std::string(name)) == 0 || IsAlone(name, word);
    const int row = static_cast<int>(words_.variants.rows.size());
    words_.variants.rows.push_back(std::move(word));
    for (const std::string& form : {std::string(name), PluralOf(name)}) {
      for (const std::string_view phrase : words_.variants.index.Phrases()) {
        if (HasWords(phrase, form)) Retarget(phrase, row);
      }
      words_.variants.index.Add(form, row);
      for (const Token& token : Tokenize(form)) known_.insert(token.text);
    }
  }

  // Whether the name says something of the property by itself already.
  bool IsAlone(std::string_view name, const VariantWord& word) {
    const std::vector<int>* rows = words_.variants.index.RowsOf(name);
    return rows != nullptr && std::any_of(rows->begin(), rows->end(), [&](int number) {
             const VariantWord& row = words_.variants.rows[static_cast<std::size_t>(number)];
             return row.alone && IsSameProperty(row, word);
           });
  }

  void Retarget(std::string_view phrase, int row) {
    const VariantWord& word = words_.variants.rows[static_cast<std::size_t>(row)];
    for (int& number : *words_.variants.index.RowsOf(phrase)) {
      const VariantWord& other = words_.variants.rows[static_cast<std::size_t>(number)];
      if (IsSameProperty(other, word)) number = row;
    }
  }

  static bool IsSameProperty(const VariantWord& a, const VariantWord& b) {
    return a.asset == b.asset && a.key == b.key;
  }

  EnvironmentWords words_;
  std::set<std::string> told_;
  std::set<std::string> known_;
};

}  // namespace

AddedValueWords AddedValueWordsOf(const Catalogue& catalogue) {
  // Copying the tables costs milliseconds: not for nothing.
  if (&catalogue == Catalogue::BuiltIn().get()) return {};
  Collector collector;
  for (const auto& entry : EnumNames(AssetType{})) {
    const AssetTypeValues& all = catalogue.ValuesOf(entry.value);
    const AssetTypeValues& built_in = ValuesOf(entry.value);
    collector.AddToSeasons(entry.value, catalogue);
    collector.AddCommonNames(entry.value, catalogue);
    collector.AddNames(entry.value, VariantKey::kSeasonVariant, all.season_variants,
                       built_in.season_variants);
    collector.AddNames(entry.value, VariantKey::kMaterial, all.materials, built_in.materials);
  }
  return collector.Take();
}

}  // namespace latticeworld
