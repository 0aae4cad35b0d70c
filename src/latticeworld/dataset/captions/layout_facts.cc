#include "latticeworld/dataset/captions/layout_facts.h"

#include <algorithm>
#include <utility>

#include "latticeworld/layout/claims/line_frame.h"
#include "latticeworld/layout/claims/mask_measures.h"
#include "latticeworld/layout/class_letters.h"

namespace latticeworld {
namespace {

// Words for a class claim at least this share of the layout; for a line they claim less.
constexpr double kLeastShare = 0.016;
constexpr double kLeastLineShare = 0.010;
// What has so few cells, or so small a share, is a thing and no land.
constexpr int kLargestThing = 130;
constexpr double kLargestWater = 0.25;  // share; more is no lake but "water"

// Whether nearly all of a class runs as one line or several: long for its area, and slim.
bool RunsAsLines(const std::vector<LayoutMask>& pieces, int cells) {
  int running = 0;
  for (const LayoutMask& piece : pieces) {
    const LineFrame frame = LineFrameOf(piece);
    const bool line = frame.length >= 8 && piece.count() <= 3.5 * (frame.length + 1) &&
                      SlimnessOf(PrincipalAxesOf(piece), frame) >= 2.5;
    if (line) running += piece.count();
  }
  return 10 * running >= 8 * cells;
}

ClassForm FormOf(Vocabulary vocabulary, const ClassInLayout& entry,
                 const std::vector<LayoutMask>& pieces) {
  if (IsRoad(vocabulary, entry.letter)) {
    return entry.pieces == 1 ? ClassForm::kLine : ClassForm::kLines;
  }
  if (entry.letter == class_letter::kWater) {
    if (pieces.size() <= 4 && RunsAsLines(pieces, entry.cells)) {
      return entry.pieces == 1 ? ClassForm::kLine : ClassForm::kLines;
    }
    if (entry.share() > kLargestWater) return ClassForm::kSpread;
    if (entry.pieces == 1) return ClassForm::kOne;
    return entry.least_piece >= 3 ? ClassForm::kMany : ClassForm::kSpread;
  }
  if (IsBuilding(vocabulary, entry.letter)) {
    return entry.pieces == 1 && entry.cells <= kLargestThing ? ClassForm::kOne : ClassForm::kMany;
  }
  if (entry.cells > kLargestThing || entry.least_piece < 4) return ClassForm::kSpread;
  return entry.pieces == 1 ? ClassForm::kOne : ClassForm::kMany;
}

// Whether the two say the same, or nearly.
bool SameFact(const LayoutFact& a, const LayoutFact& b) {
  // "Two ponds", and then "there are ponds in the north", would be four.
  const auto counts = [](const LayoutFact& one) { return one.count > 0; };
  const auto there = [](const LayoutFact& one) { return one.phrase == "place.there"; };
  if (a.subject == b.subject &&
      ((counts(a) && (counts(b) || there(b))) || (there(a) && counts(b)))) {
    return true;
  }
  // A share of the whole beside a part that is full of it confuses more than it tells.
  const auto share = [](const LayoutFact& one) { return one.phrase == "extent.share"; };
  const auto full = [](const LayoutFact& one) {
    return one.phrase == "place.fills" || one.phrase == "place.mostly";
  };
  if (a.subject == b.subject && ((share(a) && full(b)) || (full(a) && share(b)))) return true;
  // One of several villages may lie in the forest and one in the fields: told of one class, the two
  // facts contradict each other to a reader.
  if (a.subject == b.subject && a.phrase == "relation.within" && b.phrase == a.phrase) return true;
  if (a.topic != b.topic) return false;
  switch (a.topic) {
    case FactTopic::kExtent:
    case FactTopic::kNumber:
      return a.subject == b.subject;
    case FactTopic::kPlace:
      return a.subject == b.subject || (a.zone == b.zone);
    case FactTopic::kLine:
      return a.subject == b.subject;
    case FactTopic::kRelation:
      return (a.subject == b.subject && a.object == b.object) ||
             (a.subject == b.object && a.object == b.subject);
    case FactTopic::kAbsence:
      return a.subject == b.subject || a.zone == b.zone;
    default:
      return true;
  }
}

// The candidates of each topic, made when they are first wanted.
class Deck {
 public:
  explicit Deck(const internal::FactSource& source) : source_(source) {}

  // The next fact of a topic that holds and that no other one says.
  bool Draw(FactTopic topic, const std::vector<LayoutFact>& said, LayoutFact* fact) {
    Pile& pile = piles_[static_cast<std::size_t>(topic)];
    if (!pile.made) {
      pile.facts = Make(topic);
      pile.made = true;
    }
    while (pile.next < pile.facts.size()) {
      LayoutFact& next = pile.facts[pile.next++];
      const bool known = std::any_of(said.begin(), said.end(),
                                     [&](const LayoutFact& one) { return SameFact(one, next); });
      if (known || !Holds(next)) continue;
      *fact = std::move(next);
      return true;
    }
    return false;
  }

 private:
  struct Pile {
    bool made = false;
    std::size_t next = 0;
    std::vector<LayoutFact> facts;
  };

  std::vector<LayoutFact> Make(FactTopic topic) const {
    switch (topic) {
      case FactTopic::kExtent:
        return internal::ExtentFacts(source_);
      case FactTopic::kLine:
        return internal::LineFacts(source_);
      case FactTopic::kPlace:
        return internal::PlaceFacts(source_);
      case FactTopic::kNumber:
        return internal::NumberFacts(source_);
      case FactTopic::kRelation:
        return internal::RelationFacts(source_);
      case FactTopic::kOrder:
        return internal::OrderFacts(source_);
      case FactTopic::kAbsence:
        return internal::AbsenceFacts(source_);
      case FactTopic::kRest:
        return {};
    }
    return {};
  }

