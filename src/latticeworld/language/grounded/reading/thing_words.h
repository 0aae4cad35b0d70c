#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_READING_THING_WORDS_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_READING_THING_WORDS_H_

#include <cstddef>
#include <string_view>
#include <vector>

#include "latticeworld/language/class_words.h"
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

// The token after a thing with what stands before its noun: "the small village", "two patches of
// forest", "it"; `at`: none stands there.
std::size_t PhraseEnd(const std::vector<Token>& tokens, std::size_t at);
// The first token of such a thing that ends before `end`; `end`: none ends there.
std::size_t PhraseBegin(const std::vector<Token>& tokens, std::size_t end);
// The noun that ends before `end`; nullptr: none ends there.
const ClassWord* NounBefore(const std::vector<Token>& tokens, std::size_t end);

// "is", "lies", "there are", "you will find": the token after such words.
std::size_t SkipBeing(const std::vector<Token>& tokens, std::size_t at);
// The first of such words that end before `end`.
std::size_t BeingBegin(const std::vector<Token>& tokens, std::size_t end);

// A phrase that names one: "the old stone houses".
struct NounSpan {
  std::size_t begin = 0, noun = 0, end = 0;  // of its first word, of its noun, behind it
  bool plural = false;
  bool found() const { return end > begin; }
};
// Returns the span that begins right there: an article or another such word, at most three words,
// the noun.
NounSpan TakeNounSpan(const std::vector<Token>& tokens, std::size_t at);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_READING_THING_WORDS_H_
