#include "latticeworld/layout/claims.h"

#include <algorithm>
#include <cstdio>
#include <set>

#include "latticeworld/layout/measures.h"

namespace latticeworld {
namespace {

// A class "occurs" in a region from about two of a ninth's hundred cells on: one stray cell of a
// border is not meant by "a pond in the upper left".
constexpr double kPresentShare = 0.015;
// "A little": at most a quarter of the region.
constexpr double kLittleShare = 0.25;
// "Clustered": at most three pieces hold nine tenths of the class.
constexpr int kClusteredPieces = 3;
constexpr double kClusteredShare = 0.9;
// "Scattered": at least five pieces, none above half of the class.
constexpr int kScatteredPieces = 5;
constexpr double kScatteredLargest = 0.5;
// "Surrounded": at least six tenths of the border.
constexpr double kSurroundedShare = 0.6;

std::string Name(Vocabulary vocabulary, char letter) {
  const LayoutClass* entry = FindClass(vocabulary, letter);
  return entry != nullptr ? std::string(entry->name) : std::string(1, letter);
}

std::string Percent(double share) {
  char text[16];
  std::snprintf(text, sizeof(text), "%.1f %%", 100.0 * share);
  return text;
}

// 0 when value reaches the limit, growing linearly to 1.
double Shortfall(double value, double limit) {
  return limit <= 0.0 ? 0.0 : std::clamp((limit - value) / limit, 0.0, 1.0);
}

ClaimMeasure Make(double distance, std::string explanation) {
  return {distance <= 0.0, distance, std::move(explanation)};
}

ClaimMeasure MeasureIn(const Claim& claim, const SymbolicLayout& layout, Region region) {
  const double share = ShareIn(layout, claim.subject, region);
  const std::string what = Name(layout.vocabulary, claim.subject) + " covers " + Percent(share) +
                           " of " + std::string(NameOf(region));
  switch (claim.kind) {
    case ClaimKind::kPresent:
      return Make(Shortfall(share, kPresentShare),
                  what + "; at least " + Percent(kPresentShare) + " is asked");
    case ClaimKind::kAbsent:
      return Make(share, what + "; none is asked");
    case ClaimKind::kLittle:
      return Make(share > kLittleShare ? share - kLittleShare : Shortfall(share, 1e-9),
                  what + "; some, and at most " + Percent(kLittleShare) + " is asked");
    case ClaimKind::kMostly: {
      double largest_other = 0.0;
      for (const LayoutClass& entry : ClassesOf(layout.vocabulary)) {
        if (entry.letter == claim.subject) continue;
        largest_other = std::max(largest_other, ShareIn(layout, entry.letter, region));
      }
      const double missing = largest_other - share;
      return Make(missing >= 0.0 ? std::max(missing, 1e-6) : 0.0,
                  what + "; more than any other class (" + Percent(largest_other) + ") is asked");
    }
    case ClaimKind::kMoreThan: {
      const double other = ShareIn(layout, claim.object, region);
      const double missing = other - share;
      return Make(missing >= 0.0 ? std::max(missing, 1e-6) : 0.0,
                  what + "; more than " + Name(layout.vocabulary, claim.object) + " (" +
                      Percent(other) + ") is asked");
    }
    default:
      return Make(1.0, "not a claim about a region");
  }
}

ClaimMeasure MeasureCourse(const Claim& claim, const SymbolicLayout& layout) {
  double best = 1.0;
  for (const LayoutComponent& component : ComponentsOf(layout, claim.subject)) {
    std::set<Region> touched;
    const GridGeometry unit = GridGeometry::FromCells(kLayoutSize, 1.0);
    for (const CellIndex cell : component.cells)
      touched.insert(RegionAt(unit, unit.CenterOf(cell)));
    const auto reaches = [&](Region region) {
      return region == Region::kAnywhere || touched.count(region) > 0;
    };
    best = std::min(best, 0.5 * !reaches(claim.from) + 0.5 * !reaches(claim.to));
  }
  return Make(best, "a connected " + Name(layout.vocabulary, claim.subject) + " from " +
                        std::string(NameOf(claim.from)) + " to " + std::string(NameOf(claim.to)) +
                        (best == 0.0 ? " is there" : " is missing"));
}

ClaimMeasure MeasurePieces(const Claim& claim, const SymbolicLayout& layout) {
  const std::vector<LayoutComponent> components = ComponentsOf(layout, claim.subject);
  double total = 0.0, largest_few = 0.0;
  for (std::size_t i = 0; i < components.size(); ++i) {
    const double size = static_cast<double>(components[i].cells.size());
    total += size;
    if (i < kClusteredPieces) largest_few += size;
  }
  const std::string what = Name(layout.vocabulary, claim.subject) + " lies in " +
                           std::to_string(components.size()) + " pieces";
  if (components.empty()) return Make(1.0, what);
  if (claim.kind == ClaimKind::kClustered) {
    return Make(Shortfall(largest_few / total, kClusteredShare), what + "; few are asked");
  }
  const double pieces = Shortfall(static_cast<double>(components.size()), kScatteredPieces);
  const double largest = static_cast<double>(components.front().cells.size()) / total;
  return Make(std::max(pieces, largest > kScatteredLargest ? largest - kScatteredLargest : 0.0),
              what + "; many small ones are asked");
}

// Share of the border of `inside` (its 4-neighbours that are not of it) that is `outside`.
double BorderShare(const SymbolicLayout& layout, char inside, char outside) {
  int border = 0, matching = 0;
  for (int row = 0; row < kLayoutSize; ++row) {
    for (int col = 0; col < kLayoutSize; ++col) {
      if (layout.cells(row, col) != inside) continue;
      for (const CellIndex near : {CellIndex{row - 1, col}, CellIndex{row + 1, col},
                                   CellIndex{row, col - 1}, CellIndex{row, col + 1}}) {
        if (!layout.cells.Contains(near) || layout.cells[near] == inside) continue;
        ++border;
        matching += layout.cells[near] == outside;
      }
    }
  }
  return border == 0 ? 0.0 : static_cast<double>(matching) / border;
}

}  // namespace

ClaimMeasure Measure(const Claim& claim, const SymbolicLayout& layout) {
  switch (claim.kind) {
    case ClaimKind::kCourse:
      return MeasureCourse(claim, layout);
    case ClaimKind::kClustered:
    case ClaimKind::kScattered:
      return MeasurePieces(claim, layout);
    case ClaimKind::kAdjacent: {
      const double share = AdjacencyOf(layout, claim.subject, claim.object);
      return Make(share > 0.0 ? 0.0 : 1.0, Name(layout.vocabulary, claim.subject) + " touches " +
                                               Name(layout.vocabulary, claim.object) + " with " +
                                               Percent(share) + " of its cells");
    }
    case ClaimKind::kSurrounds: {
      const double share = BorderShare(layout, claim.object, claim.subject);
      return Make(Shortfall(share, kSurroundedShare),
                  Name(layout.vocabulary, claim.subject) + " makes up " + Percent(share) +
                      " of the border of " + Name(layout.vocabulary, claim.object) + "; at least " +
                      Percent(kSurroundedShare) + " is asked");
    }
    default:
      break;
  }
  if (claim.regions.empty()) return MeasureIn(claim, layout, Region::kAnywhere);
  ClaimMeasure worst;
  for (const Region region : claim.regions) {
    ClaimMeasure measure = MeasureIn(claim, layout, region);
    if (worst.explanation.empty() || measure.distance > worst.distance) worst = std::move(measure);
  }
  return worst;
}

}  // namespace latticeworld
