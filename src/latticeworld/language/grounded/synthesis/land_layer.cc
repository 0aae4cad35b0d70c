#include <algorithm>
#include <cmath>
#include <string>

#include "latticeworld/language/grounded/synthesis/area_grower.h"
#include "latticeworld/language/grounded/synthesis/draft.h"
#include "latticeworld/language/grounded/synthesis/smooth_field.h"

namespace latticeworld {
namespace {

struct LandInGrowth {
  AreaGrower grower;
  int laid;  // cells that the feature had before
  int target;
  bool stuck = false;  // no cell is left for it
};

class LandLayer {
 public:
  explicit LandLayer(Draft* draft) : draft_(draft) {}

  void Lay() {
    std::vector<LandInGrowth> growing;
    for (std::size_t i = 0; i < draft_->wishes.size(); ++i) {
      const PieceWish& wish = draft_->wishes[i];
      if (wish.spread && !wish.late) growing.push_back(Start(i));
    }
    while (true) {
      LandInGrowth* hungriest = nullptr;
      double least = 1.0;
      for (LandInGrowth& land : growing) {
        const double progress =
            static_cast<double>(land.laid + land.grower.cells()) / std::max(1, land.target);
        if (!land.stuck && progress < least) {
          least = progress;
          hungriest = &land;
        }
      }
      if (hungriest == nullptr) break;
      hungriest->stuck = !hungriest->grower.Step();
    }
    FillBackground();
  }

 private:
  LandInGrowth Start(std::size_t index) {
    const PieceWish& wish = draft_->wishes[index];
    const char letter = draft_->feature(wish.feature).letter;
    const Spot middle = draft_->skeleton.pieces[index];
    const LayoutMask own = draft_->canvas.MaskOfFeature(wish.feature);
    GrowOptions options;
    options.letter = letter;
    options.feature = wish.feature;
    options.allowed = ~draft_->forbidden.of(letter) - Shunned(wish.feature);
    options.cost = CostOf(wish, middle);
    CellIndex seed = NearestFree(draft_->canvas, options.allowed & wish.zone, middle);
    if (seed.row < 0) seed = NearestFree(draft_->canvas, options.allowed, middle);
    if (!own.empty()) {
      const CellIndex beside = NearestFree(draft_->canvas, options.allowed & own.Grown8(), middle);
      if (beside.row >= 0) seed = beside;
    }
    int target = wish.cells;
    if (wish.zoned && !draft_->feature(wish.feature).share) {
      // Filled to the last cell a zone would show its outline.
      target = std::min(
          target, static_cast<int>(
                      0.88 * (wish.zone & options.allowed & draft_->canvas.FreeCells()).count()));
    }
    LandInGrowth land{AreaGrower(std::move(options), seed, &draft_->canvas), 0, target};
    // What rings another piece counts only where one piece is all there is.
    if (!wish.zoned) land.laid = own.count();
    if (!own.empty() && draft_->feature(wish.feature).share) land.laid = own.count();
    for (const CellIndex further : FurtherSeeds(wish, seed)) land.grower.Take(further);
    const LayoutMask must = BesideWhatRunsThrough(wish.feature, middle);
    for (int id = 0; id < kCellCount; ++id) {
      if (must.Contains(CellOf(id))) land.grower.Take(CellOf(id));
    }
    return land;
  }

  // Returns further cells to grow from, so that the land comes to lie all over a zone that it shall
  // mostly fill. Each is the cell that is farthest from those before.
  std::vector<CellIndex> FurtherSeeds(const PieceWish& wish, CellIndex first) const {
    std::vector<CellIndex> seeds;
    if (!wish.zoned || first.row < 0 || 2 * wish.cells < wish.zone.count()) return seeds;
    const LayoutMask open = wish.zone & draft_->canvas.FreeCells();
    LayoutMask taken;
    taken.Add(first);
    for (int i = 0; i < wish.zone.count() / 70; ++i) {
      const Grid<float> steps = StepsFrom(taken);
      CellIndex best{-1, -1};
      float farthest = 7.0f;
      for (int id = 0; id < kCellCount; ++id) {
        const CellIndex cell = CellOf(id);
        if (!open.Contains(cell) || steps[cell] <= farthest || steps[cell] > 90.0f) continue;
        farthest = steps[cell];
        best = cell;
      }
      if (best.row < 0) break;
      taken.Add(best);
      seeds.push_back(best);
    }
    return seeds;
  }

