#include "latticeworld/language/reading/text_warnings.h"

#include <cstddef>
#include <cstdlib>
#include <unordered_set>

#include "latticeworld/common/text.h"
#include "latticeworld/language/reading/text_units.h"
#include "latticeworld/language/spelling.h"
#include "latticeworld/language/tokens.h"

namespace latticeworld {
namespace {

bool SeemsForeign(std::string_view text, const std::vector<Token>& tokens, SentenceKind kind) {
  constexpr std::size_t kLeastWords = 4;
  constexpr double kLeastKnown = 0.35;
  static const std::unordered_set<std::string_view> common(CommonEnglishWords().begin(),
                                                           CommonEnglishWords().end());
  std::size_t words = 0;
  std::size_t known = 0;
  for (const TextUnit& unit : UnitsOf(text, kind, Vocabulary::kSuburb)) {
    for (const Token& token : tokens) {
      if (token.kind != TokenKind::kWord) continue;
      if (token.begin < unit.begin || token.end > unit.end) continue;
      ++words;
      if (unit.known || common.count(token.text) > 0) ++known;
    }
  }
  return words >= kLeastWords &&
         static_cast<double>(known) < kLeastKnown * static_cast<double>(words);
}

}  // namespace

void WarnOfText(std::string_view text, SentenceKind kind, std::vector<std::string>* warnings) {
  std::vector<std::string> of_text;
  const std::vector<Token> tokens = Tokenize(text);
  if (SeemsForeign(text, tokens, kind)) {
    of_text.push_back("the text does not seem to be English, which alone is read well: " +
                      Quote(std::string(text)));
  }
  for (std::size_t i = 0; kind == SentenceKind::kLayout && i + 1 < tokens.size(); ++i) {
    const bool is_share = tokens[i].kind == TokenKind::kNumber && tokens[i + 1].text == "percent";
    if (!is_share || std::strtod(tokens[i].text.c_str(), nullptr) <= 100.0) continue;
    of_text.push_back(
        Quote(std::string(text.substr(tokens[i].begin, tokens[i + 1].end - tokens[i].begin))) +
        " is more than the whole: shares are 0 to 100 %, and 100 % is taken");
  }
  warnings->insert(warnings->begin(), of_text.begin(), of_text.end());
}

}  // namespace latticeworld
