#include "latticeworld/language/reading/relief/relief_ties.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/language/places.h"

namespace latticeworld {
namespace {

class TieReader {
 public:
  TieReader(ReliefSentence* sentence, LayoutPlan* plan) : s_(*sentence), plan_(*plan) {}

  void Read() {
    for (const ReliefMention& mention : s_.mentions()) {
      if (mention.wish < 0) continue;
      for (const OtherMention& other : s_.others()) TieToClass(mention, other);
      if (IsBridged(mention)) Bridge(mention);
    }
    if (s_.mentions().empty()) ClimbKnown();
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
  char WayLetter() const { return plan_.vocabulary == Vocabulary::kSuburb ? 'R' : '\0'; }

  void Climb(ReliefWish* wish) {
    ReliefTie tie;
    tie.kind = ReliefTie::Kind::kClimbed;
    tie.letter = WayLetter();
    tie.words = s_.words();
    wish->ties.push_back(std::move(tie));
  }

  // "A path of 15 degrees leads to its top": of what was said last.
  void ClimbKnown() {
    for (const OtherMention& way : s_.others()) {
      if (!ReliefSentence::IsWay(way) || (WayLetter() == '\0' && !s_.way_slope())) continue;
      for (std::size_t i = way.end; i + 1 < s_.tokens().size(); ++i) {
        const bool top = s_.Is(i, {"its", "the"}) && s_.Is(i + 1, {"top"});
        if (!top && !(s_.Is(i, {"climbs", "ascends", "up"}) && s_.Is(i + 1, {"it"}))) continue;
        const auto known = std::find_if(
            plan_.reliefs.rbegin(), plan_.reliefs.rend(),
            [](const ReliefWish& wish) { return Rises(wish.kind) && !IsTexture(wish.kind); });
        if (known == plan_.reliefs.rend()) return;
        Climb(&*known);
        s_.Take(way.begin, i + 2);
        return;
      }
    }
  }

  // "A bridge over the gorge", "the road crosses the canyon", "a gorge with a bridge".
  bool IsBridged(const ReliefMention& mention) {
    if (mention.kind != ReliefKind::kGorge && mention.kind != ReliefKind::kCanyon) return false;
    const auto leads_over = [&](std::size_t end) {
      for (std::size_t i = mention.begin; i-- > end;) {
        if (s_.tokens()[i].kind != TokenKind::kWord || s_.Is(i, {"and", "or"})) return false;
        if (s_.Is(i, {"over", "across", "spans", "span", "spanning", "crosses", "cross",
                      "crossing"})) {
          s_.Take(end, mention.begin);
          return true;
        }
      }
      return false;
    };
    for (const OtherMention& way : s_.others()) {
      if (ReliefSentence::IsWay(way) && way.end <= mention.begin && leads_over(way.end)) {
        return true;
      }
    }
    for (std::size_t i = 0; i < s_.tokens().size(); ++i) {
      if (!s_.Is(i, {"bridge", "bridges", "footbridge", "viaduct"})) continue;
      const bool denied = s_.Has(i < 2 ? 0 : i - 2, i, {"no", "not", "without"});
      const bool behind = i >= mention.end && s_.Has(mention.end, i, {"with", "has", "have"}) &&
                          i - mention.end <= 4;
      if (denied || !(behind || (i < mention.begin && leads_over(i + 1)))) continue;
      s_.Take(i, i + 1);
      return true;
    }
    return false;
  }

  void Bridge(const ReliefMention& mention) {
    std::vector<ReliefTie>& ties = WishOf(mention).ties;
    for (const ReliefTie& tie : ties) {
      if (tie.kind == ReliefTie::Kind::kBridged) return;
    }
    ReliefTie tie;
    tie.kind = ReliefTie::Kind::kBridged;
    tie.letter = WayLetter();
    tie.words = s_.words();
    ties.push_back(std::move(tie));
  }

  void TieToClass(const ReliefMention& mention, const OtherMention& other) {
    ReliefTie tie;
    tie.letter = other.noun->LetterIn(plan_.vocabulary);
    // Ways whose slope is said climb in the wild too.
    const bool wild_way = tie.letter == '\0' && ReliefSentence::IsWay(other) && s_.way_slope();
    if (tie.letter == '\0' && !wild_way) return;
    for (const PlannedFeature& feature : plan_.features) {
      if (feature.noun == other.noun->phrase) tie.zones = feature.zones;
    }
    const bool said = other.end <= mention.begin ? SaidOfOther(other, mention, &tie)
                                                 : SaidOfMention(mention, other.begin, &tie);
    const bool climbed = tie.kind == ReliefTie::Kind::kClimbed;
    if (!said || (wild_way && !climbed)) return;
    if (climbed) TakeTop(&tie);
    WishOf(mention).ties.push_back(std::move(tie));
  }

  // What is climbed is climbed to its top.
  void TakeTop(ReliefTie* tie) {
    tie->words = s_.words();
    for (std::size_t i = 0; i < s_.tokens().size(); ++i) {
      if (s_.Is(i, {"top"})) s_.Take(i, i + 1);
    }
  }

  bool IsRoad(const ReliefTie& tie) const { return tie.letter == WayLetter(); }

  // "The village is inside the valley", "the road climbs the hill", "the lake is north of the
  // hill".
  bool SaidOfOther(const OtherMention& other, const ReliefMention& mention, ReliefTie* tie) {
    const bool road = IsRoad(*tie);
    const bool over = mention.kind == ReliefKind::kSaddle &&
                      s_.Has(other.end, mention.begin, {"over", "through", "across"});
    if (road && over) {
      tie->kind = ReliefTie::Kind::kClimbed;
      return true;
    }
    if (road && Rises(mention.kind) &&
        (s_.Has(other.end, mention.begin,
                {"climbs", "climb", "climbing", "up", "ascends", "ascend", "top"}) ||
         (s_.way_slope() && s_.Has(other.end, mention.begin, {"to", "onto"})))) {
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
        tie->kind = IsRoad(*tie) && Rises(mention.kind) ? ReliefTie::Kind::kClimbed
                                                        : ReliefTie::Kind::kUnder;
        return true;
      }
    }
    return false;
  }

