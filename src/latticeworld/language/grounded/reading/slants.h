#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_READING_SLANTS_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_READING_SLANTS_H_

#include <optional>
#include <string>
#include <string_view>

#include "latticeworld/language/places.h"
#include "latticeworld/layout/zone.h"

namespace latticeworld {

// A corner of the map or the middle of one of its edges: 0, 1, 2 from the west and the north.
struct RimPoint {
  int east = 0;
  int south = 0;
};

// All of the map on one side of a straight line, as a word that no instruction holds: "slant#0022+"
// is to the left of who walks from the north-west corner to the south-east corner.
struct Slant {
  RimPoint from;
  RimPoint to;
  bool left = true;
};

// The side of the line that lies toward the heading; nullopt: the line runs along the heading.
std::optional<Slant> SlantToward(RimPoint from, RimPoint to, Heading heading);

std::string WordOf(const Slant& slant);
// nullopt: no such word.
std::optional<Slant> SlantNamed(std::string_view word);
// A box a row of the layout.
Zone ZoneOfSlant(const Slant& slant);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_READING_SLANTS_H_
