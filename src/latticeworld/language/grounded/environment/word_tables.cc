#include "latticeworld/language/grounded/environment/word_tables.h"

#include <algorithm>
#include <charconv>
#include <set>

#include "latticeworld/common/check.h"
#include "latticeworld/common/text.h"
#include "latticeworld/environment/ranges.h"
#include "latticeworld/language/grounded/environment/inflection.h"
#include "latticeworld/layout/vocabulary.h"

namespace latticeworld {

std::string_view EnvironmentWordFile(std::string_view file_name);  // generated

namespace {

std::string_view Trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

// The columns of one line, and what is wrong with them.
class Line {
 public:
  Line(std::string_view file, int number, std::string_view text, std::vector<Violation>* violations)
      : place_(std::string(file) + ":" + std::to_string(number)),
        columns_(Split(text, '\t')),
        violations_(violations) {}

  bool HasColumns(std::size_t count) {
    if (columns_.size() == count) return true;
    Wrong("has " + std::to_string(columns_.size()) + " columns, not " + std::to_string(count));
    return false;
  }
  const std::string& Text(std::size_t column) const { return columns_[column]; }

  template <typename Enum>
  Enum Name(std::size_t column) {
    const auto value = FromName<Enum>(columns_[column]);
    if (!value) Wrong(Quote(columns_[column]) + " is not one of " + LegalNames<Enum>());
    return value.value_or(Enum{});
  }

  double Number(std::size_t column) {
    const std::string& text = columns_[column];
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) {
      Wrong(Quote(text) + " is not a number");
    }
    return value;
  }

  // Whether the column is `yes`; anything but `no` otherwise is wrong.
  bool Choice(std::size_t column, std::string_view yes, std::string_view no) {
    const std::string& text = columns_[column];
    if (text != yes && text != no) {
      Wrong(Quote(text) + " is neither " + std::string(yes) + " nor " + std::string(no));
    }
    return text == yes;
  }

  std::vector<std::string> List(std::size_t column, char separator) {
    std::vector<std::string> parts;
    for (const std::string& part : Split(columns_[column], separator)) {
      const std::string_view trimmed = Trimmed(part);
      if (trimmed.empty()) {
        Wrong("has an empty entry in column " + std::to_string(column + 1));
      } else {
        parts.emplace_back(trimmed);
      }
    }
    return parts;
  }

  void Wrong(std::string message) {
    violations_->push_back({"bad_line", place_, std::move(message), ""});
  }
  std::size_t Flaws() const { return violations_->size(); }

  // Values in order and within what is legal.
  void CheckOrder(double least, double value, double most, const Range& legal) {
    if (!(least <= value && value <= most)) Wrong("least, value and most are not in order");
    if (!(least >= legal.low && most <= legal.high)) Wrong("exceeds the legal range");
  }

 private:
  std::string place_;
  std::vector<std::string> columns_;
  std::vector<Violation>* violations_;
};

class TableReader {
 public:
  TableReader(std::string_view (*text_of)(std::string_view), EnvironmentWords* words,
              std::vector<Violation>* violations)
      : text_of_(text_of), words_(words), violations_(violations) {}

  void ReadAll() {
    ForEachLine("environment_kinds.txt", 3, [&](Line& line) { ReadKind(line); });
    ForEachLine("environment_species.txt", 3, [&](Line& line) { ReadSpecies(line); });
    ForEachLine("environment_coarse.txt", 4, [&](Line& line) { ReadCoarse(line); });
    ForEachLine("environment_states.txt", 3, [&](Line& line) { ReadState(line); });
    ForEachLine("environment_assets.txt", 2, [&](Line& line) {
      AddRow({line.Name<AssetType>(0)}, line.List(1, ','), &words_->assets);
    });
    ForEachLine("environment_densities.txt", 4, [&](Line& line) {
      const DensityWord word{line.Number(0), line.Number(1), line.Number(2)};
      line.CheckOrder(word.least, word.value, word.most, kDensityRange);
      AddRow(word, line.List(3, ','), &words_->densities);
    });
    ForEachLine("environment_variants.txt", 5, [&](Line& line) { ReadVariant(line); });
    ForEachLine("environment_parameters.txt", 7, [&](Line& line) { ReadParameter(line); });
    ForEachLine("environment_quantities.txt", 5, [&](Line& line) { ReadQuantity(line); });
    ForEachLine("environment_features.txt", 4, [&](Line& line) { ReadFeature(line); });
    ForEachLine("environment_small_words.txt", 2, [&](Line& line) {
      const auto role = static_cast<std::size_t>(line.Name<Role>(0));
      for (const std::string& phrase : line.List(1, ',')) words_->roles[role].Add(phrase, 0);
    });
  }

