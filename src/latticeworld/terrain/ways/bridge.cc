#include "latticeworld/terrain/ways/bridge.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace latticeworld {
namespace {

constexpr double kFoundation_m = 0.5;   // of a pier below the bed
constexpr double kRailedLand_m = 1.0;   // beyond the water
constexpr int kArchSlices = 16;         // of an opening
constexpr double kArchSpringing = 0.1;  // of the clearance, above the water
constexpr double kPosts_m = 2.0;        // between posts of timber railings, at most
// The beams of timber railings, from bottom to top as shares of their height. The lowest is a kerb
// that no wheel gets below.
constexpr std::array<std::array<double, 2>, 3> kBeams = {{{0.0, 0.2}, {0.45, 0.6}, {0.85, 1.0}}};

double Distance(WorldPoint a, WorldPoint b) { return std::hypot(b.x_m - a.x_m, b.y_m - a.y_m); }

double Heading(WorldPoint a, WorldPoint b) { return std::atan2(b.y_m - a.y_m, b.x_m - a.x_m); }

// The turn from one heading to another [rad], in (-pi, pi].
double Turn(double from_rad, double to_rad) {
  return std::remainder(to_rad - from_rad, 2.0 * M_PI);
}

class PartsBuilder {
 public:
  PartsBuilder(const Bridge& bridge, const HeightField& ground)
      : bridge_(bridge), ground_(ground) {}

  std::vector<BridgePart> Build() {
    AddDecksAndRailings();
    if (bridge_.kind == BridgeKind::kStoneArch) AddArches();
    AddPiers();
    return std::move(parts_);
  }

 private:
  // A straight piece of the line, longer or shorter at its ends, sideways off it, cut into parts.
  void AddAlong(BridgePartKind kind, std::size_t piece, double begin_m, double end_m, double off_m,
                double half_width_m, double bottom_m, double top_m) {
    const WorldPoint from = bridge_.line[piece];
    const double yaw_rad = Heading(from, bridge_.line[piece + 1]);
    const double cosine = std::cos(yaw_rad), sine = std::sin(yaw_rad);
    const double length_m = end_m - begin_m;
    if (length_m <= 0.0) return;
    const int count = std::max(1, static_cast<int>(std::ceil(length_m / kLongestBridgePart_m)));
    for (int i = 0; i < count; ++i) {
      const double along_m = begin_m + (i + 0.5) * length_m / count;
      BridgePart part;
      part.kind = kind;
      part.middle = {from.x_m + cosine * along_m - sine * off_m,
                     from.y_m + sine * along_m + cosine * off_m};
      part.bottom_m = bottom_m;
      part.top_m = top_m;
      part.yaw_rad = yaw_rad;
      part.half_length_m = 0.5 * length_m / count;
      part.half_width_m = half_width_m;
      parts_.push_back(part);
    }
  }

  // Tangent of half the turn of the line at one of its places; above 0: to the left.
  double HalfTurn(std::size_t place) const {
    const std::vector<WorldPoint>& line = bridge_.line;
    if (place == 0 || place + 1 == line.size()) return 0.0;
    return std::tan(
        0.5 * Turn(Heading(line[place - 1], line[place]), Heading(line[place], line[place + 1])));
  }

  void AddDecksAndRailings() {
    const double half_m = 0.5 * bridge_.width_m;
    const double top_m = bridge_.deck_z_m;
    const double rail_half_m = std::min(0.15, 0.03 * bridge_.width_m);
    // Railings stand beside the water alone: streets join the road right behind it.
    const double rail_begin_m = bridge_.supports_m.front() - kRailedLand_m;
    const double rail_end_m = bridge_.supports_m.back() + kRailedLand_m;
    double passed_m = 0.0;
    for (std::size_t i = 0; i + 1 < bridge_.line.size(); ++i) {
      const double length_m = Distance(bridge_.line[i], bridge_.line[i + 1]);
      const double begin_m = rail_begin_m - passed_m, end_m = rail_end_m - passed_m;
      passed_m += length_m;
      const double before = HalfTurn(i), after = HalfTurn(i + 1);
      // On the outer side of a bend decks reach so far that no gap is left.
      AddAlong(BridgePartKind::kDeck, i, -half_m * std::abs(before),
               length_m + half_m * std::abs(after), 0.0, half_m, top_m - bridge_.thickness_m,
               top_m);
      if (bridge_.railing_m <= 0.0) continue;
      for (const double side : {-1.0, 1.0}) {
        // Railings meet on the line that halves the bend.
        const double off_m = side * (half_m - rail_half_m);
        AddRailing(i, std::max(begin_m, off_m * before), std::min(end_m, length_m - off_m * after),
                   off_m, rail_half_m);
      }
    }
  }

