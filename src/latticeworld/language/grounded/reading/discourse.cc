#include "latticeworld/language/grounded/reading/discourse.h"

#include <algorithm>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/language/place_words.h"

namespace latticeworld {
namespace {

constexpr std::size_t kMaxRelations = 48;
constexpr int kMaxPieces = 24;
constexpr int kSmallCells = 6;  // "houses" of this size stand together, "lakes" apart
constexpr double kWinding = 2.2;
constexpr double kStraight = 0.1;

bool Holds(const std::vector<int>& indices, int index) {
  return std::find(indices.begin(), indices.end(), index) != indices.end();
}

bool NamesIsland(const ClassWord& noun) {
  return noun.phrase.find("island") != std::string_view::npos ||
         noun.phrase.find("islet") != std::string_view::npos;
}

// A word for one of the many small things that a class is made of.
bool IsCrowd(const ClassWord& noun) {
  for (const std::string_view one : {"tree", "trees", "bush", "bushes", "shrub", "shrubs", "rock",
                                     "rocks", "stone", "stones", "boulder", "boulders"}) {
    if (EndsWith(noun.phrase, one)) return true;
  }
  return false;
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

// Whether the share bounds from one side what was bounded from the other.
bool BoundsShare(const PlannedFeature& feature, const ShareMatch& share) {
  constexpr double kSome = 0.01;  // "at most" allows less
  if (!share.fraction || !feature.share.has_value() || !feature.share_least.has_value() ||
      !feature.share_most.has_value()) {
    return false;
  }
  const bool above = *feature.share_least > kSome && *feature.share_most >= 1.0;
  const bool below = *feature.share_least <= kSome && *feature.share_most < 1.0;
  const bool upper = share.least <= kSome && share.most < 1.0;
  const bool lower = share.least > kSome && share.most >= 1.0;
  return (above && upper && *feature.share_least < share.most) ||
         (below && lower && share.least < *feature.share_most);
}

FeatureForm FormOf(WordShape shape) {
  switch (shape) {
    case WordShape::kThing:
      return FeatureForm::kPatch;
    case WordShape::kLine:
      return FeatureForm::kLine;
    case WordShape::kMass:
      break;
  }
  return FeatureForm::kSpread;
}

}  // namespace

Discourse::Discourse(std::string_view instruction, Vocabulary vocabulary)
    : instruction_(instruction) {
  plan_.vocabulary = vocabulary;
}

int Discourse::Create(const NounPhrase& phrase, std::size_t begin, std::size_t end) {
  const std::string vocabulary(NameOf(plan_.vocabulary));
  const char letter = phrase.noun->LetterIn(plan_.vocabulary);
  if (letter == '\0') {
    plan_.warnings.push_back("the " + vocabulary + " vocabulary has nothing like " +
                             Quote(Words(begin, end)) + "; it is not placed");
    return -1;
  }
  if (things_.size() >= kMaxFeatures) {
    if (!full_) {
      plan_.warnings.push_back("too many things for one layout: nothing is laid from " +
                               Quote(Words(begin, end)) + " on");
    }
    full_ = true;
    return -1;
  }
  if (!phrase.noun->IsExactIn(plan_.vocabulary)) {
    plan_.warnings.push_back(Quote(Words(begin, end)) + " is laid as " +
                             std::string(FindClass(plan_.vocabulary, letter)->name) +
                             ", the nearest class of the " + vocabulary + " vocabulary");
  }
  PlannedFeature feature;
  feature.letter = letter;
  if (phrase.head == Head::kBoth && !phrase.qualities.count.has_value()) {
    feature.pieces = feature.pieces_least = feature.pieces_most = 2;  // "the two roads"
  }
  feature.form = FormOf(phrase.noun->shape);
  feature.cells = std::max(1, phrase.noun->cells);
  feature.noun = phrase.noun->phrase;
  feature.plural = phrase.plural;
  // "five separate farms, spread out": the homesteads.
  const bool homestead = letter == 'A' && plan_.vocabulary == Vocabulary::kSuburb &&
                         EndsWith(phrase.noun->phrase, "farm") &&
                         phrase.qualities.count.has_value() &&
                         phrase.qualities.texture == Texture::kScattered;
  if (homestead) {
    feature.letter = 'B';
    feature.cells = kSmallCells;
  }
  // "water in the east", as "forest in the east"
  const bool mass = phrase.noun->phrase == "water" && !phrase.indefinite && !phrase.plural &&
                    !phrase.qualities.any && !phrase.definite;
  if (mass) {
    feature.form = FeatureForm::kSpread;
    feature.cells = 2 * feature.cells;
  }
  Thing thing;
  thing.noun = phrase.noun;
  thing.plural = phrase.plural;
  thing.is_island = NamesIsland(*phrase.noun);
  thing.sentence = sentence_;
  thing.begin = begin;
  thing.end = end;
  plan_.features.push_back(std::move(feature));
  things_.push_back(std::move(thing));
  const int index = size() - 1;
  if (phrase.noun->phrase.find("grid") != std::string_view::npos) {
    this->feature(index).shape = ClaimShape::kGridded;
  }
  if (IsOneOf(phrase.noun->phrase, {"loop road", "circular road", "ring road", "moat"})) {
    this->feature(index).shape = ClaimShape::kRing;
  }
  Describe(phrase.qualities, index);
  std::vector<Zone> zones;
  for (const Place& place : phrase.places) zones.push_back(place.zone);
  AddZones(index, zones);
  // "grid city": its streets are.
  if (letter == 'B' && this->feature(index).shape == ClaimShape::kGridded) {
    this->feature(index).shape.reset();
    const std::vector<Token> words = Tokenize("street grid");
    NounPhrase streets;
    streets.noun = MatchClassWord(words, 0).word;
    const bool known = Latest('R', FeatureForm::kLine) >= 0;
    if (streets.noun != nullptr && !known && plan_.vocabulary == Vocabulary::kSuburb) {
      const int grid = Create(streets, begin, end);
      if (grid >= 0) {
        PlannedRelation near;
        near.kind = RelationKind::kNear;
        near.subject = grid;
        near.object = index;
        near.steps = 4.0;
        Relate(std::move(near));
        mentioned_.pop_back();
      }
    }
  }
  Mention(index);
  return index;
}

void Discourse::Describe(const Qualities& said, int index) {
  PlannedFeature& feature = this->feature(index);
  const bool of_mass = feature.form == FeatureForm::kSpread;
  // "many trees": much of it, not so many woods.
  const bool crowd = of_mass && said.count.has_value() && said.count->least == 4 &&
                     said.count->most == CountMatch::kUnbounded && IsCrowd(*thing(index).noun);
  const bool vague = said.count.has_value() && said.count->least <= 3 && said.count->most <= 7 &&
                     said.count->most > said.count->least &&
                     (said.count->least >= 2 || IsCrowd(*thing(index).noun));
  if (of_mass && vague && said.count->most != 1) {
    // "a few trees": not so many woods, but a little of it.
    feature.share = 0.06;
    feature.share_least = 0.002;
    feature.share_most = 0.25;
  } else if (crowd) {
    feature.cells *= 2;
  } else if (said.count.has_value()) {
    const CountMatch& count = *said.count;
    feature.pieces_least = std::min(std::max(1, count.least), kMaxPieces);
    const bool bounded = count.most != CountMatch::kUnbounded;
    feature.pieces_most = bounded ? std::min(std::max(1, count.most), kMaxPieces) : 0;
    feature.pieces = bounded ? std::max(1, (feature.pieces_least + feature.pieces_most) / 2)
                             : feature.pieces_least + 1;
    // "lots of houses" make a place of some size.
    const bool quarter = !bounded && count.least == 4 && feature.letter == 'B' &&
                         plan_.vocabulary == Vocabulary::kSuburb && thing(index).plural &&
                         feature.form == FeatureForm::kPatch;
    if (quarter) {
      constexpr int kBlocks = 7;
      constexpr int kBlockCells = 20;
      feature.pieces = kBlocks;
      feature.cells = std::max(feature.cells, kBlockCells);
      feature.share_least = std::max(feature.share_least.value_or(0.0), 0.1);
    }
  } else if (said.few && feature.form != FeatureForm::kSpread) {
    feature.pieces = 3;
    feature.pieces_least = 2;
    feature.pieces_most = 5;
  } else if (said.group && feature.form != FeatureForm::kSpread && feature.pieces_least == 0) {
    feature.pieces = 4;
  }
  const bool spread = feature.form == FeatureForm::kSpread;
  if (spread && feature.pieces > 1) {
    feature.form = FeatureForm::kPatch;
    feature.cells = std::clamp(240 / feature.pieces, 4, feature.cells);
  }
  if (said.share.has_value()) {
    const ShareMatch& share = *said.share;
    if (share.mostly && !share.fraction) {
      feature.dominant = true;
      if (share.least >= 0.6) feature.share_least = share.least;
    } else if (BoundsShare(feature, share)) {
      // "at least 10 percent ... At most 20 percent": both hold.
      const bool upper = share.most < 1.0;
      (upper ? feature.share_most : feature.share_least) = upper ? share.most : share.least;
      feature.share = (*feature.share_least + *feature.share_most) / 2.0;
    } else {
      feature.share = share.value;
      feature.share_least = share.least;
      feature.share_most = share.most;
      if (said.at_most) {
        feature.share = 0.7 * share.value;
        feature.share_least = 0.002;
        feature.share_most = share.value;
      }
    }
  }
  if (said.mostly) feature.dominant = true;
  if (said.size != 1.0) feature.cells = std::max(2, static_cast<int>(feature.cells * said.size));
  if (said.least_share > 0.0 && feature.form != FeatureForm::kLine && feature.pieces <= 1) {
    feature.share_least = std::max(feature.share_least.value_or(0.0), said.least_share);
  }
  if (said.width > 1.0 || (feature.form == FeatureForm::kLine && said.size > 1.0)) {
    feature.wide = feature.form == FeatureForm::kLine;
  }
  if ((said.little || (said.few && spread)) && !said.share.has_value() &&
      feature.form != FeatureForm::kLine) {
    feature.share = 0.06;
    feature.share_least = 0.002;
    feature.share_most = 0.25;
  }
  if (said.much && feature.form != FeatureForm::kLine) {
    feature.cells *= 2;
  }
  if (said.texture != Texture::kUnsaid) feature.texture = said.texture;
  if (said.shape.has_value()) {
    feature.shape = said.shape;
    if (*said.shape == ClaimShape::kWinding) feature.meander = kWinding;
    if (*said.shape == ClaimShape::kStraight) feature.meander = kStraight;
    if (*said.shape == ClaimShape::kElongated && feature.form == FeatureForm::kLine) {
      feature.shape.reset();  // every line is long
    }
  }
  if (said.axis.has_value()) {
    Waypoint from;
    from.zone = RimZoneOf(said.axis->from);
    Waypoint to;
    to.zone = RimZoneOf(said.axis->to);
    // "a stretch of water from one side to the other" runs like a river, and is wide.
    if (feature.form != FeatureForm::kLine) {
      feature.form = FeatureForm::kLine;
      feature.wide = true;
      feature.pieces = feature.pieces_least = feature.pieces_most = 0;
    }
    feature.from = from;
    feature.to = to;
  }
  // What stands in the plural without a number: several lakes, a group of houses.
  const Thing& thing = this->thing(index);
  if (thing.plural && feature.form == FeatureForm::kPatch && feature.pieces == 0 &&
      !feature.dominant) {
    if (feature.cells < kSmallCells && feature.texture != Texture::kScattered) {
      feature.cells = 30;
    } else if (feature.texture == Texture::kUnsaid) {
      feature.pieces = 3;
    }
  }
}

void Discourse::AddZones(int index, const std::vector<Zone>& zones) {
  PlannedFeature& feature = this->feature(index);
  for (const Zone& zone : zones) {
    if (zone.is_anywhere()) continue;
    const bool known =
        std::find(feature.zones.begin(), feature.zones.end(), zone) != feature.zones.end();
    if (!known) feature.zones.push_back(zone);
  }
}

void Discourse::Extend(int index, std::size_t end) {
  Thing& thing = this->thing(index);
  if (thing.sentence == sentence_) thing.end = std::max(thing.end, end);
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
