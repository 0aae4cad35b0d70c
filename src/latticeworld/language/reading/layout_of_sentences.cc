#include "latticeworld/language/reading/layout_of_sentences.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/language/class_words.h"
#include "latticeworld/language/grounded/reading/claims_of_plan.h"
#include "latticeworld/language/grounded/reading/discourse.h"
#include "latticeworld/language/grounded/reading/frame.h"
#include "latticeworld/language/grounded/reading/settle_plan.h"
#include "latticeworld/language/reading/sentence_places.h"
#include "latticeworld/language/sentences/sentence.h"
#include "latticeworld/language/tokens.h"

namespace latticeworld {
namespace {

constexpr double kPercentRoom = 0.08;  // that "30 %" leaves to either side
constexpr double kApartSteps = 3.0;
constexpr double kFarSteps = 8.0;
constexpr double kFilled = 0.5;  // of a place, at the least, that a thing is said to fill
constexpr double kMostCounted = 1000.0;
constexpr double kMostOfIt = 0.6;  // of a class, at the least, of which most is somewhere

double NumberOf(const Phrase& phrase) { return std::strtod(phrase.text.c_str(), nullptr); }

// The bounds of a phrase with one or two numbers: "at least 3", "2 to 4", "5".
struct Bounds {
  double least = 0.0;
  double most = 0.0;
  bool open_below = false;
  bool open_above = false;
};
Bounds BoundsOf(const Phrase& phrase) {
  const std::vector<const Phrase*> numbers = phrase.FindAll("n");
  Bounds bounds;
  bounds.least = NumberOf(*numbers.front());
  bounds.most = NumberOf(*numbers.back());
  if (bounds.least > bounds.most) std::swap(bounds.least, bounds.most);
  bounds.open_above = StartsWith(phrase.text, "at least");
  bounds.open_below = StartsWith(phrase.text, "at most");
  return bounds;
}

CountMatch CountOf(const Phrase& quantity) {
  const Bounds bounds = BoundsOf(quantity);
  const auto whole = [](double value) {
    return static_cast<int>(std::lround(std::clamp(value, 0.0, kMostCounted)));
  };
  CountMatch count;
  count.least = bounds.open_below ? 0 : whole(bounds.least);
  count.most = bounds.open_above ? CountMatch::kUnbounded : whole(bounds.most);
  count.tokens = 1;
  return count;
}

ShareMatch ShareOf(const Phrase& percent) {
  constexpr double kSome = 0.002;
  Bounds bounds = BoundsOf(percent);
  const double low = std::clamp(bounds.least / 100.0, 0.0, 1.0);
  const double high = std::clamp(bounds.most / 100.0, 0.0, 1.0);
  ShareMatch share;
  share.fraction = true;
  share.tokens = 1;
  if (bounds.open_above) {
    share.least = low;
    share.value = std::min(1.0, low + kPercentRoom);
  } else if (bounds.open_below) {
    share.least = kSome;
    share.most = high;
    share.value = 0.7 * high;
  } else {
    const double room = low == high ? kPercentRoom : 0.0;
    share.value = (low + high) / 2.0;
    share.least = std::max(low - room, std::min(low, kSome));
    share.most = std::min(1.0, high + room);
  }
  return share;
}

void AddSize(std::string_view size, Qualities* qualities) {
  constexpr double kLargeShare = 0.08;
  qualities->size *= size == "tiny" ? 0.25 : size == "small" ? 0.5 : size == "large" ? 1.8 : 3.0;
  if (size == "large" || size == "huge") qualities->least_share = kLargeShare;
  qualities->any = true;
}

void AddShape(std::string_view shape, Qualities* qualities) {
  constexpr std::pair<std::string_view, ClaimShape> kShapes[] = {
      {"round", ClaimShape::kRound},       {"long", ClaimShape::kElongated},
      {"curved", ClaimShape::kBent},       {"ring-shaped", ClaimShape::kRing},
      {"straight", ClaimShape::kStraight}, {"winding", ClaimShape::kWinding},
  };
  for (const auto& [name, which] : kShapes)
    if (name == shape) qualities->shape = which;
  qualities->any = true;
}

// What a bare noun, one with neither article nor number, may point back to.
enum class Reference {
  kNothing,   // "forest from the northern edge to the lake": it is said anew
  kUnplaced,  // "forest surrounds the lake": what was said to be somewhere else is not meant
  kAny,       // "forest covers 30 % of the map": all that there is
};

// The noun whose class a noun of the small language has, where the table of classes takes its word
// otherwise: a farm is its buildings, its land is fields.
std::string_view ClassNoun(std::string_view noun) {
  if (noun == "farm") return "farmhouse";
  if (noun == "farms") return "farmhouses";
  return noun;
}

double AreaOf(const Zone& zone) {
  return MaskOf(zone).count() / static_cast<double>(kLayoutSize * kLayoutSize);
}

// Says sentence after sentence to the discourse that makes the plan.
class SentencePlanner {
 public:
  SentencePlanner(std::string_view text, Vocabulary vocabulary) : d_(text, vocabulary) {}

