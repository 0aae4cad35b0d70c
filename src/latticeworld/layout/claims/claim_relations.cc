#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "latticeworld/layout/claims/claim_measures.h"
#include "latticeworld/layout/claims/mask_measures.h"

// Claims about how two or three classes lie to each other.
namespace latticeworld::internal {
namespace {

// Pieces that a claim may be about on their own: "a village" north of the lake may be one of
// several. The set as a whole comes first, then its pieces of at least a quarter of the largest.
std::vector<LayoutMask> Readings(const LayoutMask& cells) {
  constexpr std::size_t kMost = 4;
  const LayoutMask clean = WithoutStrays(cells);
  std::vector<LayoutMask> pieces = clean.Pieces();
  std::vector<LayoutMask> readings = {clean};
  if (pieces.size() < 2) return readings;
  for (std::size_t i = 0; i < std::min(pieces.size(), kMost); ++i) {
    if (4 * pieces[i].count() >= pieces.front().count()) readings.push_back(pieces[i]);
  }
  return readings;
}

// How many sides of the layout a set reaches, and with how many cells.
struct EdgeContact {
  int edges = 0;
  int cells = 0;
};

EdgeContact EdgesOf(const LayoutMask& cells) {
  std::uint32_t columns = 0;
  EdgeContact contact;
  for (int row = 0; row < kLayoutSize; ++row) {
    columns |= cells.row(row);
    contact.cells += static_cast<int>(cells.row(row) & 1u) +
                     static_cast<int>(cells.row(row) >> (kLayoutSize - 1));
  }
  const std::uint32_t north = cells.row(0), south = cells.row(kLayoutSize - 1);
  contact.cells += __builtin_popcount(north) + __builtin_popcount(south);
  contact.edges = (north != 0) + (south != 0) + static_cast<int>(columns & 1u) +
                  static_cast<int>(columns >> (kLayoutSize - 1));
  return contact;
}

// Share of the cells around `inside` that are `outside`: of the first, second or third ring of
// cells around it the best, because a shore or a fence may lie between. Edges of the layout are no
// border, but for a set that reaches three of them: a half of the land is not in the other half.
double BorderShare(const LayoutMask& inside, const LayoutMask& outside) {
  constexpr int kRings = 3;
  double best = 0.0;
  LayoutMask grown = WithHolesFilled(inside);
  const EdgeContact contact = EdgesOf(grown);
  const int open = contact.edges >= 3 ? contact.cells : 0;
  for (int ring = 0; ring < kRings; ++ring) {
    const LayoutMask wider = ring == 0 ? grown.Grown4() : grown.Grown8();
    const LayoutMask border = wider - grown;
    const int total = border.count();
    if (total > 0) {
      best = std::max(best, static_cast<double>((border & outside).count()) / (total + open));
    }
    grown = wider;
  }
  return best;
}

// The whole, or the piece that is best surrounded: "a clearing in the forest" may be one of many.
double BestBorderShare(const LayoutMask& inside, const LayoutMask& outside) {
  constexpr std::size_t kMostPieces = 16;
  const LayoutMask clean = WithoutStrays(inside);
  const std::vector<LayoutMask> pieces = clean.Pieces();
  double best = BorderShare(clean, outside);
  for (std::size_t i = 0; i < std::min(pieces.size(), kMostPieces) && best < 1.0; ++i) {
    best = std::max(best, BorderShare(pieces[i], outside));
  }
  return best;
}

// How far `to` is from lying toward `heading` from `from`: by at least one cell, and at least
// `slope` times as far as to the side.
double DirectionLack(LayoutMask::Point from, LayoutMask::Point to, Claim::Heading heading,
                     double* along) {
  const double norm = std::hypot(heading.east, heading.south);
  if (norm == 0.0) return 1.0;
  const double east = to.col - from.col, south = to.row - from.row;
  *along = (east * heading.east + south * heading.south) / norm;
  const double aside = std::abs(east * heading.south - south * heading.east) / norm;
  // The way may be up to 63 degrees off a cardinal heading, 40 off another.
  const double slope = heading.east == 0 || heading.south == 0 ? 0.5 : 1.2;
  const double lack = std::max(1.0, slope * aside) - *along;
  return std::clamp(lack / kLayoutSize, 0.0, 1.0);
}

// The first and last row, or column, of a set.
struct Extent {
  int first = kLayoutSize;
  int last = -1;
  int width() const { return last - first + 1; }
};

Extent RowsOf(const LayoutMask& cells) {
  Extent extent;
  for (int row = 0; row < kLayoutSize; ++row) {
    if (cells.row(row) == 0) continue;
    extent.first = std::min(extent.first, row);
    extent.last = row;
  }
  return extent;
}

Extent ColumnsOf(const LayoutMask& cells) {
  std::uint32_t columns = 0;
  for (int row = 0; row < kLayoutSize; ++row) columns |= cells.row(row);
  if (columns == 0) return {};
  return {__builtin_ctz(columns), kLayoutSize - 1 - __builtin_clz(columns)};
}

// What of a thing lies before or behind the other as one goes along a cardinal heading, where it
// is more than twice as wide across it: north of a river is north of its nearest reach, wherever
// the river goes. Else all of it.
LayoutMask PartBeside(const LayoutMask& wide, const LayoutMask& other, Claim::Heading heading) {
  if (heading.east != 0 && heading.south != 0) return wide;
  const bool by_rows = heading.east != 0;
  const Extent across = by_rows ? RowsOf(wide) : ColumnsOf(wide);
  const Extent kept = by_rows ? RowsOf(other) : ColumnsOf(other);
  if (across.width() <= 2 * kept.width()) return wide;
  LayoutMask part;
  for (int row = 0; row < kLayoutSize; ++row) {
    if (!by_rows) {
      part.set_row(row, wide.row(row) & (~0u >> (kLayoutSize - kept.width())) << kept.first);
    } else if (row >= kept.first && row <= kept.last) {
      part.set_row(row, wide.row(row));
    }
  }
  return part.empty() ? wide : part;
}

// How far `point` is from lying between `a` and `b`.
double BetweenLack(LayoutMask::Point point, LayoutMask::Point a, LayoutMask::Point b) {
  const double rows = b.row - a.row, cols = b.col - a.col;
  const double length = std::hypot(rows, cols);
  if (length < 1.0) return 1.0;
  const double along =
      ((point.row - a.row) * rows + (point.col - a.col) * cols) / (length * length);
  const double aside = std::abs((point.row - a.row) * cols - (point.col - a.col) * rows) / length;
  constexpr double kEnd = 0.15;       // of the way: nearer is at an end, not between
  constexpr double kNarrowest = 5.0;  // cells to either side, of things that are close together
  const double early = std::max({kEnd - along, along - (1.0 - kEnd), 0.0}) * length;
  const double off = std::max(aside - std::max(kNarrowest, 0.5 * length), 0.0);
  return std::min((early + off) / kLayoutSize, 1.0);
}

}  // namespace

ClaimMeasure ReadGap(const Claim& claim, const LayoutMasks& layout) {
  LayoutMask subject = WithoutStrays(SubjectOf(claim, layout));
  LayoutMask object = WithoutStrays(ObjectOf(claim, layout));
  if (subject.empty()) return Missing(claim.subject);
  if (object.empty()) return Missing(claim.object);
  ClaimMeasure reading;
  int gap = kNoGap;
  if (claim.subject == claim.object && !(subject & object).empty()) {
    // Two pieces of one class: the closest two.
    const std::vector<LayoutMask> pieces = (subject | object).Pieces();
    if (pieces.size() < 2) return Missing(claim.subject);
    for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
      LayoutMask others;
      for (std::size_t k = i + 1; k < pieces.size(); ++k) others = others | pieces[k];
      gap = std::min(gap, GapBetween(pieces[i], others));
    }
  } else {
    gap = GapBetween(subject, object);
  }
  reading.value = gap;
  reading.distance =
      DistanceFor(claim.kind == ClaimKind::kAdjacent ? Excess(gap, MostOf(claim), kNoGap)
                                                     : Shortfall(gap, LeastOf(claim)));
  return reading;
}