  bool SaysNear(std::size_t at) const {
    return s_.Is(at, {"near", "beside", "by", "touches", "touch"});
  }

  bool SaysToward(std::size_t at, ReliefTie* tie) {
    const HeadingMatch heading = MatchHeading(s_.tokens(), at);
    if (heading.tokens == 0 || !s_.Is(at + heading.tokens, {"of"})) return false;
    tie->kind = ReliefTie::Kind::kToward;
    tie->heading = {heading.heading.east, heading.heading.south};
    s_.Take(at, at + heading.tokens);
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

  ReliefSentence& s_;
  LayoutPlan& plan_;
};

}  // namespace

void ReadReliefTies(ReliefSentence* sentence, LayoutPlan* plan) {
  TieReader(sentence, plan).Read();
}

void SettleWaySlopes(const std::vector<SaidWaySlope>& said, LayoutPlan* plan) {
  const auto for_each_climb = [plan](auto visit) {
    for (ReliefWish& wish : plan->reliefs) {
      for (ReliefTie& tie : wish.ties) {
        if (tie.kind == ReliefTie::Kind::kClimbed) visit(&tie);
      }
    }
  };
  for (const SaidWaySlope& slope : said) {
    bool own = false, any = false;
    for_each_climb([&](const ReliefTie* tie) { own = own || tie->words == slope.words; });
    for_each_climb([&](ReliefTie* tie) {
      if (own ? tie->words != slope.words : tie->slope_deg.has_value()) return;
      tie->slope_deg = slope.degrees;
      tie->words = slope.words;
      any = true;
    });
    if (any) continue;
    plan->warnings.push_back(Quote(slope.words) +
                             ": the slope is of a way that climbs nothing; say what it climbs, as "
                             "in \"a path of 15 degrees climbs the hill\"");
  }
  // Of two ways up one form the later is laid.
  for (ReliefWish& wish : plan->reliefs) {
    const ReliefTie* last = nullptr;
    for (const ReliefTie& tie : wish.ties) {
      if (tie.kind != ReliefTie::Kind::kClimbed || !tie.slope_deg) continue;
      if (last != nullptr && *last->slope_deg != *tie.slope_deg) {
        plan->warnings.push_back(Quote(last->words) + " and " + Quote(tie.words) +
                                 " cannot both be: the later slope counts");
      }
      last = &tie;
    }
    if (last == nullptr) continue;
    const ReliefTie kept = *last;
    const auto is_climb = [](const ReliefTie& tie) {
      return tie.kind == ReliefTie::Kind::kClimbed;
    };
    wish.ties.erase(std::remove_if(wish.ties.begin(), wish.ties.end(), is_climb), wish.ties.end());
    wish.ties.push_back(kept);
  }
}

}  // namespace latticeworld
