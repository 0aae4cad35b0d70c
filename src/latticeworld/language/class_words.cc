#include "latticeworld/language/class_words.h"

#include <algorithm>
#include <string>
#include <unordered_map>

namespace latticeworld {
namespace {

constexpr std::size_t kMaxPhraseWords = 5;

struct PhraseIndex {
  std::unordered_map<std::string_view, const ClassWord*> by_phrase;
  std::unordered_map<std::string, std::size_t> longest_by_first_word;
};

const PhraseIndex& Index() {
  static const PhraseIndex index = [] {
    PhraseIndex built;
    for (const ClassWord& word : AllClassWords()) {
      built.by_phrase.emplace(word.phrase, &word);
      const std::string_view phrase = word.phrase;
      const auto words =
          static_cast<std::size_t>(1 + std::count(phrase.begin(), phrase.end(), ' '));
      std::size_t& longest = built.longest_by_first_word[std::string(
          phrase.substr(0, std::min(phrase.find(' '), phrase.size())))];
      longest = std::max(longest, words);
    }
    return built;
  }();
  return index;
}

}  // namespace

ClassWordMatch MatchClassWord(const std::vector<Token>& tokens, std::size_t at) {
  const PhraseIndex& index = Index();
  std::size_t limit = 0;
  for (const std::string& first : {tokens[at].text, Singular(tokens[at].text)}) {
    const auto entry = index.longest_by_first_word.find(first);
    if (entry != index.longest_by_first_word.end()) limit = std::max(limit, entry->second);
  }
  std::size_t words = 0;
  while (words < std::min(limit, kMaxPhraseWords) && at + words < tokens.size() &&
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
    const std::string last_singular =
        phrase.substr(0, phrase.size() - last.size()) + Singular(last);
    const std::string first_singular =
        Singular(tokens[at].text) + phrase.substr(tokens[at].text.size());
    for (const std::string& singular : {last_singular, first_singular}) {
      if (const auto found = index.by_phrase.find(singular); found != index.by_phrase.end()) {
        return {found->second, words, true};
      }
    }
  }
  return {};
}

}  // namespace latticeworld
