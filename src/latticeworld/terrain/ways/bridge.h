#ifndef LATTICEWORLD_TERRAIN_WAYS_BRIDGE_H_
#define LATTICEWORLD_TERRAIN_WAYS_BRIDGE_H_

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "latticeworld/common/enum_names.h"
#include "latticeworld/geometry/grid_geometry.h"
#include "latticeworld/geometry/height_field.h"

namespace latticeworld {

enum class BridgeKind : std::uint8_t {
  kPlank,      // timber on trestles, of narrow roads
  kStoneArch,  // arches of stone, in and near villages
  kGirder      // concrete beams on piers
};
constexpr std::array<EnumName<BridgeKind>, 3> EnumNames(BridgeKind) {
  return {{{BridgeKind::kPlank, "plank bridge"},
           {BridgeKind::kStoneArch, "stone bridge"},
           {BridgeKind::kGirder, "girder bridge"}}};
}

// A fixed way of a road over water that runs on below, or over a gorge. Its deck is level.
struct Bridge {
  BridgeKind kind = BridgeKind::kGirder;
  // The middle of the deck from one end on land to the other, at least two places.
  std::vector<WorldPoint> line;
  double width_m = 0.0;        // of the deck
  double deck_z_m = 0.0;       // of the top of the deck
  double thickness_m = 0.0;    // of the deck
  double water_level_m = 0.0;  // the highest below; the floor of a dry gorge
  double railing_m = 0.0;      // height of the railings above the deck; 0: none
  double load_kg = 0.0;        // greatest mass of a body that it carries
  // The places along the line, from its begin, at which it is held [m]: the faces of both
  // abutments, and the piers between them. Increasing, at least two.
  std::vector<double> supports_m;

  double length_m() const;
  double clearance_m() const { return deck_z_m - thickness_m - water_level_m; }
};

// A point of a bridge's line, and where the line heads there.
struct BridgePlace {
  WorldPoint point;
  double yaw_rad = 0.0;
};
// along_m: from its begin, clamped to its length.
BridgePlace PlaceOn(const Bridge& bridge, double along_m);

enum class BridgePartKind : std::uint8_t { kDeck, kRailing, kPier, kArch };

// An upright box: x along the bridge, z up.
struct BridgePart {
  BridgePartKind kind = BridgePartKind::kDeck;
  WorldPoint middle;
  double bottom_m = 0.0, top_m = 0.0;
  double yaw_rad = 0.0;
  double half_length_m = 0.0, half_width_m = 0.0;

  double middle_z_m() const { return 0.5 * (bottom_m + top_m); }
  Eigen::Vector3d size_m() const {
    return {2.0 * half_length_m, 2.0 * half_width_m, top_m - bottom_m};
  }
};

// No part is longer than this.
inline constexpr double kLongestBridgePart_m = 40.0;

// All that a bridge is for physics, rays, maps and pictures alike: decks, railings, piers down into
// the bed, arches as slices.
std::vector<BridgePart> PartsOf(const Bridge& bridge, const HeightField& ground);

}  // namespace latticeworld

#endif  // LATTICEWORLD_TERRAIN_WAYS_BRIDGE_H_
