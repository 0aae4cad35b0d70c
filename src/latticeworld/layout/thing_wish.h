#ifndef LATTICEWORLD_LAYOUT_THING_WISH_H_
#define LATTICEWORLD_LAYOUT_THING_WISH_H_

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "latticeworld/common/enum_names.h"
#include "latticeworld/geometry/grid_geometry.h"
#include "latticeworld/layout/zone.h"

namespace latticeworld {

// Single things that are asked for one by one or in an arrangement: "three trees in a row beside
// the village". Kinds are those of thing_kinds.h.

// No world holds more of them than this, and no wish asks for more.
inline constexpr int kMostThings = 500;
inline constexpr int kMostThingWishes = 500;

enum class ThingArrangement : std::uint8_t { kNone, kRow, kRing, kGrid, kPair, kCluster };
constexpr std::array<EnumName<ThingArrangement>, 6> EnumNames(ThingArrangement) {
  return {{{ThingArrangement::kNone, "none"},
           {ThingArrangement::kRow, "row"},
           {ThingArrangement::kRing, "ring"},
           {ThingArrangement::kGrid, "grid"},
           {ThingArrangement::kPair, "pair"},
           {ThingArrangement::kCluster, "cluster"}}};
}

// How things lie to their target.
enum class ThingRelation : std::uint8_t {
  kNone,
  kIn,       // of land: on it
  kNear,     // distance_m from it, to its edge; 0: near; on a side of it, where one is said
  kInFront,  // before its front
  kBehind,   // behind its back
  kAround,   // around it, alike far apart
  kAlong,    // beside it, alike far from it; faces it
  kBetween   // half way between it and a second one
};
constexpr std::array<EnumName<ThingRelation>, 8> EnumNames(ThingRelation) {
  return {{{ThingRelation::kNone, "none"},
           {ThingRelation::kIn, "in"},
           {ThingRelation::kNear, "near"},
           {ThingRelation::kInFront, "in front of"},
           {ThingRelation::kBehind, "behind"},
           {ThingRelation::kAround, "around"},
           {ThingRelation::kAlong, "along"},
           {ThingRelation::kBetween, "between"}}};
}

// On which side of their target things are, by the compass: "north of the lake".
enum class ThingSide : std::uint8_t {
  kAny,
  kEast,
  kNorthEast,
  kNorth,
  kNorthWest,
  kWest,
  kSouthWest,
  kSouth,
  kSouthEast
};
constexpr std::array<EnumName<ThingSide>, 9> EnumNames(ThingSide) {
  return {{{ThingSide::kAny, "any"},
           {ThingSide::kEast, "east"},
           {ThingSide::kNorthEast, "north-east"},
           {ThingSide::kNorth, "north"},
           {ThingSide::kNorthWest, "north-west"},
           {ThingSide::kWest, "west"},
           {ThingSide::kSouthWest, "south-west"},
           {ThingSide::kSouth, "south"},
           {ThingSide::kSouthEast, "south-east"}}};
}

// Land of a class, or the things of a wish; neither: nothing.
struct ThingTarget {
  char letter = '\0';
  int wish = -1;  // index into the list of wishes, before the one that has the target

  bool is_nothing() const { return letter == '\0' && wish < 0; }
};

struct ThingWish {
  std::string kind;
  std::string name;     // that programs gave it; of several "<name>_1" ...; "": after its kind
  int count = 1;        // to place
  int count_least = 1;  // that fulfil the words
  int count_most = 1;
  ThingArrangement arrangement = ThingArrangement::kNone;
  double spacing_m = 0.0;             // between the middles of neighbours; 0: usual for the kind
  double size = 1.0;                  // over that of the kind, [0.2, 5]
  std::optional<double> heading_rad;  // of its front
  Zone zone;
  ThingRelation relation = ThingRelation::kNone;
  ThingTarget target;                // of the relation
  ThingTarget second;                // of kBetween
  ThingSide side = ThingSide::kAny;  // of kNear
  double distance_m = 0.0;
  ThingTarget facing;
  std::optional<WorldPoint> position;  // exact: it stands there or not at all
  std::string words;                   // of the instruction
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_LAYOUT_THING_WISH_H_
