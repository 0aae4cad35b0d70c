#include "latticeworld/language/grounded/environment/known_spelling.h"

#include <optional>
#include <string>
#include <vector>

#include "latticeworld/language/grounded/environment/word_tables.h"
#include "latticeworld/language/spelling.h"

namespace latticeworld {
namespace {

SpellingDictionary MakeDictionary() {
  const std::vector<std::string> all = AllWords(GetEnvironmentWords());
  std::vector<std::string_view> known = CommonEnglishWords();
  known.insert(known.end(), LayoutWords().begin(), LayoutWords().end());
  return SpellingDictionary({all.begin(), all.end()}, known);
}

}  // namespace

std::string_view MendedWord(std::string_view word) {
  static const SpellingDictionary dictionary = MakeDictionary();
  return dictionary.Correct(word).value_or(std::string_view());
}

}  // namespace latticeworld