  // Cells that the feature shall keep away from.
  LayoutMask Shunned(int feature) const {
    LayoutMask shunned;
    for (const PlannedRelation& relation : draft_->plan.relations) {
      const bool near = relation.kind == RelationKind::kNear;
      if (relation.kind != RelationKind::kApart && !near) continue;
      const int other = relation.subject == feature  ? relation.object
                        : relation.object == feature ? relation.subject
                                                     : -1;
      if (other < 0) continue;
      const LayoutMask mask = draft_->canvas.MaskOfFeature(other);
      if (!mask.empty()) shunned = shunned | mask.Grown8(near ? 1 : 6);
    }
    return shunned;
  }

  // A line through woods has woods on both its sides.
  LayoutMask BesideWhatRunsThrough(int feature, Spot middle) const {
    LayoutMask must;
    for (const PlannedRelation& relation : draft_->plan.relations) {
      if (relation.kind != RelationKind::kThrough || relation.object != feature) continue;
      const LayoutMask line = draft_->canvas.MaskOfFeature(relation.subject);
      if (line.empty()) continue;
      LayoutMask close;
      for (int id = 0; id < kCellCount; ++id) {
        const CellIndex cell = CellOf(id);
        const Spot spot{static_cast<double>(cell.row), static_cast<double>(cell.col)};
        if (DistanceBetween(spot, middle) < 6.5) close.Add(cell);
      }
      must = must | ((line & close).Grown8(2) - line);
    }
    return must;
  }

  Grid<float> CostOf(const PieceWish& wish, Spot middle) {
    const double wavelength = wish.zone.count() < 200 ? 5.0 : 8.0;
    const Grid<float> noise = SmoothField(draft_->random.NextBits(), wavelength);
    const Grid<float> outside = RoundStepsFrom(wish.zone);
    const Grid<float> inside = RoundStepsFrom(~wish.zone);
    const char letter = draft_->feature(wish.feature).letter;
    // Where it must not go it stops short, here more and there less.
    const Grid<float> ban = RoundStepsFrom(draft_->forbidden.of(letter));
    Grid<float> cost(kLayoutSize, kLayoutSize);
    for (int id = 0; id < kCellCount; ++id) {
      const CellIndex cell = CellOf(id);
      const double distance = LengthOf(cell.row - middle.row, cell.col - middle.col);
      double value = 3.5 * noise[cell] + (wish.zoned ? 0.02 : 0.3) * distance;
      // The zone's edge is no border of the land: it wavers a few cells to either side.
      value += 0.3 * std::min(outside[cell], 3.0f) + 1.5 * std::max(0.0f, outside[cell] - 3.0f);
      if (wish.zoned) value -= 0.25 * std::min(inside[cell], 4.0f);
      value += 1.5 * noise[cell] * std::max(0.0f, 4.0f - ban[cell]);
      value += 4.0 * AversionTo(letter, cell, draft_->plan.vocabulary, draft_->relief);
      cost[cell] = static_cast<float>(value);
    }
    for (const PlannedRelation& relation : draft_->plan.relations) {
      if (relation.subject == wish.feature) AddRelation(relation, &cost);
    }
    return cost;
  }

  Spot PointOf(int feature) const {
    const LayoutMask mask = draft_->canvas.MaskOfFeature(feature);
    if (!mask.empty()) return mask.Centroid();
    for (std::size_t i = 0; i < draft_->wishes.size(); ++i) {
      if (draft_->wishes[i].feature == feature) return draft_->skeleton.pieces[i];
    }
    return {15.5, 15.5};
  }

