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

double Distance(WorldPoint a, WorldPoint b) { return std::hypot(a.x_m - b.x_m, a.y_m - b.y_m); }

// A line up to where it comes back to itself so near that who is on it would leave it out.
std::vector<WorldPoint> WithoutMeeting(const std::vector<WorldPoint>& line, double width_m) {
  constexpr double kNear = 1.6;   // widths between two parts of it
  constexpr double kApart = 5.0;  // widths along it, from where on they are two
  constexpr double kStep_m = 1.0;
  std::vector<WorldPoint> kept;
  std::vector<double> along_m;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const double length_m = Distance(line[i], line[i + 1]);
    const int steps = std::max(1, static_cast<int>(std::ceil(length_m / kStep_m)));
    for (int k = i == 0 ? 0 : 1; k <= steps; ++k) {
      const double t = static_cast<double>(k) / steps;
      const WorldPoint at = {line[i].x_m + t * (line[i + 1].x_m - line[i].x_m),
                             line[i].y_m + t * (line[i + 1].y_m - line[i].y_m)};
      const double here_m = kept.empty() ? 0.0 : along_m.back() + Distance(kept.back(), at);
      for (std::size_t j = 0; j < kept.size(); ++j) {
        if (here_m - along_m[j] < kApart * width_m) break;
        if (Distance(kept[j], at) < kNear * width_m) return kept;
      }
      kept.push_back(at);
      along_m.push_back(here_m);
    }
  }
  return kept;
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
    if (way.slope && !way.street.line.empty()) {
      way.street.line = WithoutMeeting(way.street.line, way.street.width_m);
    }
    if (way.street.line.size() >= 2) ways.push_back(std::move(way));
  }
  return ways;
}

}  // namespace latticeworld::internal
