#ifndef LATTICEWORLD_ENVIRONMENT_RULE_BOOK_H_
#define LATTICEWORLD_ENVIRONMENT_RULE_BOOK_H_

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/environment/rules.h"

namespace latticeworld {

// Coarse attributes for which a rule holds: sets of values, by bit.
struct RuleCondition {
  std::uint32_t terrain_types = ~0u;
  std::uint32_t seasons = ~0u;
  std::uint32_t weathers = ~0u;
  std::uint32_t times_of_day = ~0u;

  bool Holds(const CoarseAttributes& coarse) const;
};

// Which values of a type are meant: those of the words, of more snow, or out of their season.
struct ValueSelector {
  std::string words;  // whole words of the value's name; "": any
  std::optional<double> snow_above;
  bool out_of_season = false;
};

struct WordWeight {
  std::string words;
  double times = 1.0;
};

struct ValuesEffect {
  std::vector<ValueSelector> exclude;
  std::vector<WordWeight> weights;
};

struct NumberEffect {
  std::optional<double> min, max, typical;
  double factor = 1.0;  // of what was typical before
  std::optional<std::array<double, 2>> draw;
  std::optional<bool> evenly;
};

struct RuleEffect {
  std::vector<AssetType> types;
  ValuesEffect season_variants;
  ValuesEffect materials;
  std::array<std::optional<NumberEffect>, kFineParameterCount> numbers;
};

struct Rule {
  RuleLabel label;
  std::vector<RuleCondition> when;  // one of them must hold
  std::vector<RuleEffect> then;

  bool Holds(const CoarseAttributes& coarse) const;
};

// The rules in their order: later ones narrow what earlier ones left. Whatever the rules and the
// catalogue are, something stays legal: an exclusion that would leave nothing is not applied, and a
// limit beyond the opposite one stops at it.
class RuleBook {
 public:
  // The one that is compiled in.
  static const RuleBook& BuiltIn();
  // Reads a rule file (schema: RuleSchema()). Errors: INVALID_ARGUMENT with every violation at
  // once: parse_error, duplicate_key and what the schema forbids, else duplicate_name,
  // unknown_value (words that no value of the built-in catalogue has) and out_of_range.
  static Result<RuleBook> Parse(std::string_view json);

  explicit RuleBook(std::vector<Rule> rules) : rules_(std::move(rules)) {}

  const std::vector<Rule>& rules() const { return rules_; }
  // Labels of the answer point into this.
  FineBounds BoundsOf(const CoarseAttributes& coarse, AssetType type,
                      const Catalogue& catalogue) const;

 private:
  std::vector<Rule> rules_;
};

// Whether `words` stand in `name` as whole words, one after another.
bool HasWords(std::string_view name, std::string_view words);

// The rule file that is compiled in, and the JSON Schema (draft 7) that rule files obey.
std::string_view RuleText();
std::string_view RuleSchema();

}  // namespace latticeworld

#endif  // LATTICEWORLD_ENVIRONMENT_RULE_BOOK_H_
