#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/language/grounded/mention.h"
#include "latticeworld/language/grounded/repeated_mentions.h"

namespace latticeworld {
namespace {

// Cells that a class needs to count as present in the whole layout, with some to spare.
constexpr int kPresentCells = 20;

// Things that a layout of 1024 cells has room for, and ties between them.
constexpr std::size_t kMaxWishes = 32;
constexpr std::size_t kMaxRelations = 32;
constexpr int kMaxIslands = 4;  // of one mention

bool SameMeaning(const Claim& a, const Claim& b) {
  return a.kind == b.kind && a.subject == b.subject && a.object == b.object &&
         a.regions == b.regions && a.from == b.from && a.to == b.to;
}

bool IsSame(const RelationWish& a, const RelationWish& b) {
  return a.kind == b.kind && a.subject == b.subject && a.object == b.object &&
         a.subject_area == b.subject_area && a.object_area == b.object_area;
}

std::size_t Index(int index) { return static_cast<std::size_t>(index); }

char DefaultBackground(Vocabulary vocabulary) {
  return vocabulary == Vocabulary::kSuburb ? 'G' : 'B';
}

Region MainOf(const Mention& mention) {
  if (!mention.places.empty()) return mention.places.front().main;
  // A course through the middle of the map unless its ends say otherwise.
  if (mention.is_line() && mention.has_course()) return Region::kCenter;
  return Region::kAnywhere;
}

class Planner {
 public:
  Planner(LayoutReading reading, std::string_view instruction, Vocabulary vocabulary)
      : reading_(std::move(reading)), instruction_(instruction) {
    plan_.vocabulary = vocabulary;
    plan_.warnings = std::move(reading_.warnings);
  }

  LayoutPlan Plan() {
    JoinRepeated();
    SettleHeadings();
    SettleCourseEnds();
    SettleBetween();
    ChooseBackground();
    area_of_.assign(reading_.mentions.size(), -1);
    for (std::size_t i = 0; i < reading_.mentions.size(); ++i) {
      const Mention& mention = reading_.mentions[i];
      if (is_repeated_[i]) continue;
      if (plan_.areas.size() + plan_.courses.size() >= kMaxWishes) {
        plan_.warnings.push_back("too many things for one layout: nothing is laid from " +
                                 Quote(Words(mention.begin, mention.end)) + " on");
        break;
      }
      if (mention.is_island()) {
        WishIsland(mention);
      } else if (mention.negated) {
        Deny(mention);
      } else if (mention.is_line()) {
        WishCourse(mention);
      } else {
        WishArea(static_cast<int>(i));
      }
    }
    RelateAll();
    DropContradictions();
    DropRepeatedClaims();
    return std::move(plan_);
  }

 private:
  Mention& At(int index) { return reading_.mentions[Index(index)]; }

  std::string Words(std::size_t begin, std::size_t end) const {
    return std::string(instruction_.substr(begin, end - begin));
  }

  void AddClaim(ClaimKind kind, const Mention& mention, std::vector<Region> regions) {
    Claim claim;
    claim.kind = kind;
    claim.subject = mention.letter;
    claim.regions = std::move(regions);
    claim.words = Words(mention.begin, mention.end);
    plan_.claims.push_back(std::move(claim));
  }

  // What is said again in the same words is the same thing: it is laid once.
  void JoinRepeated() {
    const std::vector<int> first = FirstOfRepeated(reading_.mentions, instruction_);
    for (Mention& mention : reading_.mentions) {
      if (mention.from_mention >= 0) mention.from_mention = first[Index(mention.from_mention)];
      if (mention.to_mention >= 0) mention.to_mention = first[Index(mention.to_mention)];
    }
    for (Tie& tie : reading_.ties) {
      tie.subject = first[Index(tie.subject)];
      tie.object = first[Index(tie.object)];
    }
    is_repeated_.assign(first.size(), false);
    std::size_t repeated = 0;
    std::string words;
    for (std::size_t i = 0; i < first.size(); ++i) {
      is_repeated_[i] = first[i] != static_cast<int>(i);
      if (!is_repeated_[i]) continue;
      if (repeated++ == 0)
        words = Words(At(static_cast<int>(i)).begin, At(static_cast<int>(i)).end);
    }
    if (repeated == 0) return;
    plan_.warnings.push_back(
        "said more than once and laid once: " + Quote(words) +
        (repeated > 1 ? " and " + std::to_string(repeated - 1) + " more" : ""));
  }

