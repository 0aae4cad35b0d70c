#ifndef LATTICEWORLD_LANGUAGE_PHRASE_TABLE_H_
#define LATTICEWORLD_LANGUAGE_PHRASE_TABLE_H_

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "latticeworld/language/tokens.h"

namespace latticeworld {

// Phrases of one or more words and what each of them means; the longest one that fits is found.
template <typename Value>
class PhraseTable {
 public:
  struct Match {
    const Value* value = nullptr;  // nullptr: no phrase starts here
    std::size_t tokens = 0;
    bool plural = false;
  };
  struct Group {
    Value value;
    std::vector<std::string_view> phrases;  // lower case, hyphens written as spaces
  };

  PhraseTable() = default;
  explicit PhraseTable(std::initializer_list<Group> groups) {
    for (const Group& group : groups) {
      for (const std::string_view phrase : group.phrases) Add(phrase, group.value);
    }
  }

  // The phrases must outlive the table, as literals do; of equal ones the first counts.
  void Add(std::string_view phrase, const Value& value) {
    by_phrase_.emplace(phrase, value);
    const auto words = static_cast<std::size_t>(1 + std::count(phrase.begin(), phrase.end(), ' '));
    std::size_t& longest = longest_by_first_word_[phrase.substr(0, phrase.find(' '))];
    longest = std::max(longest, words);
  }

  // plurals: whether the last word may be the plural of the phrase's.
  Match At(const std::vector<Token>& tokens, std::size_t at, bool plurals) const {
    const auto first = longest_by_first_word_.find(tokens[at].text);
    // One word alone may be a plural that begins no phrase itself.
    const std::size_t limit =
        std::max<std::size_t>(first == longest_by_first_word_.end() ? 0 : first->second, plurals);
    std::size_t words = 0;
    while (words < limit && at + words < tokens.size() &&
           tokens[at + words].kind == TokenKind::kWord) {
      ++words;
    }
    for (; words > 0; --words) {
      const std::string phrase = JoinWords(tokens, at, at + words);
      if (const auto found = by_phrase_.find(phrase); found != by_phrase_.end()) {
        return {&found->second, words, false};
      }
      if (!plurals) continue;
      const std::string& last = tokens[at + words - 1].text;
      const std::string singular = phrase.substr(0, phrase.size() - last.size()) + Singular(last);
      if (const auto found = by_phrase_.find(singular); found != by_phrase_.end()) {
        return {&found->second, words, true};
      }
    }
    return {};
  }

 private:
  std::unordered_map<std::string_view, Value> by_phrase_;
  std::unordered_map<std::string_view, std::size_t> longest_by_first_word_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_PHRASE_TABLE_H_
