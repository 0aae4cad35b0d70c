#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_PLACES_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_PLACES_H_

#include <cstddef>
#include <optional>
#include <vector>

#include "latticeworld/geometry/region.h"
#include "latticeworld/language/tokens.h"

namespace latticeworld {

// A place in words, read.
struct Place {
  UnitBox box;                      // what the words cover: "northern half" is v in [0, 0.5]
  std::vector<Region> regions;      // the ninths that it speaks of, each of them
  Region main = Region::kAnywhere;  // the ninth for one compact thing: "north" is upper
};

struct PlaceMatch {
  std::vector<Place> places;  // several: "the corners", "all sides"
  std::size_t tokens = 0;     // 0: no place starts here
};

// The place that starts at tokens[at], without a preposition before it: "upper left", "the southern
// half", "north-east corner of the map", "middle of the right side", "edges", "everywhere".
PlaceMatch MatchPlace(const std::vector<Token>& tokens, std::size_t at);

// A unit step of a compass word or side that starts at tokens[at]: column to the east, row to the
// south. For "north of the lake", "to the left of the village".
struct Heading {
  int east = 0;   // -1, 0, 1
  int south = 0;  // -1, 0, 1
};
struct HeadingMatch {
  Heading heading;
  std::size_t tokens = 0;  // 0: no heading starts here
};
HeadingMatch MatchHeading(const std::vector<Token>& tokens, std::size_t at);

// The place of one ninth.
Place PlaceOf(Region region);
// The ninth at column -1, 0, 1 (west to east) and row -1, 0, 1 (north to south).
Region RegionOf(Heading heading);
Heading HeadingOf(Region region);  // kAnywhere: the centre

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_PLACES_H_