  // "north of the lake": a place beside the other's, which gets one if it has none.
  void SettleHeadings() {
    for (const Tie& tie : reading_.ties) {
      if (tie.kind != TieKind::kHeading) continue;
      Mention& subject = At(tie.subject);
      Mention& object = At(tie.object);
      if (!subject.places.empty() || subject.has_course()) continue;
      Region main = MainOf(object);
      if (main == Region::kAnywhere) {
        main = Region::kCenter;
        if (!object.is_line()) object.places = {PlaceOf(main)};
      }
      const Heading from = HeadingOf(main);
      const Heading to{std::clamp(from.east + tie.heading.east, -1, 1),
                       std::clamp(from.south + tie.heading.south, -1, 1)};
      if (RegionOf(to) != main) {
        subject.places = {PlaceOf(RegionOf(to))};
        continue;
      }
      // The other lies at the edge itself: it moves in by a third.
      object.places = {
          PlaceOf(RegionOf({from.east - tie.heading.east, from.south - tie.heading.south}))};
      subject.places = {PlaceOf(main)};
    }
  }

  void SettleCourseEnds() {
    for (Mention& line : reading_.mentions) {
      if (line.from_mention >= 0) line.from = EndAt(line.from_mention, Region::kMiddleLeft);
      if (line.to_mention >= 0) {
        line.to = EndAt(line.to_mention, line.from == Region::kMiddleRight ? Region::kMiddleLeft
                                         : line.from_mention >= 0          ? Region::kMiddleRight
                                                                           : Region::kCenter);
      }
    }
  }

  Region EndAt(int index, Region otherwise) {
    Mention& goal = At(index);
    if (goal.places.empty() && !goal.is_line()) goal.places = {PlaceOf(otherwise)};
    const Region main = MainOf(goal);
    return main == Region::kAnywhere ? otherwise : main;
  }

  // What lies between two placed things stands half-way.
  void SettleBetween() {
    for (std::size_t i = 1; i < reading_.ties.size(); ++i) {
      const Tie& first = reading_.ties[i - 1];
      const Tie& second = reading_.ties[i];
      if (first.kind != TieKind::kNextTo || second.kind != TieKind::kNextTo ||
          first.subject != second.subject) {
        continue;
      }
      Mention& subject = At(first.subject);
      const Region a = MainOf(At(first.object));
      const Region b = MainOf(At(second.object));
      if (!subject.places.empty() || subject.has_course() || a == Region::kAnywhere ||
          b == Region::kAnywhere) {
        continue;
      }
      const Heading ha = HeadingOf(a);
      const Heading hb = HeadingOf(b);
      subject.places = {PlaceOf(RegionOf({(ha.east + hb.east) / 2, (ha.south + hb.south) / 2}))};
    }
  }

  void ChooseBackground() {
    for (const Mention& mention : reading_.mentions) {
      if (mention.is_rest && !mention.negated) plan_.background = mention.letter;
    }
    if (plan_.background != '\0') return;
    // What covers most of the whole map is what everything else lies on.
    for (const Mention& mention : reading_.mentions) {
      if (!mention.negated && !mention.is_line() && mention.amount == Amount::kMost &&
          mention.places.empty()) {
        plan_.background = mention.letter;
        return;
      }
    }
    const char usual = DefaultBackground(plan_.vocabulary);
    for (const Tie& tie : reading_.ties) {
      if (tie.kind == TieKind::kMoreThan && At(tie.object).letter == usual &&
          !At(tie.subject).is_line()) {
        plan_.background = At(tie.subject).letter;
        return;
      }
    }
    plan_.background = IsDesert() ? 'D' : usual;
  }