  // A sentence and where it stands in the text.
  void Say(const Sentence& sentence, std::size_t begin, std::size_t end) {
    sentence_ = &sentence;
    begin_ = begin;
    end_ = end;
    const std::size_t relations = d_.plan().relations.size();
    const bool known = SayWhere() || SayRelation() || SayCourse() || SayShape();
    if (!known) {
      d_.plan().warnings.push_back("read, but land cannot be laid by it yet: " +
                                   Quote(d_.Words(begin, end)));
    }
    for (std::size_t i = relations; i < d_.plan().relations.size(); ++i) {
      d_.plan().relations[i].words = d_.Words(begin, end);
    }
    d_.NextSentence();
  }

  LayoutPlan Finish() {
    LayoutPlan plan = d_.Finish();
    SettlePlan(&plan);
    plan.claims = ClaimsOfPlan(plan);
    return plan;
  }

 private:
  bool Is(std::string_view form) const { return sentence_->form->name == form; }
  const Phrase* Slot(std::string_view name) const { return sentence_->whole.Find(name); }
  std::vector<Zone> Zones() const {
    const Phrase* zone = Slot("zone");
    return zone == nullptr ? std::vector<Zone>() : ZonesOf(*zone);
  }

  // What a thing's words say of it, and its class; without one nothing is known by that noun.
  NounPhrase NounOf(const Phrase& thing) const {
    NounPhrase phrase;
    const Phrase* noun = thing.slot == "noun" ? &thing : thing.Find("noun");
    const std::vector<Token> tokens = Tokenize(ClassNoun(noun->text));
    const ClassWordMatch match = MatchClassWord(tokens, 0);
    phrase.noun = match.word;
    phrase.plural = match.plural;
    phrase.definite = StartsWith(thing.text, "the ");
    phrase.indefinite = StartsWith(thing.text, "a ") || StartsWith(thing.text, "an ");
    for (const Phrase* size : thing.FindAll("size")) AddSize(size->text, &phrase.qualities);
    for (const Phrase* shape : thing.FindAll("shape")) AddShape(shape->text, &phrase.qualities);
    if (const Phrase* quantity = thing.Find("quantity"); quantity != nullptr) {
      phrase.qualities.count = CountOf(*quantity);
      phrase.qualities.any = true;
    }
    return phrase;
  }

  // The features of a thing that is spoken of, new ones where none is known.
  std::vector<int> Things(const Phrase& thing, Reference bare = Reference::kUnplaced) {
    NounPhrase phrase = NounOf(thing);
    if (phrase.noun == nullptr) {
      d_.plan().warnings.push_back("no land is known by the noun of " + Quote(thing.text));
      return {};
    }
    const Phrase* label = thing.Find("label");
    const std::string name =
        label == nullptr ? std::string() : std::string(phrase.noun->phrase) + " " + label->text;
    if (const auto found = labelled_.find(name); found != labelled_.end()) return {found->second};
    const bool is_bare = !phrase.indefinite && !phrase.qualities.count.has_value();
    const bool refers = phrase.definite || (is_bare && bare != Reference::kNothing);
    if (label == nullptr && refers) {
      std::vector<int> known = d_.Find(phrase, {});
      if (!known.empty() && (phrase.definite || bare == Reference::kAny || IsOpen(known))) {
        for (const int index : known) {
          if (phrase.qualities.any) d_.Describe(phrase.qualities, index);
          d_.Extend(index, end_);
        }
        return known;
      }
    }
    if (label != nullptr && !phrase.qualities.count.has_value()) phrase.indefinite = true;
    const int created = d_.Create(phrase, begin_, end_);
    if (created < 0) return {};
    if (label != nullptr) labelled_.emplace(name, created);
    return {created};
  }

  // Nothing says where they are.
  bool IsOpen(const std::vector<int>& indices) const {
    return std::all_of(indices.begin(), indices.end(),
                       [&](int index) { return d_.feature(index).zones.empty(); });
  }