  void AddRelation(const PlannedRelation& relation, Grid<float>* cost) const {
    if (relation.object < 0) return;
    if (relation.kind == RelationKind::kDirection) {
      // Dear behind the object, and aside of the heading.
      const Spot object = PointOf(relation.object);
      const double length = std::max(1.0, LengthOf(relation.heading.east, relation.heading.south));
      for (int id = 0; id < kCellCount; ++id) {
        const CellIndex cell = CellOf(id);
        const double right = cell.col - object.col;
        const double down = cell.row - object.row;
        const double along =
            (right * relation.heading.east + down * relation.heading.south) / length;
        const double across =
            std::abs(right * relation.heading.south - down * relation.heading.east) / length;
        (*cost)[cell] += static_cast<float>(0.6 * std::max(0.0, 2.0 - along) +
                                            0.3 * std::max(0.0, across - std::abs(along) - 2.0));
      }
    }
    if (relation.kind == RelationKind::kAdjacent || relation.kind == RelationKind::kNear) {
      const LayoutMask mask = draft_->canvas.MaskOfFeature(relation.object);
      const Grid<float> steps = StepsFrom(mask);
      if (mask.empty()) return;
      for (int id = 0; id < kCellCount; ++id) {
        const CellIndex cell = CellOf(id);
        (*cost)[cell] +=
            0.25f * std::max(0.0f, steps[cell] - 2.0f) - (steps[cell] < 2.5f ? 1.5f : 0.0f);
      }
    }
    if (relation.kind == RelationKind::kBetween && relation.second_object >= 0) {
      const Spot first = PointOf(relation.object);
      const Spot second = PointOf(relation.second_object);
      const double length = std::max(1.0, DistanceBetween(first, second));
      for (int id = 0; id < kCellCount; ++id) {
        const CellIndex cell = CellOf(id);
        const double along = ((cell.col - first.col) * (second.col - first.col) +
                              (cell.row - first.row) * (second.row - first.row)) /
                             length;
        (*cost)[cell] += static_cast<float>(
            0.5 * (std::max(0.0, 0.2 * length - along) + std::max(0.0, along - 0.8 * length)));
      }
    }
  }

  // The cells where the letter is forbidden, or that lie outside of the only place it shall have.
  LayoutMask Unwelcome(char letter) const {
    constexpr double kOnly = 0.85;
    LayoutMask unwelcome = draft_->forbidden.of(letter);
    for (const Claim& claim : draft_->plan.claims) {
      const bool only = claim.kind == ClaimKind::kLocated && claim.subject == letter &&
                        claim.least != Claim::kUnsaid && claim.least >= kOnly;
      if (only) unwelcome = unwelcome | ~MaskOf(claim.zone);
    }
    return unwelcome;
  }

  void FillBackground() {
    const bool suburb = draft_->plan.vocabulary == Vocabulary::kSuburb;
    std::string order(1, draft_->plan.background);
    order += suburb ? "GADFWRB" : "BRFWS";
    for (const char letter : order) {
      const LayoutMask welcome = draft_->canvas.FreeCells() - Unwelcome(letter);
      Fill(welcome, letter);
    }
    // Nothing is welcome here: what is not forbidden, else the background.
    for (const char letter : order) {
      Fill(draft_->canvas.FreeCells() - draft_->forbidden.of(letter), letter);
    }
    Fill(draft_->canvas.FreeCells(), draft_->plan.background);
  }

  void Fill(const LayoutMask& cells, char letter) {
    for (int id = 0; id < kCellCount; ++id) {
      if (cells.Contains(CellOf(id))) draft_->canvas.Paint(CellOf(id), letter, -1);
    }
  }

  Draft* draft_;
};

}  // namespace

void LayLand(Draft* draft) { LandLayer(draft).Lay(); }

}  // namespace latticeworld
