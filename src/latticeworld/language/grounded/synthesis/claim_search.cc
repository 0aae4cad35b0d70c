#include "latticeworld/language/grounded/synthesis/claim_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/language/grounded/synthesis/line_router.h"
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

LayoutMask Disc(Spot middle, double radius) {
  LayoutMask disc;
  const int reach = static_cast<int>(radius) + 1;
  const CellIndex centre = NearestCell(middle);
  for (int row = centre.row - reach; row <= centre.row + reach; ++row) {
    for (int col = centre.col - reach; col <= centre.col + reach; ++col) {
      if (!IsInside({row, col})) continue;
      if (LengthOf(row - middle.row, col - middle.col) <= radius) disc.Add({row, col});
    }
  }
  return disc;
}

class Search {
 public:
  Search(const LayoutPlan& plan, const ForbiddenCells& forbidden, RandomStream* random,
         Canvas* canvas)
      : plan_(plan),
        forbidden_(forbidden),
        random_(random),
        canvas_(canvas),
        lines_(canvas->lines()),
        masks_(SymbolicLayout{plan.vocabulary, canvas->letters()}) {
    for (const Claim& claim : plan.claims) distances_.push_back(DistanceOf(claim, masks_));
    roughness_ = CostOf(RoughnessOf(masks_, lines_));
  }

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
      changed_.fill(false);
      --budget;  // a move that changes nothing costs as well
      if (!Move(plan_.claims[failing], &next)) continue;
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
      changed_.fill(false);
      bool any = false;
      for (int i = 0; i < kBlock * kBlock; ++i) {
        const CellIndex cell{corner.row + i / kBlock, corner.col + i % kBlock};
        const char letter = MajorityAround(cell);
        LayoutMask single;
        single.Add(cell);
        if (letter != '\0') any = Stamp(single, letter, false, &next) || any;
      }
      if (any) TryTo(std::move(next));
    }
  }

  void Tidy() {
    temperature_ = 0.0;
    for (const LayoutClass& entry : ClassesOf(plan_.vocabulary)) {
      if (IsThin(entry.letter)) continue;
      const std::vector<LayoutMask> pieces = masks_.of(entry.letter).Pieces();
      for (const LayoutMask& piece : pieces) {
        if (piece.count() > 2 || !(piece & lines_).empty()) continue;
        const char around = LetterAround(piece);
        if (around == '\0') continue;
        LayoutMasks next = masks_;
        changed_.fill(false);
        if (Stamp(piece, around, false, &next)) TryTo(std::move(next));
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
                        return changed_[Slot(entry.letter)] && Concerns(claim, entry.letter);
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

  static std::size_t Slot(char letter) { return static_cast<unsigned char>(letter) & 31; }

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

  char LetterAt(CellIndex cell) const {
    for (const LayoutClass& entry : ClassesOf(plan_.vocabulary)) {
      if (masks_.of(entry.letter).Contains(cell)) return entry.letter;
    }
    return plan_.background;
  }

  // Sets the cells to the letter, except lines (unless over them) and where it is forbidden.
  bool Stamp(const LayoutMask& cells, char letter, bool over_lines, LayoutMasks* next) {
    LayoutMask target = cells - forbidden_.of(letter) - next->of(letter);
    if (!over_lines) target = target - lines_;
    if (target.empty()) return false;
    for (const LayoutClass& entry : ClassesOf(plan_.vocabulary)) {
      const LayoutMask lost = next->of(entry.letter) & target;
      if (lost.empty()) continue;
      changed_[Slot(entry.letter)] = true;
      for (int row = 0; row < kLayoutSize; ++row) {
        for (std::uint32_t bits = lost.row(row); bits != 0; bits &= bits - 1) {
          next->Set({row, __builtin_ctz(bits)}, entry.letter, letter);
        }
      }
    }
    changed_[Slot(letter)] = true;
    return true;
  }

  // Another letter that at least five of the cell's eight neighbours have; '\0': none.
  char MajorityAround(CellIndex cell) const {
    std::array<int, 32> votes{};
    for (const auto& step : kNeighbours8) {
      const CellIndex next{cell.row + step[0], cell.col + step[1]};
      if (IsInside(next) && !lines_.Contains(next)) ++votes[Slot(LetterAt(next))];
    }
    if (IsThin(LetterAt(cell))) return '\0';
    for (const LayoutClass& entry : ClassesOf(plan_.vocabulary)) {
      if (votes[Slot(entry.letter)] >= 5 && !masks_.of(entry.letter).Contains(cell)) {
        return entry.letter;
      }
    }
    return '\0';
  }

  // The letter, off lines, most common around the set (ties: alphabetical); '\0': none.
  char LetterAround(const LayoutMask& cells) const {
    const LayoutMask ring = cells.Grown8() - cells - lines_;
    char best = '\0';
    int most = 0;
    for (const LayoutClass& entry : ClassesOf(plan_.vocabulary)) {
      const int count = (masks_.of(entry.letter) & ring).count();
      if (count <= most || !(forbidden_.of(entry.letter) & cells).empty()) continue;
      if (!(masks_.of(entry.letter) & cells).empty()) continue;
      most = count;
      best = entry.letter;
    }
    return best;
  }

  CellIndex Draw(const LayoutMask& cells) {
    int pick = random_->UniformInt(0, cells.count() - 1);
    for (int row = 0; row < kLayoutSize; ++row) {
      const int here = __builtin_popcount(cells.row(row));
      if (pick >= here) {
        pick -= here;
        continue;
      }
      std::uint32_t bits = cells.row(row);
      while (pick-- > 0) bits &= bits - 1;
      return {row, __builtin_ctz(bits)};
    }
    return cells.FirstCell();
  }

  // The letter that the move is about, and where.
  char PickLetter(const Claim& claim) {
    std::string letters(3, claim.subject);
    if (claim.object != '\0') letters += std::string(2, claim.object);
    if (claim.second_object != '\0') letters += claim.second_object;
    letters += claim.sequence;
    if (claim.kind == ClaimKind::kOrder) letters = claim.sequence;
    letters.erase(
        std::remove_if(letters.begin(), letters.end(),
                       [&](char letter) { return FindClass(plan_.vocabulary, letter) == nullptr; }),
        letters.end());
    if (letters.empty()) return plan_.background;
    return letters[static_cast<std::size_t>(
        random_->UniformInt(0, static_cast<int>(letters.size()) - 1))];
  }

  // Whether the letter is only of lines.
  bool IsThin(char letter) const {
    bool line = false;
    for (const PlannedFeature& feature : plan_.features) {
      if (feature.letter != letter) continue;
      if (feature.form != FeatureForm::kLine) return false;
      line = true;
    }
    return line;
  }

  LayoutMask PlaceOf(const Claim& claim, char letter) {
    LayoutMask place =
        MaskOf(letter == claim.object && letter != claim.subject ? claim.object_zone : claim.zone);
    if (claim.kind == ClaimKind::kCourse) {
      place = MaskOf(random_->Chance(0.5) ? claim.from : claim.to);
    }
    return place.empty() ? LayoutMask::All() : place;
  }

  bool Move(const Claim& claim, LayoutMasks* next) {
    const char letter = PickLetter(claim);
    const LayoutMask place = PlaceOf(claim, letter);
    if (IsThin(letter)) {
      // A road grows into no square.
      const int line_move = random_->UniformInt(0, 5);
      if (line_move <= 2) return Bridge(claim, letter, next);
      if (line_move == 3) return TakeLineAway(letter, next);
      if (line_move == 4) return LayLine(claim, letter, place, next);
      const bool taken = TakeLineAway(letter, next);
      return LayLine(claim, letter, place, next) || taken;
    }
    const int kind = random_->UniformInt(0, 9);
    if (kind <= 2) return Grow(letter, place, next);
    if (kind <= 4) return CutBack(letter, place, next);
    if (kind == 5) return Add(letter, place, claim, next);
    if (kind == 6) return TakeAway(letter, next);
    if (kind <= 8) return Shift(letter, place, next);
    return Bridge(claim, letter, next);
  }

  bool Grow(char letter, const LayoutMask& place, LayoutMasks* next) {
    const LayoutMask& mask = masks_.of(letter);
    LayoutMask rim = mask.Grown4() - mask;
    if (random_->Chance(0.8) && !(rim & place).empty()) rim = rim & place;
    if (rim.empty()) return Add(letter, place, Claim(), next);
    const CellIndex cell = Draw(rim);
    const double radius = random_->Uniform(0.5, 2.6);
    return Stamp(Disc({static_cast<double>(cell.row), static_cast<double>(cell.col)}, radius),
                 letter, false, next);
  }

  bool CutBack(char letter, const LayoutMask& place, LayoutMasks* next) {
    const LayoutMask& mask = masks_.of(letter);
    LayoutMask rim = (mask & (~mask).Grown4()) - lines_;
    if (random_->Chance(0.6) && !(rim & place).empty()) rim = rim & place;
    if (rim.empty()) return false;
    const CellIndex cell = Draw(rim);
    const double radius = random_->Uniform(0.5, 2.6);
    const Spot spot{static_cast<double>(cell.row), static_cast<double>(cell.col)};
    const LayoutMask bite = Disc(spot, radius) & mask;
    const char around = LetterBeside(cell, letter);
    return around != '\0' && Stamp(bite, around, false, next);
  }

  // A letter beside the cell that is not its own.
  char LetterBeside(CellIndex cell, char letter) {
    std::array<char, 8> others{};
    int count = 0;
    for (const auto& step : kNeighbours8) {
      const CellIndex next{cell.row + step[0], cell.col + step[1]};
      if (!IsInside(next) || lines_.Contains(next)) continue;
      const char other = LetterAt(next);
      if (other != letter) others[static_cast<std::size_t>(count++)] = other;
    }
    if (count == 0) return plan_.background == letter ? '\0' : plan_.background;
    return others[static_cast<std::size_t>(random_->UniformInt(0, count - 1))];
  }

  bool Add(char letter, const LayoutMask& place, const Claim& claim, LayoutMasks* next) {
    LayoutMask where = place - forbidden_.of(letter);
    // Near what the claim ties it to, as often as not.
    const char other = letter == claim.subject ? claim.object : claim.subject;
    if (other != '\0' && other != letter && random_->Chance(0.5)) {
      const LayoutMask near = masks_.of(other).Grown8(3) & where;
      if (!near.empty()) where = near;
    }
    if (where.empty()) return false;
    const CellIndex cell = Draw(where);
    const double radius = random_->Uniform(1.0, 3.2);
    return Stamp(Disc({static_cast<double>(cell.row), static_cast<double>(cell.col)}, radius),
                 letter, false, next);
  }

  bool TakeLineAway(char letter, LayoutMasks* next) {
    const std::vector<LayoutMask> pieces = next->of(letter).Pieces();
    if (pieces.empty()) return false;
    const LayoutMask& piece = pieces[static_cast<std::size_t>(
        random_->UniformInt(0, static_cast<int>(pieces.size()) - 1))];
    const char around = LetterAround(piece);
    return around != '\0' && Stamp(piece, around, true, next);
  }

  // A straight line within its place, or beside what it is tied to.
  bool LayLine(const Claim& claim, char letter, const LayoutMask& place, LayoutMasks* next) {
    LayoutMask where = place - forbidden_.of(letter);
    const char other = letter == claim.subject ? claim.object : claim.subject;
    if (other != '\0' && random_->Chance(0.6)) {
      const LayoutMask& mask = next->of(other);
      const LayoutMask near = (mask.Grown8(5) - mask.Grown8()) & where;
      if (!near.empty()) where = near;
    }
    if (where.empty()) return false;
    const CellIndex start = Draw(where);
    CellIndex end = start;
    for (int trial = 0; trial < 3; ++trial) {
      const CellIndex cell = Draw(where);
      const auto length = [&](CellIndex to) {
        return std::max(std::abs(to.row - start.row), std::abs(to.col - start.col));
      };
      if (length(cell) > length(end)) end = cell;
    }
    LayoutMask line;
    for (const CellIndex cell : StraightCells(start, end)) line.Add(cell);
    return Stamp(line, letter, letter == 'R', next);
  }

  // One piece off lines; small ones rather than large.
  bool PickPiece(char letter, LayoutMask* piece) {
    std::vector<LayoutMask> pieces = (masks_.of(letter) - lines_).Pieces();
    if (pieces.empty()) return false;
    const int last = static_cast<int>(pieces.size()) - 1;
    *piece = pieces[static_cast<std::size_t>(
        std::max(random_->UniformInt(0, last), random_->UniformInt(0, last)))];
    return true;
  }

  bool TakeAway(char letter, LayoutMasks* next) {
    LayoutMask piece;
    if (!PickPiece(letter, &piece) || piece.count() > 150) return false;
    const char around = LetterAround(piece);
    return around != '\0' && Stamp(piece, around, false, next);
  }

  bool Shift(char letter, const LayoutMask& place, LayoutMasks* next) {
    LayoutMask piece;
    if (!PickPiece(letter, &piece) || piece.count() > 180) return false;
    const CellIndex middle = NearestCell(piece.Centroid());
    int down = random_->UniformInt(-4, 4);
    int right = random_->UniformInt(-4, 4);
    if (random_->Chance(0.4)) {
      const CellIndex target = Draw(place);
      down = target.row - middle.row;
      right = target.col - middle.col;
    }
    LayoutMask moved;
    for (int row = 0; row < kLayoutSize; ++row) {
      const int to = row + down;
      if (piece.row(row) == 0) continue;
      if (to < 0 || to >= kLayoutSize) return false;
      if (std::abs(right) >= kLayoutSize) return false;
      moved.set_row(to, right >= 0 ? piece.row(row) << right : piece.row(row) >> -right);
    }
    if (moved.count() < piece.count()) return false;
    const char around = LetterAround(piece);
    if (around == '\0') return false;
    const bool left = Stamp(piece, around, false, next);
    return Stamp(moved, letter, false, next) || left;
  }

  // A line of the letter from one of its pieces to another, or to the zone that it shall reach.
  bool Bridge(const Claim& claim, char letter, LayoutMasks* next) {
    const std::vector<LayoutMask> pieces = masks_.of(letter).Pieces();
    if (pieces.empty()) return false;
    const auto last = static_cast<int>(pieces.size()) - 1;
    const LayoutMask& from =
        pieces[static_cast<std::size_t>(random_->UniformInt(0, std::min(last, 3)))];
    LayoutMask to;
    if (claim.kind == ClaimKind::kPresent || claim.kind == ClaimKind::kAmount ||
        claim.kind == ClaimKind::kAlong) {
      to = MaskOf(claim.zone);
    } else if (claim.kind == ClaimKind::kCourse) {
      to = MaskOf(random_->Chance(0.5) ? claim.from : claim.to);
    } else if (claim.kind == ClaimKind::kConnects || claim.kind == ClaimKind::kAdjacent) {
      to = masks_.of(random_->Chance(0.5) || claim.second_object == '\0' ? claim.object
                                                                         : claim.second_object);
    } else if (last >= 1) {
      to = pieces[static_cast<std::size_t>(random_->UniformInt(0, last))];
    }
    if (to.empty() || !(to & from).empty()) return false;
    LayoutMask reached = from;
    while ((reached & to).empty()) reached = reached.Grown8();
    const CellIndex end = Draw(reached & to);
    CellIndex start = end;
    int nearest = 1 << 20;
    for (int id = 0; id < kCellCount; ++id) {
      if (!from.Contains(CellOf(id))) continue;
      const int rows = CellOf(id).row - end.row;
      const int cols = CellOf(id).col - end.col;
      if (rows * rows + cols * cols >= nearest) continue;
      nearest = rows * rows + cols * cols;
      start = CellOf(id);
    }
    LayoutMask bridge;
    for (const CellIndex cell : StraightCells(start, end)) bridge.Add(cell);
    if (claim.kind == ClaimKind::kAdjacent || claim.kind == ClaimKind::kConnects) {
      bridge = bridge - to;
    }
    const bool line_like = letter == 'R' || letter == 'W';
    if (!line_like) bridge = bridge.Grown4();
    return Stamp(bridge, letter, letter == 'R' && plan_.vocabulary == Vocabulary::kSuburb, next);
  }

  const LayoutPlan& plan_;
  const ForbiddenCells& forbidden_;
  RandomStream* random_;
  Canvas* canvas_;
  LayoutMask lines_;
  LayoutMasks masks_;
  std::vector<double> distances_;  // beside the claims
  double roughness_ = 0.0;
  double temperature_ = 0.0;
  std::array<bool, 32> changed_{};  // letters that the move at hand gives or takes cells
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
