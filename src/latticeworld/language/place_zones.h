#ifndef LATTICEWORLD_LANGUAGE_PLACE_ZONES_H_
#define LATTICEWORLD_LANGUAGE_PLACE_ZONES_H_

#include <array>
#include <string>
#include <vector>

#include "latticeworld/language/place_words.h"
#include "latticeworld/language/places.h"

namespace latticeworld {

inline constexpr std::array<Heading, 4> kCornerHeadings = {
    {Heading{-1, -1}, Heading{1, -1}, Heading{-1, 1}, Heading{1, 1}}};

// How much of a direction the words ask for.
enum class PlaceDepth {
  kUnsaid,    // "north", "northern part"
  kSide,      // "north side": a third, but an edge for what runs along it
  kThird,     // said so
  kHalf,      // also of the diagonals: a triangle
  kQuarter,   // a band; of the diagonals a quadrant
  kBand,      // a quarter deep; of the middle the middle rows
  kRows,      // of the middle the middle rows, else an edge
  kColumns,   // of the middle the middle columns, else an edge
  kCorner,    // a quarter a side
  kEdge,      // an eighth
  kFraction,  // a number
};

struct PlaceExtent {
  PlaceDepth depth = PlaceDepth::kUnsaid;
  double fraction = 1.0;           // (0, 1]; kFraction only
  std::string fraction_name = {};  // "two thirds"; kFraction only
};

Place MakePlace(const Direction& direction, const PlaceExtent& extent);

// A place of given boxes; a zone with a name keeps it, another is called `name`.
Place PlaceOfBoxes(std::string name, std::vector<UnitBox> boxes);
// A zone that FindZone knows.
Place PlaceOfName(std::string_view name);
Place Everywhere();
// The ring of the four edges; the four corners taken as one.
Place AllEdges();
Place AllCorners();
// Falling: from the north-west to the south-east; else from the south-west to the north-east.
Place Diagonal(bool falling);
// A third of the map, moved by a fifth from the middle.
Place BesideCenter(Heading heading);
Place AroundCenter();
Place Between(const Place& a, const Place& b);
// "the middle of the northern half", "the west end of the northern edge": `part` measured in
// `whole` and not in the map. If the whole has several boxes, the box around them counts.
Place PartOf(const Direction& part, const Place& part_place, const Place& whole);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_PLACE_ZONES_H_