ClaimMeasure ReadSurrounds(const Claim& claim, const LayoutMasks& layout) {
  const LayoutMask subject = SubjectOf(claim, layout), object = ObjectOf(claim, layout);
  if (subject.empty()) return Missing(claim.subject);
  if (object.empty()) return Missing(claim.object);
  const double share = BestBorderShare(object, subject);
  return {DistanceFor(Shortfall(share, LeastOf(claim))), share};
}

ClaimMeasure ReadWithin(const Claim& claim, const LayoutMasks& layout) {
  const LayoutMask subject = SubjectOf(claim, layout), object = ObjectOf(claim, layout);
  if (subject.empty()) return Missing(claim.subject);
  if (object.empty()) return Missing(claim.object);
  const double share = BestBorderShare(subject, object);
  return {DistanceFor(Shortfall(share, LeastOf(claim))), share};
}

ClaimMeasure ReadBetween(const Claim& claim, const LayoutMasks& layout) {
  const LayoutMask subject = SubjectOf(claim, layout), object = ObjectOf(claim, layout);
  const LayoutMask& second = layout.of(claim.second_object);
  if (subject.empty()) return Missing(claim.subject);
  if (object.empty()) return Missing(claim.object);
  if (second.empty()) return Missing(claim.second_object);
  const auto centers = [](const LayoutMask& cells, bool pieces_alone) {
    std::vector<LayoutMask::Point> points;
    const std::vector<LayoutMask> readings = Readings(cells);
    for (std::size_t i = pieces_alone ? 1 : 0; i < readings.size(); ++i) {
      points.push_back(readings[i].Centroid());
    }
    return points;
  };
  const bool same = claim.object == claim.second_object;
  const std::vector<LayoutMask::Point> subjects = centers(subject, false);
  const std::vector<LayoutMask::Point> firsts = centers(object, same);
  const std::vector<LayoutMask::Point> seconds = same ? firsts : centers(second, false);
  double best = 1.0;
  for (std::size_t a = 0; a < firsts.size(); ++a) {
    for (std::size_t b = same ? a + 1 : 0; b < seconds.size(); ++b) {
      for (const LayoutMask::Point point : subjects) {
        best = std::min(best, BetweenLack(point, firsts[a], seconds[b]));
      }
    }
  }
  return {DistanceFor(best), best * kLayoutSize};
}

