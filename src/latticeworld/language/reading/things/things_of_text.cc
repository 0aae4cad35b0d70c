#include "latticeworld/language/reading/things/things_of_text.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/language/class_words.h"
#include "latticeworld/language/numbers.h"
#include "latticeworld/language/places.h"
#include "latticeworld/language/reading/sentence_places.h"
#include "latticeworld/language/reading/things/laid_as_houses.h"
#include "latticeworld/language/tokens.h"
#include "latticeworld/layout/thing_kinds.h"
#include "latticeworld/layout/thing_wishes.h"

namespace latticeworld {
namespace {

struct Word {
  std::string_view word;
  double value;
};
constexpr Word kSizes[] = {{"tiny", 0.5}, {"small", 0.7}, {"little", 0.7}, {"large", 1.4},
                           {"big", 1.4},  {"tall", 1.3},  {"huge", 1.8},   {"old", 1.0}};

struct ArrangementWord {
  std::string_view word;
  ThingArrangement arrangement;
  int usual;  // things, where no number is said
};
constexpr ArrangementWord kArrangements[] = {
    {"row", ThingArrangement::kRow, 5},       {"line", ThingArrangement::kRow, 5},
    {"ring", ThingArrangement::kRing, 6},     {"circle", ThingArrangement::kRing, 6},
    {"grid", ThingArrangement::kGrid, 9},     {"cluster", ThingArrangement::kCluster, 5},
    {"group", ThingArrangement::kCluster, 5}, {"pair", ThingArrangement::kPair, 2}};

constexpr std::string_view kOrderly[] = {"organized", "organised", "orderly", "ordered", "regular"};
constexpr int kOrderlyCount = 9;

struct RelationWords {
  std::initializer_list<std::string_view> words;
  ThingRelation relation;
};

// Words that may follow a noun that stands by itself.
constexpr std::string_view kFollowers[] = {
    "in",      "on",     "at",       "by",        "near",     "beside", "next",   "along",
    "around",  "and",    "with",     "is",        "are",      "stand",  "stands", "form",
    "forms",   "every",  "spaced",   "that",      "behind",   "facing", "close",  "lie",
    "lies",    "placed", "arranged", "line",      "lines",    "from",   "to",     "surrounding",
    "between", "inside", "within",   "surrounds", "surround", "face",   "faces",  "alongside",
    "which",   "just",   "directly", "right"};

// These verbs may follow "the trees" where a text says more about them.
constexpr std::string_view kVerbs[] = {"is",   "are",   "stand",    "stands",    "lie",  "lies",
                                       "face", "faces", "surround", "surrounds", "form", "forms"};

template <typename List>
bool Has(const List& list, std::string_view word) {
  return std::find(std::begin(list), std::end(list), word) != std::end(list);
}

class Taker {
 public:
  Taker(std::string_view text, Vocabulary vocabulary)
      : text_(text), vocabulary_(vocabulary), tokens_(Tokenize(text)), gone_(tokens_.size()) {}

  TextThings Take() {
    for (std::size_t at = 0; at < tokens_.size();) {
      const bool taken = TakeOrderly(at) || TakeMore(at) || TakePhrase(at);
      const std::size_t end = taken ? at_ : at + 1;
      at = std::max(end, at + 1);
    }
    TextThings taken;
    if (things_.empty()) {
      taken.rest = text_;
      return taken;
    }
    taken.things = std::move(things_);
    taken.warnings = std::move(warnings_);
    WriteRest(&taken);
    return taken;
  }

 private:
  std::string_view WordAt(std::size_t at) const {
    return at < tokens_.size() && tokens_[at].kind == TokenKind::kWord
               ? std::string_view(tokens_[at].text)
               : std::string_view();
  }
  bool TakeWords(std::initializer_list<std::string_view> words) {
    std::size_t at = at_;
    for (const std::string_view word : words) {
      if (WordAt(at++) != word) return false;
    }
    at_ = at;
    return true;
  }
  bool TakeAny(std::initializer_list<std::string_view> words) {
    if (!Has(words, WordAt(at_)) || WordAt(at_).empty()) return false;
    ++at_;
    return true;
  }

