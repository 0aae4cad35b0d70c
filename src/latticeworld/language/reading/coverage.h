#ifndef LATTICEWORLD_LANGUAGE_READING_COVERAGE_H_
#define LATTICEWORLD_LANGUAGE_READING_COVERAGE_H_

#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/language/reading/text_units.h"

namespace latticeworld {

// TextCoverage says how much of a text was read.
struct TextCoverage {
  int words = 0;    // units of the text (text_units.h)
  int carried = 0;  // of them, those that a sentence carries
  // The known units that no sentence carries, as they stand in the text, each once.
  std::vector<std::string> lost;
};

// Counts the units of `text` and those that one of the sentences carries.
TextCoverage CoverageOf(std::string_view text, const std::vector<std::string>& sentences,
                        SentenceKind kind, Vocabulary vocabulary);

// Adds the known words that no sentence carries to those that were not understood, where these do
// not hold them already. What a claim quotes was heard, though nothing that is measured came of it.
void AddLost(const TextCoverage& coverage, const std::vector<std::string>& quotes,
             std::vector<std::string>* not_understood);

// Returns the piece of a text, between two pauses, that says most of a sentence. Where none says
// anything of it, the sentence itself is returned.
std::string QuoteOf(std::string_view text, const std::string& sentence, SentenceKind kind,
                    Vocabulary vocabulary);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_READING_COVERAGE_H_
