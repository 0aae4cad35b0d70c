#include <algorithm>
#include <cmath>

#include "latticeworld/layout/claims/claim_measures.h"
#include "latticeworld/layout/claims/line_frame.h"
#include "latticeworld/layout/claims/mask_measures.h"

// Claims about rivers and roads: where they run and what they do to each other.
namespace latticeworld::internal {
namespace {

constexpr double kDegrees = 180.0 / 3.14159265358979323846;

// The ring of radius 2 around a cell, clockwise.
constexpr int kRing[16][2] = {{-2, -2}, {-2, -1}, {-2, 0}, {-2, 1}, {-2, 2}, {-1, 2},
                              {0, 2},   {1, 2},   {2, 2},  {2, 1},  {2, 0},  {2, -1},
                              {2, -2},  {1, -2},  {0, -2}, {-1, -2}};

bool Has(const LayoutMask& cells, int row, int col) {
  return row >= 0 && row < kLayoutSize && col >= 0 && col < kLayoutSize &&
         cells.Contains({row, col});
}

// How often one set follows the other on a walk around the cell, the last cell before the first.
int Changes(const LayoutMask& a, const LayoutMask& b, CellIndex cell) {
  int changes = 0, first = 0, last = 0;
  for (const auto& [dr, dc] : kRing) {
    const int row = cell.row + dr, col = cell.col + dc;
    const int here = Has(a, row, col) ? 1 : Has(b, row, col) ? 2 : 0;
    if (here == 0) continue;
    if (first == 0) first = here;
    changes += last != 0 && here != last;
    last = here;
  }
  return changes + (first != last);
}

// How many arms of a set leave the cell: runs of it on the ring.
int Arms(const LayoutMask& cells, CellIndex cell) {
  int arms = 0;
  bool before = Has(cells, cell.row + kRing[15][0], cell.col + kRing[15][1]);
  for (const auto& [dr, dc] : kRing) {
    const bool here = Has(cells, cell.row + dr, cell.col + dc);
    arms += here && !before;
    before = here;
  }
  return arms;
}

double ShareOf(const LayoutMask& part, const LayoutMask& whole) {
  const int total = whole.count();
  return total == 0 ? 0.0 : static_cast<double>((part & whole).count()) / total;
}

// The share of the rows or of the columns of a band, whichever it has more of, that hold a cell.
double LengthShare(const LayoutMask& cells, const LayoutMask& band) {
  int rows = 0, rows_held = 0;
  std::uint32_t columns = 0, columns_held = 0;
  for (int row = 0; row < kLayoutSize; ++row) {
    rows += band.row(row) != 0;
    rows_held += (band.row(row) & cells.row(row)) != 0;
    columns |= band.row(row);
    columns_held |= band.row(row) & cells.row(row);
  }
  const int width = __builtin_popcount(columns);
  if (rows == 0) return 0.0;
  return rows >= width ? static_cast<double>(rows_held) / rows
                       : static_cast<double>(__builtin_popcount(columns_held)) / width;
}

}  // namespace

ClaimMeasure ReadCourse(const Claim& claim, const LayoutMasks& layout) {
  const LayoutMask subject = SubjectOf(claim, layout);
  if (subject.empty()) return Missing(claim.subject);
  const LayoutMask from = MaskOf(claim.from), to = MaskOf(claim.to);
  double best = 2.0 * kNoGap;
  for (const JoinedPiece& piece : JoinedPiecesOf(subject, claim.subject, layout)) {
    best = std::min<double>(best, GapBetween(piece.cells, from) + GapBetween(piece.cells, to));
    if (best == 0.0) break;
  }
  return {DistanceFor(best / (2.0 * kNoGap)), best};
}

ClaimMeasure ReadAlong(const Claim& claim, const LayoutMasks& layout) {
  constexpr int kSteps = 3;
  ClaimMeasure reading;
  if (claim.object == '\0') {
    const LayoutMask subject = WithoutStrays(layout.of(claim.subject));
    if (subject.empty()) return Missing(claim.subject);
    const LayoutMask band = MaskOf(claim.zone);
    reading.value = LengthShare(subject, band);
    for (const LayoutMask& piece : subject.Pieces()) {
      if (4 * piece.count() < subject.count()) break;
      reading.value = std::max(reading.value, ShareOf(band, piece));
    }
    reading.value = std::max(reading.value, ShareOf(band, subject));
  } else {
    const LayoutMask subject = WithoutStrays(SubjectOf(claim, layout));
    const LayoutMask object = ObjectOf(claim, layout);
    if (subject.empty()) return Missing(claim.subject);
    if (object.empty()) return Missing(claim.object);
    const LayoutMask near = object.Grown8(kSteps);
    reading.value = ShareOf(near, subject);
    for (const LayoutMask& piece : subject.Pieces()) {
      if (4 * piece.count() < subject.count()) break;
      reading.value = std::max(reading.value, ShareOf(near, piece));
    }
  }
  reading.distance = DistanceFor(Shortfall(reading.value, LeastOf(claim)));
  return reading;
}

ClaimMeasure ReadCrosses(const Claim& claim, const LayoutMasks& layout) {
  const LayoutMask subject = SubjectOf(claim, layout), object = ObjectOf(claim, layout);
  if (subject.empty()) return Missing(claim.subject);
  if (object.empty()) return Missing(claim.object);
  constexpr int kAsked = 4;
  int most = 0;
  if (claim.subject == claim.object) {
    // Two lines of one class: four arms leave a cell.
    const LayoutMask lines = subject | object;
    ForEachCell(lines, [&](CellIndex cell) { most = std::max(most, Arms(lines, cell)); });
    const double lack = Shortfall(std::max(most - 2, 0), kAsked - 2);
    return {DistanceFor(lack), static_cast<double>(most)};
  }
  const LayoutMask meeting = (subject & object.Grown8()) | (object & subject.Grown8());
  ForEachCell(meeting, [&](CellIndex cell) {
    if (most < kAsked) most = std::max(most, Changes(subject, object, cell));
  });
  if (most >= kAsked) return {0.0, static_cast<double>(most)};
  // Lines that touch are half way.
  const double far = Excess(GapBetween(subject, object), 1.0, kNoGap);
  return {DistanceFor(0.5 + 0.5 * far), static_cast<double>(most)};
}

ClaimMeasure ReadParallel(const Claim& claim, const LayoutMasks& layout) {
  const LayoutMask subjects = SubjectOf(claim, layout), objects = ObjectOf(claim, layout);
  if (subjects.empty()) return Missing(claim.subject);
  if (objects.empty()) return Missing(claim.object);
  const std::vector<JoinedPiece> subject_pieces = JoinedPiecesOf(subjects, claim.subject, layout);
  const std::vector<JoinedPiece> object_pieces = JoinedPiecesOf(objects, claim.object, layout);
  const JoinedPiece& first = subject_pieces.front();
  const LayoutMask& subject = first.cells;
  // If both are of one class, the object is another piece of it.
  const auto other =
      std::find_if(object_pieces.begin(), object_pieces.end(),
                   [&](const JoinedPiece& piece) { return (piece.cells & subject).empty(); });
  if (other == object_pieces.end()) return Missing(claim.object);
  const LayoutMask& object = other->cells;
  const PrincipalAxes a = PrincipalAxesOf(subject), b = PrincipalAxesOf(object);

  // The axes differ by at most 30 degrees.
  constexpr double kLeastCosine = 0.866;
  const double cosine = std::abs(a.axis.row * b.axis.row + a.axis.col * b.axis.col);
  // Half of the shorter runs beside the longer, measured along the longer's axis.
  const PrincipalAxes& axis = a.length >= b.length ? a : b;
  const auto along = [&](const PrincipalAxes& line) {
    return (line.center.row - axis.center.row) * axis.axis.row +
           (line.center.col - axis.center.col) * axis.axis.col;
  };
  const double from = std::max(along(a) - 0.5 * a.length, along(b) - 0.5 * b.length);
  const double to = std::min(along(a) + 0.5 * a.length, along(b) + 0.5 * b.length);
  const double overlap = std::max(to - from, 0.0) / std::min(a.length, b.length);
  // They touch in at most a tenth of their cells, and are no more than half the map apart.
  const double touching = ShareOf(object.Grown8(), subject);
  const double gap = GapBetween(subject, object);
  // Both are lines.
  const double slimness = std::min(SlimnessOf(a, LineFrameOf(first.connected)),
                                   SlimnessOf(b, LineFrameOf(other->connected)));

  const double lack = 0.3 * Shortfall(cosine, kLeastCosine) + 0.2 * Shortfall(overlap, 0.5) +
                      0.3 * Excess(touching, 0.1, 1.0) + 0.1 * Excess(gap, 16.0, kNoGap) +
                      0.1 * Shortfall(slimness, 2.0);
  return {DistanceFor(lack), std::acos(std::min(cosine, 1.0)) * kDegrees, overlap};
}

ClaimMeasure ReadConnects(const Claim& claim, const LayoutMasks& layout) {
  constexpr int kSteps = 2;
  const LayoutMask subject = SubjectOf(claim, layout);
  const LayoutMask object = WithoutStrays(ObjectOf(claim, layout));
  const LayoutMask second = WithoutStrays(layout.of(claim.second_object));
  if (subject.empty()) return Missing(claim.subject);
  if (object.empty()) return Missing(claim.object);
  if (second.empty()) return Missing(claim.second_object);
  std::vector<LayoutMask> ends = {object, second};
  if (claim.object == claim.second_object) {
    ends = object.Pieces();
    if (ends.size() < 2) return Missing(claim.object);
  }
  const auto beyond = [](int gap) { return std::max(gap - kSteps, 0); };
  int best = 2 * kNoGap;
  for (const JoinedPiece& piece : JoinedPiecesOf(subject, claim.subject, layout)) {
    // The two ends that are nearest.
    int first = kNoGap, next = kNoGap;
    for (const LayoutMask& end : ends) {
      const int gap = beyond(GapBetween(piece.cells, end));
      next = std::min(next, std::max(first, gap));
      first = std::min(first, gap);
    }
    best = std::min(best, first + next);
  }
  return {DistanceFor(best / (2.0 * kNoGap)), static_cast<double>(best)};
}

}  // namespace latticeworld::internal
