#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_WORD_TABLES_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_WORD_TABLES_H_

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/common/enum_names.h"
#include "latticeworld/common/result.h"
#include "latticeworld/environment/environment_claims.h"
#include "latticeworld/language/grounded/environment/phrase_index.h"

namespace latticeworld {

// The words of environment instructions, from the files language/data/environment_*.txt; each
// file's header says what its columns mean.

struct CoarseWord {
  CoarseKey key = CoarseKey::kTerrainType;
  std::string value;
  bool hints = false;  // counts only where nothing is said outright
};

// A set of agent categories under one name; the usual one is first.
struct AgentKind {
  std::string name;
  std::vector<AgentCategory> categories;
};

struct SpeciesWord {
  std::vector<AgentCategory> categories;  // several: a kind, what it does decides
  bool exact = true;                      // false: only the nearest category
  bool plural = false;
  bool singular = false;  // both for "sheep"
};

struct StateWord {
  AgentState state = AgentState::kIdle;
};

struct AssetWord {
  AssetType asset = AssetType::kGrass;
};

struct DensityWord {
  double least = 0.0;
  double value = 0.0;
  double most = 0.0;
};

struct VariantWord {
  AssetType asset = AssetType::kGrass;
  VariantKey key = VariantKey::kSeasonVariant;
  std::vector<std::string> values;
  bool alone = true;  // false: only with a noun of the asset type
};

struct ParameterWord {
  AssetType asset = AssetType::kGrass;
  ParameterKey key = ParameterKey::kRotationYaw;
  double least = 0.0;
  double value = 0.0;
  double most = 0.0;
  bool alone = true;
};

struct QuantityWord {
  int least = 1;
  int value = 1;
  int most = 1;
  bool group = false;  // "a flock of"
};

// A kind of land that agents can be at.
struct FeatureWord {
  std::string name;
  std::string suburb;  // letters; empty: the vocabulary has no such land
  std::string wild;
};

enum class Role : std::uint8_t {
  kFunction,
  kIgnored,
  kNot,
  kBut,
  kCorrection,
  kThey,
  kOthers,
  kHalf,
  kOfThem,
  kSomeOfThem,
  kMore,
  kAtLeast,
  kAtMost,
  kMoreThan,
  kFewerThan,
  kAbout,
  kExactly,
  kBetween,
  kNear,
  kIn,
  kFacing,
  kAfterSpecies,
  kBeforeSpecies,
  kNobody,
  kUnwanted
};
constexpr std::array<EnumName<Role>, 25> EnumNames(Role) {
  return {{{Role::kFunction, "function"},
           {Role::kIgnored, "ignored"},
           {Role::kNot, "not"},
           {Role::kBut, "but"},
           {Role::kCorrection, "correction"},
           {Role::kThey, "they"},
           {Role::kOthers, "others"},
           {Role::kHalf, "half"},
           {Role::kOfThem, "of_them"},
           {Role::kSomeOfThem, "some_of_them"},
           {Role::kMore, "more"},
           {Role::kAtLeast, "at_least"},
           {Role::kAtMost, "at_most"},
           {Role::kMoreThan, "more_than"},
           {Role::kFewerThan, "fewer_than"},
           {Role::kAbout, "about"},
           {Role::kExactly, "exactly"},
           {Role::kBetween, "between"},
           {Role::kNear, "near"},
           {Role::kIn, "in"},
           {Role::kFacing, "facing"},
           {Role::kAfterSpecies, "after_species"},
           {Role::kBeforeSpecies, "before_species"},
           {Role::kNobody, "nobody"},
           {Role::kUnwanted, "unwanted"}}};
}

// Rows, and the phrases that lead to them.
template <typename Row>
struct WordTable {
  std::vector<Row> rows;
  PhraseIndex index;

  struct Match {
    std::vector<const Row*> rows;
    std::size_t tokens = 0;  // 0: no phrase starts here
  };
  Match At(const std::vector<Token>& tokens, std::size_t at) const {
    const PhraseIndex::Match found = index.At(tokens, at);
    Match match;
    match.tokens = found.tokens;
    if (found.rows == nullptr) return match;
    for (const int row : *found.rows) match.rows.push_back(&rows[static_cast<std::size_t>(row)]);
    return match;
  }
  // Returns how many tokens match, without the rows.
  std::size_t LengthAt(const std::vector<Token>& tokens, std::size_t at) const {
    return index.At(tokens, at).tokens;
  }
};

struct EnvironmentWords {
  WordTable<CoarseWord> coarse;
  WordTable<AgentKind> kinds;
  WordTable<SpeciesWord> species;
  WordTable<StateWord> states;
  WordTable<AssetWord> assets;
  WordTable<DensityWord> densities;
  WordTable<VariantWord> variants;
  WordTable<ParameterWord> parameters;
  WordTable<QuantityWord> quantities;
  WordTable<FeatureWord> features;
  // One index a role: a phrase of one role does not hide a shorter one of another.
  std::array<PhraseIndex, EnumNames(Role{}).size()> roles;

  // How many tokens a phrase of the role takes; 0 when none starts here.
  std::size_t RoleAt(Role role, const std::vector<Token>& tokens, std::size_t at) const {
    return roles[static_cast<std::size_t>(role)].At(tokens, at).tokens;
  }
};

// Reads the tables out of the files' texts, found by name. Errors: INVALID_ARGUMENT with every bad
// line, each with its file and number.
Result<EnvironmentWords> ReadEnvironmentWords(std::string_view (*text_of)(std::string_view file));

// The ones that are compiled in.
const EnvironmentWords& GetEnvironmentWords();

// Every word of every phrase, sorted, each once: what counts as known when spelling is judged.
std::vector<std::string> AllWords(const EnvironmentWords& words);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_WORD_TABLES_H_
