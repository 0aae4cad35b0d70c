#include "latticeworld/language/reading/foreign_text.h"

#include <cstddef>
#include <unordered_set>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/spelling.h"
#include "latticeworld/language/tokens.h"

namespace latticeworld {
bool SeemsForeign(std::string_view text) {
  constexpr std::size_t kLeastWords = 4;
  constexpr double kLeastKnown = 0.35;
  static const std::unordered_set<std::string_view> common(CommonEnglishWords().begin(),
                                                           CommonEnglishWords().end());
  const std::vector<Token> tokens = Tokenize(text);
  std::size_t words = 0;
  std::size_t known = 0;
  for (std::size_t at = 0; at < tokens.size(); ++at) {
    if (tokens[at].kind != TokenKind::kWord) continue;
    ++words;
    const bool is_known =
        common.count(tokens[at].text) > 0 || MatchClassWord(tokens, at).word != nullptr;
    if (is_known) ++known;
  }
  return words >= kLeastWords &&
         static_cast<double>(known) < kLeastKnown * static_cast<double>(words);
}

}  // namespace latticeworld
