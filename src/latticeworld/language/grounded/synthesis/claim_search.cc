#include "latticeworld/language/grounded/synthesis/claim_search.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/language/grounded/synthesis/layout_moves.h"
#include "latticeworld/language/grounded/synthesis/naturalness.h"

namespace latticeworld {
namespace {

constexpr double kGone = 1e-6;

// Whether a change of cells from one letter to another can change the claim's distance.
bool Concerns(const Claim& claim, char letter) {
  switch (claim.kind) {
    case ClaimKind::kDominant:
    case ClaimKind::kRest:
      return true;
    case ClaimKind::kPresent:
    case ClaimKind::kAbsent:
    case ClaimKind::kAmount:
    case ClaimKind::kLocated:
    case ClaimKind::kScattered:
    case ClaimKind::kClustered:
      return claim.subject == letter;
    case ClaimKind::kCourse:
    case ClaimKind::kCount:
    case ClaimKind::kShape:
      return claim.subject == letter || letter == 'R' || letter == 'W';
    default:
      return claim.subject == letter || claim.object == letter || claim.second_object == letter ||
             claim.sequence.find(letter) != std::string::npos || letter == 'R' || letter == 'W';
  }
}

class Search {
 public:
  Search(const LayoutPlan& plan, const ForbiddenCells& forbidden, RandomStream* random,
         Canvas* canvas)
      : plan_(plan),
        random_(random),
        canvas_(canvas),
        lines_(canvas->lines()),
        masks_(SymbolicLayout{plan.vocabulary, canvas->letters()}),
        moves_(plan, forbidden, lines_, masks_, random) {
    for (const Claim& claim : plan.claims) distances_.push_back(DistanceOf(claim, masks_));
    roughness_ = CostOf(RoughnessOf(masks_, lines_));
  }
  Search(const Search&) = delete;
  Search& operator=(const Search&) = delete;

  double Distance() const {
    double sum = 0.0;
    for (const double distance : distances_) sum += distance;
    return sum;
  }

  double Run(int budget) {
    double best = Distance();
    LayoutMasks best_masks = masks_;
    double best_roughness = roughness_;
    const int start = budget;
    while (budget > 0 && best > kGone) {
      const double progress = 1.0 - static_cast<double>(budget) / start;
      temperature_ = 0.02 * std::pow(0.02, progress);
      const std::size_t failing = PickFailing();
      if (failing == distances_.size()) break;
      LayoutMasks next = masks_;
      moves_.Begin();
      --budget;  // a move that changes nothing costs as well
      if (!moves_.Move(plan_.claims[failing], &next)) continue;
      budget -= TryTo(std::move(next));
      const double distance = Distance();
      if (distance < best - kGone || (distance < best + kGone && roughness_ < best_roughness)) {
        best = distance;
        best_masks = masks_;
        best_roughness = roughness_;
      }
    }
    masks_ = best_masks;
    return best;
  }

  // Takes what was found over to the canvas.
  void Commit() {
    for (int id = 0; id < kCellCount; ++id) {
      const CellIndex cell = CellOf(id);
      for (const LayoutClass& entry : ClassesOf(plan_.vocabulary)) {
        if (!masks_.of(entry.letter).Contains(cell) || canvas_->at(cell) == entry.letter) continue;
        if (lines_.Contains(cell)) {
          canvas_->PaintLine(cell, entry.letter, canvas_->feature_at(cell));
        } else {
          canvas_->Paint(cell, entry.letter, -1);
        }
      }
    }
  }

  void Smooth() {
    constexpr int kBlock = 8;
    constexpr int kRounds = 2;
    temperature_ = 0.0;
    for (int block = 0; block < kRounds * kCellCount / (kBlock * kBlock); ++block) {
      const int blocks = kLayoutSize / kBlock;
      const CellIndex corner{block / blocks % blocks * kBlock, block % blocks * kBlock};
      LayoutMasks next = masks_;
      moves_.Begin();
      bool any = false;
      for (int i = 0; i < kBlock * kBlock; ++i) {
        const CellIndex cell{corner.row + i / kBlock, corner.col + i % kBlock};
        const char letter = moves_.MajorityAround(cell);
        LayoutMask single;
        single.Add(cell);
        if (letter != '\0') any = moves_.Stamp(single, letter, false, &next) || any;
      }
      if (any) TryTo(std::move(next));
    }
  }

