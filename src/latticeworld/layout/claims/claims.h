#ifndef LATTICEWORLD_LAYOUT_CLAIMS_CLAIMS_H_
#define LATTICEWORLD_LAYOUT_CLAIMS_CLAIMS_H_

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "latticeworld/common/enum_names.h"
#include "latticeworld/layout/symbolic_layout.h"
#include "latticeworld/layout/zone.h"

namespace latticeworld {

// What can be said of a layout. "The subject" is the set of cells of the claim's subject class in
// the claim's zone (anywhere: all of them); "the object" the cells of the object class in
// object_zone. A piece is 8-connected. `least` and `most` bound the quantity named with a kind;
// kUnsaid stands for its default, given in brackets.
//
// Layouts are noisy, and words are not about single cells. Therefore:
// - Stray cells, those without a neighbour of their class, count for shares, but neither for pieces
//   nor for what lies how to what, where they are less than a tenth of their class.
// - In suburb, roads and rivers cut each other where they cross. Pieces of road and of water are
//   one piece across a line of the other that is one or two cells wide, if one of them is a line
//   itself: a strip of road between two lakes joins none.
// - A relation between classes holds when it holds for them as a whole or for one of their larger
//   pieces: a village north of the lake may be one of two. It needs all of its classes: what is not
//   there is neither near nor far. Where subject and object are the same class, in kAdjacent,
//   kApart, kParallel and kCrosses, it is about two pieces of it (kCrosses: two lines).
// - The edges of the layout are no border, but for a thing that reaches three of them: one half of
//   the land does not lie in the other half.
enum class ClaimKind : std::uint8_t {
  kPresent,    // share of the zone's cells, least [0.015]
  kAbsent,     // share of the zone's cells, most [0]
  kAmount,     // share of the zone's cells, least [0] .. most [1]
  kDominant,   // the subject has more cells in the zone than any other class
  kMoreThan,   // more cells of the subject than of the object, both in the zone
  kLocated,    // share of the class's cells, of the whole layout, that lie in the zone: least [0.6]
  kCount,      // number of pieces with at least half of their cells in the zone, least [1] .. most
  kClustered,  // at most `most` [3] pieces hold nine tenths of the subject
  kScattered,  // at least `least` [4] pieces, none with more than half of the subject
  kAdjacent,  // the gap between subject and object: at most `most` [1] steps of a king, 1: touching
  kApart,     // the same gap: at least `least` [3] steps
  kSurrounds,  // share of the object's border that is subject: least [0.6]. The border is the ring
               // of cells around it, or the next or second next ring (a shore, a fence), the best
  kWithin,     // share of the subject's border that is object: least [0.6]; the subject lies in it
  kBothSides,  // subject within 4 steps of the object on both sides of it, a tenth of it or more on
               // the lesser side. Sides follow the bends of what is long; what is round has two
               // sides along any line through its middle
  kBetween,    // the subject's centroid lies between those of object and second_object (the same
               // letter: two pieces): 0.15 to 0.85 of the way, aside at most half of it or 5 cells
  kDirection,  // the subject's centroid lies toward `heading` from the object's: by a cell or more,
               // at most 63 degrees off north, east, south, west, 40 degrees off the others
  kOrder,      // the centroids of `sequence` (letters) follow each other along `heading`, a cell
               // apart or more
  kCourse,     // one piece of the subject reaches both zone `from` and zone `to`
  kThrough,  // the subject, a line, runs through the object: for two cells or more of it the object
             // lies within 3 steps on both sides
  kAlong,    // share of the subject's cells at most 3 steps from the object (or, without one, in
             // the zone; or share of the zone's length that the subject has cells in): least [0.5]
  kCrosses,  // subject and object, both lines, cross each other: on the way around some cell, two
             // cells off it, they follow each other twice
  kParallel,  // subject and object, both lines, run side by side without touching: axes at most 30
              // degrees apart, half of the shorter beside the longer, 16 steps apart at most
  kConnects,  // a piece of the subject comes within 2 steps of object and of second_object (the
              // same letter: two pieces)
  kShape,     // the subject's largest piece has `shape`
  kRest,  // of the zone's cells that are of no letter in `sequence`, share of the subject: least
          // [0.8]
};

constexpr std::array<EnumName<ClaimKind>, 25> EnumNames(ClaimKind) {
  return {{{ClaimKind::kPresent, "present"},
           {ClaimKind::kAbsent, "absent"},
           {ClaimKind::kAmount, "amount"},
           {ClaimKind::kDominant, "dominant"},
           {ClaimKind::kMoreThan, "more_than"},
           {ClaimKind::kLocated, "located"},
           {ClaimKind::kCount, "count"},
           {ClaimKind::kClustered, "clustered"},
           {ClaimKind::kScattered, "scattered"},
           {ClaimKind::kAdjacent, "adjacent"},
           {ClaimKind::kApart, "apart"},
           {ClaimKind::kSurrounds, "surrounds"},
           {ClaimKind::kWithin, "within"},
           {ClaimKind::kBothSides, "both_sides"},
           {ClaimKind::kBetween, "between"},
           {ClaimKind::kDirection, "direction"},
           {ClaimKind::kOrder, "order"},
           {ClaimKind::kCourse, "course"},
           {ClaimKind::kThrough, "through"},
           {ClaimKind::kAlong, "along"},
           {ClaimKind::kCrosses, "crosses"},
           {ClaimKind::kParallel, "parallel"},
           {ClaimKind::kConnects, "connects"},
           {ClaimKind::kShape, "shape"},
           {ClaimKind::kRest, "rest"}}};
}

// The length of what is bent is measured along it; a line is at least 2.5 times as long as wide.
enum class ClaimShape : std::uint8_t {
  kRound,      // at most 1.6 times as long as wide, and filling 0.7 of the ellipse around it
  kElongated,  // at least twice as long as wide
  kBent,       // elongated, and its middle lies off the line between its ends by 0.15 of its length
  kRing,       // encloses cells that are not its own, a tenth of them or more; an opening of two
               // cells, as a road makes, does not undo it
  kStraight,   // a line whose middle course lies at most 1.5 cells from the line between its ends
  kWinding,    // a line whose middle course leaves that line by 2 cells or more
  kGridded,    // lines both ways that cross: it encloses two holes, or parts the layout into six
};

constexpr std::array<EnumName<ClaimShape>, 7> EnumNames(ClaimShape) {
  return {{{ClaimShape::kRound, "round"},
           {ClaimShape::kElongated, "elongated"},
           {ClaimShape::kBent, "bent"},
           {ClaimShape::kRing, "ring"},
           {ClaimShape::kStraight, "straight"},
           {ClaimShape::kWinding, "winding"},
           {ClaimShape::kGridded, "gridded"}}};
}

// One thing that an instruction says about a layout, checkable on the layout alone.
struct Claim {
  static constexpr double kUnsaid = std::numeric_limits<double>::infinity();

