#ifndef LATTICEWORLD_LANGUAGE_PLACE_PHRASES_H_
#define LATTICEWORLD_LANGUAGE_PLACE_PHRASES_H_

#include <vector>

#include "latticeworld/language/place_words.h"
#include "latticeworld/language/place_zones.h"
#include "latticeworld/language/places.h"

namespace latticeworld {

// A place while it is read.
struct ReadPlace {
  std::vector<Place> places;  // empty: no place
  bool of_other = false;
  bool whole = false;
  // If there is one place: the direction and the extent that it was made of. A preposition may
  // change them.
  Direction direction;
  PlaceExtent extent;
};

ReadPlace FoundPlace(Place place);

// The phrases that hold no other place. Each returns whether it was there; where it was not, the
// cursor may stand anywhere and `read` may hold anything.

// "everywhere"; with `whole` also "map", of "the whole map".
bool TakeEverywhere(PlaceCursor* cursor, bool whole, ReadPlace* read);
// "corners", "all four edges", "opposite corners", "both sides".
bool TakeGroup(PlaceCursor* cursor, ReadPlace* read);
// "just north of the centre", "left of the middle", "slightly off-centre".
bool TakeBesideCenter(PlaceCursor* cursor, ReadPlace* read);
// "background", "the front", "the diagonal"; determined: after "the" or the like.
bool TakePictureWord(PlaceCursor* cursor, bool determined, ReadPlace* read);

// "half", "two thirds", "20 %", "5 rows", "side", "corner" after a direction.
PlaceExtent TakeExtent(const Direction& direction, PlaceCursor* cursor);
// "halves", "edges": a noun that may belong to several directions.
bool IsPluralOfPlace(std::string_view word);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_PLACE_PHRASES_H_
