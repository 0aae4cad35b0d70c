#include "latticeworld/language/grounded/reading/discourse.h"

#include <algorithm>
#include <utility>

#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

constexpr std::size_t kMaxFeatures = 32;
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
  Describe(phrase.qualities, index);
  std::vector<Zone> zones;
  for (const Place& place : phrase.places) zones.push_back(place.zone);
  AddZones(index, zones);
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
                     said.count->most > said.count->least;
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
  if (thing.dropped || phrase.noun->LetterIn(plan_.vocabulary) != feature.letter) return false;
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

int Discourse::SplitOff(int index) {
  PlannedFeature& whole = feature(index);
  if (whole.pieces < 2 || things_.size() >= kMaxFeatures) return index;
  PlannedFeature part = whole;
  part.pieces = part.pieces_least = part.pieces_most = 1;
  if (thing(index).zones_from_lead || whole.pieces >= 2) part.zones.clear();
  --whole.pieces;
  if (whole.pieces_least > 1) --whole.pieces_least;
  if (whole.pieces_most > 1) --whole.pieces_most;
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

// Of a class that is asked for and denied altogether, what was said later counts.
void Discourse::SettleDenials() {
  std::vector<PlannedAbsence> kept;
  for (std::size_t a = 0; a < plan_.absences.size(); ++a) {
    PlannedAbsence& absence = plan_.absences[a];
    bool overruled = false;
    for (int i = 0; i < size() && absence.zone.is_anywhere(); ++i) {
      if (thing(i).dropped || feature(i).letter != absence.letter) continue;
      const std::string words = Quote(Words(thing(i).begin, thing(i).end));
      if (i >= named_before_denial_[a]) {
        overruled = true;
        plan_.warnings.push_back(Quote(absence.words) +
                                 " is overruled by what is said later: " + words);
        break;
      }
      plan_.warnings.push_back(words +
                               " is not laid, for it is said later: " + Quote(absence.words));
      Drop(i);
    }
    if (!overruled) kept.push_back(std::move(absence));
  }
  plan_.absences = std::move(kept);
}

void Discourse::Drop(int index) { thing(index).dropped = true; }

// "desert at the top, farmland in the middle, sea at the bottom": what spreads between two sides
// takes all that lies between them.
void Discourse::WidenMiddles() {
  for (int i = 0; i < size(); ++i) {
    PlannedFeature& middle = feature(i);
    if (thing(i).dropped || (middle.form != FeatureForm::kSpread && !middle.dominant) ||
        middle.zones.size() != 1 ||
        !(middle.zones.front() == ZoneOf(Heading{0, 0}) ||
          middle.zones.front() == *FindZone("middle rows"))) {
      continue;
    }
    bool sides[4] = {false, false, false, false};  // north, south, west, east
    for (int j = 0; j < size(); ++j) {
      if (thing(j).dropped || thing(j).sentence != thing(i).sentence) continue;
      for (const Zone& zone : feature(j).zones) {
        const Heading at = HeadingOf(RegionOf(zone));
        sides[0] = sides[0] || (at.south == -1 && at.east == 0);
        sides[1] = sides[1] || (at.south == 1 && at.east == 0);
        sides[2] = sides[2] || (at.east == -1 && at.south == 0);
        sides[3] = sides[3] || (at.east == 1 && at.south == 0);
      }
    }
    if (sides[0] && sides[1] && !sides[2] && !sides[3]) middle.zones = {*FindZone("middle rows")};
    if (sides[2] && sides[3] && !sides[0] && !sides[1]) {
      middle.zones = {*FindZone("middle columns")};
    }
  }
}

// "NW forest, NE houses, SW fields, SE bare soil": four that share the map by its quarters.
void Discourse::WidenQuarters() {
  for (int first = 0; first < size(); ++first) {
    std::vector<int> quarters;
    for (int i = first; i < size() && thing(i).sentence == thing(first).sentence; ++i) {
      const PlannedFeature& feature = this->feature(i);
      const bool counted = feature.pieces_least > 0 || feature.form == FeatureForm::kLine;
      if (thing(i).dropped || counted || feature.zones.size() != 1) continue;
      const Heading at = HeadingOf(RegionOf(feature.zones.front()));
      const bool ninth = at.IsDiagonal() && feature.zones.front() == ZoneOf(at);
      const bool again = std::any_of(quarters.begin(), quarters.end(), [&](int other) {
        return this->feature(other).zones == feature.zones;
      });
      if (ninth && !again) quarters.push_back(i);
    }
    if (quarters.size() != 4) continue;
    const std::string words = ToLowerAscii(instruction_);
    const bool said =
        words.find("quadrant") != std::string::npos || words.find("quarter") != std::string::npos;
    const bool spread = std::all_of(quarters.begin(), quarters.end(), [&](int i) {
      return feature(i).form == FeatureForm::kSpread || thing(i).plural;
    });
    if (!said && !spread) continue;
    for (const int i : quarters) {
      PlannedFeature& feature = this->feature(i);
      const Heading at = HeadingOf(RegionOf(feature.zones.front()));
      const std::string name = std::string(at.south < 0 ? "north" : "south") +
                               (at.east < 0 ? "-western" : "-eastern") + " quarter";
      feature.zones = {*FindZone(name)};
      feature.form = FeatureForm::kSpread;
      feature.pieces = 0;
      feature.dominant = true;
      if (said) feature.share_least = std::max(feature.share_least.value_or(0.0), 0.5);
    }
  }
}

// An island needs water to lie in.
void Discourse::SettleIslands() {
  bool water = false;
  for (int i = 0; i < size(); ++i) {
    water = water || (!thing(i).dropped && feature(i).letter == 'W' &&
                      feature(i).form != FeatureForm::kLine);
  }
  for (int i = 0; i < size() && !water; ++i) {
    if (thing(i).dropped || !thing(i).is_island) continue;
    plan_.warnings.push_back("there is no lake or sea for " +
                             Quote(Words(thing(i).begin, thing(i).end)) + " to lie in");
    Drop(i);
  }
  // "A lake. An island.": in the first water there is.
  for (int i = 0; i < size() && water; ++i) {
    if (thing(i).dropped || !thing(i).is_island) continue;
    const bool placed = std::any_of(
        plan_.relations.begin(), plan_.relations.end(), [&](const PlannedRelation& relation) {
          return relation.kind == RelationKind::kWithin && relation.subject == i;
        });
    for (int j = 0; j < size() && !placed; ++j) {
      if (thing(j).dropped || feature(j).letter != 'W' || feature(j).form == FeatureForm::kLine) {
        continue;
      }
      PlannedRelation relation;
      relation.kind = RelationKind::kWithin;
      relation.subject = i;
      relation.object = j;
      Relate(std::move(relation));
      break;
    }
  }
}

// "a river and jungle, nothing else": what spreads takes all the land, the first where it is two.
void Discourse::SettleRest() {
  if (!all_is_said_) return;
  int land = -1;
  for (int i = 0; i < size(); ++i) {
    const PlannedFeature& feature = this->feature(i);
    if (thing(i).dropped || feature.form != FeatureForm::kSpread) continue;
    if (feature.fills_rest) return;
    const bool open =
        feature.zones.empty() && !feature.share.has_value() && feature.texture == Texture::kUnsaid;
    if (open && land < 0) land = i;
  }
  if (land >= 0) feature(land).fills_rest = true;
}

// "A crossroads in the centre: one road north-south, the other east-west": two roads that cross,
// those that are spoken of, else two of its own.
void Discourse::SettleCrossroads() {
  for (int i = 0; i < size(); ++i) {
    const std::string_view noun = thing(i).noun->phrase;
    const bool crossing = noun == "crossroads" || noun == "crossroad" || noun == "intersection" ||
                          noun == "junction" || noun == "road crossing";
    if (thing(i).dropped || !crossing || feature(i).form != FeatureForm::kLine) continue;
    std::vector<int> roads;
    for (int j = 0; j < size(); ++j) {
      const bool road = j != i && !thing(j).dropped && feature(j).letter == feature(i).letter &&
                        feature(j).form == FeatureForm::kLine;
      if (road) roads.push_back(j);
    }
    const bool tied = feature(i).from.has_value() || feature(i).to.has_value() ||
                      feature(i).along.has_value() || roads.size() == 1 || roads.size() > 2;
    if (tied) continue;
    const std::vector<Zone> zones = feature(i).zones;
    if (roads.empty()) {
      const int second = Twin(i);
      if (second == i) continue;
      roads = {i, second};
      for (const bool down : {true, false}) {
        PlannedFeature& road = feature(roads[down ? 0 : 1]);
        Waypoint from;
        from.zone = RimZoneOf(down ? Heading{0, -1} : Heading{-1, 0});
        from.said = false;
        Waypoint to;
        to.zone = RimZoneOf(down ? Heading{0, 1} : Heading{1, 0});
        to.said = false;
        road.from = from;
        road.to = to;
        road.zones.clear();
      }
    } else {
      for (PlannedRelation& relation : plan_.relations) {
        if (relation.subject == i) relation.subject = roads[0];
        if (relation.object == i) relation.object = roads[0];
      }
      Drop(i);
    }
    for (const int road : roads) {
      if (zones.size() != 1 || !feature(road).via.empty()) continue;
      Waypoint via;
      via.zone = zones.front();
      feature(road).via.push_back(std::move(via));
    }
    PlannedRelation crosses;
    crosses.kind = RelationKind::kCrosses;
    crosses.subject = roads[0];
    crosses.object = roads[1];
    Relate(std::move(crosses));
  }
}

// What runs along an edge, and nothing more is said, runs all along it.
void Discourse::SettleAlong() {
  for (int i = 0; i < size(); ++i) {
    PlannedFeature& line = feature(i);
    const bool open = line.form == FeatureForm::kLine && line.along.has_value() &&
                      !line.from.has_value() && !line.to.has_value() && line.pieces <= 1;
    if (!open || !EndsWith(line.along->name, " edge")) continue;
    const Heading side = HeadingOf(RegionOf(*line.along));
    const Heading way = {side.south != 0 ? 1 : 0, side.east != 0 ? 1 : 0};
    Waypoint from;
    from.zone = RimZoneOf({side.east - way.east, side.south - way.south});
    Waypoint to;
    to.zone = RimZoneOf({side.east + way.east, side.south + way.south});
    line.from = from;
    line.to = to;
  }
}

// "sea, behind it a beach, behind that a town": what goes on in one direction is an order.
void Discourse::SettleChains() {
  const std::vector<PlannedRelation>& relations = plan_.relations;
  const auto next_of = [&](int object, Claim::Heading heading) {
    for (const PlannedRelation& relation : relations) {
      if (relation.kind == RelationKind::kDirection && relation.object == object &&
          relation.heading == heading && !thing(relation.subject).dropped) {
        return relation.subject;
      }
    }
    return -1;
  };
  for (const PlannedRelation& first : relations) {
    if (first.kind != RelationKind::kDirection || thing(first.object).dropped) continue;
    const bool begins =
        std::none_of(relations.begin(), relations.end(), [&](const PlannedRelation& other) {
          return other.kind == RelationKind::kDirection && other.subject == first.object &&
                 other.heading == first.heading;
        });
    if (!begins) continue;
    PlannedOrder order;
    order.heading = first.heading;
    order.words = first.words;
    for (int at = first.object; at >= 0 && order.features.size() < 8;
         at = next_of(at, first.heading)) {
      order.features.push_back(at);
    }
    const bool known =
        std::any_of(plan_.orders.begin(), plan_.orders.end(), [&](const PlannedOrder& other) {
          return other.features.front() == order.features.front();
        });
    if (order.features.size() >= 3 && !known) plan_.orders.push_back(std::move(order));
  }
}

// "All but one lie in the forest that fills the lower half": so they lie there.
void Discourse::PlaceContained() {
  for (const PlannedRelation& relation : plan_.relations) {
    if (relation.kind != RelationKind::kWithin) continue;
    PlannedFeature& inner = feature(relation.subject);
    const PlannedFeature& outer = feature(relation.object);
    const bool counted = inner.pieces_least > 0 && inner.form == FeatureForm::kPatch;
    if (counted && inner.zones.empty() && outer.zones.size() == 1 && outer.dominant) {
      inner.zones = outer.zones;
    }
  }
}

// "a wooded spit sticks out from the western edge into the lake": it lies there, and runs nowhere.
void Discourse::SettleOpenEnds() {
  for (int i = 0; i < size(); ++i) {
    PlannedFeature& feature = this->feature(i);
    if (feature.form == FeatureForm::kLine) continue;
    if (feature.from.has_value() && feature.from->feature < 0 && !feature.to.has_value()) {
      AddZones(i, {feature.from->zone});
      feature.from.reset();
    }
  }
}

LayoutPlan Discourse::Finish() {
  SettleOpenEnds();
  SettleAlong();
  SettleCrossroads();
  SettleDenials();
  SettleIslands();
  WidenMiddles();
  WidenQuarters();
  PlaceContained();
  SettleChains();
  SettleRest();
  std::vector<int> moved(things_.size(), -1);
  std::vector<PlannedFeature> features;
  for (int i = 0; i < size(); ++i) {
    if (thing(i).dropped) continue;
    moved[static_cast<std::size_t>(i)] = static_cast<int>(features.size());
    feature(i).words = Words(thing(i).begin, thing(i).end);
    features.push_back(std::move(feature(i)));
  }
  const auto move = [&](int* index) {
    if (*index >= 0) *index = moved[static_cast<std::size_t>(*index)];
  };
  for (PlannedFeature& feature : features) {
    for (std::optional<Waypoint>* end : {&feature.from, &feature.to}) {
      if (!end->has_value() || (*end)->feature < 0) continue;
      move(&(*end)->feature);
      if ((*end)->feature < 0) end->reset();
    }
    for (Waypoint& waypoint : feature.via) move(&waypoint.feature);
    feature.via.erase(std::remove_if(feature.via.begin(), feature.via.end(),
                                     [](const Waypoint& waypoint) {
                                       return waypoint.feature < 0 && waypoint.zone.is_anywhere();
                                     }),
                      feature.via.end());
  }
  std::vector<PlannedRelation> relations;
  for (PlannedRelation& relation : plan_.relations) {
    const bool two = relation.second_object >= 0;
    move(&relation.subject);
    move(&relation.object);
    move(&relation.second_object);
    if (relation.subject < 0 || relation.object < 0 || (two && relation.second_object < 0)) {
      continue;
    }
    relations.push_back(std::move(relation));
  }
  for (PlannedOrder& order : plan_.orders) {
    for (int& index : order.features) move(&index);
    order.features.erase(std::remove(order.features.begin(), order.features.end(), -1),
                         order.features.end());
  }
  plan_.features = std::move(features);
  plan_.relations = std::move(relations);
  return std::move(plan_);
}

}  // namespace latticeworld
