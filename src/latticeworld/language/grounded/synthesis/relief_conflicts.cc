#include "latticeworld/language/grounded/synthesis/relief_conflicts.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/language/grounded/synthesis/canvas.h"

namespace latticeworld {
namespace {

// Shares of the relief's height, as its summary has them.
constexpr double kLow = 0.3;
constexpr double kHigh = 0.7;

// The part of the zone that suits the class best: a quarter of its cells may be the high (low)
// ones that it is meant for. The zone must not be empty.
double BestQuarterOf(const LayoutMask& zone, bool wants_height, const Relief& relief) {
  std::vector<double> heights;
  for (int id = 0; id < kCellCount; ++id) {
    if (zone.Contains(CellOf(id))) heights.push_back(relief.summary[CellOf(id)]);
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
    const bool places = claim.kind == ClaimKind::kPresent || claim.kind == ClaimKind::kDominant ||
                        claim.kind == ClaimKind::kLocated ||
                        (claim.kind == ClaimKind::kAmount && claim.least != Claim::kUnsaid);
    if (!places || claim.zone.is_anywhere()) continue;
    const bool wants_height =
        vocabulary == Vocabulary::kWild && (claim.subject == 'S' || claim.subject == 'R');
    if (!wants_height && claim.subject != 'W') continue;
    const LayoutMask zone = MaskOf(claim.zone);
    if (zone.empty()) continue;
    const double height = BestQuarterOf(zone, wants_height, relief);
    if (wants_height ? height >= kLow : height <= kHigh) continue;
    std::string warning = "against the relief: " + Quote(claim.words) + ": the " + claim.zone.name +
                          " lies " + (wants_height ? "low, not above " : "high, not below ") +
                          std::to_string(std::lround(100.0 * height)) +
                          " percent of the relief's height for the most part";
    // Several claims may come from the same words.
    if (warnings.empty() || warnings.back() != warning) warnings.push_back(std::move(warning));
  }
  return warnings;
}

}  // namespace latticeworld
