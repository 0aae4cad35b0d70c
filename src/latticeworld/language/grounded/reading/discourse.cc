#include "latticeworld/language/grounded/reading/discourse.h"

#include <algorithm>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/language/place_words.h"

namespace latticeworld {
namespace {

constexpr std::size_t kMaxRelations = 48;

bool Holds(const std::vector<int>& indices, int index) {
  return std::find(indices.begin(), indices.end(), index) != indices.end();
}

// Whether "the settlement" may be the village, "the sea" the lake: where the words differ, one of
// them must be a general one or a part of the other ("market town", "town").
bool MayMean(const ClassWord& word, const ClassWord& known) {
  if (word.shape == WordShape::kLine) return true;
  if (word.suburb != 'W' && word.suburb != 'B') return true;
  if (EndsWith(known.phrase, word.phrase) || EndsWith(word.phrase, known.phrase)) return true;
  for (const std::string_view general :
       {"coast", "coastline", "seashore", "sea", "water", "waters", "body of water", "water body",
        "open water", "settlement", "building", "buildings", "house", "houses", "built up area",
        "town", "village", "residential area"}) {
    // "the town" is no church.
    constexpr int kSettlementCells = 15;
    const bool houses = known.phrase.find("hous") != std::string_view::npos ||
                        known.phrase.find("building") != std::string_view::npos ||
                        known.phrase.find("home") != std::string_view::npos;
    const bool settlement = word.cells >= kSettlementCells && !houses;
    if (word.phrase == general) {
      return word.suburb == 'W' ||
             (word.phrase != known.phrase && (!settlement || known.cells >= kSettlementCells));
    }
  }
  return false;
}

}  // namespace

bool NamesIsland(const ClassWord& noun) {
  return noun.phrase.find("island") != std::string_view::npos ||
         noun.phrase.find("islet") != std::string_view::npos;
}

Discourse::Discourse(std::string_view instruction, Vocabulary vocabulary)
    : instruction_(instruction) {
  plan_.vocabulary = vocabulary;
}

bool Discourse::Matches(const NounPhrase& phrase, int index) const {
  const Thing& thing = this->thing(index);
  const PlannedFeature& feature = this->feature(index);
  if (thing.dropped) return false;
  // "a wooded island ...; the island": one that is told no closer.
  const bool any_island =
      thing.is_island && !phrase.indefinite && IsOneOf(phrase.noun->phrase, {"island", "islet"});
  if (!any_island && phrase.noun->LetterIn(plan_.vocabulary) != feature.letter) return false;
  const bool line = phrase.noun->shape == WordShape::kLine;
  const bool was_line = thing.noun->shape == WordShape::kLine;
  return line == was_line && NamesIsland(*phrase.noun) == thing.is_island;
}

std::vector<int> Discourse::Find(const NounPhrase& phrase, const std::vector<int>& subjects) const {
  // Things that match are looked at from the last back; those with the very same word go before
  // others of the class.
  std::vector<int> same_word;
  std::vector<int> same_class;
  for (int i = size() - 1; i >= 0; --i) {
    if (!Matches(phrase, i)) continue;
    if (!phrase.places.empty()) {
      const auto& zones = feature(i).zones;
      const bool there = std::any_of(zones.begin(), zones.end(), [&](const Zone& zone) {
        return RegionOf(zone) == phrase.places.front().main;
      });
      if (!there) continue;
    }
    same_class.push_back(i);
    if (thing(i).noun->phrase == phrase.noun->phrase) same_word.push_back(i);
  }
  const std::vector<int>& found = same_word.empty() ? same_class : same_word;
  if (found.empty()) return {};
  if (same_word.empty() && !MayMean(*phrase.noun, *thing(found[0]).noun)) return {};
  // "both", "the first", "the other" choose among them.
  switch (phrase.head) {
    case Head::kBoth:
      if (found.size() >= 2) return {found[1], found[0]};
      return {found[0]};
    case Head::kFirst:
      return {found.back()};
    case Head::kOther: {
      for (const int index : found) {
        if (!Holds(subjects, index) && !(topics_.empty() ? false : Holds(topics_.back(), index))) {
          return {index};
        }
      }
      return {found[0]};
    }
    default:
      break;
  }
  // A plural means all of them, in the order in which they were named.
  const bool many =
      phrase.plural || (phrase.qualities.count.has_value() && phrase.qualities.count->least > 1);
  if (many && found.size() > 1) {
    std::vector<int> all = found;
    std::reverse(all.begin(), all.end());
    return all;
  }
  return {found[0]};
}

std::vector<int> Discourse::Antecedent(const std::vector<int>& subjects, bool many) const {
  const auto fits = [&](const std::vector<int>& topic) {
    return !topic.empty() && std::none_of(topic.begin(), topic.end(), [&](int index) {
      return Holds(subjects, index) || thing(index).dropped;
    });
  };
  const std::size_t reach = topics_.size() > 6 ? topics_.size() - 6 : 0;
  if (many) {
    for (std::size_t i = topics_.size(); i-- > reach;) {
      if (fits(topics_[i]) && (topics_[i].size() > 1 || thing(topics_[i][0]).plural ||
                               feature(topics_[i][0]).pieces > 1)) {
        return topics_[i];
      }
    }
    const std::vector<int> two = LastTwo(subjects);
    if (two.size() == 2) return two;
  }
  for (std::size_t i = topics_.size(); i-- > reach;) {
    if (fits(topics_[i])) return {topics_[i].back()};
  }
  const std::vector<int> two = LastTwo(subjects);
  if (!two.empty()) return {two.back()};
  return {};
}

std::vector<int> Discourse::LastTwo(const std::vector<int>& subjects) const {
  std::vector<int> two;
  const std::size_t reach = mentioned_.size() > 16 ? mentioned_.size() - 16 : 0;
  for (std::size_t i = mentioned_.size(); i-- > reach && two.size() < 2;) {
    const int index = mentioned_[i];
    if (!Holds(subjects, index) && !Holds(two, index) && !thing(index).dropped &&
        !feature(index).fills_rest) {
      two.push_back(index);
    }
  }
  std::reverse(two.begin(), two.end());
  return two;
}

int Discourse::SplitOff(int index, int pieces) {
  PlannedFeature& whole = feature(index);
  if (pieces < 1 || whole.pieces <= pieces || things_.size() >= kMaxFeatures) return index;
  PlannedFeature part = whole;
  part.pieces = part.pieces_least = part.pieces_most = pieces;
  if (thing(index).zones_from_lead || whole.pieces >= 2) part.zones.clear();
  whole.pieces -= pieces;
  if (whole.pieces_least > pieces) whole.pieces_least -= pieces;
  if (whole.pieces_most > pieces) whole.pieces_most -= pieces;
  Thing thing = this->thing(index);
  thing.sentence = sentence_;
  plan_.features.push_back(std::move(part));
  things_.push_back(std::move(thing));
  Mention(size() - 1);
  return size() - 1;
}

int Discourse::Twin(int index) {
  if (feature(index).pieces >= 2) return SplitOff(index);
  if (things_.size() >= kMaxFeatures) return index;
  PlannedFeature twin = feature(index);
  twin.zones.clear();
  twin.fills_rest = false;
  twin.dominant = false;
  Thing thing = this->thing(index);
  plan_.features.push_back(std::move(twin));
  things_.push_back(std::move(thing));
  return size() - 1;
}

int Discourse::Latest(char letter, FeatureForm form) const {
  for (int i = size() - 1; i >= 0; --i) {
    if (!thing(i).dropped && feature(i).letter == letter && feature(i).form == form) return i;
  }
  return -1;
}

void Discourse::SetTopic(const std::vector<int>& subjects) {
  if (subjects.empty() || (!topics_.empty() && topics_.back() == subjects)) return;
  topics_.push_back(subjects);
}

void Discourse::Relate(PlannedRelation relation) {
  if (relation.subject < 0 || relation.object < 0 || relation.subject == relation.object) return;
  std::vector<PlannedRelation>& relations = plan_.relations;
  const bool known =
      std::any_of(relations.begin(), relations.end(), [&](const PlannedRelation& other) {
        return other.kind == relation.kind && other.subject == relation.subject &&
               other.object == relation.object && other.second_object == relation.second_object &&
               other.heading == relation.heading;
      });
  if (known) return;
  const Thing& subject = thing(relation.subject);
  const Thing& object = thing(relation.object);
  if (relation.words.empty()) {
    const std::size_t begin = std::min(subject.begin, object.begin);
    const std::size_t end = std::max(subject.end, object.end);
    relation.words =
        subject.sentence == object.sentence ? Words(begin, end) : Words(subject.begin, subject.end);
  }
  if (relations.size() == kMaxRelations) {
    plan_.warnings.push_back("too many ties for one layout: nothing is tied from " +
                             Quote(relation.words) + " on");
  }
  if (relations.size() > kMaxRelations) return;
  relations.push_back(std::move(relation));
}

void Discourse::Deny(PlannedAbsence absence) {
  plan_.absences.push_back(std::move(absence));
  named_before_denial_.push_back(size());
}

void Discourse::TakeBackDenial() {
  plan_.absences.pop_back();
  named_before_denial_.pop_back();
}

void Discourse::Drop(int index) { thing(index).dropped = true; }

}  // namespace latticeworld