ClaimMeasure ReadDirection(const Claim& claim, const LayoutMasks& layout) {
  const LayoutMask subject = SubjectOf(claim, layout), object = ObjectOf(claim, layout);
  if (subject.empty()) return Missing(claim.subject);
  if (object.empty()) return Missing(claim.object);
  const std::vector<LayoutMask> objects = Readings(object);
  ClaimMeasure best;
  best.distance = 2.0;
  for (const LayoutMask& a : Readings(subject)) {
    for (const LayoutMask& b : objects) {
      const LayoutMask::Point to = PartBeside(a, b, claim.heading).Centroid();
      const LayoutMask::Point from = PartBeside(b, a, claim.heading).Centroid();
      ClaimMeasure reading;
      reading.distance = DistanceFor(DirectionLack(from, to, claim.heading, &reading.value));
      if (reading.distance < best.distance) best = reading;
    }
  }
  return best;
}

ClaimMeasure ReadOrder(const Claim& claim, const LayoutMasks& layout) {
  const LayoutMask zone = MaskOf(claim.zone);
  const double norm = std::max(std::hypot(claim.heading.east, claim.heading.south), 1.0);
  ClaimMeasure reading;
  double lack = 0.0, before = 0.0;
  for (std::size_t i = 0; i < claim.sequence.size(); ++i) {
    const LayoutMask cells = WithoutStrays(layout.of(claim.sequence[i]) & zone);
    if (cells.empty()) return Missing(claim.sequence[i]);
    const LayoutMask::Point center = cells.Centroid();
    const double along =
        (center.col * claim.heading.east + center.row * claim.heading.south) / norm;
    // A cell at least from each to the next.
    if (i > 0) {
      const double short_by = std::clamp((1.0 - (along - before)) / kLayoutSize, 0.0, 1.0);
      lack += short_by;
      reading.value += short_by > 0.0;
    }
    before = along;
  }
  const double steps = std::max<double>(static_cast<double>(claim.sequence.size()) - 1.0, 1.0);
  reading.distance = DistanceFor(lack / steps);
  return reading;
}

}  // namespace latticeworld::internal
