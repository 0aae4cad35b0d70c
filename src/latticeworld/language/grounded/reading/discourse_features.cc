#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "latticeworld/common/text.h"
#include "latticeworld/language/grounded/reading/discourse.h"
#include "latticeworld/language/place_words.h"

// The things that are named, and what their words say of each.
namespace latticeworld {
namespace {

constexpr int kMaxPieces = 24;
constexpr int kSmallCells = 6;  // "houses" of this size stand together, "lakes" apart
constexpr double kWinding = 2.2;
constexpr double kStraight = 0.1;

// A word for one of the many small things that a class is made of.
bool IsCrowd(const ClassWord& noun) {
  for (const std::string_view one : {"tree", "trees", "bush", "bushes", "shrub", "shrubs", "rock",
                                     "rocks", "stone", "stones", "boulder", "boulders"}) {
    if (EndsWith(noun.phrase, one)) return true;
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

// A feature as its noun alone has it.
PlannedFeature FeatureOf(const NounPhrase& phrase, Vocabulary vocabulary) {
  PlannedFeature feature;
  feature.letter = phrase.noun->LetterIn(vocabulary);
  if (phrase.head == Head::kBoth && !phrase.qualities.count.has_value()) {
    feature.pieces = feature.pieces_least = feature.pieces_most = 2;  // "the two roads"
  }
  feature.form = FormOf(phrase.noun->shape);
  feature.cells = std::max(1, phrase.noun->cells);
  feature.noun = phrase.noun->phrase;
  feature.plural = phrase.plural;
  // "five separate farms, spread out": the homesteads.
  const bool homestead = feature.letter == 'A' && vocabulary == Vocabulary::kSuburb &&
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
  if (phrase.noun->phrase.find("grid") != std::string_view::npos) {
    feature.shape = ClaimShape::kGridded;
  }
  if (IsOneOf(phrase.noun->phrase, {"loop road", "circular road", "ring road", "moat"})) {
    feature.shape = ClaimShape::kRing;
  }
  return feature;
}

// Sets as many pieces as the count allows.
void SetCount(const CountMatch& count, const Thing& thing, Vocabulary vocabulary,
              PlannedFeature* feature) {
  feature->pieces_least = std::min(std::max(1, count.least), kMaxPieces);
  const bool bounded = count.most != CountMatch::kUnbounded;
  feature->pieces_most = bounded ? std::min(std::max(1, count.most), kMaxPieces) : 0;
  feature->pieces = bounded ? std::max(1, (feature->pieces_least + feature->pieces_most) / 2)
                            : feature->pieces_least + 1;
  // "lots of houses" make a place of some size.
  const bool quarter = !bounded && count.least == 4 && feature->letter == 'B' &&
                       vocabulary == Vocabulary::kSuburb && thing.plural &&
                       feature->form == FeatureForm::kPatch;
  if (quarter) {
    constexpr int kBlocks = 7;
    constexpr int kBlockCells = 20;
    feature->pieces = kBlocks;
    feature->cells = std::max(feature->cells, kBlockCells);
    feature->share_least = std::max(feature->share_least.value_or(0.0), 0.1);
  }
}

// It covers little of the map.
void SetLittle(PlannedFeature* feature) {
  feature->share = 0.06;
  feature->share_least = 0.002;
  feature->share_most = 0.25;
}

void DescribeCount(const Qualities& said, const Thing& thing, Vocabulary vocabulary,
                   PlannedFeature* feature) {
  const bool of_mass = feature->form == FeatureForm::kSpread;
  // "many trees": much of it, not so many woods.
  const bool crowd = of_mass && said.count.has_value() && said.count->least == 4 &&
                     said.count->most == CountMatch::kUnbounded && IsCrowd(*thing.noun);
  const bool vague = said.count.has_value() && said.count->least <= 3 && said.count->most <= 7 &&
                     said.count->most > said.count->least &&
                     (said.count->least >= 2 || IsCrowd(*thing.noun));
  if (of_mass && vague && said.count->most != 1) {
    SetLittle(feature);  // "a few trees": not so many woods, but a little of it.
  } else if (crowd) {
    feature->cells *= 2;
  } else if (said.count.has_value()) {
    SetCount(*said.count, thing, vocabulary, feature);
  } else if (said.few && feature->form != FeatureForm::kSpread) {
    feature->pieces = 3;
    feature->pieces_least = 2;
    feature->pieces_most = 5;
  } else if (said.group && feature->form != FeatureForm::kSpread && feature->pieces_least == 0) {
    feature->pieces = 4;
  }
}

void DescribeShare(const ShareMatch& share, bool at_most, PlannedFeature* feature) {
  if (share.mostly && !share.fraction) {
    feature->dominant = true;
    if (share.least >= 0.6) feature->share_least = share.least;
  } else if (BoundsShare(*feature, share)) {
    // "at least 10 percent ... At most 20 percent": both hold.
    const bool upper = share.most < 1.0;
    (upper ? feature->share_most : feature->share_least) = upper ? share.most : share.least;
    feature->share = (*feature->share_least + *feature->share_most) / 2.0;
  } else {
    feature->share = share.value;
    feature->share_least = share.least;
    feature->share_most = share.most;
    if (at_most) {
      feature->share = 0.7 * share.value;
      feature->share_least = 0.002;
      feature->share_most = share.value;
    }
  }
}

// How much of it there is: its size, its width, its part of the map. `spread`: it was a mass before
// its pieces were counted.
void DescribeSize(const Qualities& said, bool spread, PlannedFeature* feature) {
  if (said.mostly) feature->dominant = true;
  if (said.size != 1.0) feature->cells = std::max(2, static_cast<int>(feature->cells * said.size));
  if (said.least_share > 0.0 && feature->form != FeatureForm::kLine && feature->pieces <= 1) {
    feature->share_least = std::max(feature->share_least.value_or(0.0), said.least_share);
  }
  if (said.width > 1.0 || (feature->form == FeatureForm::kLine && said.size > 1.0)) {
    feature->wide = feature->form == FeatureForm::kLine;
  }
  if ((said.little || (said.few && spread)) && !said.share.has_value() &&
      feature->form != FeatureForm::kLine) {
    SetLittle(feature);
  }
  if (said.much && feature->form != FeatureForm::kLine) {
    feature->cells *= 2;
  }
}

void DescribeShape(ClaimShape shape, PlannedFeature* feature) {
  feature->shape = shape;
  if (shape == ClaimShape::kWinding) feature->meander = kWinding;
  if (shape == ClaimShape::kStraight) feature->meander = kStraight;
  if (shape == ClaimShape::kElongated && feature->form == FeatureForm::kLine) {
    feature->shape.reset();  // every line is long
  }
}

void DescribeAxis(const AxisMatch& axis, PlannedFeature* feature) {
  Waypoint from;
  from.zone = RimZoneOf(axis.from);
  Waypoint to;
  to.zone = RimZoneOf(axis.to);
  // "a stretch of water from one side to the other" runs like a river, and is wide.
  if (feature->form != FeatureForm::kLine) {
    feature->form = FeatureForm::kLine;
    feature->wide = true;
    feature->pieces = feature->pieces_least = feature->pieces_most = 0;
  }
  feature->from = from;
  feature->to = to;
}

// What stands in the plural without a number: several lakes, a group of houses.
void SupposeSeveral(const Thing& thing, PlannedFeature* feature) {
  if (thing.plural && feature->form == FeatureForm::kPatch && feature->pieces == 0 &&
      !feature->dominant) {
    if (feature->cells < kSmallCells && feature->texture != Texture::kScattered) {
      feature->cells = 30;
    } else if (feature->texture == Texture::kUnsaid) {
      feature->pieces = 3;
    }
  }
}

}  // namespace

bool Discourse::MayCreate(const NounPhrase& phrase, const std::string& words) {
  const std::string vocabulary(NameOf(plan_.vocabulary));
  const char letter = phrase.noun->LetterIn(plan_.vocabulary);
  if (letter == '\0') {
    plan_.warnings.push_back("the " + vocabulary + " vocabulary has nothing like " + Quote(words) +
                             "; it is not placed");
    return false;
  }
  if (things_.size() >= kMaxFeatures) {
    if (!full_) {
      plan_.warnings.push_back("too many things for one layout: nothing is laid from " +
                               Quote(words) + " on");
    }
    full_ = true;
    return false;
  }
  if (!phrase.noun->IsExactIn(plan_.vocabulary)) {
    plan_.warnings.push_back(Quote(words) + " is laid as " +
                             std::string(FindClass(plan_.vocabulary, letter)->name) +
                             ", the nearest class of the " + vocabulary + " vocabulary");
  }
  return true;
}

int Discourse::Create(const NounPhrase& phrase, std::size_t begin, std::size_t end) {
  if (!MayCreate(phrase, Words(begin, end))) return -1;
  Thing thing;
  thing.noun = phrase.noun;
  thing.plural = phrase.plural;
  thing.is_island = NamesIsland(*phrase.noun);
  thing.sentence = sentence_;
  thing.begin = begin;
  thing.end = end;
  plan_.features.push_back(FeatureOf(phrase, plan_.vocabulary));
  things_.push_back(std::move(thing));
  const int index = size() - 1;
  Describe(phrase.qualities, index);
  std::vector<Zone> zones;
  for (const Place& place : phrase.places) zones.push_back(place.zone);
  AddZones(index, zones);
  if (phrase.noun->LetterIn(plan_.vocabulary) == 'B' &&
      feature(index).shape == ClaimShape::kGridded) {
    LayStreets(index, begin, end);
  }
  Mention(index);
  return index;
}

void Discourse::LayStreets(int city, std::size_t begin, std::size_t end) {
  feature(city).shape.reset();
  const std::vector<Token> words = Tokenize("street grid");
  NounPhrase streets;
  streets.noun = MatchClassWord(words, 0).word;
  const bool known = Latest('R', FeatureForm::kLine) >= 0;
  if (streets.noun == nullptr || known || plan_.vocabulary != Vocabulary::kSuburb) return;
  const int grid = Create(streets, begin, end);
  if (grid < 0) return;
  PlannedRelation near;
  near.kind = RelationKind::kNear;
  near.subject = grid;
  near.object = city;
  near.steps = 4.0;
  Relate(std::move(near));
  mentioned_.pop_back();
}

void Discourse::Describe(const Qualities& said, int index) {
  PlannedFeature& feature = this->feature(index);
  const Thing& thing = this->thing(index);
  DescribeCount(said, thing, plan_.vocabulary, &feature);
  const bool spread = feature.form == FeatureForm::kSpread;
  if (spread && feature.pieces > 1) {
    feature.form = FeatureForm::kPatch;
    feature.cells = std::clamp(240 / feature.pieces, 4, feature.cells);
  }
  if (said.share.has_value()) DescribeShare(*said.share, said.at_most, &feature);
  DescribeSize(said, spread, &feature);
  if (said.texture != Texture::kUnsaid) feature.texture = said.texture;
  if (said.shape.has_value()) DescribeShape(*said.shape, &feature);
  if (said.axis.has_value()) DescribeAxis(*said.axis, &feature);
  SupposeSeveral(thing, &feature);
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

}  // namespace latticeworld
