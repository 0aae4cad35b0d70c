#include "latticeworld/terrain/ways/climbing_ways.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace latticeworld::internal {
namespace {

constexpr double kWidth_m = 4.0;
constexpr double kLeastWidth_m = 1.5;
constexpr double kOfSaid = 0.8;  // of a said slope: above which ground is dear

const ReliefTie* ClimbOf(const ReliefWish& wish) {
  const auto climb = std::find_if(wish.ties.begin(), wish.ties.end(), [](const ReliefTie& tie) {
    return tie.kind == ReliefTie::Kind::kClimbed;
  });
  return climb == wish.ties.end() ? nullptr : &*climb;
}

}  // namespace

std::vector<ClimbingWay> ClimbingWays(const std::vector<ReliefWish>& wishes,
                                      const std::vector<ReliefPiece>& pieces,
                                      const WayFinder& finder, double max_slope) {
  std::vector<ClimbingWay> ways;
  for (const ReliefPiece& piece : pieces) {
    const ReliefWish& wish = wishes[static_cast<std::size_t>(piece.wish)];
    const bool pass = wish.kind == ReliefKind::kSaddle;
    const ReliefTie* climb = ClimbOf(wish);
    if (climb == nullptr || (pass && piece.kind != ReliefKind::kRidge)) continue;
    if (!finder.HasRoad() && !climb->slope_deg) continue;
    const CellIndex top = pass ? finder.PassOf(piece) : finder.TopOf(piece);
    if (top.row < 0) continue;
    ClimbingWay way;
    if (climb->slope_deg) way.slope = std::tan(*climb->slope_deg * M_PI / 180.0);
    WayFinder::Rule rule;
    rule.max_slope = way.slope ? kOfSaid * *way.slope : max_slope;
    rule.wide_bends = way.slope.has_value();
    const auto from = finder.HasRoad() ? WayFinder::From::kRoad : WayFinder::From::kEdge;
    way.street.line = finder.LineTo(top, from, rule);
    // Legs of bends lie a step apart.
    way.street.width_m =
        way.slope ? std::clamp(0.5 * finder.step_m(), kLeastWidth_m, kWidth_m) : kWidth_m;
    if (way.street.line.size() >= 2) ways.push_back(std::move(way));
  }
  return ways;
}

}  // namespace latticeworld::internal
