#ifndef LATTICEWORLD_LANGUAGE_TOKEN_EDITS_H_
#define LATTICEWORLD_LANGUAGE_TOKEN_EDITS_H_

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/language/tokens.h"

// Helpers for what rewrites the tokens of an instruction.
namespace latticeworld {

// "" at punctuation, at numbers and outside.
inline std::string_view WordAt(const std::vector<Token>& tokens, std::size_t at) {
  return at < tokens.size() && tokens[at].kind == TokenKind::kWord
             ? std::string_view(tokens[at].text)
             : std::string_view();
}

inline bool IsNumberAt(const std::vector<Token>& tokens, std::size_t at) {
  return at < tokens.size() && tokens[at].kind == TokenKind::kNumber;
}

// A comma, a stop or the end.
inline bool IsPauseAt(const std::vector<Token>& tokens, std::size_t at) {
  return at >= tokens.size() || tokens[at].kind == TokenKind::kStop ||
         tokens[at].kind == TokenKind::kComma;
}

// A stop or the end.
inline bool IsStopAt(const std::vector<Token>& tokens, std::size_t at) {
  return at >= tokens.size() || tokens[at].kind == TokenKind::kStop;
}

// The first pause at or after `at`.
inline std::size_t PauseAfter(const std::vector<Token>& tokens, std::size_t at) {
  while (!IsPauseAt(tokens, at)) ++at;
  return at;
}

// The stop at or after `at`, or the end.
inline std::size_t StopAfter(const std::vector<Token>& tokens, std::size_t at) {
  while (!IsStopAt(tokens, at)) ++at;
  return at;
}

// The first token of the sentence of `at`.
inline std::size_t SentenceBegin(const std::vector<Token>& tokens, std::size_t at) {
  while (at > 0 && !IsStopAt(tokens, at - 1)) --at;
  return at;
}

// A word that stands for the bytes of another.
inline Token WordLike(std::string_view word, const Token& beside) {
  return {TokenKind::kWord, std::string(word), beside.begin, beside.end};
}

inline Token CommaLike(const Token& beside) {
  return {TokenKind::kComma, ",", beside.begin, beside.end};
}

inline Token StopLike(const Token& beside) {
  return {TokenKind::kStop, ".", beside.begin, beside.end};
}

// Copies of tokens [begin, end).
inline std::vector<Token> TokensBetween(const std::vector<Token>& tokens, std::size_t begin,
                                        std::size_t end) {
  return {tokens.begin() + static_cast<std::ptrdiff_t>(begin),
          tokens.begin() + static_cast<std::ptrdiff_t>(end)};
}

inline void EraseTokens(std::vector<Token>* tokens, std::size_t first, std::size_t count) {
  const auto begin = tokens->begin() + static_cast<std::ptrdiff_t>(first);
  tokens->erase(begin, begin + static_cast<std::ptrdiff_t>(count));
}

inline void InsertTokens(std::vector<Token>* tokens, std::size_t at,
                         const std::vector<Token>& added) {
  tokens->insert(tokens->begin() + static_cast<std::ptrdiff_t>(at), added.begin(), added.end());
}

// Words in the place of `count` tokens, all with the bytes of the first of these.
inline void ReplaceTokens(std::vector<Token>* tokens, std::size_t first, std::size_t count,
                          const std::vector<std::string_view>& words) {
  const Token beside = (*tokens)[first];
  EraseTokens(tokens, first, count);
  std::vector<Token> added;
  for (const std::string_view word : words) added.push_back(WordLike(word, beside));
  InsertTokens(tokens, first, added);
}

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_TOKEN_EDITS_H_
