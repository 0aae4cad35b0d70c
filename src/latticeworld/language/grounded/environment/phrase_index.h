#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_PHRASE_INDEX_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_PHRASE_INDEX_H_

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "latticeworld/language/tokens.h"

namespace latticeworld {

// Phrases of one or more words and the rows of a table that they stand for, several where a phrase
// has several meanings; the longest phrase that fits is found.
class PhraseIndex {
 public:
  struct Match {
    const std::vector<int>* rows = nullptr;  // in the order they were added; nullptr: no phrase
    std::size_t tokens = 0;
  };

  // The phrase is read by the tokenizer, so that it is written as an instruction would.
  void Add(std::string_view phrase, int row) {
    const std::vector<Token> tokens = Tokenize(phrase);
    if (tokens.empty()) return;
    std::vector<int>& rows = rows_by_phrase_[JoinWords(tokens, 0, tokens.size())];
    if (std::find(rows.begin(), rows.end(), row) == rows.end()) rows.push_back(row);
    std::size_t& longest = longest_by_first_word_[tokens.front().text];
    longest = std::max(longest, tokens.size());
  }

  // No phrase starts at the end or beyond.
  Match At(const std::vector<Token>& tokens, std::size_t at) const {
    if (at >= tokens.size()) return {};
    const auto first = longest_by_first_word_.find(tokens[at].text);
    if (first == longest_by_first_word_.end()) return {};
    std::size_t words = 0;
    while (words < first->second && at + words < tokens.size() && IsSpoken(tokens[at + words])) {
      ++words;
    }
    std::string phrase = JoinWords(tokens, at, at + words);
    for (; words > 0; --words) {
      if (const auto found = rows_by_phrase_.find(phrase); found != rows_by_phrase_.end()) {
        return {&found->second, words};
      }
      const std::size_t last = tokens[at + words - 1].text.size();
      phrase.resize(phrase.size() - std::min(phrase.size(), last + 1));
    }
    return {};
  }

  bool Has(std::string_view phrase) const { return rows_by_phrase_.count(std::string(phrase)) > 0; }

  // What a phrase stands for, to be changed; nullptr: it is none.
  std::vector<int>* RowsOf(std::string_view phrase) {
    const auto found = rows_by_phrase_.find(std::string(phrase));
    return found == rows_by_phrase_.end() ? nullptr : &found->second;
  }

  // Every phrase, in alphabetical order.
  std::vector<std::string_view> Phrases() const {
    std::vector<std::string_view> phrases;
    for (const auto& [phrase, rows] : rows_by_phrase_) phrases.push_back(phrase);
    std::sort(phrases.begin(), phrases.end());
    return phrases;
  }

 private:
  static bool IsSpoken(const Token& token) {
    return token.kind == TokenKind::kWord || token.kind == TokenKind::kNumber;
  }

  std::unordered_map<std::string, std::vector<int>> rows_by_phrase_;
  std::unordered_map<std::string, std::size_t> longest_by_first_word_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_PHRASE_INDEX_H_
