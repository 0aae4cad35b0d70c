#include "latticeworld/language/grounded/tidy.h"

#include <array>
#include <cstdint>
#include <vector>

namespace latticeworld {
namespace {

constexpr std::size_t kSmallPiece = 2;

std::vector<CellIndex> PieceAt(const Canvas& canvas, CellIndex start, Grid<std::uint8_t>* seen) {
  std::vector<CellIndex> piece = {start};
  (*seen)[start] = 1;
  for (std::size_t i = 0; i < piece.size(); ++i) {
    for (const auto& step : kNeighbours8) {
      const CellIndex next{piece[i].row + step[0], piece[i].col + step[1]};
      if (!canvas.Contains(next) || (*seen)[next] != 0 || canvas.at(next) != canvas.at(start)) {
        continue;
      }
      (*seen)[next] = 1;
      piece.push_back(next);
    }
  }
  return piece;
}

// The unlocked letter most common around the piece that may lie there; '\0' when there is none.
char LetterAround(const Canvas& canvas, const std::vector<CellIndex>& piece) {
  std::array<int, 128> votes{};
  for (const CellIndex cell : piece) {
    for (const auto& step : kNeighbours8) {
      const CellIndex next{cell.row + step[0], cell.col + step[1]};
      if (!canvas.Contains(next) || canvas.locked(next)) continue;
      const char letter = canvas.at(next);
      if (letter != canvas.at(cell) && !canvas.IsForbidden(letter, cell)) {
        ++votes[static_cast<std::size_t>(letter)];
      }
    }
  }
  int best = 0;
  for (int letter = 1; letter < 128; ++letter) {
    if (votes[letter] > votes[best]) best = letter;
  }
  return static_cast<char>(best);
}

}  // namespace

void TidySmallPieces(std::string_view kept, Canvas* canvas) {
  Grid<std::uint8_t> seen(kLayoutSize, kLayoutSize, 0);
  for (int row = 0; row < kLayoutSize; ++row) {
    for (int col = 0; col < kLayoutSize; ++col) {
      const CellIndex start{row, col};
      if (seen[start] != 0 || canvas->locked(start)) continue;
      const std::vector<CellIndex> piece = PieceAt(*canvas, start, &seen);
      if (piece.size() > kSmallPiece || kept.find(canvas->at(start)) != std::string_view::npos) {
        continue;
      }
      const char letter = LetterAround(*canvas, piece);
      if (letter == Canvas::kFree) continue;
      for (const CellIndex cell : piece) {
        if (!canvas->locked(cell)) canvas->Paint(cell, letter, -1);
      }
    }
  }
}

}  // namespace latticeworld
