#include "latticeworld/language/grounded/synthesis/skeleton_energy.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/language/grounded/synthesis/lines/polyline.h"

namespace latticeworld {
namespace {

constexpr double kTwoPieces = 2.5;  // gap that keeps two pieces of a letter apart [cells]

// Signed distance to a zone's edge [cells, king's moves]: inside positive; the map's edge is none.
Grid<float> DepthOf(const LayoutMask& zone) {
  Grid<float> depth(kLayoutSize, kLayoutSize, 0.0f);
  for (const bool inside : {true, false}) {
    LayoutMask reached = inside ? ~zone : zone;
    if (reached.empty()) {
      for (float& value : depth) value = kLayoutSize;
      return depth;
    }
    for (int step = 1; step <= kLayoutSize; ++step) {
      const LayoutMask next = reached.Grown8();
      const LayoutMask shell = next - reached;
      if (shell.empty()) break;
      for (int id = 0; id < kCellCount; ++id) {
        if (shell.Contains(CellOf(id))) {
          depth[CellOf(id)] = static_cast<float>(inside ? step : -step);
        }
      }
      reached = next;
    }
  }
  return depth;
}

bool IsStop(const SkeletonLine& line, int feature) {
  return std::find(line.stop_features.begin(), line.stop_features.end(), feature) !=
         line.stop_features.end();
}

}  // namespace

SkeletonEnergy::SkeletonEnergy(const LayoutPlan& plan, const std::vector<PieceWish>& wishes,
                               const ForbiddenCells& forbidden, const Relief* relief,
                               const Skeleton& skeleton)
    : plan_(plan), wishes_(wishes), forbidden_(forbidden), relief_(relief), skeleton_(skeleton) {
  const std::size_t features = plan.features.size();
  pieces_of_.resize(features);
  line_of_.assign(features, -1);
  tied_.assign(features, std::vector<Tie>(features, Tie::kNone));
  for (std::size_t i = 0; i < wishes.size(); ++i) {
    AddDepth(wishes[i]);
    if (!wishes[i].late) pieces_of_[Index(wishes[i].feature)].push_back(static_cast<int>(i));
  }
  for (std::size_t i = 0; i < skeleton.lines.size(); ++i)
    line_of_[Index(skeleton.lines[i].feature)] = static_cast<int>(i);
  for (const PlannedRelation& relation : plan.relations) NoteTie(relation);
}

void SkeletonEnergy::AddDepth(const PieceWish& wish) {
  for (std::size_t i = 0; i < depths_.size(); ++i) {
    if (depth_masks_[i] == wish.zone) {
      depth_of_.push_back(i);
      return;
    }
  }
  depth_of_.push_back(depths_.size());
  depth_masks_.push_back(wish.zone);
  depths_.push_back(DepthOf(wish.zone));
}

void SkeletonEnergy::NoteTie(const PlannedRelation& relation) {
  if (relation.subject < 0 || relation.object < 0) return;
  Tie tie = Tie::kNone;
  switch (relation.kind) {
    case RelationKind::kAdjacent:
      tie = Tie::kTouch;
      break;
    case RelationKind::kNear:
      tie = Tie::kNear;
      break;
    case RelationKind::kWithin:
    case RelationKind::kSurrounds:
      tie = Tie::kNested;
      break;
    case RelationKind::kAlong:
    case RelationKind::kBothSides:
    case RelationKind::kThrough:
    case RelationKind::kCrosses:
    case RelationKind::kParallel:
    case RelationKind::kConnects:
      tie = Tie::kLoose;
      break;
    default:
      return;
  }
  SetTie(relation.subject, relation.object, tie);
  if (relation.second_object >= 0) SetTie(relation.subject, relation.second_object, tie);
}

void SkeletonEnergy::SetTie(int a, int b, Tie tie) {
  Tie& first = tied_[Index(a)][Index(b)];
  if (first == Tie::kNested) return;
  first = tie;
  tied_[Index(b)][Index(a)] = tie;
}

Spot SkeletonEnergy::PointOf(int feature) const {
  if (feature < 0) return {15.5, 15.5};
  const int line = line_of_[Index(feature)];
  if (line >= 0) return MiddleOf(skeleton_.lines[Index(line)].stops);
  Spot sum;
  double weight = 0.0;
  for (const int piece : pieces_of_[Index(feature)]) {
    const double cells = wishes_[Index(piece)].cells;
    sum.row += cells * skeleton_.pieces[Index(piece)].row;
    sum.col += cells * skeleton_.pieces[Index(piece)].col;
    weight += cells;
  }
  if (weight == 0.0) return {15.5, 15.5};
  return {sum.row / weight, sum.col / weight};
}

double SkeletonEnergy::Now() const {
  double energy = 0.0;
  for (std::size_t i = 0; i < wishes_.size(); ++i) {
    if (!wishes_[i].late) energy += PieceEnergy(i);
  }
  energy += PairEnergy();
  for (std::size_t i = 0; i < skeleton_.lines.size(); ++i) {
    if (!skeleton_.lines[i].derived) energy += LineEnergy(i);
  }
  for (const PlannedRelation& relation : plan_.relations) energy += RelationEnergy(relation);
  for (const Claim& claim : plan_.claims) energy += ClaimEnergy(claim);
  return energy;
}

double SkeletonEnergy::PieceEnergy(std::size_t i) const {
  const PieceWish& wish = wishes_[i];
  const Spot spot = skeleton_.pieces[i];
  const CellIndex cell = NearestCell(spot);
  const char letter = FeatureOf(wish.feature).letter;
  double energy = 0.0;
  const double depth = depths_[depth_of_[i]][cell];
  if (wish.zoned) {
    energy += 2.0 * std::max(0.0, 1.0 - depth);
    energy += (wish.spread ? 0.15 : 0.8) * std::max(0.0, std::min(wish.radius + 0.5, 6.0) - depth);
  }
  if (!wish.spread) {
    const double edge =
        std::min(std::min(spot.row, 31.0 - spot.row), std::min(spot.col, 31.0 - spot.col));
    energy += 0.5 * std::max(0.0, wish.radius + 0.5 - edge);
  }
  energy += (wish.zoned ? 4.0 : 12.0) * AversionTo(letter, cell, plan_.vocabulary, relief_);
  if (forbidden_.Contains(letter, cell)) energy += 10.0;
  return energy;
}

double SkeletonEnergy::PairEnergy() const {
  double energy = 0.0;
  for (std::size_t i = 0; i < wishes_.size(); ++i) {
    if (wishes_[i].late) continue;
    for (std::size_t j = i + 1; j < wishes_.size(); ++j) {
      if (wishes_[j].late) continue;
      const PieceWish& a = wishes_[i];
      const PieceWish& b = wishes_[j];
      const Tie tie =
          a.feature == b.feature ? Tie::kNone : tied_[Index(a.feature)][Index(b.feature)];
      if (tie == Tie::kNested) continue;
      const double gap =
          DistanceBetween(skeleton_.pieces[i], skeleton_.pieces[j]) - a.radius - b.radius;
      const bool same = FeatureOf(a.feature).letter == FeatureOf(b.feature).letter;
      if (a.spread && b.spread) {
        energy += (same ? 0.1 : 0.25) * std::max(0.0, -gap);
      } else if (a.spread || b.spread) {
        energy += same ? 0.5 * std::max(0.0, kTwoPieces - gap)
                       : 0.15 * std::max(0.0, -gap - std::min(a.radius, b.radius));
      } else {
        const double wanted = same ? kTwoPieces : tie == Tie::kTouch ? -0.3 : 1.0;
        energy += 1.5 * std::max(0.0, wanted - gap);
      }
    }
  }
  return energy;
}

double SkeletonEnergy::LineEnergy(std::size_t index) const {
  const SkeletonLine& line = skeleton_.lines[index];
  const PlannedFeature& feature = FeatureOf(line.feature);
  double energy = 0.0;
  // Open ends lie far from each other, on different sides of the map.
  const Spot from = line.stops.front();
  const Spot to = line.stops.back();
  const bool open = !feature.from || !feature.to;
  energy += (open ? 0.5 : 0.2) *
            std::max(0.0, (feature.zones.empty() ? 30.0 : 26.0) - DistanceBetween(from, to));
  if (feature.zones.empty()) {
    const Spot middle = MiddleOf(line.stops);
    const double edge =
        std::min(std::min(middle.row, 31.0 - middle.row), std::min(middle.col, 31.0 - middle.col));
    energy += 0.7 * std::max(0.0, 8.0 - edge);
  }
  // A bend costs, and so does a stop that makes the line turn back.
  for (std::size_t i = 1; i + 1 < line.stops.size(); ++i) {
    const double detour = DistanceBetween(line.stops[i - 1], line.stops[i]) +
                          DistanceBetween(line.stops[i], line.stops[i + 1]) -
                          DistanceBetween(line.stops[i - 1], line.stops[i + 1]);
    if (feature.shape == ClaimShape::kBent && i == line.stops.size() / 2) {
      // A bow that leaves the straight way by a third of it.
      const double length = DistanceBetween(from, to);
      const double off = DistanceTo({from, to}, line.stops[i]);
      energy += std::abs(off - 0.33 * length);
    } else {
      energy += 0.3 * detour;
    }
    if (line.bends[i]) {
      energy += 0.1 * std::abs(DistanceBetween(line.stops[i - 1], line.stops[i]) -
                               DistanceBetween(line.stops[i], line.stops[i + 1]));
    }
  }
  if (relief_ != nullptr && feature.letter == 'W') energy += ReliefEnergyOf(line);
  // Room to what it has nothing to do with.
  for (std::size_t i = 0; i < wishes_.size(); ++i) {
    const PieceWish& wish = wishes_[i];
    if (wish.spread || wish.late) continue;
    const Tie tie = tied_[Index(line.feature)][Index(wish.feature)];
    if (tie == Tie::kLoose || IsStop(line, wish.feature)) continue;
    const double gap = DistanceTo(line.stops, skeleton_.pieces[i]) - wish.radius;
    const bool same = FeatureOf(wish.feature).letter == feature.letter;
    const double wanted = same ? kTwoPieces + 1.0 : tie == Tie::kTouch ? 0.0 : 1.5;
    energy += 1.0 * std::max(0.0, wanted - gap);
  }
  for (std::size_t other = 0; other < index; ++other) {
    const SkeletonLine& there = skeleton_.lines[other];
    if (there.derived || FeatureOf(there.feature).letter != feature.letter ||
        tied_[Index(line.feature)][Index(there.feature)] != Tie::kNone ||
        IsStop(line, there.feature) || IsStop(there, line.feature)) {
      continue;
    }
    energy += std::max(0.0, 6.0 - DistanceBetweenLines(line.stops, there.stops));
  }
  return energy;
}

double SkeletonEnergy::ReliefEnergyOf(const SkeletonLine& line) const {
  double energy = 0.0;
  for (std::size_t i = 1; i < line.stops.size(); ++i) {
    const double rise = relief_->summary[NearestCell(line.stops[i])] -
                        relief_->summary[NearestCell(line.stops[i - 1])];
    energy += 20.0 * std::max(0.0, rise + 0.05);
  }
  return energy + 6.0 * relief_->summary[NearestCell(line.stops.back())];
}

}  // namespace latticeworld
