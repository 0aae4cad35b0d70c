#include "latticeworld/language/reading/text_units.h"

#include <algorithm>
#include <array>

#include "latticeworld/common/text.h"
#include "latticeworld/language/class_words.h"
#include "latticeworld/language/grounded/environment/word_tables.h"
#include "latticeworld/language/numbers.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/tokens.h"

namespace latticeworld {
namespace {

// "wandering", "wandered", "wanders": "wander". Only has to be the same for the same word.
std::string StemOf(std::string_view word) {
  std::string stem = Singular(word);
  for (const std::string_view ending : {"ing", "ed", "ly", "ern", "er", "e", "y"}) {
    if (stem.size() < ending.size() + 3 || !EndsWith(stem, ending)) continue;
    stem.resize(stem.size() - ending.size());
    break;
  }
  return stem;
}

// Takes the units from the tokens one after the other.
class UnitTaker {
 public:
  UnitTaker(const std::vector<Token>& tokens, SentenceKind kind, Vocabulary vocabulary)
      : tokens_(tokens), kind_(kind), vocabulary_(vocabulary) {}

  std::vector<TextUnit> Take() {
    while (at_ < tokens_.size()) {
      std::size_t taken = TakeNumber();
      if (taken == 0) taken = TakeSide();
      if (taken == 0) taken = TakeNoun();
      if (taken == 0 && kind_ == SentenceKind::kEnvironment) taken = TakeOfEnvironment();
      if (taken == 0) taken = TakeWord();
      at_ += std::max<std::size_t>(1, taken);
    }
    return std::move(units_);
  }

 private:
  TextUnit& Add(std::size_t tokens) {
    TextUnit unit;
    unit.begin = tokens_[at_].begin;
    unit.end = tokens_[at_ + tokens - 1].end;
    units_.push_back(std::move(unit));
    return units_.back();
  }

  bool IsNoun(std::size_t at) const {
    if (at >= tokens_.size()) return false;
    if (kind_ == SentenceKind::kLayout) return MatchClassWord(tokens_, at).word != nullptr;
    return GetEnvironmentWords().species.LengthAt(tokens_, at) > 0;
  }

  // "two thirds" counts nothing.
  bool IsPartOfShare(std::size_t at) const {
    if (at >= tokens_.size()) return false;
    const std::string part = Singular(tokens_[at].text);
    const std::string_view parts[] = {"half",    "third",  "quarter", "fifth",   "sixth",
                                      "seventh", "eighth", "ninth",   "tenth",   "percent",
                                      "%",       "cell",   "step",    "per cent"};
    return std::find(std::begin(parts), std::end(parts), part) != std::end(parts);
  }

  // Whether one of the next three words is a noun, before a pause.
  bool IsBeforeNoun(std::size_t at) const {
    for (std::size_t i = at; i < std::min(at + 3, tokens_.size()); ++i) {
      if (tokens_[i].kind == TokenKind::kStop || tokens_[i].kind == TokenKind::kComma) return false;
      if (IsNoun(i)) return true;
    }
    return false;
  }

  // A number is known to count something where a noun follows within three words.
  std::size_t TakeNumber() {
    const NumberMatch match = MatchNumber(tokens_, at_);
    if (match.tokens == 0) return 0;
    TextUnit& unit = Add(match.tokens);
    unit.keys.push_back("number " + std::to_string(match.value));
    const std::size_t after = at_ + match.tokens;
    unit.known = match.value > 1 && !IsPartOfShare(after) && IsBeforeNoun(after);
    return match.tokens;
  }

  std::size_t TakeSide() {
    PlaceCursor cursor(tokens_, at_);
    const Direction direction = TakeDirection(&cursor);
    if (!direction.found || cursor.at() == at_) return 0;
    const std::size_t taken = cursor.at() - at_;
    TextUnit& unit = Add(taken);
    // "n" may be a typing mistake, and "mid" be of July.
    unit.known = unit.end - unit.begin > 1 && (taken > 1 || tokens_[at_].text != "mid");
    const auto [east, south] = direction.heading;
    if (east != 0) unit.keys.emplace_back(east > 0 ? "side east" : "side west");
    if (south != 0) unit.keys.emplace_back(south > 0 ? "side south" : "side north");
    const bool middle =
        std::any_of(tokens_.begin() + at_, tokens_.begin() + at_ + taken,
                    [](const Token& token) { return StartsWith(token.text, "mid"); });
    if (unit.keys.empty() || middle) unit.keys.emplace_back("side center");
    return taken;
  }

