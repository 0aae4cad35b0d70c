#include "latticeworld/language/class_words.h"

#include <algorithm>
#include <initializer_list>
#include <string>
#include <unordered_map>

namespace latticeworld {
namespace {

struct PhraseIndex {
  std::unordered_map<std::string_view, const ClassWord*> by_phrase;
  std::unordered_map<std::string_view, std::size_t> longest_by_first_word;
};

const PhraseIndex& Index() {
  static const PhraseIndex index = [] {
    PhraseIndex built;
    for (const ClassWord& word : AllClassWords()) {
      built.by_phrase.emplace(word.phrase, &word);
      const std::string_view phrase = word.phrase;
      const auto words =
          static_cast<std::size_t>(1 + std::count(phrase.begin(), phrase.end(), ' '));
      std::size_t& longest = built.longest_by_first_word[phrase.substr(0, phrase.find(' '))];
      longest = std::max(longest, words);
    }
    return built;
  }();
  return index;
}

}  // namespace

ClassWordMatch MatchClassWord(const std::vector<Token>& tokens, std::size_t at) {
  const PhraseIndex& index = Index();
  if (at >= tokens.size() || tokens[at].kind != TokenKind::kWord) return {};
  const std::string first_singular = Singular(tokens[at].text);
  std::size_t limit = 0;
  for (const std::string_view first :
       {std::string_view(tokens[at].text), std::string_view(first_singular)}) {
    const auto entry = index.longest_by_first_word.find(first);
    if (entry != index.longest_by_first_word.end()) limit = std::max(limit, entry->second);
  }
  std::size_t words = 0;
  while (words < limit && at + words < tokens.size() &&
         tokens[at + words].kind == TokenKind::kWord) {
    ++words;
  }
  for (; words > 0; --words) {
    const std::string phrase = JoinWords(tokens, at, at + words);
    if (const auto found = index.by_phrase.find(phrase); found != index.by_phrase.end()) {
      return {found->second, words, false};
    }
    // The plural stands in the last word ("gravel roads") or in the first ("rows of houses").
    const std::string& last = tokens[at + words - 1].text;
    for (const std::string& singular :
         {phrase.substr(0, phrase.size() - last.size()) + Singular(last),
          first_singular + phrase.substr(tokens[at].text.size())}) {
      if (const auto found = index.by_phrase.find(singular); found != index.by_phrase.end()) {
        return {found->second, words, true};
      }
    }
  }
  return {};
}

}  // namespace latticeworld
