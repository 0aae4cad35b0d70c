#ifndef LATTICEWORLD_LANGUAGE_SENTENCES_SENTENCE_MATCHER_H_
#define LATTICEWORLD_LANGUAGE_SENTENCES_SENTENCE_MATCHER_H_

#include <bitset>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/language/sentences/pattern.h"
#include "latticeworld/language/sentences/sentence.h"

namespace latticeworld {

// SentenceMatcher finds how patterns cover the words of one sentence. Where the slots of the tables
// can end is found once for each place of the sentence and serves all patterns, so that a sentence
// of no form is known as one without trying the ways through each of them.
class SentenceMatcher {
 public:
  static constexpr std::size_t kMostWords = 64;

  // A sentence without words, or of more than kMostWords, matches nothing.
  explicit SentenceMatcher(std::string_view sentence);

  // Returns the slots of the sentence if the pattern covers it from its first word to its last.
  std::optional<Phrase> Match(const Pattern& pattern);

 private:
  struct Word {
    std::string text;  // lower case
    std::string written;
  };
  // A set of places between words: 0 before the first, words_.size() after the last.
  using Places = std::bitset<kMostWords + 1>;
  // What is to be tried once a part has covered the words before `end`.
  using Then = std::function<bool(std::size_t end)>;

  static std::vector<Word> WordsOf(std::string_view sentence);
  std::string TextOf(std::size_t begin, std::size_t end) const;

  Places EndsOf(const Pattern& pattern, const Places& begins);
  const Places& EndsOfSlot(const std::string& slot, std::size_t at);
  Places FindEndsOfSlot(const std::string& slot, std::size_t at);
  // Returns where the phrase of a list ends if it stands at `at`, else `at`.
  std::size_t EndOf(std::string_view phrase, std::size_t at) const;

  // Every way in which the pattern covers words from `at` on is offered to `then`, until one is
  // taken. The slots of the way that is taken stay in `into`.
  bool Try(const Pattern& pattern, std::size_t at, Phrase* into, const Then& then);
  bool TrySequence(const Pattern& pattern, std::size_t part, std::size_t at, Phrase* into,
                   const Then& then);
  bool TrySlot(const std::string& slot, std::size_t at, Phrase* into, const Then& then);
  bool Take(const std::string& slot, std::size_t at, std::size_t end, Phrase* into,
            const Then& then);

  const std::vector<Word> words_;
  std::vector<std::map<std::string, Places, std::less<>>> ends_of_slots_;  // at each word
  std::vector<std::size_t> labels_;  // which words are labels on the way that is tried
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_SENTENCES_SENTENCE_MATCHER_H_
