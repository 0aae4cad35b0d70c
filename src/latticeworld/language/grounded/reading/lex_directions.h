#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_READING_LEX_DIRECTIONS_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_READING_LEX_DIRECTIONS_H_

#include <cstddef>
#include <vector>

#include "latticeworld/language/grounded/reading/lexeme.h"
#include "latticeworld/language/tokens.h"

namespace latticeworld {

// "north of the lake", "to its west", "on the southern shore of it" at tokens[at]; false, and the
// lexeme as it was, where none starts there.
bool LexDirection(const std::vector<Token>& tokens, std::size_t at, Lexeme* lexeme);
// "south and east of the lake": between the two.
bool LexCornerDirection(const std::vector<Token>& tokens, std::size_t at, Lexeme* lexeme);
// "north and south of", "on the E and W sides of": how many tokens; 0: none.
std::size_t MatchTwoSides(const std::vector<Token>& tokens, std::size_t at);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_READING_LEX_DIRECTIONS_H_
