#include "latticeworld/language/grounded/environment/known_spelling.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/language/grounded/environment/word_tables.h"
#include "latticeworld/language/spelling.h"

namespace latticeworld {
namespace {

// Words of numbers and of orders, which no table of words has.
constexpr std::string_view kOtherWords[] = {
    "three",    "seven",    "eight",   "twelve",   "thirteen", "fourteen", "fifteen", "sixteen",
    "eighteen", "nineteen", "twenty",  "thirty",   "forty",    "fifty",    "sixty",   "seventy",
    "eighty",   "ninety",   "hundred", "thousand", "dozen",    "quarter",  "percent", "cancel",
    "remove",   "wheels",   "wheel",   "rotors",   "rotated",  "between",  "corners", "corner"};

std::vector<std::string> MeantWords() {
  std::vector<std::string> words = AllWords(GetEnvironmentWords());
  words.insert(words.end(), std::begin(kOtherWords), std::end(kOtherWords));
  return words;
}

SpellingDictionary MakeDictionary(const std::vector<std::string>& meant) {
  std::vector<std::string_view> known = CommonEnglishWords();
  known.insert(known.end(), LayoutWords().begin(), LayoutWords().end());
  return SpellingDictionary({meant.begin(), meant.end()}, known);
}

// "froest": two letters of a word swapped, where it looks like the superlative of a short one.
std::string_view Unswapped(const std::vector<std::string>& meant, std::string_view word) {
  constexpr std::size_t kLength = 6;
  if (word.size() != kLength || word.substr(kLength - 3) != "est") return {};
  if (std::find(meant.begin(), meant.end(), word) != meant.end()) return {};
  for (std::size_t i = 1; i + 1 < word.size(); ++i) {
    std::string swapped(word);
    std::swap(swapped[i], swapped[i + 1]);
    const auto found = std::find(meant.begin(), meant.end(), swapped);
    if (swapped != word && found != meant.end()) return *found;
  }
  return {};
}

}  // namespace

std::string_view MendedWord(std::string_view word) {
  static const std::vector<std::string> meant = MeantWords();
  static const SpellingDictionary dictionary = MakeDictionary(meant);
  if (const std::string_view swapped = Unswapped(meant, word); !swapped.empty()) return swapped;
  return dictionary.Correct(word).value_or(std::string_view());
}

}  // namespace latticeworld
