#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_PHRASE_TABLE_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_PHRASE_TABLE_H_

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
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

  explicit PhraseTable(std::initializer_list<Group> groups) {
    for (const Group& group : groups) {
      for (const std::string_view phrase : group.phrases) {
        by_phrase_.emplace(phrase, group.value);
        const auto words =
            static_cast<std::size_t>(1 + std::count(phrase.begin(), phrase.end(), ' '));
        longest_ = std::max(longest_, words);
      }
    }
  }

  // plurals: whether the last word may be the plural of the phrase's.
  Match At(const std::vector<Token>& tokens, std::size_t at, bool plurals) const {
    std::size_t words = 0;
    while (words < longest_ && at + words < tokens.size() &&
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
      const auto found =
          by_phrase_.find(phrase.substr(0, phrase.size() - last.size()) + Singular(last));
      if (found != by_phrase_.end()) return {&found->second, words, true};
    }
    return {};
  }

 private:
  std::unordered_map<std::string, Value> by_phrase_;
  std::size_t longest_ = 0;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_PHRASE_TABLE_H_
