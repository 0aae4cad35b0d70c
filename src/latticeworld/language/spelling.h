#ifndef LATTICEWORLD_LANGUAGE_SPELLING_H_
#define LATTICEWORLD_LANGUAGE_SPELLING_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace latticeworld {

// Reads a mistyped word as the one word that was most likely meant, and rather not at all than
// wrongly. Distance is that of Damerau ("A technique for computer detection and correction of
// spelling errors", 1964) in its restricted form: letters put in, left out, changed, or two
// neighbours swapped.
class SpellingDictionary {
 public:
  // Lower case words: what may be meant, and what else is no mistake. Both are copied.
  explicit SpellingDictionary(const std::vector<std::string_view>& words,
                              const std::vector<std::string_view>& known = {});

  // Whether the word, or the word less a regular English ending, is in the dictionary.
  bool Knows(std::string_view word) const;

  // Returns the word that was meant by one that the dictionary does not know: at distance 1, for
  // words of nine letters and more also 2; a word of four letters only by a swap of two, or where a
  // letter was left out. The first letter is right, or swapped with the second. If several words
  // are one edit away, the likeliest edit wins. nullopt for known words, for shorter ones, where
  // two words are as good (but for a word and its plural), and where nothing is near. The view is
  // of this dictionary.
  std::optional<std::string_view> Correct(std::string_view word) const;

 private:
  bool Has(std::string_view word) const { return all_.count(word) > 0; }

  // A word with one letter doubled by mistake.
  std::optional<std::string_view> Undoubled(std::string_view word) const;

  std::vector<std::string> words_;  // sorted
  std::vector<std::string> known_;
  std::unordered_set<std::string_view> all_;
  struct Entry {
    std::size_t index;      // into words_
    std::uint32_t letters;  // which it holds, a bit each
  };
  // The words by their first letter and length.
  std::unordered_map<std::size_t, std::vector<Entry>> by_start_;
};

// Every word of data/class_words.txt (with plurals) and data/layout_words.txt.
const std::vector<std::string_view>& LayoutWords();
// data/english_words.txt.
const std::vector<std::string_view>& CommonEnglishWords();

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_SPELLING_H_
