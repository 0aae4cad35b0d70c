#include "latticeworld/language/reading/things/things_of_text.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/language/class_words.h"
#include "latticeworld/language/places.h"
#include "latticeworld/language/reading/things/thing_words.h"
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

constexpr std::string_view kOrderly[] = {"organized", "organised", "orderly", "ordered", "regular"};
constexpr int kOrderlyCount = 9;

struct RelationWords {
  std::initializer_list<std::string_view> words;
  ThingRelation relation;
};

// These verbs may follow "the trees" where a text says more about them.
constexpr std::string_view kVerbs[] = {"is",   "are",   "stand",    "stands",    "lie",  "lies",
                                       "face", "faces", "surround", "surrounds", "form", "forms"};

template <typename List>
bool Has(const List& list, std::string_view word) {
  return std::find(std::begin(list), std::end(list), word) != std::end(list);
}

// A sentence that begins with one of these says where something is before it says what: "by the
// lake stands a bench".
constexpr std::string_view kOpenings[] = {
    "in",     "on",    "at",     "by",     "near",  "next", "beside",   "between", "behind",
    "along",  "under", "around", "inside", "above", "to",   "opposite", "not",     "close",
    "across", "from",  "just",   "deep",   "all",   "both", "each",     "half"};
// What stands before these words has what stands behind them: "a village with a well".
constexpr std::string_view kOwners[] = {"with", "has", "have", "having"};
// These words may follow all that is said of a thing.
constexpr std::string_view kJoints[] = {"and", "with", "but"};

class Taker {
 public:
  Taker(std::string_view text, Vocabulary vocabulary)
      : text_(text), words_(text, vocabulary), gone_(words_.tokens().size()) {}

  TextThings Take() {
    for (std::size_t at = 0; at < words_.tokens().size();) {
      const bool taken = TakeOrderly(at) || TakeMore(at) || TakePhrase(at);
      const std::size_t end = taken ? words_.at() : at + 1;
      if (taken && (IsToldBefore(at) || IsToldAfter(end))) whole_ = false;
      at = std::max(end, at + 1);
    }
    TextThings taken;
    if (things_.empty()) {
      taken.rest = text_;
      return taken;
    }
    StandByWhatTheyFace(&things_);
    taken.things = std::move(things_);
    taken.warnings = std::move(warnings_);
    WriteRest(&taken);
    taken.whole = whole_ && !IsAnyLeft();
    return taken;
  }

 private:
  // Whether words of the same sentence before the last thing say where it is.
  bool IsToldBefore(std::size_t begin) const {
    std::size_t first = begin;
    while (first > 0 && words_.tokens()[first - 1].kind != TokenKind::kStop) --first;
    if (first == begin) return false;
    const std::string_view before = words_.WordAt(begin - 1);
    const ThingWish& wish = things_.back();
    const bool is_open = wish.relation == ThingRelation::kNone && wish.zone.is_anywhere();
    return Has(kOpenings, words_.WordAt(first)) || before == "of" ||
           (is_open && Has(kOwners, before));
  }

  // Whether more is said of a thing than was taken.
  bool IsToldAfter(std::size_t end) const {
    if (words_.IsComma(end)) return Has(kOpenings, words_.WordAt(end + 1));
    if (end >= words_.tokens().size() || Has(kJoints, words_.WordAt(end))) return false;
    return words_.tokens()[end].kind != TokenKind::kStop;
  }

  // Whether the rest names single things that are no land.
  bool IsAnyLeft() {
    for (std::size_t at = 0; at < words_.tokens().size(); ++at) {
      words_.GoTo(at);
      bool plural = false;
      if (!gone_[at] && !words_.IsLand() && words_.TakeKind(&plural) != nullptr) return true;
    }
    return false;
  }

  // "organized chambers, trees, and rocks": each in a grid.
  bool TakeOrderly(std::size_t begin) {
    if (!Has(kOrderly, words_.WordAt(begin))) return false;
    words_.GoTo(begin + 1);
    const std::size_t things = things_.size();
    std::size_t end = begin;
    for (;;) {
      bool plural = false;
      const ThingKind* kind = words_.TakeKind(&plural);
      if (kind == nullptr || !plural) break;
      ThingWish wish;
      wish.kind = kind->name;
      wish.count = wish.count_least = wish.count_most = kOrderlyCount;
      wish.arrangement = ThingArrangement::kGrid;
      things_.push_back(wish);
      end = words_.at();
      words_.TakeComma();
      words_.TakeAny({"and"});
    }
    words_.GoTo(end);
    if (things_.size() == things) return false;
    const std::string words = words_.Text(begin, end);
    for (std::size_t i = things; i < things_.size(); ++i) things_[i].words = words;
    Remove(begin, end);
    return true;
  }

