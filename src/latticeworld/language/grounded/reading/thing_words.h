#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_READING_THING_WORDS_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_READING_THING_WORDS_H_

#include <cstddef>
#include <string_view>
#include <vector>

#include "latticeworld/language/tokens.h"

// Things in the tokens of an instruction, for what rewrites them.
namespace latticeworld {

// Whether one is named within the next five words, before a pause.
bool NamesThing(const std::vector<Token>& tokens, std::size_t at);

// The land that an adjective tells: "forested" is forest; "": it tells none.
std::string_view LandOfAdjective(std::string_view adjective);

// "big", "smaller", "narrow".
bool IsSize(std::string_view word);

// The token after articles ("the", "any", "its") and sizes.
std::size_t PastArticle(const std::vector<Token>& tokens, std::size_t at);
// The token after a thing with or without them, "the large lake"; 0: none stands there.
std::size_t PastThing(const std::vector<Token>& tokens, std::size_t at);

// The tokens of some words, all with the bytes of one token.
std::vector<Token> SaidLike(std::string_view words, const Token& beside);

struct NamedThing {
  std::size_t begin, end;  // of its noun
};
// Those that are named before `at`, the nearest first, back to the sentence before.
std::vector<NamedThing> NamedBefore(const std::vector<Token>& tokens, std::size_t at);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_READING_THING_WORDS_H_
