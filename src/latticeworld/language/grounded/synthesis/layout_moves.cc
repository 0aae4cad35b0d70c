#include "latticeworld/language/grounded/synthesis/layout_moves.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "latticeworld/language/grounded/synthesis/lines/line_router.h"

namespace latticeworld {
namespace {

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

}  // namespace

bool LayoutMoves::Move(const Claim& claim, LayoutMasks* next) {
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

bool LayoutMoves::Stamp(const LayoutMask& cells, char letter, bool over_lines, LayoutMasks* next) {
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

bool LayoutMoves::IsThin(char letter) const {
  bool line = false;
  for (const PlannedFeature& feature : plan_.features) {
    if (feature.letter != letter) continue;
    if (feature.form != FeatureForm::kLine) return false;
    line = true;
  }
  return line;
}

char LayoutMoves::LetterAt(CellIndex cell) const {
  for (const LayoutClass& entry : ClassesOf(plan_.vocabulary)) {
    if (masks_.of(entry.letter).Contains(cell)) return entry.letter;
  }
  return plan_.background;
}

char LayoutMoves::MajorityAround(CellIndex cell) const {
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

char LayoutMoves::LetterAround(const LayoutMask& cells) const {
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

char LayoutMoves::LetterBeside(CellIndex cell, char letter) {
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

CellIndex LayoutMoves::Draw(const LayoutMask& cells) {
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

char LayoutMoves::PickLetter(const Claim& claim) {
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

LayoutMask LayoutMoves::PlaceOf(const Claim& claim, char letter) {
  LayoutMask place =
      MaskOf(letter == claim.object && letter != claim.subject ? claim.object_zone : claim.zone);
  if (claim.kind == ClaimKind::kCourse) {
    place = MaskOf(random_->Chance(0.5) ? claim.from : claim.to);
  }
  return place.empty() ? LayoutMask::All() : place;
}

bool LayoutMoves::PickPiece(char letter, LayoutMask* piece) {
  std::vector<LayoutMask> pieces = (masks_.of(letter) - lines_).Pieces();
  if (pieces.empty()) return false;
  const int last = static_cast<int>(pieces.size()) - 1;
  *piece = pieces[static_cast<std::size_t>(
      std::max(random_->UniformInt(0, last), random_->UniformInt(0, last)))];
  return true;
}

bool LayoutMoves::Grow(char letter, const LayoutMask& place, LayoutMasks* next) {
  const LayoutMask& mask = masks_.of(letter);
  LayoutMask rim = mask.Grown4() - mask;
  if (random_->Chance(0.8) && !(rim & place).empty()) rim = rim & place;
  if (rim.empty()) return Add(letter, place, Claim(), next);
  const CellIndex cell = Draw(rim);
  const double radius = random_->Uniform(0.5, 2.6);
  return Stamp(Disc({static_cast<double>(cell.row), static_cast<double>(cell.col)}, radius), letter,
               false, next);
}

bool LayoutMoves::CutBack(char letter, const LayoutMask& place, LayoutMasks* next) {
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

bool LayoutMoves::Add(char letter, const LayoutMask& place, const Claim& claim, LayoutMasks* next) {
  LayoutMask where = place - forbidden_.of(letter);
  // Half of the time, the piece goes near what the claim ties it to.
  const char other = letter == claim.subject ? claim.object : claim.subject;
  if (other != '\0' && other != letter && random_->Chance(0.5)) {
    const LayoutMask near = masks_.of(other).Grown8(3) & where;
    if (!near.empty()) where = near;
  }
  if (where.empty()) return false;
  const CellIndex cell = Draw(where);
  const double radius = random_->Uniform(1.0, 3.2);
  return Stamp(Disc({static_cast<double>(cell.row), static_cast<double>(cell.col)}, radius), letter,
               false, next);
}

bool LayoutMoves::TakeAway(char letter, LayoutMasks* next) {
  LayoutMask piece;
  if (!PickPiece(letter, &piece) || piece.count() > 150) return false;
  const char around = LetterAround(piece);
  return around != '\0' && Stamp(piece, around, false, next);
}

bool LayoutMoves::Shift(char letter, const LayoutMask& place, LayoutMasks* next) {
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

bool LayoutMoves::LayLine(const Claim& claim, char letter, const LayoutMask& place,
                          LayoutMasks* next) {
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

bool LayoutMoves::TakeLineAway(char letter, LayoutMasks* next) {
  const std::vector<LayoutMask> pieces = next->of(letter).Pieces();
  if (pieces.empty()) return false;
  const LayoutMask& piece =
      pieces[static_cast<std::size_t>(random_->UniformInt(0, static_cast<int>(pieces.size()) - 1))];
  const char around = LetterAround(piece);
  return around != '\0' && Stamp(piece, around, true, next);
}

bool LayoutMoves::Bridge(const Claim& claim, char letter, LayoutMasks* next) {
  // The bridge begins at one of the largest pieces of the class.
  const std::vector<LayoutMask> pieces = masks_.of(letter).Pieces();
  if (pieces.empty()) return false;
  const auto last = static_cast<int>(pieces.size()) - 1;
  const LayoutMask& from =
      pieces[static_cast<std::size_t>(random_->UniformInt(0, std::min(last, 3)))];
  // It leads to where the claim wants the class, or to another piece.
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
  // It goes straight between near cells of both.
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
  // It is not to cover what it only has to touch, and is wider unless it is a line.
  LayoutMask bridge;
  for (const CellIndex cell : StraightCells(start, end)) bridge.Add(cell);
  if (claim.kind == ClaimKind::kAdjacent || claim.kind == ClaimKind::kConnects) {
    bridge = bridge - to;
  }
  const bool line_like = letter == 'R' || letter == 'W';
  if (!line_like) bridge = bridge.Grown4();
  return Stamp(bridge, letter, letter == 'R' && plan_.vocabulary == Vocabulary::kSuburb, next);
}

}  // namespace latticeworld
