#include "latticeworld/language/reading/unread_words.h"

#include <algorithm>
#include <cstddef>

#include "latticeworld/language/class_words.h"
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

}  // namespace latticeworld
