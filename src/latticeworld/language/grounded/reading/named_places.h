#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_READING_NAMED_PLACES_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_READING_NAMED_PLACES_H_

#include <vector>

#include "latticeworld/language/tokens.h"

namespace latticeworld {

// The tokens with places and things that the words only point at by name:
// - "confined to that quarter": the quarter that was named last;
// - "a road between 1 and 2", of a numbered list: the things of these items;
// - "on your left": on the left; "in front lie fields": in the foreground;
// - "white in the north, a blue patch below": what a map paints so;
// - "where it starts is the left side": it starts there.
// Words that are put in share the bytes of a word beside them.
std::vector<Token> WithNamedPlaces(std::vector<Token> tokens);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_READING_NAMED_PLACES_H_