  std::size_t TakeNoun() {
    const ClassWordMatch match = MatchClassWord(tokens_, at_);
    if (match.word == nullptr) return 0;
    const char letter = match.word->LetterIn(vocabulary_);
    TextUnit& unit = Add(match.tokens);
    unit.keys.push_back("noun " + std::string(match.word->phrase));
    if (letter != '\0') unit.keys.push_back("land " + std::string(1, letter));
    unit.known =
        kind_ == SentenceKind::kLayout && letter != '\0' && match.word->IsExactIn(vocabulary_);
    return match.tokens;
  }

  std::size_t TakeOfEnvironment() {
    const EnvironmentWords& words = GetEnvironmentWords();
    std::size_t longest = 0;
    std::vector<std::string> keys;
    // The tables with the longest match give the unit's keys.
    const auto offer = [&](std::size_t tokens, std::vector<std::string> found) {
      if (tokens == 0 || tokens < longest) return false;
      if (tokens > longest) keys.clear();
      longest = tokens;
      for (std::string& key : found) keys.push_back(std::move(key));
      return true;
    };
    bool who = false;
    // Species are asked first; `who` stays only if nothing longer is found.
    const auto species = words.species.At(tokens_, at_);
    std::vector<std::string> found;
    for (const SpeciesWord* row : species.rows) {
      for (const AgentCategory category : row->categories) {
        found.push_back("who " + std::string(NameOf(category)));
      }
    }
    who = offer(species.tokens, std::move(found));
    const auto states = words.states.At(tokens_, at_);
    found.clear();
    for (const StateWord* row : states.rows)
      found.push_back("state " + std::string(NameOf(row->state)));
    if (offer(states.tokens, std::move(found)) && states.tokens > species.tokens) who = false;
    const auto coarse = words.coarse.At(tokens_, at_);
    found.clear();
    for (const CoarseWord* row : coarse.rows) found.push_back("value " + row->value);
    if (offer(coarse.tokens, std::move(found)) && coarse.tokens > species.tokens) who = false;
    const auto variants = words.variants.At(tokens_, at_);
    found.clear();
    for (const VariantWord* row : variants.rows) {
      for (const std::string& value : row->values) found.push_back("value " + value);
    }
    if (offer(variants.tokens, std::move(found)) && variants.tokens > species.tokens) who = false;
    // The words themselves are keys as well, by their stems.
    if (longest == 0) return 0;
    for (std::size_t i = 0; i < longest; ++i) {
      if (tokens_[at_ + i].text.size() > 3) keys.push_back("word " + StemOf(tokens_[at_ + i].text));
    }
    TextUnit& unit = Add(longest);
    unit.keys = std::move(keys);
    unit.known = who;
    return longest;
  }

  // Any other word says something unless it is one that only holds a text together.
  std::size_t TakeWord() {
    const Token& token = tokens_[at_];
    if (token.kind != TokenKind::kWord) return 1;
    const EnvironmentWords& words = GetEnvironmentWords();
    for (const Role role :
         {Role::kFunction, Role::kNear, Role::kIn, Role::kBut, Role::kThey, Role::kAtLeast,
          Role::kAtMost, Role::kAbout, Role::kExactly, Role::kBetween, Role::kMore, Role::kNot}) {
      if (const std::size_t taken = words.RoleAt(role, tokens_, at_)) return taken;
    }
    if (token.text.size() < 3 || IsMapWord(token.text)) return 1;
    Add(1).keys.push_back("word " + StemOf(token.text));
    return 1;
  }

  const std::vector<Token>& tokens_;
  const SentenceKind kind_;
  const Vocabulary vocabulary_;
  std::size_t at_ = 0;
  std::vector<TextUnit> units_;
};

}  // namespace

std::vector<TextUnit> UnitsOf(std::string_view text, SentenceKind kind, Vocabulary vocabulary) {
  const std::vector<Token> tokens = Tokenize(text);
  return UnitTaker(tokens, kind, vocabulary).Take();
}

std::set<std::string> KeysOf(const std::vector<std::string>& sentences, SentenceKind kind,
                             Vocabulary vocabulary) {
  std::set<std::string> keys;
  for (const std::string& sentence : sentences) {
    for (TextUnit& unit : UnitsOf(sentence, kind, vocabulary)) {
      for (std::string& key : unit.keys) keys.insert(std::move(key));
    }
  }
  return keys;
}

bool IsCarried(const TextUnit& unit, const std::set<std::string>& keys) {
  return std::any_of(unit.keys.begin(), unit.keys.end(),
                     [&keys](const std::string& key) { return keys.count(key) > 0; });
}

}  // namespace latticeworld
