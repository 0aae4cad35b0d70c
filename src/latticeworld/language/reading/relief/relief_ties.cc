#include "latticeworld/language/reading/relief/relief_ties.h"

#include <cstddef>
#include <utility>

#include "latticeworld/language/places.h"

namespace latticeworld {
namespace {

class TieReader {
 public:
  TieReader(const ReliefSentence& sentence, LayoutPlan* plan) : s_(sentence), plan_(*plan) {}

  void Read() {
    for (const ReliefMention& mention : s_.mentions()) {
      if (mention.wish < 0) continue;
      for (const OtherMention& other : s_.others()) TieToClass(mention, other);
    }
    for (std::size_t i = 1; i < s_.mentions().size(); ++i) {
      TieForms(s_.mentions()[i - 1], s_.mentions()[i]);
    }
  }

 private:
  ReliefWish& WishOf(const ReliefMention& mention) {
    return plan_.reliefs[static_cast<std::size_t>(mention.wish)];
  }
  // What a road can be said to climb.
  static bool Rises(ReliefKind kind) {
    return kind != ReliefKind::kValley && kind != ReliefKind::kGorge &&
           kind != ReliefKind::kCanyon && kind != ReliefKind::kBasin;
  }
  bool IsLaid(const ReliefMention& mention) { return WishOf(mention).letter != '\0'; }

  void TieToClass(const ReliefMention& mention, const OtherMention& other) {
    ReliefTie tie;
    tie.letter = other.noun->LetterIn(plan_.vocabulary);
    if (tie.letter == '\0') return;
    for (const PlannedFeature& feature : plan_.features) {
      if (feature.noun == other.noun->phrase) tie.zones = feature.zones;
    }
    const bool said = other.end <= mention.begin ? SaidOfOther(other, mention, &tie)
                                                 : SaidOfMention(mention, other.begin, &tie);
    if (said) WishOf(mention).ties.push_back(std::move(tie));
  }

  // "The village is inside the valley", "the road climbs the hill", "the lake is north of the
  // hill".
  bool SaidOfOther(const OtherMention& other, const ReliefMention& mention, ReliefTie* tie) {
    const bool road = tie->letter == 'R' && plan_.vocabulary == Vocabulary::kSuburb;
    const bool over = mention.kind == ReliefKind::kSaddle &&
                      s_.Has(other.end, mention.begin, {"over", "through", "across"});
    if (road && over) {
      tie->kind = ReliefTie::Kind::kClimbed;
      return true;
    }
    if (road && Rises(mention.kind) &&
        s_.Has(other.end, mention.begin,
               {"climbs", "climb", "climbing", "up", "ascends", "ascend", "top"})) {
      tie->kind = ReliefTie::Kind::kClimbed;
      return true;
    }
    // Water that runs in a form is where the form is, whatever class it is laid as.
    const bool runs_in_it = tie->letter == 'W' && (mention.kind == ReliefKind::kValley ||
                                                   mention.kind == ReliefKind::kGorge ||
                                                   mention.kind == ReliefKind::kCanyon);
    if (IsLaid(mention) && !runs_in_it) return false;
    for (std::size_t i = mention.begin; i-- > other.end;) {
      // "A village in the west and a hill": what comes before is said of the village.
      if (s_.Is(i, {"and"}) || s_.tokens()[i].kind != TokenKind::kWord) return false;
      if (s_.Is(i, {"inside", "in", "within", "on", "through", "atop", "into"})) {
        tie->kind = ReliefTie::Kind::kUnder;
        return true;
      }
      if (IsLaid(mention)) continue;
      if (SaysNear(i) || s_.Is(i, {"below", "under"})) {
        tie->kind = ReliefTie::Kind::kBeside;
        return true;
      }
      if (SaysToward(i, tie)) {
        tie->heading = {-tie->heading.east, -tie->heading.south};
        return true;
      }
    }
    return false;
  }

  // "A hill north of the lake", "a gorge with a river", "a hill near the village".
  bool SaidOfMention(const ReliefMention& mention, std::size_t end, ReliefTie* tie) {
    if (IsLaid(mention)) return false;
    for (std::size_t i = mention.end; i < end; ++i) {
      if (SaysToward(i, tie)) return true;
      if (SaysNear(i) || s_.Is(i, {"behind", "above"})) {
        tie->kind = ReliefTie::Kind::kBeside;
        return true;
      }
      if (s_.Is(i, {"with"})) {
        const bool road = tie->letter == 'R' && plan_.vocabulary == Vocabulary::kSuburb;
        tie->kind =
            road && Rises(mention.kind) ? ReliefTie::Kind::kClimbed : ReliefTie::Kind::kUnder;
        return true;
      }
    }
    return false;
  }

  bool SaysNear(std::size_t at) const {
    return s_.Is(at, {"near", "beside", "by", "touches", "touch"});
  }

  bool SaysToward(std::size_t at, ReliefTie* tie) const {
    const HeadingMatch heading = MatchHeading(s_.tokens(), at);
    if (heading.tokens == 0 || !s_.Is(at + heading.tokens, {"of"})) return false;
    tie->kind = ReliefTie::Kind::kToward;
    tie->heading = {heading.heading.east, heading.heading.south};
    return true;
  }

  // "A hill is north of hill A", "the crater is near the ridge". The later wish is laid by the
  // earlier one.
  void TieForms(const ReliefMention& subject, const ReliefMention& object) {
    if (subject.wish < 0 || object.wish < 0 || subject.wish == object.wish) return;
    const bool subject_later = subject.wish > object.wish;
    const ReliefMention& later = subject_later ? subject : object;
    if (IsLaid(subject) && IsLaid(object)) return;
    ReliefTie tie;
    tie.wish = subject_later ? object.wish : subject.wish;
    for (std::size_t i = subject.end; i < object.begin; ++i) {
      const bool toward = SaysToward(i, &tie);
      if (toward && !subject_later) tie.heading = {-tie.heading.east, -tie.heading.south};
      if (!toward && !SaysNear(i)) continue;
      WishOf(later).ties.push_back(std::move(tie));
      return;
    }
  }

  const ReliefSentence& s_;
  LayoutPlan& plan_;
};

}  // namespace

void ReadReliefTies(const ReliefSentence& sentence, LayoutPlan* plan) {
  TieReader(sentence, plan).Read();
}

}  // namespace latticeworld
