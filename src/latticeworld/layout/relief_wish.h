#ifndef LATTICEWORLD_LAYOUT_RELIEF_WISH_H_
#define LATTICEWORLD_LAYOUT_RELIEF_WISH_H_

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "latticeworld/common/enum_names.h"
#include "latticeworld/layout/claims/claims.h"
#include "latticeworld/layout/zone.h"

namespace latticeworld {

// What the land can do by itself, whatever grows on it. docs/relief.md defines each and says how it
// is measured.
enum class ReliefKind : std::uint8_t {
  kMountain,  // stands alone or in ranges, with ridges and valleys of its own
  kPeak,      // a mountain with one top
  kHill,      // round, of soil
  kRidge,     // long and high
  kMoraine,   // long and low, bent
  kSaddle,    // a pass between two rises
  kPlateau,   // high and level, scarps around it
  kMesa,      // a small plateau with steep sides
  kCrater,    // a rim around a hollow
  kBasin,     // a hollow that no water leaves
  kValley,    // long and low, with a floor
  kGorge,     // a narrow valley with steep walls
  kCanyon,    // a deep and wide one
  kCliff,     // a step that is steep
  kSlope,     // land that falls one way
  kDunes,     // waves of sand
  kTerraces,  // land in level steps
  // The whole of a place:
  kFlat,
  kGentle,
  kRolling,
  kHilly,
  kMountainous,
  kRugged,
  kSteep,
};

constexpr std::array<EnumName<ReliefKind>, 24> EnumNames(ReliefKind) {
  return {{{ReliefKind::kMountain, "mountain"}, {ReliefKind::kPeak, "peak"},
           {ReliefKind::kHill, "hill"},         {ReliefKind::kRidge, "ridge"},
           {ReliefKind::kMoraine, "moraine"},   {ReliefKind::kSaddle, "saddle"},
           {ReliefKind::kPlateau, "plateau"},   {ReliefKind::kMesa, "mesa"},
           {ReliefKind::kCrater, "crater"},     {ReliefKind::kBasin, "basin"},
           {ReliefKind::kValley, "valley"},     {ReliefKind::kGorge, "gorge"},
           {ReliefKind::kCanyon, "canyon"},     {ReliefKind::kCliff, "cliff"},
           {ReliefKind::kSlope, "slope"},       {ReliefKind::kDunes, "dunes"},
           {ReliefKind::kTerraces, "terraces"}, {ReliefKind::kFlat, "flat"},
           {ReliefKind::kGentle, "gentle"},     {ReliefKind::kRolling, "rolling"},
           {ReliefKind::kHilly, "hilly"},       {ReliefKind::kMountainous, "mountainous"},
           {ReliefKind::kRugged, "rugged"},     {ReliefKind::kSteep, "steep"}}};
}

// Whether the kind is about a place as a whole rather than a thing in it.
inline bool IsTexture(ReliefKind kind) { return kind >= ReliefKind::kFlat; }
// Whether the kind runs along a course.
inline bool IsCourse(ReliefKind kind) {
  return kind == ReliefKind::kRidge || kind == ReliefKind::kMoraine ||
         kind == ReliefKind::kValley || kind == ReliefKind::kGorge || kind == ReliefKind::kCanyon ||
         kind == ReliefKind::kCliff;
}

// What a piece of relief has to do with a class of the layout, or with another piece.
struct ReliefTie {
  enum class Kind : std::uint8_t {
    kUnder,    // the class lies on it, or in it: "the village is inside the valley"
    kBeside,   // it lies near the class
    kToward,   // it lies toward `heading` from the class
    kClimbed,  // the class, a road, leads up to its top
    kBridged,  // a way leads over it on a bridge
  };
  Kind kind = Kind::kBeside;
  char letter = '?';                // '\0': a way that the vocabulary has no class for
  std::vector<Zone> zones;          // of the class's thing; empty: anywhere
  Claim::Heading heading;           // kToward
  int wish = -1;                    // the other piece's, one before its own; -1: the class is meant
  std::optional<double> slope_deg;  // kClimbed: of the way
  std::string words;                // kClimbed, kBridged: of the instruction; may be empty
};

// One piece of relief that an instruction asks for.
struct ReliefWish {
  ReliefKind kind = ReliefKind::kHill;
  std::vector<Zone> zones;  // where, one of them for each piece in turn; empty: anywhere
  int count = 0;            // pieces; 0: as many as fit, where `plural`, else one
  bool plural = false;
  double size = 1.0;                // of the natural size: "large" 1.8
  double steepness = 1.0;           // of the natural slope: "steep" above 1, "gentle" below
  std::optional<double> height_m;   // above its foot
  std::optional<double> depth_m;    // below its rim
  std::optional<double> width_m;    // across
  std::optional<double> length_m;   // along
  std::optional<double> slope_deg;  // of its flanks
  Claim::Heading heading;           // that the land rises to; {0, 0}: nothing said
  std::vector<Zone> from, to;       // of a course: one zone each, or none
  char letter = '\0';               // class of the layout that it is laid as; '\0': none
  std::string label;                // "A" of "hill A"
  std::vector<int> between;         // kSaddle: wishes before it whose rises it lies between; empty:
                                    // two rises of its own
  bool alone = false;               // nothing else is said of the land: it is all of the world
  std::vector<ReliefTie> ties;
  std::string words;  // of the instruction
  // The sentences that its measures come from, where they are others.
  std::string height_words, depth_words, width_words, length_words, slope_words;
};

// Land of one class above or below a height, and none of it on the other side: "snow above 80 m".
struct HeightCover {
  char letter = '?';
  double height_m = 0.0;  // as the world's maps have it
  bool above = true;
  std::string words;  // of the instruction
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_LAYOUT_RELIEF_WISH_H_
