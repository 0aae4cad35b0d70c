#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_READING_SIDE_WORDS_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_READING_SIDE_WORDS_H_

#include <cstddef>
#include <string>
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
// "north", "northwards", "northern": "north"; "" where it is none of the four.
std::string_view HeadingWord(std::string_view word);
// The same, and "north" for "top" and "upper", "west" for "left".
std::string_view SideWord(std::string_view word);
// "south" of "north"; "" of what is none of the four.
std::string_view OppositeOf(std::string_view heading);
// "north", "southwest".
std::string_view NameOf(Heading heading);
// A direction, after an article or "its" or none; the token after it, 0: no direction.
std::size_t TakeHeading(const std::vector<Token>& tokens, std::size_t at, Heading* heading);
// "The west", "west edge" after an article: which side, "west", "western edge", and the token after
// it; 0: none.
std::size_t TakeSideWords(const std::vector<Token>& tokens, std::size_t at, std::string* place);
// "Corners", "quarter", "border": the singular of a place that there are several of; "".
std::string_view NounOfPlace(std::string_view word);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_READING_SIDE_WORDS_H_
