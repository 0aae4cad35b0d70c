#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_SYNTHESIS_LAYOUT_MOVES_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_SYNTHESIS_LAYOUT_MOVES_H_

#include <array>
#include <cstddef>

#include "latticeworld/common/random.h"
#include "latticeworld/language/grounded/layout_plan.h"
#include "latticeworld/language/grounded/synthesis/canvas.h"
#include "latticeworld/layout/layout_mask.h"

namespace latticeworld {

// What can be done to a layout to bring it nearer to a claim: pieces grow, are cut back, shifted,
// added and taken away, lines are laid, bridged and taken away. Each of them changes *next, which
// begins as the layout that the moves look at, and says whether it did. Cells of lines stay unless
// a line is what is moved, and no letter comes where it is forbidden.
class LayoutMoves {
 public:
  // lines: cells of lines. layout: looked at anew by each call. All of them outlive this.
  LayoutMoves(const LayoutPlan& plan, const ForbiddenCells& forbidden, const LayoutMask& lines,
              const LayoutMasks& layout, RandomStream* random)
      : plan_(plan), forbidden_(forbidden), lines_(lines), masks_(layout), random_(random) {}

  // Forgets what the moves before have changed.
  void Begin() { changed_.fill(false); }
  // Whether a move since then gave or took cells of the letter.
  bool HasChanged(char letter) const { return changed_[Slot(letter)]; }

  // Any move that may help the claim.
  bool Move(const Claim& claim, LayoutMasks* next);
  // Sets the cells to the letter.
  bool Stamp(const LayoutMask& cells, char letter, bool over_lines, LayoutMasks* next);

  // Whether the letter is only of lines.
  bool IsThin(char letter) const;
  // Another letter that at least five of the cell's eight neighbours have; '\0': none.
  char MajorityAround(CellIndex cell) const;
  // The letter, off lines, most common around the set (ties: alphabetical); '\0': none.
  char LetterAround(const LayoutMask& cells) const;

 private:
  static std::size_t Slot(char letter) { return static_cast<unsigned char>(letter) & 31; }

  char LetterAt(CellIndex cell) const;
  // A letter beside the cell that is not its own.
  char LetterBeside(CellIndex cell, char letter);
  CellIndex Draw(const LayoutMask& cells);
  // The letter that the move is about, and where.
  char PickLetter(const Claim& claim);
  LayoutMask PlaceOf(const Claim& claim, char letter);
  // One piece off lines; small ones rather than large.
  bool PickPiece(char letter, LayoutMask* piece);

  bool Grow(char letter, const LayoutMask& place, LayoutMasks* next);
  bool CutBack(char letter, const LayoutMask& place, LayoutMasks* next);
  bool Add(char letter, const LayoutMask& place, const Claim& claim, LayoutMasks* next);
  bool TakeAway(char letter, LayoutMasks* next);
  bool Shift(char letter, const LayoutMask& place, LayoutMasks* next);
  // A straight line within its place, or beside what it is tied to.
  bool LayLine(const Claim& claim, char letter, const LayoutMask& place, LayoutMasks* next);
  bool TakeLineAway(char letter, LayoutMasks* next);
  // A line of the letter from one of its pieces to another, or to the zone that it shall reach.
  bool Bridge(const Claim& claim, char letter, LayoutMasks* next);

  const LayoutPlan& plan_;
  const ForbiddenCells& forbidden_;
  const LayoutMask& lines_;
  const LayoutMasks& masks_;
  RandomStream* random_;
  std::array<bool, 32> changed_{};
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_SYNTHESIS_LAYOUT_MOVES_H_
