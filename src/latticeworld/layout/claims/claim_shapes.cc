#include <algorithm>
#include <cmath>

#include "latticeworld/layout/claims/claim_measures.h"
#include "latticeworld/layout/claims/line_frame.h"
#include "latticeworld/layout/claims/mask_measures.h"

// Claims about the outline of a class's largest piece.
namespace latticeworld::internal {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kLineSlimness = 2.5;  // of straight and winding lines, at least

// What a shape lacks, 0 to 1, and the numbers that say why.
struct ShapeReading {
  double lack = 0.0;
  double value = 0.0;
  double other = 0.0;
};

double DistanceToLine(LayoutMask::Point point, LayoutMask::Point a, LayoutMask::Point b) {
  const double rows = b.row - a.row, cols = b.col - a.col;
  const double length_sq = rows * rows + cols * cols;
  double along = 0.0;
  if (length_sq > 0.0) {
    along = ((point.row - a.row) * rows + (point.col - a.col) * cols) / length_sq;
    along = std::clamp(along, 0.0, 1.0);
  }
  return std::hypot(point.row - a.row - along * rows, point.col - a.col - along * cols);
}

ShapeReading Round(const LayoutMask& piece) {
  const PrincipalAxes axes = PrincipalAxesOf(piece);
  const double slimness = SlimnessOf(axes, LineFrameOf(piece));
  // An ellipse with the piece's moments has the area that the piece has where it is full.
  const double fill = piece.count() / (0.25 * kPi * axes.length * axes.width);
  return {0.5 * Excess(slimness, 1.6, 8.0) + 0.5 * Shortfall(fill, 0.7), slimness, fill};
}

ShapeReading Elongated(const LayoutMask& piece) {
  const double slimness = SlimnessOf(PrincipalAxesOf(piece), LineFrameOf(piece));
  return {Shortfall(slimness, 2.0), slimness};
}

ShapeReading Bent(const LayoutMask& piece) {
  const LineFrame frame = LineFrameOf(piece);
  const double slimness = SlimnessOf(PrincipalAxesOf(piece), frame);
  const double off =
      DistanceToLine(frame.levels[frame.levels.size() / 2].Centroid(),
                     frame.levels.front().Centroid(), frame.levels.back().Centroid());
  const double bend = off / (frame.length + 1);
  return {0.5 * Shortfall(slimness, 2.0) + 0.5 * Shortfall(bend, 0.15), slimness, bend};
}

// Share of sixteen directions from the piece's middle that meet it: how nearly it closes.
double Closure(const LayoutMask& piece) {
  const LayoutMask::Point center = piece.Centroid();
  unsigned met = 0;
  ForEachCell(piece, [&](CellIndex cell) {
    const double turn = std::atan2(cell.row - center.row, cell.col - center.col) / (2.0 * kPi);
    met |= 1u << (static_cast<unsigned>(std::floor((turn + 1.0) * 16.0)) & 15u);
  });
  return __builtin_popcount(met) / 16.0;
}

ShapeReading Ring(const LayoutMask& piece) {
  // An opening of two cells, such as a road makes, does not undo a ring.
  const LayoutMask wide = piece.Grown8();
  const LayoutMask closed = piece | (wide - (~wide).Grown8());
  const int enclosed = std::max((WithHolesFilled(piece) - piece).count(),
                                (WithHolesFilled(closed) - closed).count());
  // A pond does not make a ring of the forest around it.
  const double lack = Shortfall(enclosed, std::max(1.0, 0.1 * piece.count()));
  const double value = enclosed;
  if (enclosed > 0) return {0.5 * lack, value};
  return {1.0 - 0.5 * Closure(piece), value};
}

// Straight and winding lines: the greatest distance of the centre line from its chord.
ShapeReading Line(const LayoutMask& piece, ClaimShape shape) {
  const LineFrame frame = LineFrameOf(piece);
  const std::vector<LayoutMask::Point> line = frame.CenterLine();
  double deviation = 0.0;
  for (const LayoutMask::Point point : line) {
    deviation = std::max(deviation, DistanceToLine(point, line.front(), line.back()));
  }
  const double slimness = SlimnessOf(PrincipalAxesOf(piece), frame);
  const double off =
      shape == ClaimShape::kStraight ? Excess(deviation, 1.5, 16.0) : Shortfall(deviation, 2.0);
  return {0.5 * Shortfall(slimness, kLineSlimness) + 0.5 * off, slimness, deviation};
}

// Two blocks within the lines; or six, when lines that run over the whole layout leave most blocks
// open to its edges: two lines one way and one across make so many.
ShapeReading Gridded(const LayoutMask& piece) {
  int holes = 0, blocks = 0;
  for (const LayoutMask& hole : Pieces4(WithHolesFilled(piece) - piece)) holes += hole.count() >= 2;
  for (const LayoutMask& block : Pieces4(~piece)) blocks += block.count() >= 4;
  return {std::min(Shortfall(holes, 2.0), Shortfall(blocks, 6.0)), static_cast<double>(holes),
          static_cast<double>(blocks)};
}

ShapeReading ReadingOf(ClaimShape shape, const LayoutMask& piece) {
  switch (shape) {
    case ClaimShape::kRound:
      return Round(piece);
    case ClaimShape::kElongated:
      return Elongated(piece);
    case ClaimShape::kBent:
      return Bent(piece);
    case ClaimShape::kRing:
      return Ring(piece);
    case ClaimShape::kStraight:
    case ClaimShape::kWinding:
      return Line(piece, shape);
    case ClaimShape::kGridded:
      return Gridded(piece);
  }
  return {1.0};
}

}  // namespace

ClaimMeasure ReadShape(const Claim& claim, const LayoutMasks& layout) {
  const LayoutMask subject = SubjectOf(claim, layout);
  if (subject.empty()) return Missing(claim.subject);
  const ShapeReading shape =
      ReadingOf(claim.shape, JoinedPiecesOf(subject, claim.subject, layout).front().connected);
  return {DistanceFor(shape.lack), shape.value, shape.other};
}

}  // namespace latticeworld::internal
