#include <algorithm>
#include <cmath>

#include "latticeworld/language/grounded/synthesis/area_grower.h"
#include "latticeworld/language/grounded/synthesis/draft.h"
#include "latticeworld/language/grounded/synthesis/piece_shape.h"
#include "latticeworld/layout/claims/mask_measures.h"

namespace latticeworld {
namespace {

// Cells that a piece of the feature may take: none that are forbidden, none beside another piece of
// its letter or nearer to it than was said, and room kept to what it shall stay away from.
LayoutMask AllowedFor(int index, const Draft& draft) {
  const char letter = draft.feature(index).letter;
  LayoutMask allowed = ~draft.forbidden.of(letter);
  const int gap = std::max(2, static_cast<int>(std::ceil(draft.feature(index).gap)));
  allowed = allowed - draft.canvas.MaskOfLetter(letter).Grown8(gap);
  for (const PlannedRelation& relation : draft.plan.relations) {
    if (relation.kind != RelationKind::kApart) continue;
    const int other = relation.subject == index  ? relation.object
                      : relation.object == index ? relation.subject
                                                 : -1;
    if (other >= 0) allowed = allowed - draft.canvas.MaskOfFeature(other).Grown8(6);
  }
  return allowed;
}

// The features that lie within this one, or that it surrounds.
std::vector<int> InnerFeatures(int outer, const LayoutPlan& plan) {
  std::vector<int> inner;
  for (const PlannedRelation& relation : plan.relations) {
    if (relation.kind == RelationKind::kWithin && relation.object == outer) {
      inner.push_back(relation.subject);
    }
    if (relation.kind == RelationKind::kSurrounds && relation.subject == outer) {
      inner.push_back(relation.object);
    }
  }
  return inner;
}

bool IsRing(int index, const LayoutPlan& plan) {
  return std::any_of(
      plan.relations.begin(), plan.relations.end(), [&](const PlannedRelation& relation) {
        return relation.kind == RelationKind::kSurrounds && relation.subject == index;
      });
}

// How deep the feature nests: 0 where nothing lies within it.
int DepthOf(int index, const LayoutPlan& plan, int limit) {
  int depth = 0;
  if (limit == 0) return depth;
  for (const int inner : InnerFeatures(index, plan)) {
    if (inner >= 0 && inner != index) {
      depth = std::max(depth, 1 + DepthOf(inner, plan, limit - 1));
    }
  }
  return depth;
}

bool IsOnMapBorder(CellIndex cell) {
  return cell.row == 0 || cell.col == 0 || cell.row == kLayoutSize - 1 ||
         cell.col == kLayoutSize - 1;
}

void LayRing(int outer, const LayoutMask& inner, Draft* draft) {
  const PlannedFeature& feature = draft->feature(outer);
  const bool thick = feature.form == FeatureForm::kSpread;
  const LayoutMask around = WithHolesFilled(inner);
  LayoutMask ring = around.Grown8() - around;
  if (thick) {
    // One to three cells wide, smoothly.
    const LayoutMask second = ring.Grown8() - around;
    const double phase = draft->random.Uniform(0.0, 6.28);
    const Spot middle = around.Centroid();
    for (int id = 0; id < kCellCount; ++id) {
      const CellIndex cell = CellOf(id);
      if (!second.Contains(cell)) continue;
      const double angle = std::atan2(cell.row - middle.row, cell.col - middle.col);
      if (std::sin(angle * 2.0 + phase) > -0.4) ring.Add(cell);
    }
  }
  for (int id = 0; id < kCellCount; ++id) {
    const CellIndex cell = CellOf(id);
    if (!ring.Contains(cell) || draft->canvas.at(cell) != Canvas::kFree) continue;
    if (draft->forbidden.Contains(feature.letter, cell)) continue;
    draft->canvas.Paint(cell, feature.letter, outer);
  }
}

void LayRings(int outer, Draft* draft) {
  for (const int inner : InnerFeatures(outer, draft->plan)) {
    if (inner < 0 || draft->feature(outer).form == FeatureForm::kLine) continue;
    for (const LayoutMask& piece : draft->canvas.MaskOfFeature(inner).Pieces()) {
      LayRing(outer, piece, draft);
    }
  }
}

void Lay(const PieceWish& wish, Spot middle, Draft* draft) {
  const PlannedFeature& feature = draft->feature(wish.feature);
  PieceShape shape = ShapeOf(feature.shape, middle, wish.cells, &draft->random);
  const Grid<float> outside = StepsFrom(wish.zone);
  LayoutMask allowed = AllowedFor(wish.feature, *draft);
  // What grows around another piece starts as the ring that is there.
  const LayoutMask ring = draft->canvas.MaskOfFeature(wish.feature);
  int laid = 0;
  if (!InnerFeatures(wish.feature, draft->plan).empty()) {
    laid = ring.count();
    allowed = allowed | (ring.Grown8(2) - draft->forbidden.of(feature.letter));
  }
  GrowOptions options;
  options.letter = feature.letter;
  options.feature = wish.feature;
  options.cohesion = feature.shape == ClaimShape::kGridded ? 0.0 : 0.15;
  options.cost = std::move(shape.cost);
  for (int id = 0; id < kCellCount; ++id) {
    const CellIndex cell = CellOf(id);
    options.cost[cell] += 1.2f * outside[cell];
    if (!wish.zoned && IsOnMapBorder(cell)) options.cost[cell] += 1.5f;
    options.cost[cell] += static_cast<float>(
        2.0 * AversionTo(feature.letter, cell, draft->plan.vocabulary, draft->relief));
  }
  options.allowed = allowed;
  CellIndex seed = NearestFree(draft->canvas, allowed & wish.zone, shape.seed);
  if (seed.row < 0) seed = NearestFree(draft->canvas, allowed, shape.seed);
  if (seed.row < 0) return;
  if (laid > 0) {
    // If the ring that is there has free cells beside it, the piece grows from one of them.
    const CellIndex beside = NearestFree(draft->canvas, allowed & ring.Grown8(), shape.seed);
    if (beside.row >= 0) seed = beside;
  }
  AreaGrower grower(std::move(options), seed, &draft->canvas);
  while (laid + grower.cells() < shape.cells && grower.Step()) {
  }
}

// The cells of a piece that follows a line: near it, on the side wanted, away from its like.
Spot LateSpot(const PieceWish& wish, const LayoutMask& side, const Grid<float>& steps,
              const std::vector<Spot>& taken, Draft* draft) {
  Spot best{15.5, 15.5};
  double best_score = 1e9;
  const Grid<float> outside = StepsFrom(wish.zone);
  for (int trial = 0; trial < 80; ++trial) {
    const CellIndex cell{draft->random.UniformInt(0, kLayoutSize - 1),
                         draft->random.UniformInt(0, kLayoutSize - 1)};
    if (draft->canvas.at(cell) != Canvas::kFree) continue;
    const Spot spot{static_cast<double>(cell.row), static_cast<double>(cell.col)};
    double score = 2.0 * std::abs(steps[cell] - (wish.radius + 0.6)) + 2.0 * outside[cell];
    if (!side.Contains(cell)) score += 30.0;
    const int edge = std::min(std::min(cell.row, kLayoutSize - 1 - cell.row),
                              std::min(cell.col, kLayoutSize - 1 - cell.col));
    score += 1.5 * std::max(0, 3 - edge);
    for (const Spot& other : taken) {
      score += 2.0 * std::max(0.0, 2.0 * wish.radius + 3.0 - DistanceBetween(spot, other));
    }
    if (score >= best_score) continue;
    best_score = score;
    best = spot;
  }
  return best;
}

// The feature that a late piece follows, and whether on both sides.
int FollowedBy(int index, const LayoutPlan& plan, bool* both) {
  int followed = -1;
  for (const PlannedRelation& relation : plan.relations) {
    if (relation.subject != index) continue;
    if (relation.kind == RelationKind::kBothSides) {
      *both = true;
      return relation.object;
    }
    if (relation.kind == RelationKind::kAlong) followed = relation.object;
  }
  return followed;
}

// One side of the object: of a line the left, of an area what lies to one side of its longer axis.
LayoutMask OneSideOf(int object, const LayoutMask& mask, const Draft& draft) {
  const std::vector<CellIndex>& path = draft.paths[static_cast<std::size_t>(object)];
  if (path.size() >= 2) return LeftOf(path);
  const Spot middle = mask.Centroid();
  double rows = 0.0;
  double cols = 0.0;
  for (int id = 0; id < kCellCount; ++id) {
    if (!mask.Contains(CellOf(id))) continue;
    rows += std::abs(CellOf(id).row - middle.row);
    cols += std::abs(CellOf(id).col - middle.col);
  }
  LayoutMask side;
  for (int id = 0; id < kCellCount; ++id) {
    const CellIndex cell = CellOf(id);
    if (rows > cols ? cell.col < middle.col : cell.row < middle.row) side.Add(cell);
  }
  return side;
}

void LayLateBand(const PieceWish& wish, const LayoutMask& side, const LayoutMask& object,
                 const Grid<float>& steps, int cells, double closeness, Draft* draft) {
  const PlannedFeature& feature = draft->feature(wish.feature);
  GrowOptions options;
  options.letter = feature.letter;
  options.feature = wish.feature;
  options.allowed = side - draft->forbidden.of(feature.letter);
  options.cost = ShapeOf(std::nullopt, object.Centroid(), 400, &draft->random).cost;
  const Grid<float> outside = StepsFrom(wish.zone);
  for (int id = 0; id < kCellCount; ++id) {
    const CellIndex cell = CellOf(id);
    options.cost[cell] +=
        static_cast<float>(closeness) * std::max(0.0f, steps[cell] - 1.0f) + 1.5f * outside[cell];
  }
  const LayoutMask near = object.Grown8(2) & options.allowed;
  Spot start = object.Centroid();
  if (wish.zoned && !(near & wish.zone).empty()) start = (near & wish.zone).Centroid();
  const CellIndex seed = NearestFree(draft->canvas, near, start);
  AreaGrower grower(std::move(options), seed, &draft->canvas);
  while (grower.cells() < cells && grower.Step()) {
  }
}

}  // namespace

void LayPieces(Draft* draft) {
  const int features = static_cast<int>(draft->plan.features.size());
  std::vector<int> depths(draft->plan.features.size());
  int deepest = 0;
  for (int i = 0; i < features; ++i) {
    depths[static_cast<std::size_t>(i)] = DepthOf(i, draft->plan, 4);
    deepest = std::max(deepest, depths[static_cast<std::size_t>(i)]);
  }
  for (int depth = 0; depth <= deepest; ++depth) {
    for (int i = 0; i < features; ++i) {
      if (depths[static_cast<std::size_t>(i)] != depth) continue;
      if (depth > 0) LayRings(i, draft);
      // A ring of houses is all there is of them; woods that ring a lake may go on.
      const bool is_ring = IsRing(i, draft->plan) &&
                           draft->feature(i).form == FeatureForm::kPatch &&
                           draft->feature(i).zones.empty();
      if (is_ring) continue;
      for (std::size_t w = 0; w < draft->wishes.size(); ++w) {
        const PieceWish& wish = draft->wishes[w];
        if (wish.feature == i && !wish.spread && !wish.late) {
          Lay(wish, draft->skeleton.pieces[w], draft);
        }
      }
    }
  }
}

void LayLatePieces(Draft* draft) {
  std::vector<Spot> taken;
  int previous = -1;
  int number = 0;
  LayoutMask side;
  LayoutMask object_mask;
  Grid<float> steps;
  for (const PieceWish& wish : draft->wishes) {
    if (!wish.late) continue;
    bool both = false;
    const int object = FollowedBy(wish.feature, draft->plan, &both);
    if (wish.feature != previous) {
      previous = wish.feature;
      number = 0;
      taken.clear();
      object_mask = draft->canvas.MaskOfFeature(object);
      if (object_mask.empty()) object_mask.Add({15, 15});
      steps = StepsFrom(object_mask);
      side = OneSideOf(object, object_mask, *draft);
    }
    if (wish.spread) {
      const int near = ((object_mask.Grown8(2) - object_mask) & draft->canvas.FreeCells()).count();
      const bool sized = draft->feature(wish.feature).share.has_value() || wish.zoned;
      // Along a river runs a band; fields on both sides go on.
      const int cells = sized || both ? std::max(wish.cells, near) : std::max(8, near);
      const double closeness = both ? 0.5 : 1.5;
      if (both || draft->feature(object).form == FeatureForm::kLine) {
        LayLateBand(wish, side, object_mask, steps, cells / 2, closeness, draft);
        LayLateBand(wish, ~side, object_mask, steps, cells / 2, closeness, draft);
      } else {
        LayLateBand(wish, LayoutMask::All(), object_mask, steps, cells, closeness, draft);
      }
      continue;
    }
    const bool left = number++ % 2 == 0;
    const LayoutMask wanted = !both ? LayoutMask::All() : left ? side : ~side;
    const Spot spot = LateSpot(wish, wanted, steps, taken, draft);
    taken.push_back(spot);
    Lay(wish, spot, draft);
  }
}

}  // namespace latticeworld
