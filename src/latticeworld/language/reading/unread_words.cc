#include "latticeworld/language/reading/unread_words.h"

#include <algorithm>
#include <cstddef>
#include <unordered_set>

#include "latticeworld/language/class_words.h"
#include "latticeworld/language/spelling.h"
#include "latticeworld/language/tokens.h"

namespace latticeworld {
namespace {

bool SpeaksOf(const LayoutPlan& plan, char letter) {
  return std::any_of(plan.features.begin(), plan.features.end(),
                     [&](const PlannedFeature& feature) { return feature.letter == letter; }) ||
         std::any_of(plan.absences.begin(), plan.absences.end(),
                     [&](const PlannedAbsence& absence) { return absence.letter == letter; });
}

}  // namespace

std::vector<std::string> UnreadLand(std::string_view text, const LayoutPlan& plan) {
  const std::vector<Token> tokens = Tokenize(text);
  std::vector<std::string> words;
  std::string told;
  for (std::size_t at = 0; at < tokens.size();) {
    const ClassWordMatch match = MatchClassWord(tokens, at);
    if (match.word == nullptr) {
      ++at;
      continue;
    }
    const char letter = match.word->LetterIn(plan.vocabulary);
    const bool known = letter == '\0' || !match.word->IsExactIn(plan.vocabulary) ||
                       SpeaksOf(plan, letter) || told.find(letter) != std::string::npos;
    if (!known) {
      const std::size_t begin = tokens[at].begin;
      words.emplace_back(text.substr(begin, tokens[at + match.tokens - 1].end - begin));
      told += letter;
    }
    at += match.tokens;
  }
  return words;
}

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