  // "a desert with an oasis": barren land without a place, and no other that spreads, is the land
  // itself.
  bool IsDesert() const {
    bool desert = false;
    for (const Mention& mention : reading_.mentions) {
      if (mention.negated || mention.noun->shape != WordShape::kMass) continue;
      const bool barren = plan_.vocabulary == Vocabulary::kSuburb && mention.letter == 'D' &&
                          mention.places.empty() && mention.amount != Amount::kLittle &&
                          mention.texture == Texture::kUnsaid;
      if (!barren) return false;
      const std::string_view phrase = mention.noun->phrase;
      desert = desert || phrase.find("desert") != std::string_view::npos || phrase == "sand" ||
               phrase == "dune";
    }
    return desert;
  }

  void Deny(const Mention& mention) {
    std::vector<Region> regions;
    for (const Place& place : mention.places) {
      regions.insert(regions.end(), place.regions.begin(), place.regions.end());
    }
    AddClaim(ClaimKind::kAbsent, mention, std::move(regions));
  }

  void WishIsland(const Mention& mention) {
    if (mention.negated) return;  // nobody lays one unasked
    const bool water =
        std::any_of(reading_.mentions.begin(), reading_.mentions.end(), [](const Mention& other) {
          return other.letter == 'W' && !other.negated && !other.is_line();
        });
    if (!water) {
      plan_.warnings.push_back("there is no lake or sea for " +
                               Quote(Words(mention.begin, mention.end)) + " to lie in");
      return;
    }
    const int pieces = mention.number > 0 ? mention.number : mention.plural ? 2 : 1;
    plan_.islands.push_back(
        {mention.letter, std::min(pieces, kMaxIslands),
         mention.amount == Amount::kMuch ? 2 * mention.noun->cells : mention.noun->cells});
  }

  void WishCourse(const Mention& mention) {
    CourseWish wish;
    wish.letter = mention.letter;
    wish.from = mention.from;
    wish.to = mention.to;
    wish.through = mention.through;
    wish.meander = mention.meander;
    wish.wide = mention.wide;
    const bool said_course = wish.from != Region::kAnywhere && wish.to != Region::kAnywhere;
    if (said_course) {
      Claim claim;
      claim.kind = ClaimKind::kCourse;
      claim.subject = mention.letter;
      claim.from = wish.from;
      claim.to = wish.to;
      claim.words = Words(mention.begin, mention.end);
      plan_.claims.push_back(std::move(claim));
    }
    std::vector<Region> present = mention.through;
    for (const Place& place : mention.places) {
      const std::vector<Region>& regions = place.regions;
      present.insert(present.end(), regions.begin(), regions.end());
    }
    if (!present.empty() || !said_course) AddClaim(ClaimKind::kPresent, mention, present);
    if (!mention.places.empty() && !mention.has_course()) {
      for (const Place& place : mention.places) plan_.courses.push_back(CourseIn(wish, place));
      return;
    }
    const bool network = mention.noun->phrase.find("network") != std::string_view::npos ||
                         mention.noun->phrase.find("grid") != std::string_view::npos;
    const int courses = mention.has_course() ? 1
                        : mention.number > 0 ? std::min(mention.number, 6)
                        : network            ? 4
                        : mention.plural     ? 2
                                             : 1;
    for (int i = 0; i < courses; ++i) plan_.courses.push_back(wish);
  }