  // A number, an article or an arrangement before the noun. 0: nothing that counts.
  int TakeQuantity(ThingWish* wish, bool* counted, bool* lone) {
    int count = 0;
    const std::size_t begin = words_.at();
    words_.TakeAny({"a", "an", "one", "the"});
    if (const ThingWords::Arrangement* pattern = words_.TakeArrangement();
        pattern != nullptr && words_.TakeAny({"of"})) {
      wish->arrangement = pattern->arrangement;
      const std::optional<int> number = words_.TakeNumber();
      *counted = number.has_value();
      return number.value_or(pattern->usual);
    }
    words_.GoTo(begin);
    if (const std::optional<int> number = words_.TakeNumber(); number.has_value()) {
      *counted = *number > 1;
      *lone = words_.TakeAny({"lone", "single", "solitary"});
      return std::max(1, *number);
    }
    if (words_.TakeAny({"a", "an"})) count = 1;
    if (count == 1 && words_.TakeAny({"lone", "single", "solitary"})) *counted = *lone = true;
    return count;
  }

  bool TakePhrase(std::size_t begin) {
    words_.GoTo(begin);
    ThingWish wish;
    bool counted = false, plural = false, lone = false;
    const int count = TakeQuantity(&wish, &counted, &lone);
    if (count == 0) return false;
    for (bool more = true; more;) {
      more = false;
      for (const Word& size : kSizes) {
        if (words_.Word() != size.word) continue;
        wish.size *= size.value;
        words_.GoTo(words_.at() + 1);
        more = true;
      }
    }
    const bool is_land = words_.IsLand();
    const std::size_t noun = words_.at();
    const ThingKind* kind = words_.TakeKind(&plural);
    const bool only_near = kind == nullptr;
    if (only_near) kind = words_.TakeBuilding(&plural);
    if (kind == nullptr || !words_.IsEndOfNoun() || (plural && count == 1)) return false;
    const std::size_t noun_end = words_.at();
    wish.kind = kind->name;
    wish.count = wish.count_least = wish.count_most = count;
    wish.size = std::clamp(wish.size, 0.2, 5.0);
    std::size_t end = words_.at();
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
    wish.words = words_.Text(begin, end);
    if (count == 1) FillRun(&wish);
    for (std::size_t i = things; i < things_.size(); ++i) things_[i].words = wish.words;
    things_.push_back(wish);
    if (only_near && kind->name != "house") {
      warnings_.push_back(Quote(wish.words) + ": there is no such kind of thing as " +
                          words_.Text(noun, noun_end) + "; the nearest is a " + kind->name);
    }
    for (const auto& [from, to] : parts) Remove(from, to);
    words_.GoTo(end);
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
    words_.GoTo(*end);
    words_.TakeComma();
    words_.TakeAny({"that", "which", "and"});
    if (!words_.TakeAny({"facing", "face", "faces"})) return;
    const std::size_t target_at = words_.at();
    words_.TakeAny({"the"});
    if (const HeadingMatch match = MatchHeading(words_.tokens(), words_.at()); match.tokens > 0) {
      wish->heading_rad = std::atan2(-match.heading.south, match.heading.east);
      parts->push_back({*end, words_.at() + match.tokens});
      *end = words_.at() + match.tokens;
      return;
    }
    words_.GoTo(target_at);
    const std::size_t things = things_.size();
    ThingTarget target = TakeThingTarget();
    const bool is_thing = target.wish >= 0 && things_.size() == things;  // that stands already
    if (!is_thing) {
      things_.resize(things);
      words_.GoTo(target_at);
      target = words_.TakeLand();
    }
    if (target.is_nothing()) return;
    wish->facing = target;
    parts->push_back({*end, is_thing ? words_.at() : target_at});
    *end = words_.at();
  }

