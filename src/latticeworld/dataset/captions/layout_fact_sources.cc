#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/dataset/captions/layout_facts.h"
#include "latticeworld/language/extents.h"
#include "latticeworld/language/tokens.h"
#include "latticeworld/layout/claims/mask_measures.h"
#include "latticeworld/layout/class_letters.h"

// Facts about one class: how much of it there is, where, in how many pieces, and where there is
// none.
namespace latticeworld::internal {
namespace {

// "About a third", and the shares that a reader takes it for.
struct Amount {
  std::string words;
  double value, least, most;
};

const std::vector<Amount>& Amounts() {
  static const std::vector<Amount> amounts = [] {
    std::vector<Amount> known;
    const auto add = [&](const std::string& words) {
      const ShareMatch match = MatchShare(Tokenize(words + " of the land"), 0);
      if (match.tokens > 0 && match.fraction) {
        known.push_back({words, match.value, match.least, match.most});
      }
    };
    for (const char* words : {"about a tenth", "about a fifth", "about a quarter", "about a third",
                              "roughly a third", "about two fifths", "about half", "roughly half",
                              "about three fifths", "about two thirds", "about three quarters"}) {
      add(words);
    }
    for (int percent = 10; percent <= 90; percent += 5) {
      add("about " + std::to_string(percent) + " %");
    }
    return known;
  }();
  return amounts;
}

struct NamedZone {
  Zone zone;
  LayoutMask cells;
};

// The zones with places of their own in language.
const std::vector<NamedZone>& NamedZones() {
  static const std::vector<NamedZone> zones = [] {
    std::vector<NamedZone> known;
    for (const char* name : {"upper left",
                             "upper right",
                             "center",
                             "lower left",
                             "lower right",
                             "northern half",
                             "southern half",
                             "western half",
                             "eastern half",
                             "northern third",
                             "southern third",
                             "western third",
                             "eastern third",
                             "north-western quarter",
                             "north-eastern quarter",
                             "south-western quarter",
                             "south-eastern quarter",
                             "north-west corner",
                             "north-east corner",
                             "south-west corner",
                             "south-east corner"}) {
      const Zone zone = FindZone(name).value();
      known.push_back({zone, MaskOf(zone)});
    }
    return known;
  }();
  return zones;
}

LayoutFact FactOf(FactTopic topic, std::string phrase, char subject, std::vector<Claim> claims) {
  LayoutFact fact;
  fact.topic = topic;
  fact.phrase = std::move(phrase);
  fact.subject = subject;
  fact.claims = std::move(claims);
  return fact;
}

Claim PresentIn(char letter, const Zone& zone, double least) {
  Claim claim = ClaimOf(ClaimKind::kPresent, letter);
  claim.zone = zone;
  if (least > 0.0) claim.least = least;
  return claim;
}

// Whether a reader takes the class's nouns for land, which fills a good part of where it is said to
// be: even one meadow. Water, houses and groves are things.
bool IsLand(Vocabulary vocabulary, const ClassInLayout& entry) {
  if (entry.form == ClassForm::kSpread) return true;
  return entry.letter != class_letter::kWater && entry.letter != class_letter::kForest &&
         !IsBuilding(vocabulary, entry.letter);
}

std::vector<Claim> WithFirst(Claim first, std::vector<Claim> claims) {
  claims.insert(claims.begin(), std::move(first));
  return claims;
}

// Draws an order in which what has more weight tends to come first (Efraimidis and Spirakis 2006).
void ShuffleByWeight(std::vector<std::pair<double, LayoutFact>>* facts, RandomStream* random) {
  for (auto& [weight, fact] : *facts) {
    weight = std::log(std::max(random->Uniform(), 1e-12)) / std::max(weight, 1e-6);
  }
  std::stable_sort(facts->begin(), facts->end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
}

std::vector<LayoutFact> Without(std::vector<std::pair<double, LayoutFact>> weighted) {
  std::vector<LayoutFact> facts;
  facts.reserve(weighted.size());
  for (auto& [weight, fact] : weighted) facts.push_back(std::move(fact));
  return facts;
}

}  // namespace

std::vector<LayoutFact> ExtentFacts(const FactSource& source) {
  std::vector<std::pair<double, LayoutFact>> facts;
  const auto& classes = source.classes;
  if (classes.empty()) return {};
  const ClassInLayout& first = classes.front();
  if (first.share() >= 0.3 && first.nameable) {
    const std::string phrase = first.share() >= 0.5 ? "extent.dominant" : "extent.largest";
    facts.push_back({6.0, FactOf(FactTopic::kExtent, phrase, first.letter,
                                 {ClaimOf(ClaimKind::kDominant, first.letter)})});
  }
  for (const ClassInLayout& entry : classes) {
    if (entry.form != ClassForm::kSpread || !entry.nameable) continue;
    for (const Amount& amount : Amounts()) {
      // Beside the class that there is most of, none covers half.
      const double most_left = std::min(0.45, first.share() - 0.03);
      if (entry.letter != first.letter && amount.value > most_left) continue;
      // The share must be as exact as "about 45 %" is, so that what is said of two classes adds up.
      const double error = std::abs(amount.value - entry.share());
      if (error > std::max(0.025, 0.06 * amount.value)) continue;
      Claim claim = ClaimOf(ClaimKind::kAmount, entry.letter);
      claim.least = amount.least;
      claim.most = amount.most;
      LayoutFact fact = FactOf(FactTopic::kExtent, "extent.share", entry.letter, {claim});
      fact.amount = amount.words;
      facts.push_back({entry.share(), std::move(fact)});
    }
  }
  for (std::size_t i = 0; i + 1 < classes.size() && i < 3; ++i) {
    const ClassInLayout& less = classes[i + 1];
    if (!less.nameable || classes[i].share() < 1.3 * less.share()) continue;
    if (classes[i].form != ClassForm::kSpread || less.form != ClassForm::kSpread) continue;
    LayoutFact fact = FactOf(FactTopic::kExtent, "extent.more", classes[i].letter,
                             {ClaimOf(ClaimKind::kMoreThan, classes[i].letter, less.letter)});
    fact.object = less.letter;
    facts.push_back({0.5, std::move(fact)});
  }
  ShuffleByWeight(&facts, source.random);
  return Without(std::move(facts));
}

std::vector<LayoutFact> PlaceFacts(const FactSource& source) {
  std::vector<std::pair<double, LayoutFact>> facts;
  for (const ClassInLayout& entry : source.classes) {
    const bool line = source.IsLine(entry.letter);
    if (!entry.nameable || line) continue;
    const LayoutMask& cells = source.layout.of(entry.letter);
    for (const NamedZone& place : NamedZones()) {
      const int here = (cells & place.cells).count();
      const double share = static_cast<double>(here) / place.cells.count();
      const double located = static_cast<double>(here) / entry.cells;
      const double lift = share / entry.share();
      const auto add = [&](const char* phrase, double weight, std::vector<Claim> claims) {
        LayoutFact fact = FactOf(FactTopic::kPlace, phrase, entry.letter, std::move(claims));
        fact.zone = place.zone;
        facts.push_back({weight, std::move(fact)});
      };
      const bool spread = IsLand(source.layout.vocabulary(), entry);
      const double least = spread ? 0.2 : 0.0;
      // Land that is said to be in a half or a quarter of the map is taken to be most of it.
      const bool whole =
          spread && (EndsWith(place.zone.name, "half") || EndsWith(place.zone.name, "quarter"));
      Claim most = ClaimOf(ClaimKind::kDominant, entry.letter);
      most.zone = place.zone;
      std::vector<Claim> there = {PresentIn(entry.letter, place.zone, least)};
      if (whole) there.push_back(most);
      Claim within = ClaimOf(ClaimKind::kLocated, entry.letter);
      within.zone = place.zone;
      if (spread && share >= 0.65 && lift >= 1.1) {
        Claim amount = ClaimOf(ClaimKind::kAmount, entry.letter);
        amount.zone = place.zone;
        amount.least = 0.5;
        add(share >= 0.85 ? "place.fills" : "place.mostly", 2.0 * lift * located,
            {most, amount, PresentIn(entry.letter, place.zone, least)});
      }
      const bool countable = entry.form == ClassForm::kMany && entry.pieces >= 2 &&
                             entry.pieces <= 9 && entry.least_piece >= 3 && located >= 0.93;
      if (countable) {
        Claim count = ClaimOf(ClaimKind::kCount, entry.letter);
        count.least = count.most = entry.pieces;
        LayoutFact fact =
            FactOf(FactTopic::kPlace, "place.count", entry.letter, WithFirst(count, there));
        fact.zone = place.zone;
        fact.count = entry.pieces;
        facts.push_back({2.0 * lift, std::move(fact)});
      }
      if (located >= 0.93) {
        within.least = 0.9;
        add("place.only", 3.0 / place.cells.count() * 200.0, WithFirst(within, there));
      } else if (located >= 0.6 && lift >= 1.5) {
        add("place.lies", 2.0 * lift, WithFirst(within, there));
      } else if (spread && share >= 0.25 && lift >= 1.6) {
        add("place.there", lift, there);
      } else if (!spread && share >= 0.03 && located >= 0.3 && lift >= 1.5) {
        add("place.there", lift, there);
      }
    }
  }
  ShuffleByWeight(&facts, source.random);
  return Without(std::move(facts));
}

std::vector<LayoutFact> NumberFacts(const FactSource& source) {
  std::vector<LayoutFact> facts;
  for (const ClassInLayout& entry : source.classes) {
    if (!entry.nameable) continue;
    const bool pieces = entry.form == ClassForm::kMany || entry.form == ClassForm::kLines;
    if (pieces && entry.pieces >= 2 && entry.pieces <= 9 && entry.least_piece >= 3) {
      Claim claim = ClaimOf(ClaimKind::kCount, entry.letter);
      claim.least = claim.most = entry.pieces;
      LayoutFact fact = FactOf(FactTopic::kNumber, "number.count", entry.letter, {claim});
      fact.count = entry.pieces;
      if (entry.form == ClassForm::kMany) facts.push_back(std::move(fact));
    }
    if (entry.form == ClassForm::kMany || entry.form == ClassForm::kSpread) {
      if (entry.pieces >= 5) {
        facts.push_back(FactOf(FactTopic::kNumber, "number.scattered", entry.letter,
                               {ClaimOf(ClaimKind::kScattered, entry.letter)}));
      }
    }
  }
  source.random->Shuffle(&facts);
  return facts;
}

std::vector<LayoutFact> OrderFacts(const FactSource& source) {
  std::vector<LayoutFact> facts;
  struct Way {
    Claim::Heading heading;
    std::array<const char*, 3> bands;
  };
  static const std::array<Way, 4> ways = {
      {{{0, 1}, {"northern third", "middle rows", "southern third"}},
       {{0, -1}, {"southern third", "middle rows", "northern third"}},
       {{1, 0}, {"western third", "middle columns", "eastern third"}},
       {{-1, 0}, {"eastern third", "middle columns", "western third"}}}};
  for (const Way& way : ways) {
    for (const ClassInLayout& a : source.classes) {
      for (const ClassInLayout& b : source.classes) {
        for (const ClassInLayout& c : source.classes) {
          if (a.letter == b.letter || b.letter == c.letter || a.letter == c.letter) continue;
          if (a.share() < 0.06 || b.share() < 0.06 || c.share() < 0.06) continue;
          if (source.IsLine(a.letter) || source.IsLine(b.letter) || source.IsLine(c.letter))
            continue;
          Claim order = ClaimOf(ClaimKind::kOrder, a.letter);
          order.sequence = {a.letter, b.letter, c.letter};
          order.heading = way.heading;
          std::vector<Claim> claims = {order};
          const char letters[3] = {a.letter, b.letter, c.letter};
          for (std::size_t i = 0; i < 3; ++i) {
            claims.push_back(PresentIn(letters[i], FindZone(way.bands[i]).value(), 0.25));
          }
          LayoutFact fact = FactOf(FactTopic::kOrder, "order", a.letter, std::move(claims));
          fact.sequence = order.sequence;
          fact.heading = way.heading;
          facts.push_back(std::move(fact));
        }
      }
    }
  }
  source.random->Shuffle(&facts);
  return facts;
}

std::vector<LayoutFact> AbsenceFacts(const FactSource& source) {
  std::vector<LayoutFact> facts;
  for (const LayoutClass& known : ClassesOf(source.layout.vocabulary())) {
    const ClassInLayout* entry = source.Find(known.letter);
    if (entry == nullptr) {
      facts.push_back(FactOf(FactTopic::kAbsence, "absence.anywhere", known.letter,
                             {ClaimOf(ClaimKind::kAbsent, known.letter)}));
      continue;
    }
    // If there is only one thing of a class, it is enough to say where it is.
    if (!entry->nameable || entry->form == ClassForm::kOne || entry->form == ClassForm::kLine) {
      continue;
    }
    for (const char* name : {"northern half", "southern half", "western half", "eastern half"}) {
      Claim claim = ClaimOf(ClaimKind::kAbsent, known.letter);
      claim.zone = FindZone(name).value();
      LayoutFact fact = FactOf(FactTopic::kAbsence, "absence.zone", known.letter, {claim});
      fact.zone = claim.zone;
      facts.push_back(std::move(fact));
    }
  }
  source.random->Shuffle(&facts);
  return facts;
}

}  // namespace latticeworld::internal
