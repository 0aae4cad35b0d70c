#include <algorithm>

#include "latticeworld/layout/claims/claim_measures.h"
#include "latticeworld/layout/claims/mask_measures.h"
#include "latticeworld/layout/class_letters.h"

namespace latticeworld::internal {
namespace {

// The other class whose lines may cut those of `letter`; '\0' when there is none.
char CrossingLine(Vocabulary vocabulary, char letter) {
  if (vocabulary != Vocabulary::kSuburb) return '\0';
  if (letter == suburb_letter::kRoad) return class_letter::kWater;
  return letter == class_letter::kWater ? suburb_letter::kRoad : '\0';
}

// Long for its area, as rivers and roads are and lakes are not.
bool IsLine(const LayoutMask& piece) {
  int first = kLayoutSize, last = -1;
  std::uint32_t columns = 0;
  for (int row = 0; row < kLayoutSize; ++row) {
    if (piece.row(row) == 0) continue;
    first = std::min(first, row);
    last = row;
    columns |= piece.row(row);
  }
  if (columns == 0) return false;
  const int width = 32 - __builtin_clz(columns) - __builtin_ctz(columns);
  const int longer = std::max(width, last - first + 1);
  return piece.count() <= (longer >= 12 ? 3.5 : 2.2) * longer;
}

// The cells of a line of the other class, one or two cells wide, that lie between two pieces as a
// bridge does; none where they touch both for longer, as a strip of road between two lakes. Given:
// the cells of the other class that touch the one and the other piece.
LayoutMask BridgeBetween(const LayoutMask& near_a, const LayoutMask& near_b) {
  constexpr int kMostOfOne = 6;   // cells that touch both pieces
  constexpr int kMostOfTwo = 10;  // cells of both rows
  const LayoutMask both = near_a & near_b;
  if (!both.empty()) return both.count() <= kMostOfOne ? both : LayoutMask();
  const LayoutMask rows = (near_a & near_b.Grown8()) | (near_b & near_a.Grown8());
  return rows.count() <= kMostOfTwo ? rows : LayoutMask();
}

struct Shore {
  LayoutMask near;  // cells of the other line class that touch the piece
  bool is_line = false;
  std::size_t whole = 0;  // the first piece of those that it is joined to
};

}  // namespace

std::vector<JoinedPiece> JoinedPiecesOf(const LayoutMask& cells, char letter,
                                        const LayoutMasks& layout) {
  constexpr std::size_t kMostJoined = 16;  // of the largest pieces
  std::vector<JoinedPiece> pieces;
  for (const LayoutMask& piece : cells.Pieces()) pieces.push_back({piece, piece});
  const char other = CrossingLine(layout.vocabulary(), letter);
  if (other == '\0' || pieces.size() < 2) return pieces;
  const LayoutMask crossing = layout.of(other) & cells.Grown8();
  if (crossing.empty()) return pieces;

  std::vector<Shore> shores(std::min(pieces.size(), kMostJoined));
  for (std::size_t i = 0; i < shores.size(); ++i) {
    shores[i] = {pieces[i].cells.Grown8() & crossing, IsLine(pieces[i].cells), i};
  }
  for (std::size_t i = 0; i < shores.size(); ++i) {
    for (std::size_t k = i + 1; k < shores.size(); ++k) {
      if (shores[i].whole == shores[k].whole) continue;
      if (!shores[i].is_line && !shores[k].is_line) continue;
      const LayoutMask bridge = BridgeBetween(shores[i].near, shores[k].near);
      if (bridge.empty()) continue;
      const std::size_t kept = std::min(shores[i].whole, shores[k].whole);
      const std::size_t gone = std::max(shores[i].whole, shores[k].whole);
      for (Shore& shore : shores) {
        if (shore.whole == gone) shore.whole = kept;
      }
      pieces[kept].cells = pieces[kept].cells | pieces[gone].cells;
      pieces[kept].connected = pieces[kept].connected | pieces[gone].connected | bridge;
      pieces[gone] = {};
    }
  }
  pieces.erase(std::remove_if(pieces.begin(), pieces.end(),
                              [](const JoinedPiece& piece) { return piece.cells.empty(); }),
               pieces.end());
  std::stable_sort(pieces.begin(), pieces.end(), [](const JoinedPiece& a, const JoinedPiece& b) {
    return a.cells.count() > b.cells.count();
  });
  return pieces;
}

}  // namespace latticeworld::internal
