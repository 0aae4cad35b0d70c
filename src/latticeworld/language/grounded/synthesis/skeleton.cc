#include "latticeworld/language/grounded/synthesis/skeleton.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "latticeworld/language/grounded/synthesis/line_stops.h"
#include "latticeworld/language/grounded/synthesis/polyline.h"

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

class Solver {
 public:
  Solver(const LayoutPlan& plan, const std::vector<PieceWish>& wishes,
         const ForbiddenCells& forbidden, const Relief* relief, RandomStream* random)
      : plan_(plan), wishes_(wishes), forbidden_(forbidden), relief_(relief), random_(random) {
    const std::size_t features = plan.features.size();
    pieces_of_.resize(features);
    line_of_.assign(features, -1);
    tied_.assign(features, std::vector<Tie>(features, Tie::kNone));
    for (std::size_t i = 0; i < wishes.size(); ++i) {
      skeleton_.pieces.push_back({15.5, 15.5});
      AddDepth(wishes[i]);
      if (!wishes[i].late) pieces_of_[Index(wishes[i].feature)].push_back(static_cast<int>(i));
    }
    for (std::size_t i = 0; i < features; ++i) {
      if (plan.features[i].form == FeatureForm::kLine) AddLine(static_cast<int>(i));
    }
    for (const PlannedRelation& relation : plan.relations) NoteTie(relation);
    for (std::size_t i = 0; i < wishes.size(); ++i) Redraw(static_cast<int>(i));
  }

  Skeleton Run() {
    struct Mover {
      int line;  // -1: a piece
      int index;
    };
    std::vector<Mover> movers;
    for (std::size_t i = 0; i < wishes_.size(); ++i) {
      if (!wishes_[i].late) movers.push_back({-1, static_cast<int>(i)});
    }
    for (std::size_t i = 0; i < skeleton_.lines.size(); ++i) {
      for (std::size_t stop = 0; stop < choices_[i].size(); ++stop) {
        if (choices_[i][stop].feature < 0) {
          movers.push_back({static_cast<int>(i), static_cast<int>(stop)});
        }
      }
    }
    UpdateStops();
    if (movers.empty()) return skeleton_;
    // Every step looks at all pairs of pieces: many pieces are placed with fewer steps.
    const int pairs = static_cast<int>(wishes_.size() * wishes_.size() / 2);
    const int steps = std::min(std::clamp(160 * static_cast<int>(movers.size()), 400, 1800),
                               std::max(200, 400000 / (pairs + 1)));
    double energy = Energy();
    Skeleton best = skeleton_;
    double best_energy = energy;
    for (int step = 0; step < steps; ++step) {
      const double progress = static_cast<double>(step) / steps;
      const double temperature = 3.0 * std::pow(0.01, progress);
      const Mover mover = movers[static_cast<std::size_t>(
          random_->UniformInt(0, static_cast<int>(movers.size()) - 1))];
      Spot& spot = mover.line < 0 ? skeleton_.pieces[Index(mover.index)]
                                  : skeleton_.lines[Index(mover.line)].stops[Index(mover.index)];
      const Spot before = spot;
      if (mover.line >= 0) {
        RedrawStop(mover.line, mover.index, 1.0 - progress);
      } else if (random_->Chance(0.25 * (1.0 - progress))) {
        Redraw(mover.index);
      } else {
        const double reach = 0.8 + 6.0 * (1.0 - progress);
        spot.row = std::clamp(spot.row + random_->Uniform(-reach, reach), 0.0, 31.0);
        spot.col = std::clamp(spot.col + random_->Uniform(-reach, reach), 0.0, 31.0);
      }
      UpdateStops();
      const double next = Energy();
      if (next <= energy || random_->Chance(std::exp((energy - next) / temperature))) {
        energy = next;
        if (energy < best_energy) {
          best_energy = energy;
          best = skeleton_;
        }
      } else {
        spot = before;
        UpdateStops();
      }
    }
    return best;
  }

 private:
  // What two features have with each other, as far as the room between them is concerned.
  enum class Tie { kNone, kTouch, kNear, kNested, kLoose };

