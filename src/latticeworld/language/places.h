#ifndef LATTICEWORLD_LANGUAGE_PLACES_H_
#define LATTICEWORLD_LANGUAGE_PLACES_H_

#include <cstddef>
#include <string_view>
#include <vector>

#include "latticeworld/geometry/region.h"
#include "latticeworld/language/tokens.h"
#include "latticeworld/layout/zone.h"

namespace latticeworld {

// A place in words, read.
struct Place {
  UnitBox box;                      // around all that the words cover
  std::vector<Region> regions;      // the ninths that it speaks of, each of them
  Region main = Region::kAnywhere;  // the ninth for one compact thing: "north" is upper
  // What the words cover: "north" and "northern third" are the northern third, "north-west" a
  // ninth, "north-west corner" a corner, "upper two thirds" a box of that depth. The zones that
  // FindZone knows have their names.
  Zone zone;
};

struct PlaceMatch {
  std::vector<Place> places;  // several: "all four corners", "the northern and southern halves"
  std::size_t tokens = 0;     // 0: no place starts here
  // "of" follows, and then something other than the map: in "the north of the lake" and "the middle
  // of the forest" the words are about the lake and the forest.
  bool of_other = false;
  bool whole = false;  // said to be all of it: "the entire northern half"
};

// The place that starts at tokens[at], without a preposition before it: "upper left", "the southern
// half", "north-east corner of the map", "middle of the right side", "lower two thirds", "top 20
// %", "the northern and southern edges", "just north of the centre", "a strip along the southern
// edge", "background", "the diagonal", "everywhere". The words before `at` tell "the right" from
// "right now" and "the borders" from "it borders". Two opposite words in a row ("north-south") are
// an axis and no place.
PlaceMatch MatchPlace(const std::vector<Token>& tokens, std::size_t at);

// The same after a preposition, in lower case, that bends what the place covers: "along the south"
// is the southern edge, "across the middle" the middle rows, "down the middle" the middle columns.
// Any other preposition changes nothing.
PlaceMatch MatchPlaceAfter(std::string_view preposition, const std::vector<Token>& tokens,
                           std::size_t at);

// A unit step of a compass word or side that starts at tokens[at]: column to the east, row to the
// south. For "north of the lake", "to the left of the village", "the western shore of the lake".
struct Heading {
  int east = 0;   // -1, 0, 1
  int south = 0;  // -1, 0, 1
  bool IsDiagonal() const { return east != 0 && south != 0; }
};
struct HeadingMatch {
  Heading heading;
  std::size_t tokens = 0;  // 0: no heading starts here
};
HeadingMatch MatchHeading(const std::vector<Token>& tokens, std::size_t at);

// An axis that starts at tokens[at]: "north-south", "E/W", "NE to SW", "left to right", "top to
// bottom", "north to the south". `from` is where the words begin, `to` the opposite of it.
struct AxisMatch {
  Heading from;
  Heading to;
  std::size_t tokens = 0;  // 0: no axis starts here
};
AxisMatch MatchAxis(const std::vector<Token>& tokens, std::size_t at);

// The place of one ninth.
Place PlaceOf(Region region);
// The ninth at column -1, 0, 1 (west to east) and row -1, 0, 1 (north to south).
Region RegionOf(Heading heading);
Heading HeadingOf(Region region);  // kAnywhere: the centre

// Zones by heading: {0, -1} is "northern third", {1, -1} "upper right", {0, 0} "center".
Zone ZoneOf(Heading heading);
// "northern edge", "north-east corner", "center".
Zone RimZoneOf(Heading heading);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_PLACES_H_
