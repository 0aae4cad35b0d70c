// What relations and claims add to the energy of a skeleton.

#include <algorithm>
#include <cmath>

#include "latticeworld/language/grounded/synthesis/lines/polyline.h"
#include "latticeworld/language/grounded/synthesis/skeleton_energy.h"

namespace latticeworld {

bool SkeletonEnergy::HasOneSide(const Claim& claim) const {
  const auto features =
      std::count_if(plan_.features.begin(), plan_.features.end(),
                    [&](const PlannedFeature& other) { return other.letter == claim.subject; });
  return features == 1 &&
         std::none_of(plan_.claims.begin(), plan_.claims.end(), [&](const Claim& other) {
           return other.kind == ClaimKind::kDirection && other.subject == claim.subject &&
                  other.object == claim.object && !(other.heading == claim.heading);
         });
}

std::pair<Spot, double> SkeletonEnergy::LetterPoint(char letter) const {
  Spot sum;
  double weight = 0.0;
  for (std::size_t i = 0; i < plan_.features.size(); ++i) {
    const int feature = static_cast<int>(i);
    if (plan_.features[i].letter != letter || !HasPoint(feature)) continue;
    double cells = 35.0;
    if (line_of_[i] < 0) {
      cells = 0.0;
      for (const int piece : pieces_of_[i]) cells += wishes_[Index(piece)].cells;
    }
    const Spot spot = PointOf(feature);
    sum.row += cells * spot.row;
    sum.col += cells * spot.col;
    weight += cells;
  }
  if (weight > 0.0) sum = {sum.row / weight, sum.col / weight};
  return {sum, weight};
}

double SkeletonEnergy::RadiusOf(int feature) const {
  double radius = 0.0;
  for (const int piece : pieces_of_[Index(feature)]) {
    radius = std::max(radius, wishes_[Index(piece)].radius);
  }
  return radius;
}

double SkeletonEnergy::GapFrom(int piece, int b) const {
  const Spot spot = skeleton_.pieces[Index(piece)];
  const double radius = wishes_[Index(piece)].radius;
  const int line = line_of_[Index(b)];
  if (line >= 0) return DistanceTo(skeleton_.lines[Index(line)].stops, spot) - radius - 0.5;
  double gap = 99.0;
  for (const int other : pieces_of_[Index(b)]) {
    gap = std::min(gap, DistanceBetween(spot, skeleton_.pieces[Index(other)]) - radius -
                            wishes_[Index(other)].radius);
  }
  return gap;
}

template <typename Cost>
double SkeletonEnergy::OverGaps(int a, int b, Cost cost) const {
  if (!HasPoint(a) || !HasPoint(b)) return 0.0;
  if (pieces_of_[Index(a)].empty()) std::swap(a, b);
  if (pieces_of_[Index(a)].empty()) {
    const auto& first = skeleton_.lines[Index(line_of_[Index(a)])];
    const auto& second = skeleton_.lines[Index(line_of_[Index(b)])];
    return first.derived || second.derived ? 0.0
                                           : cost(DistanceBetweenLines(first.stops, second.stops));
  }
  double sum = 0.0;
  for (const int piece : pieces_of_[Index(a)]) sum += cost(GapFrom(piece, b));
  return sum;
}

double SkeletonEnergy::DirectionEnergy(Spot subject, Spot object, Claim::Heading heading,
                                       double margin) const {
  const double length = LengthOf(heading.east, heading.south);
  if (length == 0.0) return 0.0;
  const double east = heading.east / length;
  const double south = heading.south / length;
  const double right = subject.col - object.col;
  const double down = subject.row - object.row;
  const double along = right * east + down * south;
  const double across = std::abs(right * south - down * east);
  return std::max(0.0, margin - along) + 0.7 * std::max(0.0, across - 0.5 * std::max(0.0, along));
}

double SkeletonEnergy::NestedEnergy(int inner, int outer) const {
  if (line_of_[Index(outer)] >= 0 || pieces_of_[Index(inner)].empty()) return 0.0;
  double energy = 0.0;
  for (const int piece : pieces_of_[Index(inner)]) {
    double out = 99.0;
    for (const int other : pieces_of_[Index(outer)]) {
      out = std::min(
          out, DistanceBetween(skeleton_.pieces[Index(piece)], skeleton_.pieces[Index(other)]) +
                   wishes_[Index(piece)].radius + 1.0 - wishes_[Index(other)].radius);
    }
    energy += 1.5 * std::max(0.0, out);
    // A ring needs room on all sides.
    const Spot spot = skeleton_.pieces[Index(piece)];
    const double edge =
        std::min(std::min(spot.row, 31.0 - spot.row), std::min(spot.col, 31.0 - spot.col));
    energy += std::max(0.0, wishes_[Index(piece)].radius + 2.0 - edge);
  }
  return energy;
}

double SkeletonEnergy::BetweenEnergy(const PlannedRelation& relation) const {
  Spot first = PointOf(relation.object);
  Spot second;
  if (relation.second_object < 0 || relation.second_object == relation.object) {
    const std::vector<int>& pieces = pieces_of_[Index(relation.object)];
    if (pieces.size() < 2) return 0.0;
    first = skeleton_.pieces[Index(pieces[0])];
    second = skeleton_.pieces[Index(pieces[1])];
  } else if (HasPoint(relation.second_object)) {
    second = PointOf(relation.second_object);
  } else {
    return 0.0;
  }
  const double length = std::max(1.0, DistanceBetween(first, second));
  const int line = line_of_[Index(relation.subject)];
  if (line >= 0) {
    // The line keeps the two on its two sides.
    const std::vector<Spot>& stops = skeleton_.lines[Index(line)].stops;
    const std::vector<Spot> tie = {first, second};
    const Spot middle{0.5 * (first.row + second.row), 0.5 * (first.col + second.col)};
    return 1.5 * CrossingMiss(stops, tie) + 0.5 * DistanceTo(stops, middle);
  }
  const Spot subject = PointOf(relation.subject);
  const double east = (second.col - first.col) / length;
  const double south = (second.row - first.row) / length;
  const double along =
      ((subject.col - first.col) * east + (subject.row - first.row) * south) / length;
  const double across =
      std::abs((subject.col - first.col) * south - (subject.row - first.row) * east);
  return 1.5 * (length * (std::max(0.0, 0.4 - along) + std::max(0.0, along - 0.6)) +
                std::max(0.0, across - 2.0) + std::max(0.0, 8.0 - length));
}

double SkeletonEnergy::RelationEnergy(const PlannedRelation& relation) const {
  const int a = relation.subject;
  const int b = relation.object;
  if (a < 0 || b < 0 || !HasPoint(a) || !HasPoint(b)) return 0.0;
  switch (relation.kind) {
    case RelationKind::kAdjacent:
      return OverGaps(a, b, [](double gap) { return 1.5 * std::abs(gap + 0.2); });
    case RelationKind::kNear:
      return OverGaps(a, b, [](double gap) {
        return 1.5 * (std::max(0.0, gap - 2.5) + std::max(0.0, 0.5 - gap));
      });
    case RelationKind::kApart:
      return OverGaps(a, b, [](double gap) { return 1.5 * std::max(0.0, 8.0 - gap); });
    case RelationKind::kWithin:
    case RelationKind::kSurrounds: {
      const bool within = relation.kind == RelationKind::kWithin;
      return NestedEnergy(within ? a : b, within ? b : a);
    }
    case RelationKind::kBetween:
      return BetweenEnergy(relation);
    case RelationKind::kDirection:
      return 1.5 * DirectionEnergy(PointOf(a), PointOf(b), relation.heading,
                                   RadiusOf(a) + RadiusOf(b) + 1.5);
    case RelationKind::kThrough:
      if (line_of_[Index(a)] < 0) return 0.0;
      return OverGaps(b, a, [&](double gap) { return std::max(0.0, gap + RadiusOf(b)); });
    case RelationKind::kCrosses: {
      const int first = line_of_[Index(a)];
      const int second = line_of_[Index(b)];
      if (first < 0 || second < 0) return 0.0;
      return 1.5 * CrossingMiss(skeleton_.lines[Index(first)].stops,
                                skeleton_.lines[Index(second)].stops);
    }
    default:
      return 0.0;
  }
}

double SkeletonEnergy::ClaimEnergy(const Claim& claim) const {
  if (claim.kind == ClaimKind::kDirection) {
    const auto [subject, weight] = LetterPoint(claim.subject);
    const auto [object, other] = LetterPoint(claim.object);
    // If there are several of a class, the relations tell which is meant.
    if (weight == 0.0 || other == 0.0 || !HasOneSide(claim)) return 0.0;
    return DirectionEnergy(subject, object, claim.heading, 4.0);
  }
  if (claim.kind != ClaimKind::kOrder) return 0.0;
  double energy = 0.0;
  for (std::size_t i = 1; i < claim.sequence.size(); ++i) {
    const auto [before, weight] = LetterPoint(claim.sequence[i - 1]);
    const auto [after, other] = LetterPoint(claim.sequence[i]);
    if (weight == 0.0 || other == 0.0) continue;
    const double length = std::max(1.0, LengthOf(claim.heading.east, claim.heading.south));
    const double along = ((after.col - before.col) * claim.heading.east +
                          (after.row - before.row) * claim.heading.south) /
                         length;
    energy += 1.5 * std::max(0.0, 5.0 - along);
  }
  return energy;
}

}  // namespace latticeworld