  // A course that is only said to lie in a place runs through it, along the side where it is one.
  static CourseWish CourseIn(CourseWish wish, const Place& place) {
    const Heading at = HeadingOf(place.main);
    wish.through = {place.main};
    wish.hugs_edge =
        place.box.u_max - place.box.u_min < 0.2 || place.box.v_max - place.box.v_min < 0.2;
    if (at.east == 0 && at.south == 0) return wish;
    if (at.east != 0 && at.south != 0) {
      wish.from = RegionOf({0, at.south});
      wish.to = RegionOf({at.east, 0});
    } else if (at.south != 0) {
      wish.from = RegionOf({-1, at.south});
      wish.to = RegionOf({1, at.south});
    } else {
      wish.from = RegionOf({at.east, -1});
      wish.to = RegionOf({at.east, 1});
    }
    return wish;
  }

  void WishArea(int index) {
    const Mention& mention = At(index);
    AreaWish wish;
    wish.letter = mention.letter;
    wish.shape = mention.noun->shape;
    wish.places = mention.places;
    wish.amount = mention.amount;
    wish.texture = mention.texture;
    wish.pieces = mention.number;
    wish.cells = mention.noun->cells;
    // "vineyards on the left half": many fields fill what is more than a ninth.
    const bool fills_place =
        wish.letter == 'A' && plan_.vocabulary == Vocabulary::kSuburb && mention.plural &&
        wish.pieces == 0 && wish.texture == Texture::kUnsaid && !wish.places.empty() &&
        std::all_of(wish.places.begin(), wish.places.end(),
                    [](const Place& place) { return place.regions.size() > 1; });
    if (fills_place) wish.shape = WordShape::kMass;
    const bool thing = wish.shape == WordShape::kThing;
    if (thing && mention.plural && wish.pieces == 0 && wish.amount != Amount::kMost) {
      // "houses" stand together, "lakes" apart.
      if (wish.cells < 6 && wish.texture == Texture::kUnsaid) {
        wish.cells = 30;
      } else if (wish.texture == Texture::kUnsaid) {
        wish.pieces = 3;
      } else if (wish.texture == Texture::kClustered) {
        wish.cells = std::max(wish.cells, 30);
      }
    }
    if (wish.pieces > 1 && !thing) wish.cells = std::max(15, 240 / wish.pieces);
    const bool counted = wish.pieces > 0;
    if ((counted || wish.texture != Texture::kScattered) && wish.places.empty()) {
      wish.cells = std::max(wish.cells, (kPresentCells / std::max(1, wish.pieces) + 1) *
                                            (wish.amount == Amount::kLittle ? 2 : 1));
    }
    const bool whole_map = wish.places.empty() && wish.letter == plan_.background &&
                           wish.texture != Texture::kScattered && wish.pieces == 0;
    ClaimArea(mention, wish);
    if (whole_map) return;
    plan_.areas.push_back(std::move(wish));
    area_of_[Index(index)] = static_cast<int>(plan_.areas.size()) - 1;
  }

  void ClaimArea(const Mention& mention, const AreaWish& wish) {
    const bool separate = wish.pieces > 1 || wish.texture == Texture::kScattered;
    const bool compact = wish.shape == WordShape::kThing && wish.amount != Amount::kMost;
    std::vector<Region> regions;
    for (const Place& place : wish.places) {
      if ((compact || separate) && place.regions.size() > 1) {
        regions.push_back(place.main);
      } else {
        regions.insert(regions.end(), place.regions.begin(), place.regions.end());
      }
    }
    if (wish.amount == Amount::kMost) {
      AddClaim(ClaimKind::kMostly, mention, regions);
    } else if (wish.amount == Amount::kLittle && !compact) {
      AddClaim(ClaimKind::kLittle, mention, regions);
    } else {
      AddClaim(ClaimKind::kPresent, mention, regions);
    }
    // Four lakes can lie apart, but not in many pieces.
    if (wish.texture == Texture::kScattered && (wish.pieces == 0 || wish.pieces >= 5)) {
      AddClaim(ClaimKind::kScattered, mention, {});
    }
    if (wish.texture == Texture::kClustered) AddClaim(ClaimKind::kClustered, mention, {});
  }

