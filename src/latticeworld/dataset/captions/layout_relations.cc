#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "latticeworld/dataset/captions/layout_facts.h"
#include "latticeworld/layout/claims/mask_measures.h"

// Facts about lines, and about how two or three classes lie to each other.
namespace latticeworld::internal {
namespace {

constexpr std::array<const char*, 4> kEdges = {"northern edge", "eastern edge", "southern edge",
                                               "western edge"};
constexpr std::array<Claim::Heading, 8> kCompass = {
    {{0, -1}, {1, -1}, {1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}}};

LayoutFact FactOf(FactTopic topic, std::string phrase, std::vector<Claim> claims) {
  LayoutFact fact;
  fact.topic = topic;
  fact.phrase = std::move(phrase);
  fact.subject = claims.front().subject;
  fact.object = claims.front().object;
  fact.second = claims.front().second_object;
  fact.heading = claims.front().heading;
  fact.claims = std::move(claims);
  return fact;
}

// Whether the middles of the two classes, all their cells, say the same direction: where only two
// of many pieces do, it is not worth saying.
bool LiesToward(const LayoutMasks& layout, const Claim& claim) {
  const LayoutMask::Point to = layout.of(claim.subject).Centroid();
  const LayoutMask::Point from = layout.of(claim.object).Centroid();
  const double east = to.col - from.col, south = to.row - from.row;
  const double norm = std::hypot(claim.heading.east, claim.heading.south);
  const double along = (east * claim.heading.east + south * claim.heading.south) / norm;
  const double aside = std::abs(east * claim.heading.south - south * claim.heading.east) / norm;
  return along >= 4.0 && along >= 1.5 * aside;
}

}  // namespace

std::vector<LayoutFact> LineFacts(const FactSource& source) {
  std::vector<LayoutFact> facts;
  for (const ClassInLayout& entry : source.classes) {
    if (!source.IsLine(entry.letter) || !entry.nameable) continue;
    const Claim winding = [&] {
      Claim claim = ClaimOf(ClaimKind::kShape, entry.letter);
      claim.shape = ClaimShape::kWinding;
      return claim;
    }();
    const Claim straight = [&] {
      Claim claim = ClaimOf(ClaimKind::kShape, entry.letter);
      claim.shape = ClaimShape::kStraight;
      return claim;
    }();
    const bool one = entry.form == ClassForm::kLine;
    std::vector<LayoutFact> shaped;
    for (std::size_t a = 0; a < kEdges.size(); ++a) {
      for (std::size_t b = 0; b < kEdges.size(); ++b) {
        if (a == b) continue;
        Claim course = ClaimOf(ClaimKind::kCourse, entry.letter);
        course.from = FindZone(kEdges[a]).value();
        course.to = FindZone(kEdges[b]).value();
        // Edges that are opposite, or next to each other, tell different things of a line's way.
        LayoutFact fact = FactOf(FactTopic::kLine, one ? "line.course" : "lines.course", {course});
        fact.zone = course.from;
        fact.to = course.to;
        if (one) {
          LayoutFact bent = fact, direct = fact;
          bent.phrase = "line.winding";
          bent.claims.push_back(winding);
          direct.phrase = "line.straight";
          direct.claims.push_back(straight);
          shaped.push_back(std::move(bent));
          shaped.push_back(std::move(direct));
        }
        facts.push_back(std::move(fact));
      }
    }
    source.random->Shuffle(&shaped);
    // Half of the time the shape is told with the course.
    if (source.random->Chance(0.5)) {
      shaped.insert(shaped.end(), facts.begin(), facts.end());
      facts = std::move(shaped);
      continue;
    }
    source.random->Shuffle(&facts);
  }
  return facts;
}

std::vector<LayoutFact> RelationFacts(const FactSource& source) {
  std::vector<LayoutFact> facts;
  const auto add = [&](const char* phrase, const Claim& claim) {
    facts.push_back(FactOf(FactTopic::kRelation, phrase, {claim}));
  };
  for (const ClassInLayout& subject : source.classes) {
    if (!subject.nameable) continue;
    const bool subject_line = source.IsLine(subject.letter);
    const bool subject_thing = subject.form == ClassForm::kOne || subject.form == ClassForm::kMany;
    for (const ClassInLayout& object : source.classes) {
      if (!object.nameable || object.letter == subject.letter) continue;
      const bool object_line = source.IsLine(object.letter);
      const auto claim = [&](ClaimKind kind) {
        return ClaimOf(kind, subject.letter, object.letter);
      };
      if (subject_line) {
        if (object_line) {
          add("relation.crosses", claim(ClaimKind::kCrosses));
          add("relation.crosses", claim(ClaimKind::kCrosses));
        }
        // Lines lie along land wherever they lie in it, and cross a line rather than run through
        // it.
        if (object.form != ClassForm::kSpread) add("relation.along", claim(ClaimKind::kAlong));
        if (!object_line) {
          add("relation.through", claim(ClaimKind::kThrough));
          add("relation.through", claim(ClaimKind::kThrough));
        }
        continue;
      }
      if (object_line) {
        add("relation.both_sides", claim(ClaimKind::kBothSides));
        add("relation.adjacent", claim(ClaimKind::kAdjacent));
        continue;
      }
      add("relation.adjacent", claim(ClaimKind::kAdjacent));
      if (subject_thing) {
        add("relation.within", claim(ClaimKind::kWithin));
        add("relation.within", claim(ClaimKind::kWithin));
      }
      if (object.form == ClassForm::kOne) {
        add("relation.surrounds", claim(ClaimKind::kSurrounds));
        add("relation.surrounds", claim(ClaimKind::kSurrounds));
      }
      Claim apart = claim(ClaimKind::kApart);
      apart.least = 6.0;
      add("relation.apart", apart);
      for (const Claim::Heading heading : kCompass) {
        Claim toward = claim(ClaimKind::kDirection);
        toward.heading = heading;
        if (!LiesToward(source.layout, toward)) continue;
        add("relation.direction", toward);
        add("relation.direction", toward);
      }
      if (object.form == ClassForm::kSpread) continue;
      for (const ClassInLayout& second : source.classes) {
        if (!second.nameable || second.letter <= object.letter || second.letter == subject.letter ||
            second.form == ClassForm::kSpread || source.IsLine(second.letter)) {
          continue;
        }
        Claim between = claim(ClaimKind::kBetween);
        between.second_object = second.letter;
        add("relation.between", between);
      }
    }
  }
  source.random->Shuffle(&facts);
  return facts;
}

}  // namespace latticeworld::internal
