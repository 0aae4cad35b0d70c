#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_READING_SIDE_WORDS_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_READING_SIDE_WORDS_H_

#include <cstddef>
#include <string_view>
#include <vector>

#include "latticeworld/language/places.h"
#include "latticeworld/language/tokens.h"

// Sides of things in the tokens of an instruction, for what rewrites them.
namespace latticeworld {

// "side", "bank", "flank" ...
bool IsFlank(std::string_view word);
// A comma, bracket, colon or dash.
bool IsMark(const std::vector<Token>& tokens, std::size_t at);
// "north", "southwest".
std::string_view NameOf(Heading heading);
// A direction, after an article or "its" or none; the token after it, 0: no direction.
std::size_t TakeHeading(const std::vector<Token>& tokens, std::size_t at, Heading* heading);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_READING_SIDE_WORDS_H_