 private:
  template <typename ReadLine>
  void ForEachLine(std::string_view file, std::size_t columns, const ReadLine& read) {
    const std::string_view text = text_of_(file);
    if (text.empty()) violations_->push_back({"missing_file", std::string(file), "is empty", ""});
    int number = 0;
    for (const std::string& one : Split(text, '\n')) {
      ++number;
      if (one.empty() || one.front() == '#') continue;
      Line line(file, number, one, violations_);
      if (line.HasColumns(columns)) read(line);
    }
  }

  template <typename Row>
  void AddRow(Row row, const std::vector<std::string>& phrases, WordTable<Row>* table) {
    const int number = static_cast<int>(table->rows.size());
    table->rows.push_back(std::move(row));
    for (const std::string& phrase : phrases) table->index.Add(phrase, number);
  }

  void ReadKind(Line& line) {
    AgentKind kind;
    kind.name = line.Text(0);
    for (const std::string& name : line.List(1, ',')) {
      if (const auto category = FromName<AgentCategory>(name)) {
        kind.categories.push_back(*category);
      } else {
        line.Wrong(Quote(name) + " is not one of " + LegalNames<AgentCategory>());
      }
    }
    AddRow(std::move(kind), line.List(2, ','), &words_->kinds);
  }

  std::vector<AgentCategory> CategoriesOf(Line& line) {
    constexpr std::string_view kAny = "any ";
    const std::string& name = line.Text(0);
    if (name.compare(0, kAny.size(), kAny) != 0) return {line.Name<AgentCategory>(0)};
    for (const AgentKind& kind : words_->kinds.rows) {
      if (kind.name == name.substr(kAny.size())) return kind.categories;
    }
    line.Wrong(Quote(name) + " is no kind of environment_kinds.txt");
    return {AgentCategory::kSheep};
  }

  void ReadSpecies(Line& line) {
    SpeciesWord word;
    word.categories = CategoriesOf(line);
    word.exact = line.Choice(1, "exact", "near");
    std::vector<std::string> singulars, plurals, both;
    for (const std::string& entry : line.List(2, ',')) {
      const std::vector<std::string> forms = Split(entry, '/');
      if (forms.size() == 2 && forms[0] == forms[1]) {
        both.push_back(forms[0]);
      } else {
        singulars.push_back(forms[0]);
        plurals.push_back(forms.size() > 1 ? forms[1] : PluralOf(forms[0]));
      }
    }
    word.singular = true;
    AddRow(word, singulars, &words_->species);
    word.plural = true;
    AddRow(word, both, &words_->species);
    word.singular = false;
    AddRow(word, plurals, &words_->species);
  }

  void ReadCoarse(Line& line) {
    EnvironmentClaim claim;
    claim.coarse_key = line.Name<CoarseKey>(0);
    claim.values = {line.Text(1)};
    for (const Violation& violation : Validate(claim)) line.Wrong(violation.message);
    AddRow({claim.coarse_key, line.Text(1), line.Choice(2, "hints", "says")}, line.List(3, ','),
           &words_->coarse);
  }

