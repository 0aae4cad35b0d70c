#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_TOKEN_NOTES_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_TOKEN_NOTES_H_

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/language/grounded/environment/word_tables.h"
#include "latticeworld/language/tokens.h"

namespace latticeworld {

// What the readers of an instruction found out about one token, each for the others to see.
struct TokenNote {
  bool negated = false;  // in the scope of a "no", "without", "instead of"
  bool ignored = false;  // a figure of speech, or part of a comparison
  bool measure = false;  // belongs to an hour, a temperature, a speed
  bool agent = false;    // names agents, counts them or says what they do
  bool place = false;    // says where agents are
  bool fine = false;     // is said of an asset type
  bool known = false;    // read by somebody, or a word that holds others together
};

// An instruction in tokens with notes.
struct NotedTokens {
  std::string_view instruction;
  std::vector<Token> tokens;
  std::vector<TokenNote> notes;  // one a token

  std::size_t size() const { return tokens.size(); }
  bool IsEnd(std::size_t at) const {
    return at >= tokens.size() || tokens[at].kind == TokenKind::kStop;
  }
  // Returns whether a sentence ends there, or a comma stands there.
  bool IsPause(std::size_t at) const { return IsEnd(at) || tokens[at].kind == TokenKind::kComma; }
  bool IsWord(std::size_t at, std::string_view word) const {
    return at < tokens.size() && tokens[at].text == word;
  }
  bool IsAnyWord(std::size_t at, std::initializer_list<std::string_view> words) const {
    for (const std::string_view word : words) {
      if (IsWord(at, word)) return true;
    }
    return false;
  }
  // The instruction's own text of tokens [first, last).
  std::string_view Text(std::size_t first, std::size_t last) const;
  void Mark(std::size_t first, std::size_t last, bool TokenNote::*note) {
    for (std::size_t i = first; i < last && i < notes.size(); ++i) {
      notes[i].*note = true;
      notes[i].known = true;
    }
  }
};

// Tokens with `negated` and `ignored` noted, and the words known that hold others together.
NotedTokens NoteScopes(std::string_view instruction, std::vector<Token> tokens,
                       const EnvironmentWords& words);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_TOKEN_NOTES_H_