  // The longest noun of which `find` gives a kind.
  template <typename Find>
  const ThingKind* TakeNoun(const Find& find, bool* plural) {
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

  const ThingKind* TakeKind(bool* plural) {
    const bool house_is_land = vocabulary_ == Vocabulary::kSuburb;
    return TakeNoun(
        [house_is_land](const std::string& noun) {
          const ThingKind* kind = FindThingKind(noun);
          return kind != nullptr && kind->name == "house" && house_is_land ? nullptr : kind;
        },
        plural);
  }

  // Houses, and buildings that are no kind but come near one.
  const ThingKind* TakeBuilding(bool* plural) {
    return TakeNoun(
        [](const std::string& noun) {
          const ThingKind* kind = KindOfBuilding(noun);
          return kind != nullptr ? kind : FindThingKind(noun);
        },
        plural);
  }

  bool EndsHere() const {
    return at_ >= tokens_.size() || tokens_[at_].kind != TokenKind::kWord ||
           Has(kFollowers, WordAt(at_)) || MatchHeading(tokens_, at_).tokens > 0;
  }

  const ArrangementWord* ArrangementAt(std::size_t at) const {
    for (const ArrangementWord& each : kArrangements) {
      if (each.word == WordAt(at)) return &each;
    }
    return nullptr;
  }

  // Whether a noun is land too. Piers, tents and ruins, which no class but buildings comes near,
  // are not.
  bool IsLand(std::size_t at) const {
    const ClassWord* word = MatchClassWord(tokens_, at).word;
    return word != nullptr && (word->suburb != 'B' || word->suburb_exact);
  }

  // "organized chambers, trees, and rocks": each in a grid.
  bool TakeOrderly(std::size_t begin) {
    if (!Has(kOrderly, WordAt(begin))) return false;
    at_ = begin + 1;
    const std::size_t things = things_.size();
    std::size_t end = begin;
    for (;;) {
      bool plural = false;
      const ThingKind* kind = TakeKind(&plural);
      if (kind == nullptr || !plural) break;
      ThingWish wish;
      wish.kind = kind->name;
      wish.count = wish.count_least = wish.count_most = kOrderlyCount;
      wish.arrangement = ThingArrangement::kGrid;
      things_.push_back(wish);
      end = at_;
      if (at_ < tokens_.size() && tokens_[at_].kind == TokenKind::kComma) ++at_;
      TakeAny({"and"});
    }
    at_ = end;
    if (things_.size() == things) return false;
    const std::string words = Words(begin, end);
    for (std::size_t i = things; i < things_.size(); ++i) things_[i].words = words;
    Remove(begin, end);
    return true;
  }

  // A number, an article or an arrangement before the noun. 0: nothing that counts.
  int TakeQuantity(ThingWish* wish, bool* counted, bool* lone) {
    int count = 0;
    const std::size_t begin = at_;
    TakeAny({"a", "an", "one", "the"});
    if (const ArrangementWord* pattern = ArrangementAt(at_); pattern != nullptr) {
      ++at_;
      if (TakeAny({"of"})) {
        wish->arrangement = pattern->arrangement;
        const NumberMatch number = MatchNumber(tokens_, at_);
        *counted = number.tokens > 0;
        at_ += number.tokens;
        return number.tokens > 0 ? number.value : pattern->usual;
      }
    }
    at_ = begin;
    const NumberMatch number = MatchNumber(tokens_, at_);
    if (number.tokens > 0) {
      *counted = number.value > 1;
      at_ += number.tokens;
      *lone = TakeAny({"lone", "single", "solitary"});
      return std::max(1, number.value);
    }
    if (TakeAny({"a", "an"})) count = 1;
    if (count == 1 && TakeAny({"lone", "single", "solitary"})) *counted = *lone = true;
    return count;
  }

  bool TakePhrase(std::size_t begin) {
    at_ = begin;
    ThingWish wish;
    bool counted = false, plural = false, lone = false;
    const int count = TakeQuantity(&wish, &counted, &lone);
    if (count == 0) return false;
    for (bool more = true; more;) {
      more = false;
      for (const Word& size : kSizes) {
        if (WordAt(at_) != size.word) continue;
        wish.size *= size.value;
        ++at_;
        more = true;
      }
    }
    const bool is_land = IsLand(at_);
    const std::size_t noun = at_;
    const ThingKind* kind = TakeKind(&plural);
    const bool only_near = kind == nullptr;
    if (only_near) kind = TakeBuilding(&plural);
    if (kind == nullptr || !EndsHere() || (plural && count == 1)) return false;
    const std::size_t noun_end = at_;
    wish.kind = kind->name;
    wish.count = wish.count_least = wish.count_most = count;
    wish.size = std::clamp(wish.size, 0.2, 5.0);
    std::size_t end = at_;
    TakeArrangement(&wish, &end);
    const bool grows = kind->source == ThingSource::kAsset || kind->name == "boulder" ||
                       (kind->words.size() > 1 && kind->words[1] == kind->name + " tree");
    const bool arranged = wish.arrangement != ThingArrangement::kNone && counted;
    if (only_near && !arranged) return false;
    // The number of things is kept before the thing that this one stands by is added: a thing of
    // land counts only together with that one.
    const std::size_t things = things_.size();
    if (things >= static_cast<std::size_t>(kMostThingWishes)) return false;
    const std::size_t warnings = warnings_.size();
    std::vector<std::pair<std::size_t, std::size_t>> parts = {{begin, end}};
    const bool by_thing = TakeRelation(&wish, &end, &parts);
    if (is_land && !arranged && !(grows && counted) && !by_thing && !lone) {
      things_.resize(things);
      warnings_.resize(warnings);
      return false;
    }
    TakeRest(&wish, &end, &parts);
    wish.words = Words(begin, end);
    if (count == 1) FillRun(&wish);
    for (std::size_t i = things; i < things_.size(); ++i) things_[i].words = wish.words;
    things_.push_back(wish);
    if (only_near && kind->name != "house") {
      warnings_.push_back(Quote(wish.words) + ": there is no such kind of thing as " +
                          Words(noun, noun_end) + "; the nearest is a " + kind->name);
    }
    for (const auto& [from, to] : parts) Remove(from, to);
    at_ = end;
    return true;
  }

  // What may follow the relation, in any order.
  void TakeRest(ThingWish* wish, std::size_t* end,
                std::vector<std::pair<std::size_t, std::size_t>>* parts) {
    for (std::size_t from = *end;; from = *end) {
      TakeArrangement(wish, end);
      if (*end > from) parts->push_back({from, *end});
      TakeZone(wish, end, parts);
      TakeFacing(wish, end, parts);
      if (*end == from) return;
    }
  }

  // "facing the lake", "that faces north". Land stays in the text.
  void TakeFacing(ThingWish* wish, std::size_t* end,
                  std::vector<std::pair<std::size_t, std::size_t>>* parts) {
    at_ = *end;
    if (at_ < tokens_.size() && tokens_[at_].kind == TokenKind::kComma) ++at_;
    TakeAny({"that", "which", "and"});
    if (!TakeAny({"facing", "face", "faces"})) return;
    const std::size_t target_at = at_;
    TakeAny({"the"});
    if (const HeadingMatch match = MatchHeading(tokens_, at_); match.tokens > 0) {
      wish->heading_rad = std::atan2(-match.heading.south, match.heading.east);
      parts->push_back({*end, at_ + match.tokens});
      *end = at_ + match.tokens;
      return;
    }
    at_ = target_at;
    const std::size_t things = things_.size();
    ThingTarget target = TakeThingTarget();
    const bool is_thing = target.wish >= 0 && things_.size() == things;  // that stands already
    if (!is_thing) {
      things_.resize(things);
      at_ = target_at;
      target = LandTarget();
    }
    if (target.is_nothing()) return;
    wish->facing = target;
    parts->push_back({*end, is_thing ? at_ : target_at});
    *end = at_;
  }

  // "The trees are near the village", where trees were asked for: more of the same wish.
  bool TakeMore(std::size_t begin) {
    at_ = begin;
    bool plural = false;
    if (!TakeAny({"the"})) return false;
    const ThingKind* kind = TakeKind(&plural);
    if (kind == nullptr || !Has(kVerbs, WordAt(at_))) return false;
    int known = static_cast<int>(things_.size()) - 1;
    while (known >= 0 && things_[static_cast<std::size_t>(known)].kind != kind->name) --known;
    if (known < 0) return false;
    ThingWish wish = things_[static_cast<std::size_t>(known)];
    std::size_t end = at_;
    std::vector<std::pair<std::size_t, std::size_t>> parts = {{begin, end}};
    const std::size_t things = things_.size();
    const std::size_t warnings = warnings_.size();
    TakeRelation(&wish, &end, &parts);
    TakeRest(&wish, &end, &parts);
    // What it stands by has to stand before it.
    if (parts.size() == 1 || things_.size() > things || wish.target.wish >= known ||
        wish.facing.wish >= known) {
      things_.resize(things);
      warnings_.resize(warnings);
      return false;
    }
    wish.words += ". " + Words(begin, end);
    things_[static_cast<std::size_t>(known)] = wish;
    for (const auto& [from, to] : parts) Remove(from, to);
    at_ = end;
    return true;
  }

  void TakeArrangement(ThingWish* wish, std::size_t* end) {
    for (bool more = true; more;) {
      more = false;
      at_ = *end;
      if (at_ < tokens_.size() && tokens_[at_].kind == TokenKind::kComma) ++at_;
      TakeCopula();
      TakeAny({"arranged", "placed", "planted"});
      if ((TakeWords({"in", "a"}) || (TakeAny({"form", "forms", "forming"}) && TakeAny({"a"}))) &&
          ArrangementAt(at_) != nullptr && WordAt(at_ + 1) != "of") {
        wish->arrangement = ArrangementAt(at_++)->arrangement;
        more = true;
      } else if (const double spacing_m = TakeSpacing(*end); spacing_m > 0.0) {
        wish->spacing_m = spacing_m;
        more = true;
      }
      if (more) *end = at_;
    }
  }

  // "is", "that stand", "standing": says nothing by itself.
  void TakeCopula() {
    TakeAny({"that", "which"});
    TakeAny({"is", "are", "stand", "stands", "standing", "lie", "lies", "lying"});
  }

  // "every 20 m", "20 metres apart", "spaced 20 m", "at intervals of 20 m". 0: none.
  double TakeSpacing(std::size_t begin) {
    at_ = begin;
    if (at_ < tokens_.size() && tokens_[at_].kind == TokenKind::kComma) ++at_;
    TakeCopula();
    const bool said = TakeAny({"every"}) || TakeAny({"spaced"}) ||
                      TakeWords({"at", "intervals", "of"}) ||
                      TakeWords({"with", "a", "spacing", "of"});
    TakeAny({"at"});
    const NumberMatch number = MatchNumber(tokens_, at_);
    at_ += number.tokens;
    if (number.tokens == 0 || !TakeMetres()) return 0.0;
    const bool apart =
        TakeAny({"apart"}) || TakeAny({"intervals"}) || TakeWords({"between", "them"});
    return said || apart ? number.value : 0.0;
  }

  bool TakeMetres() { return TakeAny({"m", "metres", "meters", "metre", "meter"}); }

  // What the thing stands by; true: it is another thing. Land stays in the text.
  bool TakeRelation(ThingWish* wish, std::size_t* end,
                    std::vector<std::pair<std::size_t, std::size_t>>* parts) {
    static const RelationWords kRelations[] = {
        {{"in", "front", "of"}, ThingRelation::kInFront},
        {{"behind"}, ThingRelation::kBehind},
        {{"on", "both", "sides", "of"}, ThingRelation::kAlong},
        {{"between"}, ThingRelation::kBetween},
        {{"on", "top", "of"}, ThingRelation::kIn},
        {{"around"}, ThingRelation::kAround},
        {{"surrounding"}, ThingRelation::kAround},
        {{"surround"}, ThingRelation::kAround},
        {{"surrounds"}, ThingRelation::kAround},
        {{"along"}, ThingRelation::kAlong},
        {{"alongside"}, ThingRelation::kAlong},
        {{"beside"}, ThingRelation::kNear},
        {{"next", "to"}, ThingRelation::kNear},
        {{"close", "to"}, ThingRelation::kNear},
        {{"near"}, ThingRelation::kNear},
        {{"by"}, ThingRelation::kNear},
        {{"at"}, ThingRelation::kNear},
        {{"on"}, ThingRelation::kIn},
        {{"in"}, ThingRelation::kIn},
        {{"inside"}, ThingRelation::kIn},
        {{"within"}, ThingRelation::kIn}};
    // The relation is a distance ("12 m from") or one of the words above.
    const std::size_t begin = *end;
    at_ = begin;
    TakeCopula();
    const std::size_t number_at = at_;
    const NumberMatch number = MatchNumber(tokens_, at_);
    at_ += number.tokens;
    const bool metres = number.tokens > 0 && TakeMetres();
    double distance_m = metres ? number.value : 0.0;
    ThingSide side = ThingSide::kAny;
    std::optional<ThingRelation> relation;
    if (metres && (TakeWords({"away", "from"}) || TakeAny({"from"}))) {
      relation = ThingRelation::kNear;
    } else {
      if (!metres) at_ = number_at;
      side = TakeSide();
      if (side != ThingSide::kAny) relation = ThingRelation::kNear;
    }
    if (!relation) {
      at_ = number_at;
      distance_m = 0.0;
      TakeAny({"just", "right"});
      for (const RelationWords& each : kRelations) {
        if (TakeWords(each.words)) {
          relation = each.relation;
          break;
        }
      }
    }
    if (!relation || IsPlaceHere()) return false;
    // It leads to a thing that was named before, or else to land.
    TakePlaceOf();
    const std::size_t target_at = at_;
    const ThingTarget target = TakeTarget();
    const bool is_thing = target.wish >= 0;
    if (target.is_nothing()) WarnOfLand(target_at);
    if (target.is_nothing() || (is_thing && *relation == ThingRelation::kIn)) return false;
    const std::size_t target_end = at_;
    ThingTarget second;
    if (*relation == ThingRelation::kBetween) {
      second = TakeAny({"and"}) ? TakeTarget() : target;  // "between the lakes"
      if (second.is_nothing() || second.wish >= 0) return false;
    }
    // Only now is the wish changed and are the words taken.
    wish->relation = *relation;
    wish->target = target;
    wish->second = second;
    wish->distance_m = distance_m;
    wish->side = side;
    parts->push_back({begin, is_thing ? target_end : target_at});
    *end = at_;
    return is_thing;
  }

  // A thing that was named before, or else land.
  ThingTarget TakeTarget() {
    const std::size_t begin = at_;
    const ThingTarget target = TakeThingTarget();
    if (target.wish >= 0) return target;
    at_ = begin;
    return LandTarget();
  }

  // "Left of the road", in a vocabulary that has no roads.
  void WarnOfLand(std::size_t at) {
    const std::size_t noun = at + (WordAt(at) == "the" || WordAt(at) == "a" ? 1 : 0);
    const ClassWordMatch match = MatchClassWord(tokens_, noun);
    if (match.word == nullptr || match.word->LetterIn(vocabulary_) != '\0') return;
    warnings_.push_back("the " + std::string(NameOf(vocabulary_)) +
                        " vocabulary has nothing like " + Quote(Words(at, noun + match.tokens)) +
                        "; nothing stands by it");
  }

  // "north of", "to the north of", "just north of": on which side of something.
  ThingSide TakeSide() {
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

  // The place that begins there; what is said behind "facing" is not of it.
  PlaceMatch PlaceAt(std::size_t at) const {
    const auto is_other = [](const Token& token) {
      return token.kind == TokenKind::kWord && (token.text == "facing" || token.text == "that");
    };
    const auto from = tokens_.begin() + static_cast<std::ptrdiff_t>(std::min(at, tokens_.size()));
    return MatchPlace({tokens_.begin(), std::find_if(from, tokens_.end(), is_other)}, at);
  }

  // "in the north" says where on the map, "in the north of the forest" where in the forest.
  bool IsPlaceHere() const {
    const PlaceMatch match = PlaceAt(at_ + (WordAt(at_) == "the" ? 1 : 0));
    return match.tokens > 0 && !match.of_other;
  }

  // "the middle of" the forest: the forest.
  void TakePlaceOf() {
    const std::size_t at = at_ + (WordAt(at_) == "the" ? 1 : 0);
    const PlaceMatch match = PlaceAt(at);
    if (match.tokens == 0 || !match.of_other || WordAt(at + match.tokens) != "of") return;
    at_ = at + match.tokens + 1;
  }

  ThingTarget TakeThingTarget() {
    ThingTarget target;
    const bool definite = TakeAny({"the"});
    const bool indefinite = !definite && TakeAny({"a", "an", "one"});
    TakeAny({"lone", "single", "solitary"});
    const bool is_land = IsLand(at_);
    bool plural = false;
    const ThingKind* kind = TakeKind(&plural);
    if (kind == nullptr || !EndsHere()) return target;
    for (int i = static_cast<int>(things_.size()) - 1; definite && i >= 0; --i) {
      if (things_[static_cast<std::size_t>(i)].kind != kind->name) continue;
      target.wish = i;
      return target;
    }
    // Trees are a forest, but a church is one.
    if (plural || (is_land && (!indefinite || kind->source == ThingSource::kAsset))) return target;
    ThingWish wish;
    wish.kind = kind->name;
    things_.push_back(wish);
    target.wish = static_cast<int>(things_.size()) - 1;
    return target;
  }

  ThingTarget LandTarget() {
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

  // "in the north", "in the upper left corner".
  void TakeZone(ThingWish* wish, std::size_t* end,
                std::vector<std::pair<std::size_t, std::size_t>>* parts) {
    at_ = *end;
    if (!TakeAny({"in", "at", "on", "near", "along"})) return;
    TakeAny({"the"});
    const PlaceMatch match = PlaceAt(at_);
    if (match.tokens == 0 || match.of_other || match.places.empty()) return;
    wish->zone = match.places.front().zone;
    const std::size_t begin = *end;
    *end = at_ + match.tokens;
    parts->push_back({begin, *end});
  }

  void Remove(std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) gone_[i] = true;
  }

  std::string Words(std::size_t begin, std::size_t end) const {
    return std::string(
        text_.substr(tokens_[begin].begin, tokens_[end - 1].end - tokens_[begin].begin));
  }

  // Words that only join what is gone go too.
  void WriteRest(TextThings* taken) {
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      const bool joins = tokens_[i].kind == TokenKind::kComma || WordAt(i) == "and" ||
                         WordAt(i) == "with" || WordAt(i) == "there" || WordAt(i) == "are" ||
                         WordAt(i) == "is";
      std::size_t next = i + 1;
      while (next < tokens_.size() && tokens_[next].kind == TokenKind::kWord &&
             (WordAt(next) == "and" || WordAt(next) == "with" || WordAt(next) == "are" ||
              WordAt(next) == "is")) {
        ++next;
      }
      if (joins && next < tokens_.size() && gone_[next]) gone_[i] = true;
    }
    const auto append = [&](std::string* to, std::size_t i) {
      const std::string_view piece =
          text_.substr(tokens_[i].begin, tokens_[i].end - tokens_[i].begin);
      const bool apart =
          tokens_[i].kind == TokenKind::kWord || tokens_[i].kind == TokenKind::kNumber;
      if (!to->empty() && apart) *to += " ";
      *to += piece;
    };
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      append(gone_[i] ? &taken->taken : &taken->rest, i);
    }
  }

  const std::string_view text_;
  const Vocabulary vocabulary_;
  const std::vector<Token> tokens_;
  std::vector<bool> gone_;
  std::size_t at_ = 0;
  std::vector<ThingWish> things_;
  std::vector<std::string> warnings_;
};

}  // namespace

TextThings TakeThings(std::string_view text, Vocabulary vocabulary) {
  return Taker(text, vocabulary).Take();
}

}  // namespace latticeworld
