#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_READING_STRIPES_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_READING_STRIPES_H_

#include <cstddef>
#include <vector>

#include "latticeworld/language/places.h"
#include "latticeworld/language/tokens.h"

namespace latticeworld {

// What an instruction says of its stripes before it tells what each of them holds.
struct Stripes {
  bool said = false;     // "four equal columns"
  int count = 0;         // 0: not said
  Heading way;           // the order in which they are told; (0, 0): not said
  Heading usual;         // by the noun: columns go to the east, rows to the south
  bool equal = false;    // "of the same width"
  std::size_t noun = 0;  // token of the noun
  // What says the way, tokens [way_begin, way_end).
  std::size_t way_begin = 0;
  std::size_t way_end = 0;
};

// "four stripes of equal width", "three horizontal bands", "vertical thirds"; the way is left to
// FindWay.
Stripes FindStripes(const std::vector<Token>& tokens);
// The way in which stripes are told within tokens [begin, end): "from left to right", "counted from
// the top", "going down".
void FindWay(const std::vector<Token>& tokens, std::size_t begin, std::size_t end,
             Stripes* stripes);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_READING_STRIPES_H_