  // "The trees are near the village", where trees were asked for: more of the same wish.
  bool TakeMore(std::size_t begin) {
    words_.GoTo(begin);
    bool plural = false;
    if (!words_.TakeAny({"the"})) return false;
    const ThingKind* kind = words_.TakeKind(&plural);
    if (kind == nullptr || !Has(kVerbs, words_.Word())) return false;
    int known = static_cast<int>(things_.size()) - 1;
    while (known >= 0 && things_[static_cast<std::size_t>(known)].kind != kind->name) --known;
    if (known < 0) return false;
    ThingWish wish = things_[static_cast<std::size_t>(known)];
    std::size_t end = words_.at();
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
    wish.words += ". " + words_.Text(begin, end);
    things_[static_cast<std::size_t>(known)] = wish;
    for (const auto& [from, to] : parts) Remove(from, to);
    words_.GoTo(end);
    return true;
  }

  void TakeArrangement(ThingWish* wish, std::size_t* end) {
    for (;;) {
      words_.GoTo(*end);
      words_.TakeComma();
      words_.TakeCopula();
      words_.TakeAny({"arranged", "placed", "planted"});
      const bool said = words_.TakeWords({"in", "a"}) ||
                        (words_.TakeAny({"form", "forms", "forming"}) && words_.TakeAny({"a"}));
      const ThingWords::Arrangement* pattern = said ? words_.TakeArrangement() : nullptr;
      if (pattern != nullptr && words_.Word() != "of") {
        wish->arrangement = pattern->arrangement;
      } else {
        words_.GoTo(*end);
        const double spacing_m = words_.TakeSpacing();
        if (spacing_m == 0.0) return;
        wish->spacing_m = spacing_m;
      }
      *end = words_.at();
    }
  }

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
    words_.GoTo(begin);
    words_.TakeCopula();
    const std::size_t number_at = words_.at();
    const std::optional<int> number = words_.TakeNumber();
    const bool metres = number.has_value() && words_.TakeMetres();
    double distance_m = metres ? *number : 0.0;
    ThingSide side = ThingSide::kAny;
    std::optional<ThingRelation> relation;
    if (metres && (words_.TakeWords({"away", "from"}) || words_.TakeAny({"from"}))) {
      relation = ThingRelation::kNear;
    } else {
      if (!metres) words_.GoTo(number_at);
      side = words_.TakeSide();
      if (side != ThingSide::kAny) relation = ThingRelation::kNear;
    }
    if (!relation) {
      words_.GoTo(number_at);
      distance_m = 0.0;
      words_.TakeAny({"just", "right"});
      for (const RelationWords& each : kRelations) {
        if (words_.TakeWords(each.words)) {
          relation = each.relation;
          break;
        }
      }
    }
    if (!relation || words_.IsPlace()) return false;
    // It leads to a thing that was named before, or else to land.
    const std::size_t place_at = words_.at();
    words_.TakePlaceOf();
    const std::size_t target_at = words_.at();
    // "Near the eastern shore of the lake": on which side of it is not taken.
    if (target_at > place_at && *relation != ThingRelation::kIn) whole_ = false;
    const ThingTarget target = TakeTarget();
    const bool is_thing = target.wish >= 0;
    if (target.is_nothing()) WarnOfLand(target_at);
    if (target.is_nothing() || (is_thing && *relation == ThingRelation::kIn)) return false;
    const std::size_t target_end = words_.at();
    ThingTarget second;
    if (*relation == ThingRelation::kBetween) {
      second = words_.TakeAny({"and"}) ? TakeTarget() : target;  // "between the lakes"
      if (second.is_nothing() || second.wish >= 0) return false;
    }
    // Only now is the wish changed and are the words taken.
    wish->relation = *relation;
    wish->target = target;
    wish->second = second;
    wish->distance_m = distance_m;
    wish->side = side;
    parts->push_back({begin, is_thing ? target_end : target_at});
    *end = words_.at();
    return is_thing;
  }

  // A thing that was named before, or else land.
  ThingTarget TakeTarget() {
    const std::size_t begin = words_.at();
    const ThingTarget target = TakeThingTarget();
    if (target.wish >= 0) return target;
    words_.GoTo(begin);
    return words_.TakeLand();
  }

  // "Left of the road", in a vocabulary that has no roads.
  void WarnOfLand(std::size_t at) {
    const std::size_t noun = at + (words_.WordAt(at) == "the" || words_.WordAt(at) == "a" ? 1 : 0);
    const ClassWordMatch match = MatchClassWord(words_.tokens(), noun);
    if (match.word == nullptr || match.word->LetterIn(words_.vocabulary()) != '\0') return;
    warnings_.push_back("the " + std::string(NameOf(words_.vocabulary())) +
                        " vocabulary has nothing like " +
                        Quote(words_.Text(at, noun + match.tokens)) + "; nothing stands by it");
  }

  ThingTarget TakeThingTarget() {
    ThingTarget target;
    const bool definite = words_.TakeAny({"the"});
    const bool indefinite = !definite && words_.TakeAny({"a", "an", "one"});
    words_.TakeAny({"lone", "single", "solitary"});
    const bool is_land = words_.IsLand();
    bool plural = false;
    const ThingKind* kind = words_.TakeKind(&plural);
    if (kind == nullptr || !words_.IsEndOfNoun()) return target;
    for (int i = static_cast<int>(things_.size()) - 1; definite && i >= 0; --i) {
      if (things_[static_cast<std::size_t>(i)].kind != kind->name) continue;
      target.wish = i;
      return target;
    }
    // Trees are a forest, but a church is one.
    if (plural) return target;
    if (is_land && (!indefinite || kind->source == ThingSource::kAsset)) {
      whole_ = false;
      return target;
    }
    ThingWish wish;
    wish.kind = kind->name;
    things_.push_back(wish);
    target.wish = static_cast<int>(things_.size()) - 1;
    return target;
  }

  // "in the north", "in the upper left corner".
  void TakeZone(ThingWish* wish, std::size_t* end,
                std::vector<std::pair<std::size_t, std::size_t>>* parts) {
    words_.GoTo(*end);
    if (!words_.TakeAny({"in", "at", "on", "near", "along"})) return;
    words_.TakeAny({"the"});
    const PlaceMatch match = words_.PlaceAt(words_.at());
    if (match.tokens == 0 || match.of_other || match.places.empty()) return;
    wish->zone = match.places.front().zone;
    const std::size_t begin = *end;
    *end = words_.at() + match.tokens;
    parts->push_back({begin, *end});
  }

  void Remove(std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) gone_[i] = true;
  }

  // Words that only join what is gone go too.
  void WriteRest(TextThings* taken) {
    for (std::size_t i = 0; i < words_.tokens().size(); ++i) {
      const bool joins = words_.tokens()[i].kind == TokenKind::kComma ||
                         words_.WordAt(i) == "and" || words_.WordAt(i) == "with" ||
                         words_.WordAt(i) == "there" || words_.WordAt(i) == "are" ||
                         words_.WordAt(i) == "is";
      std::size_t next = i + 1;
      while (next < words_.tokens().size() && words_.tokens()[next].kind == TokenKind::kWord &&
             (words_.WordAt(next) == "and" || words_.WordAt(next) == "with" ||
              words_.WordAt(next) == "are" || words_.WordAt(next) == "is")) {
        ++next;
      }
      if (joins && next < words_.tokens().size() && gone_[next]) gone_[i] = true;
    }
    const auto append = [&](std::string* to, std::size_t i) {
      const std::string_view piece =
          text_.substr(words_.tokens()[i].begin, words_.tokens()[i].end - words_.tokens()[i].begin);
      const bool apart = words_.tokens()[i].kind == TokenKind::kWord ||
                         words_.tokens()[i].kind == TokenKind::kNumber;
      if (!to->empty() && apart) *to += " ";
      *to += piece;
    };
    for (std::size_t i = 0; i < words_.tokens().size(); ++i) {
      append(gone_[i] ? &taken->taken : &taken->rest, i);
    }
  }

  const std::string_view text_;
  ThingWords words_;
  std::vector<bool> gone_;
  std::vector<ThingWish> things_;
  std::vector<std::string> warnings_;
  bool whole_ = true;
};

}  // namespace

TextThings TakeThings(std::string_view text, Vocabulary vocabulary) {
  return Taker(text, vocabulary).Take();
}

}  // namespace latticeworld
