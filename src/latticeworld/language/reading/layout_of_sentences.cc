#include "latticeworld/language/reading/layout_of_sentences.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/language/class_words.h"
#include "latticeworld/language/grounded/reading/claims_of_plan.h"
#include "latticeworld/language/grounded/reading/clauses/frame.h"
#include "latticeworld/language/grounded/reading/discourse.h"
#include "latticeworld/language/grounded/reading/settle_plan.h"
#include "latticeworld/language/reading/relief/relief_words.h"
#include "latticeworld/language/reading/sentence_places.h"
#include "latticeworld/language/reading/things/land_by_things.h"
#include "latticeworld/language/reading/things/sentence_things.h"
#include "latticeworld/language/reading/things/things_of_sentences.h"
#include "latticeworld/language/sentences/sentence.h"
#include "latticeworld/language/tokens.h"

namespace latticeworld {
namespace {

constexpr double kApartSteps = 3.0;
constexpr double kFarSteps = 8.0;
constexpr double kFilled = 0.5;    // of a place, at the least, that a thing is said to fill
constexpr double kMostOfIt = 0.6;  // of a class, at the least, of which most is somewhere

// What a bare noun, one with neither article nor number, may point back to.
enum class Reference {
  kNothing,   // "forest from the northern edge to the lake": it is said anew
  kUnplaced,  // "forest surrounds the lake": what was said to be somewhere else is not meant
  kAny,       // "forest covers 30 % of the map": all that there is
};

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

  // Land that a sentence about something else names.
  void Mention(const Phrase& land, std::size_t begin, std::size_t end) {
    begin_ = begin;
    end_ = end;
    (void)Things(land);
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

  static bool IsRelief(const Phrase& thing) {
    const Phrase* noun = thing.slot == "noun" ? &thing : thing.Find("noun");
    return ReliefOfNoun(noun->text).has_value();
  }

  // The features of a thing that is spoken of, new ones where none is known.
  std::vector<int> Things(const Phrase& thing, Reference bare = Reference::kUnplaced) {
    NounPhrase phrase = NounOf(thing);
    if (phrase.noun == nullptr) {
      if (IsRelief(thing)) return {};  // relief_reading.h
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
    said_.emplace(created, d_.Words(begin_, end_));
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
          if (Zones().size() > 1) HeardInPart("only the first of its places counts");
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
      if (!Zones().empty()) HeardInPart("it is meant of the whole map");
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
    for (Zone& zone : zones) {
      WarnOfContradiction(letter, zone);
      d_.Deny({letter, std::move(zone), d_.Words(begin_, end_)});
    }
    return true;
  }

  // What was said to be in a place that is now said to hold none of it.
  void WarnOfContradiction(char letter, const Zone& zone) {
    if (zone.is_anywhere()) return;  // the discourse settles those
    for (const auto& [index, words] : said_) {
      const PlannedFeature& feature = d_.feature(index);
      const bool there =
          std::find(feature.zones.begin(), feature.zones.end(), zone) != feature.zones.end();
      if (feature.letter != letter || !there) continue;
      d_.plan().warnings.push_back(Quote(words) + " and " + Quote(d_.Words(begin_, end_)) +
                                   " cannot both be");
    }
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

  bool AssertInPart(Sense sense, const char* how) {
    HeardInPart(how);
    return AssertAll(sense);
  }
  // A warning that the plan has less than the sentence says.
  void HeardInPart(const char* how) {
    d_.plan().warnings.push_back("heard in part: " + Quote(d_.Words(begin_, end_)) + ": " + how);
  }

  bool SayRelation() {
    if (Is("touch")) return AssertAll(Sense::kNextTo);
    if (Is("near")) return AssertAll(Sense::kNear);
    if (Is("near_metres")) return AssertInPart(Sense::kNear, "it is laid near, not to the metre");
    if (Is("near_cells")) return AssertAll(Sense::kNextTo, NumberOf(*Slot("n")));
    if (Is("away")) return AssertAll(Sense::kAway);
    if (Is("far")) return AssertAll(Sense::kAway, kFarSteps);
    if (Is("away_cells")) return AssertAll(Sense::kAway, NumberOf(*Slot("n")));
    if (Is("surround")) return AssertAll(Sense::kSurrounds);
    if (Is("inside")) return AssertAll(Sense::kWithin);
    if (Is("both_sides")) return AssertAll(Sense::kBothSides);
    if (Is("front")) return AssertInPart(Sense::kNear, "it is laid near, on whichever side");
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
      if (all.size() < 2) HeardInPart("like pieces that touch are one piece");
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
    if (Is("climb") || Is("climb_slope")) {
      return AssertInPart(Sense::kNear, "it is laid near, not up the slope");
    }
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
  std::map<int, std::string> said_;      // the sentence that each feature comes from
};

}  // namespace

LayoutPlan LayoutOfSentences(const std::vector<std::string>& sentences, Vocabulary vocabulary) {
  const std::string text = Join(sentences, ". ");
  SentencePlanner planner(text, vocabulary);
  SentenceThings things(vocabulary);
  std::vector<std::string> not_understood;
  std::vector<SaidSentence> about_land;
  std::vector<LandByThing> by_things;
  std::size_t begin = 0;
  for (const std::string& words : sentences) {
    const std::size_t end = begin + words.size();
    std::optional<Sentence> sentence = ReadSentence(words, SentenceKind::kLayout);
    if (!sentence.has_value()) {
      not_understood.push_back(words);
    } else if (!things.Say(*sentence, words)) {
      about_land.push_back({*std::move(sentence), begin, end});
    }
    for (std::size_t i = by_things.size(); i < things.land().size(); ++i)
      by_things.push_back({things.land()[i], begin, end});
    begin = end + 2;
  }
  // First, so that the others may speak of it.
  for (const LandByThing& each : LandLeftUnsaid(by_things, about_land, vocabulary))
    planner.Mention(each.land, each.begin, each.end);
  for (const SaidSentence& said : about_land) planner.Say(said.sentence, said.begin, said.end);
  LayoutPlan plan = planner.Finish();
  plan.not_understood = std::move(not_understood);
  plan.things = things.wishes();
  plan.warnings.insert(plan.warnings.end(), things.warnings().begin(), things.warnings().end());
  return plan;
}

}  // namespace latticeworld