  // A unit step of the compass: column to the east, row to the south; each -1, 0 or 1.
  struct Heading {
    int east = 0;
    int south = 0;
    friend bool operator==(Heading a, Heading b) { return a.east == b.east && a.south == b.south; }
  };

  ClaimKind kind = ClaimKind::kPresent;
  char subject = '?';         // letter
  char object = '\0';         // letter
  char second_object = '\0';  // letter; kBetween, kConnects
  Zone zone;
  Zone object_zone;
  Zone from;             // kCourse
  Zone to;               // kCourse
  std::string sequence;  // letters; kOrder, kRest
  Heading heading;       // kDirection, kOrder
  double least = kUnsaid;
  double most = kUnsaid;
  ClaimShape shape = ClaimShape::kRound;
  std::string words;  // of the instruction
};

struct ClaimMeasure {
  bool holds = false;
  double distance = 0.0;    // how far the layout is from the claim: 0 when it holds, else 0.02, for
                            // the last cell that is missing, to 1
  std::string explanation;  // "forest covers 41 % of upper left; at least 1.5 % is asked"
};

ClaimMeasure Measure(const Claim& claim, const SymbolicLayout& layout);

// The cells of each letter of a layout.
class LayoutMasks {
 public:
  explicit LayoutMasks(const SymbolicLayout& layout);
  const LayoutMask& of(char letter) const {
    return masks_[static_cast<unsigned char>(letter) & 31];
  }
  // The cell, of letter `from`, becomes `to`.
  void Set(CellIndex cell, char from, char to);
  Vocabulary vocabulary() const { return vocabulary_; }

 private:
  Vocabulary vocabulary_;
  std::array<LayoutMask, 32> masks_{};
};

// The distance that Measure gives, without words: for searches. A few microseconds.
double DistanceOf(const Claim& claim, const LayoutMasks& layout);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LAYOUT_CLAIMS_CLAIMS_H_