  std::vector<int> ThingsOfNoun(const Phrase& noun, Reference bare = Reference::kAny) {
    Phrase thing = noun;
    thing.parts.insert(thing.parts.begin(), noun);
    return Things(thing, bare);
  }

  bool SayWhere() {
    if (Is("absent")) return Deny();
    if (Is("there")) {
      for (const int index : Things(*Slot("x"))) d_.AddZones(index, Zones());
      return true;
    }
    if (Is("only") || Is("most_in")) {
      for (const int index : ThingsOfNoun(*Slot("noun"))) {
        if (Is("only")) {
          d_.AddZones(index, Zones());
          d_.feature(index).confined = true;
        } else {
          d_.feature(index).located_in = Zones().front();
          d_.feature(index).located_least = kMostOfIt;
        }
      }
      return true;
    }
    if (Is("some_in")) {
      const int count = static_cast<int>(NumberOf(*Slot("n")));
      for (const int index : Things(*Slot("x"))) {
        const int some = d_.feature(index).pieces > count ? d_.SplitOff(index, count) : index;
        d_.AddZones(some, Zones());
      }
      return true;
    }
    if (Is("more")) {
      const std::vector<const Phrase*> nouns = sentence_->whole.FindAll("noun");
      const std::vector<int> first = ThingsOfNoun(*nouns.front());
      const std::vector<int> second = ThingsOfNoun(*nouns.back());
      if (!first.empty() && !second.empty()) Relate(RelationKind::kMoreThan, first[0], second[0]);
      return true;
    }
    return SayHowMuch();
  }

  bool SayHowMuch() {
    if (Is("cover") || Is("cover_zone")) {
      Qualities qualities;
      qualities.share = ShareOf(*Slot("percent"));
      qualities.any = true;
      const Reference bare = Is("cover") ? Reference::kAny : Reference::kNothing;
      for (const int index : Things(*Slot("x"), bare)) {
        d_.Describe(qualities, index);
        if (Is("cover_zone")) FillPlace(index, qualities.share->value);
      }
      return true;
    }
    if (Is("fill")) {
      for (const int index : Things(*Slot("x"))) {
        PlannedFeature& feature = d_.feature(index);
        feature.dominant = true;
        if (feature.share.has_value()) {  // so much of the map, and there
          d_.AddZones(index, Zones());
          continue;
        }
        feature.share_least = kFilled;
        feature.share_most = 1.0;
        FillPlace(index, 1.0);
      }
      return true;
    }
    if (Is("mostly") || Is("rest")) {
      const Reference bare = Slot("zone") == nullptr ? Reference::kAny : Reference::kNothing;
      for (const int index : ThingsOfNoun(*Slot("noun"), bare)) {
        const bool all = Is("rest") && Slot("zone") == nullptr;
        (all ? d_.feature(index).fills_rest : d_.feature(index).dominant) = true;
        d_.AddZones(index, Zones());
      }
      return true;
    }
    return false;
  }

  // A share that is said of a place, laid in it. Plans have shares of the whole map.
  void FillPlace(int index, double share) {
    d_.AddZones(index, Zones());
    PlannedFeature& feature = d_.feature(index);
    if (feature.zones.size() != 1) return;
    feature.share_of_zones = true;
    feature.share = share * AreaOf(feature.zones.front());
  }

  bool Deny() {
    const NounPhrase phrase = NounOf(*Slot("noun"));
    if (phrase.noun == nullptr) return false;
    const char letter = phrase.noun->LetterIn(d_.plan().vocabulary);
    if (letter == '\0') return true;  // there is none in any case
    std::vector<Zone> zones = Zones();
    if (zones.empty()) zones.emplace_back();
    for (Zone& zone : zones) d_.Deny({letter, std::move(zone), d_.Words(begin_, end_)});
    return true;
  }

  void Relate(RelationKind kind, int subject, int object, double steps = 0.0) {
    PlannedRelation relation;
    relation.kind = kind;
    relation.subject = subject;
    relation.object = object;
    relation.steps = steps;
    d_.Relate(std::move(relation));
  }

  // Says a frame of each thing of {x} about each of {y}.
  bool AssertAll(Frame frame) {
    const std::vector<int> subjects = Things(*Slot("x"));
    const std::vector<int> objects = Things(*Slot("y"));
    for (const int subject : subjects) {
      for (const int object : objects) {
        frame.subjects = {subject};
        frame.objects = {object};
        latticeworld::Assert(frame, subject, &d_);
      }
    }
    return true;
  }
  bool AssertAll(Sense sense, double steps = 0.0) {
    Frame frame;
    frame.sense = sense;
    frame.steps = steps;
    return AssertAll(std::move(frame));
  }