  // A parapet, or of timber posts and beams.
  void AddRailing(std::size_t piece, double begin_m, double end_m, double off_m, double half_m) {
    const double bottom_m = bridge_.deck_z_m;
    if (bridge_.kind != BridgeKind::kPlank) {
      AddAlong(BridgePartKind::kRailing, piece, begin_m, end_m, off_m, half_m, bottom_m,
               bottom_m + bridge_.railing_m);
      return;
    }
    for (const auto& [low, high] : kBeams) {
      AddAlong(BridgePartKind::kRailing, piece, begin_m, end_m, off_m, half_m,
               bottom_m + low * bridge_.railing_m, bottom_m + high * bridge_.railing_m);
    }
    const double between_m = end_m - begin_m - 2.0 * half_m;
    if (between_m <= 0.0) return;
    const int spaces = std::max(1, static_cast<int>(std::ceil(between_m / kPosts_m)));
    for (int i = 0; i <= spaces; ++i) {
      const double post_m = begin_m + i * between_m / spaces;
      AddAlong(BridgePartKind::kRailing, piece, post_m, post_m + 2.0 * half_m, off_m, half_m,
               bottom_m, bottom_m + bridge_.railing_m);
    }
  }

  void AddUpright(BridgePartKind kind, double along_m, double half_length_m, double half_width_m,
                  double bottom_m) {
    const BridgePlace place = PlaceOn(bridge_, along_m);
    BridgePart part;
    part.kind = kind;
    part.middle = place.point;
    part.yaw_rad = place.yaw_rad;
    part.bottom_m = bottom_m;
    part.top_m = bridge_.deck_z_m - bridge_.thickness_m;
    part.half_length_m = half_length_m;
    part.half_width_m = half_width_m;
    if (part.top_m > part.bottom_m) parts_.push_back(part);
  }

  // Each opening is a half ellipse, in slices of equal angles: the steeper, the narrower.
  void AddArches() {
    const double crown_m = bridge_.deck_z_m - bridge_.thickness_m;
    const double foot_m = bridge_.water_level_m + kArchSpringing * bridge_.clearance_m();
    constexpr double kAngle_rad = M_PI / kArchSlices;
    for (std::size_t i = 0; i + 1 < bridge_.supports_m.size(); ++i) {
      const double half_m = 0.5 * (bridge_.supports_m[i + 1] - bridge_.supports_m[i]);
      const double middle_m = bridge_.supports_m[i] + half_m;
      for (int k = 0; k < kArchSlices; ++k) {
        const double begin_m = middle_m - half_m * std::cos(k * kAngle_rad);
        const double end_m = middle_m - half_m * std::cos((k + 1) * kAngle_rad);
        AddUpright(BridgePartKind::kArch, 0.5 * (begin_m + end_m), 0.5 * (end_m - begin_m),
                   0.5 * bridge_.width_m,
                   foot_m + (crown_m - foot_m) * std::sin((k + 0.5) * kAngle_rad));
      }
    }
  }

  void AddPiers() {
    const double share = bridge_.kind == BridgeKind::kStoneArch ? 0.5 : 0.42;
    for (std::size_t i = 1; i + 1 < bridge_.supports_m.size(); ++i) {
      const double opening_m = bridge_.supports_m[i + 1] - bridge_.supports_m[i];
      const double half_m = std::clamp(0.05 * opening_m, 0.1, 0.75);
      const WorldPoint point = PlaceOn(bridge_, bridge_.supports_m[i]).point;
      AddUpright(BridgePartKind::kPier, bridge_.supports_m[i], half_m, share * bridge_.width_m,
                 ground_.HeightAt(point) - kFoundation_m);
    }
  }

  const Bridge& bridge_;
  const HeightField& ground_;
  std::vector<BridgePart> parts_;
};

}  // namespace

double Bridge::length_m() const {
  double length_m = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) length_m += Distance(line[i - 1], line[i]);
  return length_m;
}

BridgePlace PlaceOn(const Bridge& bridge, double along_m) {
  along_m = std::max(along_m, 0.0);
  const std::vector<WorldPoint>& line = bridge.line;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const double length_m = Distance(line[i], line[i + 1]);
    if (along_m <= length_m || i + 2 == line.size()) {
      const double t = std::min(along_m / length_m, 1.0);
      return {{line[i].x_m + t * (line[i + 1].x_m - line[i].x_m),
               line[i].y_m + t * (line[i + 1].y_m - line[i].y_m)},
              Heading(line[i], line[i + 1])};
    }
    along_m -= length_m;
  }
  return {};
}

std::vector<BridgePart> PartsOf(const Bridge& bridge, const HeightField& ground) {
  return PartsBuilder(bridge, ground).Build();
}

}  // namespace latticeworld
