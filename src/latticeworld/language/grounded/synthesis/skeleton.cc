#include "latticeworld/language/grounded/synthesis/skeleton.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "latticeworld/language/grounded/synthesis/lines/line_stops.h"
#include "latticeworld/language/grounded/synthesis/skeleton_energy.h"

namespace latticeworld {
namespace {

constexpr Spot kMiddle{15.5, 15.5};

std::size_t Index(int value) { return static_cast<std::size_t>(value); }

// Simulated annealing (Kirkpatrick, Gelatt and Vecchi 1983) over what may move.
class Solver {
 public:
  Solver(const LayoutPlan& plan, const std::vector<PieceWish>& wishes,
         const ForbiddenCells& forbidden, const Relief* relief, RandomStream* random)
      : plan_(plan), wishes_(wishes), random_(random) {
    skeleton_.pieces.assign(wishes.size(), kMiddle);
    for (std::size_t i = 0; i < plan.features.size(); ++i) {
      if (plan.features[i].form == FeatureForm::kLine) AddLine(static_cast<int>(i));
    }
    for (std::size_t i = 0; i < wishes.size(); ++i) Redraw(static_cast<int>(i));
    energy_.emplace(plan, wishes, forbidden, relief, skeleton_);
  }
  Solver(const Solver&) = delete;
  Solver& operator=(const Solver&) = delete;

  Skeleton Run() {
    UpdateStops();
    const std::vector<Mover> movers = Movers();
    if (movers.empty()) return skeleton_;
    // Every step looks at all pairs of pieces: many pieces are placed with fewer steps.
    const int pairs = static_cast<int>(wishes_.size() * wishes_.size() / 2);
    const int steps = std::min(std::clamp(160 * static_cast<int>(movers.size()), 400, 1800),
                               std::max(200, 400000 / (pairs + 1)));
    double energy = energy_->Now();
    Skeleton best = skeleton_;
    double best_energy = energy;
    for (int step = 0; step < steps; ++step) {
      const double progress = static_cast<double>(step) / steps;
      const double temperature = 3.0 * std::pow(0.01, progress);
      const Mover mover =
          movers[Index(random_->UniformInt(0, static_cast<int>(movers.size()) - 1))];
      Spot& spot = mover.line < 0 ? skeleton_.pieces[Index(mover.index)]
                                  : skeleton_.lines[Index(mover.line)].stops[Index(mover.index)];
      const Spot before = spot;
      Move(mover, progress, &spot);
      UpdateStops();
      const double next = energy_->Now();
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
  struct Mover {
    int line;  // -1: a piece
    int index;
  };

  std::vector<Mover> Movers() const {
    std::vector<Mover> movers;
    for (std::size_t i = 0; i < wishes_.size(); ++i) {
      if (!wishes_[i].late) movers.push_back({-1, static_cast<int>(i)});
    }
    for (std::size_t i = 0; i < choices_.size(); ++i) {
      for (std::size_t stop = 0; stop < choices_[i].size(); ++stop) {
        if (choices_[i][stop].feature < 0)
          movers.push_back({static_cast<int>(i), static_cast<int>(stop)});
      }
    }
    return movers;
  }

  void AddLine(int feature) {
    SkeletonLine line;
    line.feature = feature;
    line.derived = IsDerived(plan_, feature);
    choices_.push_back(StopsOf(plan_, feature));
    for (const StopChoice& choice : choices_.back()) {
      line.stop_features.push_back(choice.feature);
      line.bends.push_back(choice.bend);
      line.stops.push_back(kMiddle);
    }
    skeleton_.lines.push_back(line);
    for (std::size_t stop = 0; stop < choices_.back().size(); ++stop) {
      if (choices_.back()[stop].feature < 0)
        RedrawStop(static_cast<int>(skeleton_.lines.size()) - 1, static_cast<int>(stop), 1.0);
    }
  }

  // progress: of the search, [0, 1): later moves are smaller.
  void Move(const Mover& mover, double progress, Spot* spot) {
    if (mover.line >= 0) {
      RedrawStop(mover.line, mover.index, 1.0 - progress);
    } else if (random_->Chance(0.25 * (1.0 - progress))) {
      Redraw(mover.index);
    } else {
      const double reach = 0.8 + 6.0 * (1.0 - progress);
      spot->row = std::clamp(spot->row + random_->Uniform(-reach, reach), 0.0, 31.0);
      spot->col = std::clamp(spot->col + random_->Uniform(-reach, reach), 0.0, 31.0);
    }
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
        if (line.stop_features[i] >= 0) line.stops[i] = energy_->PointOf(line.stop_features[i]);
      }
    }
  }

  const LayoutPlan& plan_;
  const std::vector<PieceWish>& wishes_;
  RandomStream* random_;
  std::vector<std::vector<StopChoice>> choices_;  // beside the lines
  Skeleton skeleton_;
  std::optional<SkeletonEnergy> energy_;  // of skeleton_
};

}  // namespace

Skeleton PlaceSkeleton(const LayoutPlan& plan, const std::vector<PieceWish>& wishes,
                       const ForbiddenCells& forbidden, const Relief* relief,
                       RandomStream* random) {
  return Solver(plan, wishes, forbidden, relief, random).Run();
}

}  // namespace latticeworld