  bool SayRelation() {
    if (Is("touch")) return AssertAll(Sense::kNextTo);
    if (Is("near") || Is("near_metres")) return AssertAll(Sense::kNear);
    if (Is("near_cells")) return AssertAll(Sense::kNextTo, NumberOf(*Slot("n")));
    if (Is("away")) return AssertAll(Sense::kAway);
    if (Is("far")) return AssertAll(Sense::kAway, kFarSteps);
    if (Is("away_cells")) return AssertAll(Sense::kAway, NumberOf(*Slot("n")));
    if (Is("surround")) return AssertAll(Sense::kSurrounds);
    if (Is("inside")) return AssertAll(Sense::kWithin);
    if (Is("both_sides")) return AssertAll(Sense::kBothSides);
    if (Is("front")) return AssertAll(Sense::kNear);
    if (Is("heading")) {
      Frame frame;
      frame.is_direction = true;
      frame.heading = HeadingOfName(Slot("heading")->text);
      return AssertAll(std::move(frame));
    }
    if (Is("apart") || Is("far_apart") || Is("apart_cells")) {
      return KeepApart(Is("apart")       ? kApartSteps
                       : Is("far_apart") ? kFarSteps
                                         : NumberOf(*Slot("n")));
    }
    if (Is("touch_self")) {
      const std::vector<int> all = Things(*Slot("x"));
      for (std::size_t i = 1; i < all.size(); ++i) {
        Relate(RelationKind::kAdjacent, all[i - 1], all[i]);
      }
      return true;
    }
    if (Is("between") || Is("between_all") || Is("connect") || Is("connect_all")) return JoinTwo();
    if (Is("order")) return SayOrder();
    return false;
  }

  bool KeepApart(double steps) {
    const std::vector<int> all = Things(*Slot("x"));
    if (all.size() == 1) d_.feature(all.front()).gap = steps;
    for (std::size_t i = 1; i < all.size(); ++i) {
      Relate(RelationKind::kApart, all[i - 1], all[i], steps);
    }
    return true;
  }

  bool JoinTwo() {
    Frame frame;
    frame.sense = Is("between") || Is("between_all") ? Sense::kBetween : Sense::kConnects;
    const std::vector<int> subjects = Things(*Slot("x"));
    frame.objects = Things(*Slot("y"));
    if (Slot("z") != nullptr) {
      const std::vector<int> second = Things(*Slot("z"));
      if (second.empty()) return true;
      frame.objects.push_back(second.front());
    }
    frame.subjects = subjects;
    for (const int subject : subjects) latticeworld::Assert(frame, subject, &d_);
    return true;
  }

  bool SayOrder() {
    PlannedOrder order;
    const Heading to = HeadingOfName(sentence_->whole.FindAll("heading").back()->text);
    order.heading = {to.east, to.south};
    order.words = d_.Words(begin_, end_);
    for (const Phrase* noun : Slot("nouns")->FindAll("noun")) {
      const std::vector<int> known = ThingsOfNoun(*noun);
      if (!known.empty()) order.features.push_back(known.front());
    }
    if (order.features.size() > 1) d_.plan().orders.push_back(std::move(order));
    return true;
  }

  bool SayCourse() {
    if (Is("course")) {
      const std::vector<const Phrase*> ends = sentence_->whole.FindAll("end");
      const std::vector<int> lines = Things(*Slot("x"), Reference::kNothing);
      for (const int line : lines) {
        MakeRun(line);
        End(line, *ends[0], /*from=*/true);
        End(line, *ends[1], /*from=*/false);
        if (ends.size() > 2) Through(line, *ends[2]);
      }
      return true;
    }
    if (Is("ends") || Is("begins")) {
      for (const int line : Things(*Slot("x"))) End(line, *Slot("end"), Is("begins"));
      return true;
    }
    if (Is("through")) {
      for (const int line : Things(*Slot("x"))) Through(line, *Slot("end"));
      return true;
    }
    if (Is("along") || Is("lined")) {
      for (const int index : Things(*Slot("x"))) Along(index, *Slot("end"));
      return true;
    }
    if (Is("cross")) return AssertAll(Sense::kCrosses);
    if (Is("parallel") && Slot("y") != nullptr) return AssertAll(Sense::kParallel);
    if (Is("parallel") || Is("cross_self") || Is("meet")) {
      Frame frame;
      frame.sense = Is("parallel") ? Sense::kParallelEach : Sense::kCrossEachOther;
      frame.subjects = Things(*Slot("x"));
      AssertEachOther(frame, &d_);
      if (Is("meet")) {
        for (const int line : frame.subjects) Through(line, *Slot("end"));
      }
      return true;
    }
    if (Is("over")) return Bridge();
    if (Is("climb")) return AssertAll(Sense::kNear);
    return false;
  }

