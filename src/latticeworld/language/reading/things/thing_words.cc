#include "latticeworld/language/reading/things/thing_words.h"

#include <algorithm>
#include <iterator>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/numbers.h"
#include "latticeworld/language/reading/sentence_places.h"
#include "latticeworld/language/reading/things/laid_as_houses.h"

namespace latticeworld {
namespace {

constexpr ThingWords::Arrangement kArrangements[] = {
    {"row", ThingArrangement::kRow, 5},       {"line", ThingArrangement::kRow, 5},
    {"ring", ThingArrangement::kRing, 6},     {"circle", ThingArrangement::kRing, 6},
    {"grid", ThingArrangement::kGrid, 9},     {"cluster", ThingArrangement::kCluster, 5},
    {"group", ThingArrangement::kCluster, 5}, {"pair", ThingArrangement::kPair, 2}};

// Words that may follow a noun that stands by itself.
constexpr std::string_view kFollowers[] = {
    "in",      "on",     "at",       "by",        "near",     "beside", "next",   "along",
    "around",  "and",    "with",     "is",        "are",      "stand",  "stands", "form",
    "forms",   "every",  "spaced",   "that",      "behind",   "facing", "close",  "lie",
    "lies",    "placed", "arranged", "line",      "lines",    "from",   "to",     "surrounding",
    "between", "inside", "within",   "surrounds", "surround", "face",   "faces",  "alongside",
    "which",   "just",   "directly", "right"};

template <typename List>
bool Has(const List& list, std::string_view word) {
  return std::find(std::begin(list), std::end(list), word) != std::end(list);
}

}  // namespace

ThingWords::ThingWords(std::string_view text, Vocabulary vocabulary)
    : text_(text), vocabulary_(vocabulary), tokens_(Tokenize(text)) {}

bool ThingWords::IsComma(std::size_t at) const {
  return at < tokens_.size() && tokens_[at].kind == TokenKind::kComma;
}

std::string_view ThingWords::WordAt(std::size_t at) const {
  return at < tokens_.size() && tokens_[at].kind == TokenKind::kWord
             ? std::string_view(tokens_[at].text)
             : std::string_view();
}

std::string ThingWords::Text(std::size_t begin, std::size_t end) const {
  return std::string(
      text_.substr(tokens_[begin].begin, tokens_[end - 1].end - tokens_[begin].begin));
}

void ThingWords::TakeComma() {
  if (IsComma(at_)) ++at_;
}

bool ThingWords::TakeWords(std::initializer_list<std::string_view> words) {
  std::size_t at = at_;
  for (const std::string_view word : words) {
    if (WordAt(at++) != word) return false;
  }
  at_ = at;
  return true;
}

bool ThingWords::TakeAny(std::initializer_list<std::string_view> words) {
  if (Word().empty() || !Has(words, Word())) return false;
  ++at_;
  return true;
}

void ThingWords::TakeCopula() {
  TakeAny({"that", "which"});
  TakeAny({"is", "are", "stand", "stands", "standing", "lie", "lies", "lying"});
}

std::optional<int> ThingWords::TakeNumber() {
  const NumberMatch number = MatchNumber(tokens_, at_);
  if (number.tokens == 0) return std::nullopt;
  at_ += number.tokens;
  return number.value;
}

bool ThingWords::TakeMetres() { return TakeAny({"m", "metres", "meters", "metre", "meter"}); }

double ThingWords::TakeSpacing() {
  const std::size_t begin = at_;
  TakeComma();
  TakeCopula();
  const bool said = TakeAny({"every"}) || TakeAny({"spaced"}) ||
                    TakeWords({"at", "intervals", "of"}) ||
                    TakeWords({"with", "a", "spacing", "of"});
  TakeAny({"at"});
  const std::optional<int> number = TakeNumber();
  if (number.has_value() && TakeMetres()) {
    const bool apart =
        TakeAny({"apart"}) || TakeAny({"intervals"}) || TakeWords({"between", "them"});
    if (said || apart) return *number;
  }
  at_ = begin;
  return 0.0;
}

template <typename Find>
const ThingKind* ThingWords::TakeNoun(const Find& find, bool* plural) {
  for (std::size_t count = 3; count > 0; --count) {
    std::string noun;
    for (std::size_t i = 0; i < count; ++i) {
      const std::string_view word = WordAt(at_ + i);
      if (word.empty()) noun += "?";  // a pause is within no noun
      noun += (i > 0 ? " " : "") + (i + 1 == count ? Singular(word) : std::string(word));
    }
    const ThingKind* kind = find(noun);
    if (kind == nullptr) continue;
    *plural = Singular(WordAt(at_ + count - 1)) != WordAt(at_ + count - 1);
    at_ += count;
    return kind;
  }
  return nullptr;
}

const ThingKind* ThingWords::TakeKind(bool* plural) {
  const bool house_is_land = vocabulary_ == Vocabulary::kSuburb;
  return TakeNoun(
      [house_is_land](const std::string& noun) {
        const ThingKind* kind = FindThingKind(noun);
        return kind != nullptr && kind->name == "house" && house_is_land ? nullptr : kind;
      },
      plural);
}

const ThingKind* ThingWords::TakeBuilding(bool* plural) {
  return TakeNoun(
      [](const std::string& noun) {
        const ThingKind* kind = KindOfBuilding(noun);
        return kind != nullptr ? kind : FindThingKind(noun);
      },
      plural);
}

bool ThingWords::IsEndOfNoun() const {
  return Word().empty() || Has(kFollowers, Word()) || MatchHeading(tokens_, at_).tokens > 0;
}

bool ThingWords::IsLand() const {
  const ClassWord* word = MatchClassWord(tokens_, at_).word;
  return word != nullptr && (word->suburb != 'B' || word->suburb_exact);
}

const ThingWords::Arrangement* ThingWords::TakeArrangement() {
  for (const Arrangement& each : kArrangements) {
    if (TakeAny({each.word})) return &each;
  }
  return nullptr;
}

ThingSide ThingWords::TakeSide() {
  const std::size_t begin = at_;
  for (const bool adverb : {false, true}) {  // "right of" is a side, "right by" is none
    at_ = begin;
    if (adverb && !TakeAny({"just", "directly", "right"})) break;
    if (TakeAny({"to"})) TakeAny({"the"});
    const HeadingMatch match = MatchHeading(tokens_, at_);
    at_ += match.tokens;
    const auto side = FromName<ThingSide>(HeadingName({match.heading.east, match.heading.south}));
    if (match.tokens > 0 && side && TakeAny({"of"})) return *side;
  }
  at_ = begin;
  return ThingSide::kAny;
}

PlaceMatch ThingWords::PlaceAt(std::size_t at) const {
  const auto is_other = [](const Token& token) {
    return token.kind == TokenKind::kWord && (token.text == "facing" || token.text == "that");
  };
  const auto from = tokens_.begin() + static_cast<std::ptrdiff_t>(std::min(at, tokens_.size()));
  return MatchPlace({tokens_.begin(), std::find_if(from, tokens_.end(), is_other)}, at);
}

bool ThingWords::IsPlace() const {
  const PlaceMatch match = PlaceAt(at_ + (Word() == "the" ? 1 : 0));
  return match.tokens > 0 && !match.of_other;
}

void ThingWords::TakePlaceOf() {
  const std::size_t at = at_ + (Word() == "the" ? 1 : 0);
  const PlaceMatch match = PlaceAt(at);
  if (match.tokens == 0 || !match.of_other || WordAt(at + match.tokens) != "of") return;
  at_ = at + match.tokens + 1;
}

ThingTarget ThingWords::TakeLand() {
  constexpr std::size_t kMostWordsBefore = 4;  // articles and adjectives
  ThingTarget target;
  for (std::size_t ahead = 0; ahead < kMostWordsBefore && !WordAt(at_ + ahead).empty(); ++ahead) {
    if (const char ground = GroundNamed(Singular(WordAt(at_ + ahead))); ground != '\0') {
      target.letter = ground;
      at_ += ahead + 1;
      break;
    }
    const ClassWordMatch match = MatchClassWord(tokens_, at_ + ahead);
    if (match.word == nullptr) continue;
    target.letter = match.word->LetterIn(vocabulary_);
    at_ += ahead + match.tokens;
    break;
  }
  return target;
}

}  // namespace latticeworld
