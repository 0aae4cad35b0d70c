#include <algorithm>
#include <cmath>

#include "latticeworld/layout/claims/claim_measures.h"
#include "latticeworld/layout/claims/line_frame.h"
#include "latticeworld/layout/claims/mask_measures.h"

// Claims about what lies on the two sides of a thing.
namespace latticeworld::internal {
namespace {

// The pieces of a class that are large enough to have sides.
std::vector<LayoutMask> LargestPieces(const LayoutMask& cells, char letter,
                                      const LayoutMasks& layout) {
  constexpr std::size_t kMost = 3;
  std::vector<LayoutMask> largest;
  for (const JoinedPiece& piece : JoinedPiecesOf(WithoutStrays(cells), letter, layout)) {
    if (largest.size() < kMost) largest.push_back(piece.connected);
  }
  return largest;
}

// Share of the smaller of two counts; 0 without any.
double LesserShare(int a, int b) {
  return a + b == 0 ? 0.0 : static_cast<double>(std::min(a, b)) / (a + b);
}

// The same for a round thing, which has two sides wherever one looks at it from: of the four ways
// the best.
double LesserSideOfRound(const LayoutMask& subject, const LayoutMask& piece, int steps) {
  const LayoutMask near = (piece.Grown8(steps) - piece) & subject;
  const LayoutMask::Point center = piece.Centroid();
  constexpr int kAxes[4][2] = {{0, 1}, {1, 0}, {1, 1}, {1, -1}};
  double best = 0.0;
  for (const auto& axis : kAxes) {
    const int rows = axis[0], cols = axis[1];
    int before = 0, behind = 0;
    ForEachCell(near, [&](CellIndex cell) {
      const double dr = cell.row - center.row, dc = cell.col - center.col;
      const double along = dr * rows + dc * cols, aside = std::abs(dr * cols - dc * rows);
      behind += along > aside;
      before += -along > aside;
    });
    best = std::max(best, LesserShare(before, behind));
  }
  return best;
}

// Share of what is near `piece` and of `subject` that is on the side that has less of it.
double LesserSide(const LayoutMask& subject, const LayoutMask& piece, int steps) {
  const LineFrame frame = LineFrameOf(piece);
  const int length = frame.length + 1;
  if (length * length < 3 * piece.count()) return LesserSideOfRound(subject, piece, steps);
  const LineSides sides = SidesOf(piece, frame, steps);
  return LesserShare((subject & sides.left).count(), (subject & sides.right).count());
}

}  // namespace

ClaimMeasure ReadBothSides(const Claim& claim, const LayoutMasks& layout) {
  // "Near" a side, and the least share of what is near that the lesser side must have.
  constexpr int kSteps = 4;
  constexpr double kLeastSide = 0.1;
  const LayoutMask subject = SubjectOf(claim, layout), object = ObjectOf(claim, layout);
  if (subject.empty()) return Missing(claim.subject);
  if (object.empty()) return Missing(claim.object);
  ClaimMeasure reading;
  for (const LayoutMask& piece : LargestPieces(object, claim.object, layout)) {
    reading.value = std::max(reading.value, LesserSide(subject, piece, kSteps));
  }
  const int gap = GapBetween(subject, object);
  const double far = Excess(gap, kSteps, kNoGap);
  reading.distance = DistanceFor(0.5 * Shortfall(reading.value, kLeastSide) + 0.5 * far);
  return reading;
}

ClaimMeasure ReadThrough(const Claim& claim, const LayoutMasks& layout) {
  // The object lies at most so many steps from the line, on both sides along so many of its cells.
  constexpr int kSteps = 3;
  constexpr double kLeastCells = 2.0;
  const LayoutMask subject = SubjectOf(claim, layout), object = ObjectOf(claim, layout);
  if (subject.empty()) return Missing(claim.subject);
  if (object.empty()) return Missing(claim.object);
  ClaimMeasure reading;
  for (const LayoutMask& piece : LargestPieces(subject, claim.subject, layout)) {
    const LineSides sides = SidesOf(piece, LineFrameOf(piece), kSteps);
    const LayoutMask between =
        piece & (object & sides.left).Grown8(kSteps) & (object & sides.right).Grown8(kSteps);
    reading.value = std::max<double>(reading.value, between.count());
  }
  const double far = Excess(GapBetween(subject, object), kSteps, kNoGap);
  reading.distance = DistanceFor(0.5 * Shortfall(reading.value, kLeastCells) + 0.5 * far);
  return reading;
}

}  // namespace latticeworld::internal