  bool Holds(const LayoutFact& fact) const {
    return std::all_of(fact.claims.begin(), fact.claims.end(), [&](const Claim& claim) {
      return DistanceOf(claim, source_.layout) == 0.0;
    });
  }

  const internal::FactSource& source_;
  std::array<Pile, kFactTopics> piles_;
};

// "The rest is grassland" after all else, where it is true of what was named.
void AddRest(const internal::FactSource& source, std::vector<LayoutFact>* facts) {
  std::string named;
  const auto name = [&](char letter) {
    if (letter != '\0' && letter != '?' && named.find(letter) == std::string::npos) named += letter;
  };
  for (const LayoutFact& fact : *facts) {
    if (fact.topic == FactTopic::kAbsence) continue;
    name(fact.subject), name(fact.object), name(fact.second);
    for (const char letter : fact.sequence) name(letter);
  }
  for (const ClassInLayout& entry : source.classes) {
    const bool fits = entry.form == ClassForm::kSpread && entry.share() >= 0.1 &&
                      named.find(entry.letter) == std::string::npos;
    if (!fits) continue;
    Claim claim = internal::ClaimOf(ClaimKind::kRest, entry.letter);
    claim.sequence = named;
    if (DistanceOf(claim, source.layout) > 0.0) return;
    LayoutFact fact;
    fact.topic = FactTopic::kRest;
    fact.phrase = "rest";
    fact.subject = entry.letter;
    fact.claims = {claim};
    facts->push_back(std::move(fact));
    return;
  }
}

}  // namespace

namespace internal {

Claim ClaimOf(ClaimKind kind, char subject, char object) {
  Claim claim;
  claim.kind = kind;
  claim.subject = subject;
  claim.object = object;
  return claim;
}

const ClassInLayout* FactSource::Find(char letter) const {
  const auto found = std::find_if(classes.begin(), classes.end(), [&](const ClassInLayout& entry) {
    return entry.letter == letter;
  });
  return found == classes.end() ? nullptr : &*found;
}

bool FactSource::IsLine(char letter) const {
  const ClassInLayout* entry = Find(letter);
  return entry != nullptr && (entry->form == ClassForm::kLine || entry->form == ClassForm::kLines);
}

}  // namespace internal

std::vector<ClassInLayout> ClassesIn(const LayoutMasks& layout) {
  std::vector<ClassInLayout> classes;
  for (const LayoutClass& known : ClassesOf(layout.vocabulary())) {
    const LayoutMask& cells = layout.of(known.letter);
    if (cells.empty()) continue;
    const std::vector<LayoutMask> pieces = WithoutStrays(cells).Pieces();
    ClassInLayout entry;
    entry.letter = known.letter;
    entry.cells = cells.count();
    entry.pieces = static_cast<int>(pieces.size());
    entry.least_piece = pieces.empty() ? 0 : pieces.back().count();
    entry.form = FormOf(layout.vocabulary(), entry, pieces);
    const bool line = entry.form == ClassForm::kLine || entry.form == ClassForm::kLines;
    entry.nameable = entry.share() >= (line ? kLeastLineShare : kLeastShare);
    classes.push_back(entry);
  }
  std::stable_sort(classes.begin(), classes.end(),
                   [](const auto& a, const auto& b) { return a.cells > b.cells; });
  return classes;
}

std::vector<LayoutFact> ChooseFacts(const LayoutMasks& layout,
                                    const std::vector<ClassInLayout>& classes, int wanted,
                                    RandomStream* random) {
  const internal::FactSource source{layout, classes, random};
  Deck deck(source);
  // How often each topic comes up, relative to the others.
  std::vector<double> weights(kFactTopics - 1);
  for (double& weight : weights) weight = 1.0;
  weights[static_cast<std::size_t>(FactTopic::kPlace)] = 3.0;
  weights[static_cast<std::size_t>(FactTopic::kRelation)] = 2.0;
  weights[static_cast<std::size_t>(FactTopic::kLine)] = 2.0;
  weights[static_cast<std::size_t>(FactTopic::kOrder)] = 0.4;
  weights[static_cast<std::size_t>(FactTopic::kAbsence)] = 0.6;

  std::vector<LayoutFact> facts;
  LayoutFact fact;
  // Most captions begin with what there is most of.
  if (random->Chance(0.7) && deck.Draw(FactTopic::kExtent, facts, &fact)) facts.push_back(fact);
  double left = 1.0;
  while (static_cast<int>(facts.size()) < wanted && left > 0.0) {
    const std::size_t topic = random->Weighted(weights);
    if (deck.Draw(static_cast<FactTopic>(topic), facts, &fact)) {
      facts.push_back(fact);
      weights[topic] *= 0.6;  // variety
    } else {
      weights[topic] = 0.0;
    }
    left = 0.0;
    for (const double weight : weights) left += weight;
  }
  // Half of the captions go through the land topic by topic, as people who plan do.
  if (random->Chance(0.5)) {
    std::stable_sort(facts.begin(), facts.end(),
                     [](const LayoutFact& a, const LayoutFact& b) { return a.topic < b.topic; });
  }
  if (random->Chance(0.4)) AddRest(source, &facts);
  return facts;
}

}  // namespace latticeworld