  void ReadState(Line& line) {
    const StateWord word{line.Name<AgentState>(0)};
    std::vector<std::string> phrases = line.List(2, ',');
    if (line.Choice(1, "verb", "fixed")) {
      std::vector<std::string> forms;
      for (const std::string& verb : phrases) {
        for (std::string& form : FormsOf(verb)) forms.push_back(std::move(form));
      }
      phrases = std::move(forms);
    }
    AddRow(word, phrases, &words_->states);
  }

  void ReadVariant(Line& line) {
    EnvironmentClaim claim;
    claim.kind = EnvironmentClaimKind::kVariant;
    claim.asset = line.Name<AssetType>(0);
    claim.variant_key = line.Name<VariantKey>(1);
    claim.values = line.List(2, '|');
    for (const Violation& violation : Validate(claim)) line.Wrong(violation.message);
    AddRow({claim.asset, claim.variant_key, claim.values, line.Choice(3, "alone", "with")},
           line.List(4, ','), &words_->variants);
  }

  void ReadParameter(Line& line) {
    EnvironmentClaim claim;
    claim.kind = EnvironmentClaimKind::kParameter;
    claim.asset = line.Name<AssetType>(0);
    claim.parameter_key = line.Name<ParameterKey>(1);
    claim.least = line.Number(2);
    claim.most = line.Number(4);
    for (const Violation& violation : Validate(claim)) line.Wrong(violation.message);
    AddRow({claim.asset, claim.parameter_key, claim.least, line.Number(3), claim.most,
            line.Choice(5, "alone", "with")},
           line.List(6, ','), &words_->parameters);
  }

  void ReadQuantity(Line& line) {
    const QuantityWord word{static_cast<int>(line.Number(0)), static_cast<int>(line.Number(1)),
                            static_cast<int>(line.Number(2)), line.Choice(3, "group", "plain")};
    line.CheckOrder(word.least, word.value, word.most, {1, kMaxAgents});
    AddRow(word, line.List(4, ','), &words_->quantities);
  }

  void ReadFeature(Line& line) {
    const FeatureWord word{line.Text(0), line.Text(1), line.Text(2)};
    for (const char letter : word.suburb) {
      if (letter != '&' && FindClass(Vocabulary::kSuburb, letter) == nullptr)
        line.Wrong("is no suburb letter");
    }
    for (const char letter : word.wild) {
      if (letter != '&' && FindClass(Vocabulary::kWild, letter) == nullptr)
        line.Wrong("is no wild letter");
    }
    AddRow(word, line.List(3, ','), &words_->features);
  }

  std::string_view (*text_of_)(std::string_view);
  EnvironmentWords* words_;
  std::vector<Violation>* violations_;
};

}  // namespace

Result<EnvironmentWords> ReadEnvironmentWords(std::string_view (*text_of)(std::string_view file)) {
  EnvironmentWords words;
  std::vector<Violation> violations;
  TableReader(text_of, &words, &violations).ReadAll();
  if (!violations.empty()) {
    return Status::FromViolations("illegal word tables", std::move(violations));
  }
  return words;
}

const EnvironmentWords& GetEnvironmentWords() {
  static const EnvironmentWords words = [] {
    Result<EnvironmentWords> read = ReadEnvironmentWords(&EnvironmentWordFile);
    LW_CHECK(read.ok(), "the word tables that are compiled in must be legal");
    return std::move(read).value();
  }();
  return words;
}

std::vector<std::string> AllWords(const EnvironmentWords& words) {
  std::set<std::string> all;
  const auto add = [&](const PhraseIndex& index) {
    for (const std::string_view phrase : index.Phrases()) {
      for (std::string& word : Split(phrase, ' ')) all.insert(std::move(word));
    }
  };
  add(words.coarse.index);
  add(words.kinds.index);
  add(words.species.index);
  add(words.states.index);
  add(words.assets.index);
  add(words.densities.index);
  add(words.variants.index);
  add(words.parameters.index);
  add(words.quantities.index);
  add(words.features.index);
  for (const PhraseIndex& index : words.roles) add(index);
  return {all.begin(), all.end()};
}

}  // namespace latticeworld
