#include "latticeworld/language/reading/things/things_of_sentences.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/language/class_words.h"
#include "latticeworld/language/reading/sentence_places.h"
#include "latticeworld/language/reading/things/sentence_things.h"
#include "latticeworld/language/tokens.h"
#include "latticeworld/layout/class_letters.h"
#include "latticeworld/layout/thing_kinds.h"
#include "latticeworld/layout/thing_wishes.h"

namespace latticeworld {
namespace {

constexpr int kSome = 5;  // of what is said in the plural without a number

struct RelationForm {
  std::string_view form;
  ThingRelation relation;
};
constexpr RelationForm kRelationForms[] = {
    {"near", ThingRelation::kNear},           {"near_cells", ThingRelation::kNear},
    {"near_metres", ThingRelation::kNear},    {"touch", ThingRelation::kNear},
    {"front", ThingRelation::kInFront},       {"surround", ThingRelation::kAround},
    {"inside", ThingRelation::kIn},           {"along", ThingRelation::kAlong},
    {"lined", ThingRelation::kAlong},         {"both_sides", ThingRelation::kAlong},
    {"heading", ThingRelation::kNear},        {"between", ThingRelation::kBetween},
    {"between_all", ThingRelation::kBetween},
};

// The kind of a phrase's noun, where it is an object; nullptr: it is none. A house is land, but
// where the vocabulary has no land for it.
const ThingKind* KindOf(const Phrase& thing, Vocabulary vocabulary) {
  for (const char* list : {"object", "object_s"}) {
    const Phrase* noun = thing.Find(list);
    if (noun != nullptr) return FindThingKind(SingularNoun("object", noun->text));
  }
  if (!thing.Has("noun")) return nullptr;  // a place
  const NounPhrase phrase = NounOf(thing);
  if (phrase.noun == nullptr || phrase.noun->LetterIn(vocabulary) != '\0') return nullptr;
  return FindThingKind(phrase.noun->phrase);
}

// A pond with benches has them on its shore.
bool StandsInWater(std::string_view kind) {
  constexpr std::string_view kKinds[] = {"stone", "boulder", "loose stone", "tower", "ruin",
                                         "pier",  "log",     "wall",        "crate", "post"};
  return std::find(std::begin(kKinds), std::end(kKinds), kind) != std::end(kKinds);
}

double SizeOf(std::string_view word) {
  return word == "tiny" ? 0.5 : word == "small" ? 0.7 : word == "large" ? 1.4 : 1.8;
}

// Returns the heading from the middle of the map to that of a zone [rad]; east if the zone is in
// the middle.
double HeadingTo(const Zone& zone) {
  double x = 0.0, y = 0.0;
  for (const UnitBox& box : zone.boxes) {
    x += 0.5 * (box.u_min + box.u_max) - 0.5;
    y += 0.5 - 0.5 * (box.v_min + box.v_max);
  }
  return std::atan2(y, x);
}

ThingWish NewWish(const ThingKind& kind, const Phrase& thing, const std::string& words) {
  ThingWish wish;
  wish.kind = kind.name;
  wish.words = words;
  for (const Phrase* size : thing.FindAll("size")) wish.size *= SizeOf(size->text);
  wish.size = std::clamp(wish.size, 0.2, 5.0);
  if (!IsSaidSingly(thing) && thing.Has("object_s")) {  // "lamps"
    wish.count = kSome;
    wish.count_least = 2;
    wish.count_most = kMostThings;
  }
  if (const Phrase* quantity = thing.Find("quantity"); quantity != nullptr) {
    const CountMatch count = *NounOf(thing).qualities.count;
    const bool open = count.most == CountMatch::kUnbounded;
    wish.count_least = count.least;
    wish.count_most = open ? kMostThings : count.most;
    wish.count = open ? count.least : std::max(count.least, count.most);
  }
  return wish;
}

}  // namespace

int SentenceThings::Known(const std::string& kind) const {
  for (int i = static_cast<int>(wishes_.size()) - 1; i >= 0; --i) {
    if (wishes_[static_cast<std::size_t>(i)].kind == kind) return i;
  }
  return -1;
}

int SentenceThings::WishOf(const Phrase& thing, const std::string& words) {
  const ThingKind* kind = KindOf(thing, vocabulary_);
  if (kind == nullptr) return -1;
  const bool single = IsSaidSingly(thing);
  if (!single) {
    if (const int known = Known(kind->name); known >= 0) return known;
    const bool is_land = NounOf(thing).noun != nullptr;
    if (!StartsWith(thing.text, "the ") && is_land) return -1;
  }
  if (wishes_.size() >= static_cast<std::size_t>(kMostThingWishes)) return -1;
  wishes_.push_back(NewWish(*kind, thing, words));
  return static_cast<int>(wishes_.size()) - 1;
}

ThingTarget SentenceThings::TargetOf(const Phrase& thing, const std::string& words) {
  ThingTarget target;
  target.wish = WishOf(thing, words);
  if (target.wish >= 0) return target;
  if (const Phrase* relief = thing.Find("relief"); relief != nullptr) {
    target.letter = GroundNamed(relief->text);
    return target;
  }
  const NounPhrase phrase = NounOf(thing);
  if (phrase.noun != nullptr) target.letter = phrase.noun->LetterIn(vocabulary_);
  if (target.letter != '\0') land_.push_back(thing);
  return target;
}

bool SentenceThings::Relate(const Sentence& sentence, ThingWish wish, int index, int beside,
                            const std::string& words) {
  const std::string& form = sentence.form->name;
  const Phrase* to = sentence.whole.Find("y");
  if (to == nullptr) to = sentence.whole.Find("end");
  const auto* const found =
      std::find_if(std::begin(kRelationForms), std::end(kRelationForms),
                   [&](const RelationForm& each) { return each.form == form; });
  if (to == nullptr || (found == std::end(kRelationForms) && form != "facing")) return false;
  if (to->slot == "end" && to->Has("zone")) {
    if (form == "facing") {
      wish.heading_rad = HeadingTo(EndZoneOf(*to));
    } else {
      wish.zone = EndZoneOf(*to);
    }
    wishes_[static_cast<std::size_t>(index)] = wish;
    return true;
  }
  const ThingTarget target = beside >= 0 ? ThingTarget{'\0', beside} : TargetOf(*to, words);
  if (target.is_nothing()) return false;
  if (target.wish >= 0 && LeadsTo(wishes_, target.wish, index)) {
    warnings_.push_back("heard in part: " + Quote(words) +
                        ": what it is to stand by stands by it already");
    return true;
  }
  const bool stands_elsewhere =
      wish.relation != ThingRelation::kNone &&
      (wish.target.wish != target.wish || wish.target.letter != target.letter);
  if (form == "facing") {
    wish.facing = target;
  } else if (stands_elsewhere && (wish.target.wish >= 0 || target.wish < 0)) {
    warnings_.push_back("heard in part: " + Quote(words) + ": it stands by something else already");
    return true;
  } else {
    wish.relation = found->relation;
    if (stands_elsewhere) {  // another thing says more exactly where than land does
      wish.side = ThingSide::kAny;
      wish.distance_m = 0.0;
    }
    if (form == "both_sides" && target.wish >= 0) {  // of a gate: one to its left, one to its right
      wish.relation = ThingRelation::kAround;
      wish.count = wish.count_least = wish.count_most = std::max(2, wish.count);
    }
    const bool in_water =
        wish.relation == ThingRelation::kIn && target.letter == class_letter::kWater;
    if (in_water && !StandsInWater(wish.kind)) wish.relation = ThingRelation::kNear;
    wish.target = target;
    if (wish.relation == ThingRelation::kBetween) {
      const Phrase* other = sentence.whole.Find("z");
      wish.second = other != nullptr ? TargetOf(*other, words) : target;
      const bool alone = other == nullptr && target.wish >= 0 &&
                         wishes_[static_cast<std::size_t>(target.wish)].count < 2;
      const bool by_itself = wish.second.wish >= 0 && LeadsTo(wishes_, wish.second.wish, index);
      if (wish.second.is_nothing() || by_itself || alone) return false;
    }
    if (form == "heading") {
      wish.side = *FromName<ThingSide>(sentence.whole.Find("heading")->text);
    }
    if (form == "near_metres") wish.distance_m = NumberOf(*sentence.whole.Find("n"));
    if (wish.count == 1 && wish.count_most == 1) FillRun(&wish);
  }
  wishes_[static_cast<std::size_t>(index)] = wish;
  return true;
}

std::vector<ThingWish> SentenceThings::wishes() const {
  std::vector<ThingWish> ordered = TargetsFirst(wishes_);
  StandByWhatTheyFace(&ordered);
  return ordered;
}

bool SentenceThings::Say(const Sentence& sentence, const std::string& words) {
  const Phrase* thing = sentence.whole.Find("x");
  if (thing == nullptr || KindOf(*thing, vocabulary_) == nullptr) return false;
  const std::string& form = sentence.form->name;
  // What it stands by is a wish before it.
  const Phrase* by = sentence.whole.Find("y");
  if (by == nullptr) by = sentence.whole.Find("end");
  const int beside = by != nullptr && IsSaidSingly(*thing) ? WishOf(*by, words) : -1;
  const int index = WishOf(*thing, words);
  if (index < 0) return false;
  ThingWish& wish = wishes_[static_cast<std::size_t>(index)];
  wish.words = words;
  if (form == "there") {
    if (const Phrase* zone = sentence.whole.Find("zone")) wish.zone = ZonesOf(*zone).front();
    return true;
  }
  if (form == "arranged") {
    wish.arrangement = *FromName<ThingArrangement>(sentence.whole.Find("pattern")->text);
    // The last number is the spacing where one is said.
    if (sentence.Says("every")) wish.spacing_m = NumberOf(*sentence.whole.FindAll("n").back());
    return true;
  }
  if (form == "scattered") return true;  // as they are anyway
  if (form == "grid" || form == "together") {
    wish.arrangement = form == "grid" ? ThingArrangement::kGrid : ThingArrangement::kCluster;
    return true;
  }
  if (form == "spaced") {
    wish.spacing_m = NumberOf(*sentence.whole.FindAll("n").back());
    if (wish.arrangement == ThingArrangement::kNone && wish.relation != ThingRelation::kAlong) {
      wish.arrangement = ThingArrangement::kRow;
    }
    return true;
  }
  if (!Relate(sentence, wish, index, beside, words)) {
    warnings_.push_back("heard in part: " + Quote(words) + ": single things know no such form");
  }
  return true;
}

}  // namespace latticeworld