  void RelateAll() {
    for (const Tie& tie : reading_.ties) {
      if (plan_.relations.size() >= kMaxRelations) {
        plan_.warnings.push_back("too many ties for one layout: nothing is tied from " +
                                 Quote(Words(tie.begin, tie.end)) + " on");
        return;
      }
      Relate(tie);
    }
  }

  void Relate(const Tie& tie) {
    const Mention& subject = At(tie.subject);
    const Mention& object = At(tie.object);
    if (subject.letter == object.letter || tie.kind == TieKind::kHeading) return;
    // That water surrounds an island goes without saying.
    if (subject.is_island() || object.is_island()) return;
    Claim claim;
    claim.subject = subject.letter;
    claim.object = object.letter;
    claim.words = Words(tie.begin, tie.end);
    const int subject_area = area_of_[Index(tie.subject)];
    const int object_area = area_of_[Index(tie.object)];
    if (tie.kind == TieKind::kMoreThan) {
      claim.kind = ClaimKind::kMoreThan;
      if (subject_area >= 0) plan_.areas[Index(subject_area)].amount = Amount::kMuch;
      if (object_area >= 0) plan_.areas[Index(object_area)].amount = Amount::kLittle;
    } else {
      const bool ring = tie.kind == TieKind::kSurrounds && !object.is_line();
      claim.kind = ring ? ClaimKind::kSurrounds : ClaimKind::kAdjacent;
      const RelationWish relation{claim.kind, claim.subject, claim.object, subject_area,
                                  object_area};
      const bool known =
          std::any_of(plan_.relations.begin(), plan_.relations.end(),
                      [&](const RelationWish& other) { return IsSame(relation, other); });
      if (!known) plan_.relations.push_back(relation);
      if (ring && subject_area >= 0) {
        AreaWish& wish = plan_.areas[Index(subject_area)];
        wish.laid_by_relation =
            wish.places.empty() && wish.amount == Amount::kUnsaid && wish.shape == WordShape::kMass;
      }
    }
    plan_.claims.push_back(std::move(claim));
  }

  // A class that is denied everywhere is not laid, whatever else is said of it.
  void DropContradictions() {
    for (const Claim& denied : plan_.claims) {
      if (denied.kind != ClaimKind::kAbsent || !denied.regions.empty()) continue;
      const char letter = denied.subject;
      const auto wants = [&](const auto& wish) { return wish.letter == letter; };
      plan_.courses.erase(std::remove_if(plan_.courses.begin(), plan_.courses.end(), wants),
                          plan_.courses.end());
      for (AreaWish& wish : plan_.areas) {
        if (wish.letter == letter) wish.laid_by_relation = true;
      }
      plan_.relations.erase(
          std::remove_if(plan_.relations.begin(), plan_.relations.end(),
                         [&](const RelationWish& wish) { return wish.subject == letter; }),
          plan_.relations.end());
    }
  }

  void DropRepeatedClaims() {
    std::vector<Claim> kept;
    for (Claim& claim : plan_.claims) {
      const bool repeated = std::any_of(kept.begin(), kept.end(), [&](const Claim& earlier) {
        return SameMeaning(earlier, claim);
      });
      if (!repeated) kept.push_back(std::move(claim));
    }
    plan_.claims = std::move(kept);
  }

  LayoutReading reading_;
  std::string_view instruction_;
  LayoutPlan plan_;
  std::vector<bool> is_repeated_;  // by mention: said before in the same words
  std::vector<int> area_of_;       // by mention; -1: a course, denied, or the background
};

}  // namespace

LayoutPlan PlanFromReading(LayoutReading reading, std::string_view instruction,
                           Vocabulary vocabulary) {
  return Planner(std::move(reading), instruction, vocabulary).Plan();
}

}  // namespace latticeworld