  // A bridge is where a road crosses: the one that was said, or one of its own.
  bool Bridge() {
    const std::vector<int> below = Things(*Slot("y"));
    int road = d_.Latest('R', FeatureForm::kLine);
    if (road < 0) {
      const std::vector<Token> tokens = Tokenize("road");
      NounPhrase phrase;
      phrase.noun = MatchClassWord(tokens, 0).word;
      phrase.indefinite = true;
      road = d_.Create(phrase, begin_, end_);
    }
    for (const int index : below) {
      if (road >= 0) Relate(RelationKind::kCrosses, road, index);
    }
    return true;
  }

  // What goes from one place to another is a line, or a broad band of what spreads.
  void MakeRun(int index) {
    PlannedFeature& feature = d_.feature(index);
    if (feature.form == FeatureForm::kLine) return;
    feature.form = FeatureForm::kLine;
    feature.wide = true;
    feature.pieces = feature.pieces_least = feature.pieces_most = 0;
  }

  // {end} is a place of the map, or a thing.
  void End(int line, const Phrase& end, bool from) {
    if (end.Has("zone")) {
      Waypoint waypoint;
      waypoint.zone = EndZoneOf(end);
      (from ? d_.feature(line).from : d_.feature(line).to) = std::move(waypoint);
      return;
    }
    AssertOne(from ? Sense::kFrom : Sense::kTo, line, end);
  }

  void Through(int line, const Phrase& end) {
    if (!end.Has("zone")) {
      AssertOne(Sense::kThrough, line, end);
    } else if (d_.feature(line).form != FeatureForm::kLine) {
      d_.AddZones(line, ZonesOf(end));
    } else {
      for (Zone& zone : ZonesOf(end)) {
        Waypoint waypoint;
        waypoint.zone = std::move(zone);
        d_.feature(line).via.push_back(std::move(waypoint));
      }
    }
  }

  void Along(int index, const Phrase& end) {
    if (!end.Has("zone")) {
      AssertOne(Sense::kAlong, index, end);
    } else if (d_.feature(index).form == FeatureForm::kLine) {
      d_.feature(index).along = EndZoneOf(end);
    } else {
      d_.AddZones(index, {EndZoneOf(end)});
    }
  }

  void AssertOne(Sense sense, int subject, const Phrase& object) {
    for (const int known : Things(object)) {
      Frame frame;
      frame.sense = sense;
      frame.subjects = {subject};
      frame.objects = {known};
      latticeworld::Assert(frame, subject, &d_);
    }
  }

  bool SayShape() {
    Qualities qualities;
    qualities.any = true;
    if (Is("shape")) {
      AddShape(sentence_->whole.FindAll("shape").back()->text, &qualities);
    } else if (Is("grid")) {
      qualities.shape = ClaimShape::kGridded;
    } else if (Is("scattered")) {
      qualities.texture = Texture::kScattered;
    } else if (Is("together")) {
      qualities.texture = Texture::kClustered;
    } else {
      return false;
    }
    for (const int index : Things(*Slot("x"), Reference::kAny)) {
      d_.Describe(qualities, index);
      // Houses that stand close together are one place.
      PlannedFeature& feature = d_.feature(index);
      if (Is("together") && feature.pieces_least == 0) feature.pieces = 1;
    }
    return true;
  }

  Discourse d_;
  const Sentence* sentence_ = nullptr;
  std::size_t begin_ = 0;
  std::size_t end_ = 0;
  std::map<std::string, int> labelled_;  // "lake A"
};

}  // namespace

LayoutPlan LayoutOfSentences(const std::vector<std::string>& sentences, Vocabulary vocabulary) {
  const std::string text = Join(sentences, ". ");
  SentencePlanner planner(text, vocabulary);
  std::vector<std::string> not_understood;
  std::size_t begin = 0;
  for (const std::string& words : sentences) {
    const std::optional<Sentence> sentence = ReadSentence(words, SentenceKind::kLayout);
    if (sentence.has_value()) {
      planner.Say(*sentence, begin, begin + words.size());
    } else {
      not_understood.push_back(words);
    }
    begin += words.size() + 2;
  }
  LayoutPlan plan = planner.Finish();
  plan.not_understood = std::move(not_understood);
  return plan;
}

}  // namespace latticeworld