  void Tidy() {
    temperature_ = 0.0;
    for (const LayoutClass& entry : ClassesOf(plan_.vocabulary)) {
      if (moves_.IsThin(entry.letter)) continue;
      const std::vector<LayoutMask> pieces = masks_.of(entry.letter).Pieces();
      for (const LayoutMask& piece : pieces) {
        if (piece.count() > 2 || !(piece & lines_).empty()) continue;
        const char around = moves_.LetterAround(piece);
        if (around == '\0') continue;
        LayoutMasks next = masks_;
        moves_.Begin();
        if (moves_.Stamp(piece, around, false, &next)) TryTo(std::move(next));
      }
    }
  }

 private:
  // Measures the claims that the change concerns, and takes or drops it. Returns what was measured.
  int TryTo(LayoutMasks next) {
    std::vector<double> distances = distances_;
    int measured = 0;
    double change = 0.0;
    for (std::size_t i = 0; i < plan_.claims.size(); ++i) {
      const Claim& claim = plan_.claims[i];
      const bool concerned =
          std::any_of(ClassesOf(plan_.vocabulary).begin(), ClassesOf(plan_.vocabulary).end(),
                      [&](const LayoutClass& entry) {
                        return moves_.HasChanged(entry.letter) && Concerns(claim, entry.letter);
                      });
      if (!concerned) continue;
      distances[i] = DistanceOf(claim, next);
      ++measured;
      change += distances[i] - distances_[i];
    }
    const double roughness = CostOf(RoughnessOf(next, lines_));
    change += roughness - roughness_;
    const bool take =
        change <= 0.0 || (temperature_ > 0.0 && random_->Chance(std::exp(-change / temperature_)));
    if (take) {
      masks_ = std::move(next);
      distances_ = std::move(distances);
      roughness_ = roughness;
    }
    return measured;
  }

  std::size_t PickFailing() {
    int failing = 0;
    for (const double distance : distances_) failing += distance > 0.0 ? 1 : 0;
    if (failing == 0) return distances_.size();
    int pick = random_->UniformInt(0, failing - 1);
    for (std::size_t i = 0; i < distances_.size(); ++i) {
      if (distances_[i] > 0.0 && pick-- == 0) return i;
    }
    return distances_.size();
  }

  const LayoutPlan& plan_;
  RandomStream* random_;
  Canvas* canvas_;
  LayoutMask lines_;
  LayoutMasks masks_;
  LayoutMoves moves_;              // of masks_
  std::vector<double> distances_;  // beside the claims
  double roughness_ = 0.0;
  double temperature_ = 0.0;
};

}  // namespace

double TotalDistance(const LayoutPlan& plan, const LayoutMasks& layout) {
  double sum = 0.0;
  for (const Claim& claim : plan.claims) sum += DistanceOf(claim, layout);
  return sum;
}

double SatisfyClaims(const LayoutPlan& plan, const ForbiddenCells& forbidden, int budget,
                     RandomStream* random, Canvas* canvas) {
  Search search(plan, forbidden, random, canvas);
  const double distance = search.Run(budget);
  search.Commit();
  return distance;
}

void SmoothBorders(const LayoutPlan& plan, const ForbiddenCells& forbidden, Canvas* canvas) {
  RandomStream unused(0, "language/layout/smooth");
  Search search(plan, forbidden, &unused, canvas);
  search.Smooth();
  search.Commit();
}

void TidySmallPieces(const LayoutPlan& plan, const ForbiddenCells& forbidden, Canvas* canvas) {
  RandomStream unused(0, "language/layout/tidy");
  Search search(plan, forbidden, &unused, canvas);
  search.Tidy();
  search.Commit();
}

}  // namespace latticeworld