  static std::size_t Index(int value) { return static_cast<std::size_t>(value); }
  const PlannedFeature& FeatureOf(int feature) const { return plan_.features[Index(feature)]; }

  void AddDepth(const PieceWish& wish) {
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

  void AddLine(int feature) {
    line_of_[Index(feature)] = static_cast<int>(skeleton_.lines.size());
    SkeletonLine line;
    line.feature = feature;
    line.derived = IsDerived(plan_, feature);
    choices_.push_back(StopsOf(plan_, feature));
    for (const StopChoice& choice : choices_.back()) {
      line.stop_features.push_back(choice.feature);
      line.stops.push_back({15.5, 15.5});
    }
    skeleton_.lines.push_back(line);
    for (std::size_t stop = 0; stop < choices_.back().size(); ++stop) {
      if (choices_.back()[stop].feature < 0) {
        RedrawStop(static_cast<int>(skeleton_.lines.size()) - 1, static_cast<int>(stop), 1.0);
      }
    }
  }

  void NoteTie(const PlannedRelation& relation) {
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

  void SetTie(int a, int b, Tie tie) {
    Tie& first = tied_[Index(a)][Index(b)];
    if (first == Tie::kNested) return;
    first = tie;
    tied_[Index(b)][Index(a)] = tie;
  }

  void Redraw(int piece) {
    const LayoutMask& zone = wishes_[Index(piece)].zone;
    for (int trial = 0; trial < 40; ++trial) {
      const CellIndex cell{random_->UniformInt(0, kLayoutSize - 1),
                           random_->UniformInt(0, kLayoutSize - 1)};
      if (!zone.Contains(cell)) continue;
      skeleton_.pieces[Index(piece)] = {static_cast<double>(cell.row),
                                        static_cast<double>(cell.col)};
      return;
    }
    if (!zone.empty()) skeleton_.pieces[Index(piece)] = zone.Centroid();
  }

  // Any of the stop's cells; late in the search only one near by.
  void RedrawStop(int line, int stop, double freedom) {
    const std::vector<CellIndex>& cells = choices_[Index(line)][Index(stop)].cells;
    Spot& spot = skeleton_.lines[Index(line)].stops[Index(stop)];
    for (int trial = 0; trial < 4; ++trial) {
      const CellIndex cell =
          cells[Index(random_->UniformInt(0, static_cast<int>(cells.size()) - 1))];
      const Spot next{static_cast<double>(cell.row), static_cast<double>(cell.col)};
      const bool wanted = DistanceBetween(spot, next) <= 3.0 + 40.0 * freedom;
      if (trial == 3 || wanted) {
        spot = next;
        return;
      }
    }
  }

  void UpdateStops() {
    for (SkeletonLine& line : skeleton_.lines) {
      for (std::size_t i = 0; i < line.stops.size(); ++i) {
        if (line.stop_features[i] >= 0) line.stops[i] = PointOf(line.stop_features[i]);
      }
    }
  }

  bool HasPoint(int feature) const {
    return feature >= 0 && (!pieces_of_[Index(feature)].empty() || line_of_[Index(feature)] >= 0);
  }

  Spot PointOf(int feature) const {
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

  // Whether all that is of the claim's class is to lie on that one side.
  bool HasOneSide(const Claim& claim) const {
    const auto features =
        std::count_if(plan_.features.begin(), plan_.features.end(),
                      [&](const PlannedFeature& other) { return other.letter == claim.subject; });
    return features == 1 &&
           std::none_of(plan_.claims.begin(), plan_.claims.end(), [&](const Claim& other) {
             return other.kind == ClaimKind::kDirection && other.subject == claim.subject &&
                    other.object == claim.object && !(other.heading == claim.heading);
           });
  }

  // The middle of all that is of a letter; weight 0: nothing is.
  std::pair<Spot, double> LetterPoint(char letter) const {
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

  double Energy() const {
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

  double PieceEnergy(std::size_t i) const {
    const PieceWish& wish = wishes_[i];
    const Spot spot = skeleton_.pieces[i];
    const CellIndex cell = NearestCell(spot);
    const char letter = FeatureOf(wish.feature).letter;
    double energy = 0.0;
    const double depth = depths_[depth_of_[i]][cell];
    if (wish.zoned) {
      energy += 2.0 * std::max(0.0, 1.0 - depth);
      energy +=
          (wish.spread ? 0.15 : 0.8) * std::max(0.0, std::min(wish.radius + 0.5, 6.0) - depth);
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

  double PairEnergy() const {
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

  double LineEnergy(std::size_t index) const {
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
      const double edge = std::min(std::min(middle.row, 31.0 - middle.row),
                                   std::min(middle.col, 31.0 - middle.col));
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
      if (choices_[index][i].bend) {
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

  // Rivers run from high to low ground.
  double ReliefEnergyOf(const SkeletonLine& line) const {
    double energy = 0.0;
    for (std::size_t i = 1; i < line.stops.size(); ++i) {
      const double rise = relief_->summary[NearestCell(line.stops[i])] -
                          relief_->summary[NearestCell(line.stops[i - 1])];
      energy += 20.0 * std::max(0.0, rise + 0.05);
    }
    return energy + 6.0 * relief_->summary[NearestCell(line.stops.back())];
  }

  static bool IsStop(const SkeletonLine& line, int feature) {
    return std::find(line.stop_features.begin(), line.stop_features.end(), feature) !=
           line.stop_features.end();
  }

  // Distance between the nearest rims of one piece of a and of all of b [cells].
  double GapFrom(int piece, int b) const {
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
  double OverGaps(int a, int b, Cost cost) const {
    if (!HasPoint(a) || !HasPoint(b)) return 0.0;
    if (pieces_of_[Index(a)].empty()) std::swap(a, b);
    if (pieces_of_[Index(a)].empty()) {
      const auto& first = skeleton_.lines[Index(line_of_[Index(a)])];
      const auto& second = skeleton_.lines[Index(line_of_[Index(b)])];
      return first.derived || second.derived
                 ? 0.0
                 : cost(DistanceBetweenLines(first.stops, second.stops));
    }
    double sum = 0.0;
    for (const int piece : pieces_of_[Index(a)]) sum += cost(GapFrom(piece, b));
    return sum;
  }

  double DirectionEnergy(Spot subject, Spot object, Claim::Heading heading, double margin) const {
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

  double RadiusOf(int feature) const {
    double radius = 0.0;
    for (const int piece : pieces_of_[Index(feature)]) {
      radius = std::max(radius, wishes_[Index(piece)].radius);
    }
    return radius;
  }

  double RelationEnergy(const PlannedRelation& relation) const {
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

  // Each inner piece lies well inside some outer one.
  double NestedEnergy(int inner, int outer) const {
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

  double BetweenEnergy(const PlannedRelation& relation) const {
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

  double ClaimEnergy(const Claim& claim) const {
    if (claim.kind == ClaimKind::kDirection) {
      const auto [subject, weight] = LetterPoint(claim.subject);
      const auto [object, other] = LetterPoint(claim.object);
      // Of several of a class the relations tell which is meant.
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

  const LayoutPlan& plan_;
  const std::vector<PieceWish>& wishes_;
  const ForbiddenCells& forbidden_;
  const Relief* relief_;
  RandomStream* random_;
  std::vector<LayoutMask> depth_masks_;
  std::vector<Grid<float>> depths_;
  std::vector<std::size_t> depth_of_;             // beside the wishes
  std::vector<std::vector<int>> pieces_of_;       // by feature, without late ones
  std::vector<int> line_of_;                      // by feature; -1: none
  std::vector<std::vector<Tie>> tied_;            // by feature and feature
  std::vector<std::vector<StopChoice>> choices_;  // beside the lines
  Skeleton skeleton_;
};

}  // namespace

Skeleton PlaceSkeleton(const LayoutPlan& plan, const std::vector<PieceWish>& wishes,
                       const ForbiddenCells& forbidden, const Relief* relief,
                       RandomStream* random) {
  return Solver(plan, wishes, forbidden, relief, random).Run();
}

}  // namespace latticeworld
