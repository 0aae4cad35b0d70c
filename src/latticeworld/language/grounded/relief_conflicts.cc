#include "latticeworld/language/grounded/relief_conflicts.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/common/text.h"
#include "latticeworld/language/grounded/canvas.h"

namespace latticeworld {
namespace {

// Shares of the relief's height, as its summary has them.
constexpr double kLow = 0.3;
constexpr double kHigh = 0.7;

// The part of the region that suits the class best: a quarter of its cells may be the high (low)
// ones that it is meant for.
double BestQuarterOf(Region region, bool wants_height, const Relief& relief) {
  std::vector<double> heights;
  const UnitBox box = BoxOf(region);
  for (int row = 0; row < kLayoutSize; ++row) {
    for (int col = 0; col < kLayoutSize; ++col) {
      if (IsIn(box, {row, col})) heights.push_back(relief.summary(row, col));
    }
  }
  const std::size_t rank = wants_height ? heights.size() * 3 / 4 : heights.size() / 4;
  std::nth_element(heights.begin(), heights.begin() + static_cast<std::ptrdiff_t>(rank),
                   heights.end());
  return heights[rank];
}

}  // namespace

std::vector<std::string> ReliefConflicts(const std::vector<Claim>& claims, Vocabulary vocabulary,
                                         const Relief& relief) {
  std::vector<std::string> warnings;
  for (const Claim& claim : claims) {
    if (claim.kind != ClaimKind::kPresent && claim.kind != ClaimKind::kMostly) continue;
    const bool wants_height =
        vocabulary == Vocabulary::kWild && (claim.subject == 'S' || claim.subject == 'R');
    if (!wants_height && claim.subject != 'W') continue;
    for (const Region region : claim.regions) {
      const double height = BestQuarterOf(region, wants_height, relief);
      if (wants_height ? height >= kLow : height <= kHigh) continue;
      warnings.push_back("against the relief: " + Quote(claim.words) + ": the " +
                         std::string(NameOf(region)) + " lies " +
                         (wants_height ? "low, not above " : "high, not below ") +
                         std::to_string(std::lround(100.0 * height)) +
                         " percent of the relief's height for the most part");
      break;
    }
  }
  return warnings;
}

}  // namespace latticeworld
