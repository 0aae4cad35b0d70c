#ifndef LATTICEWORLD_LANGUAGE_READING_COVERAGE_H_
#define LATTICEWORLD_LANGUAGE_READING_COVERAGE_H_

#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/language/reading/text_units.h"

namespace latticeworld {

// TextCoverage says how much of a text was read.
struct TextCoverage {
  int words = 0;    // units of the text (text_units.h)
  int carried = 0;  // of them, those that a sentence carries
  // The known units that nothing carries, as they stand in the text, each once.
  std::vector<std::string> lost;
  std::set<std::string> keys;  // of what carries
};

// Counts the units of `text` and those that are carried: one of their keys is among `keys`, which
// are those of sentences (text_units.h) or of claims (claim_coverage.h).
TextCoverage CoverageOfKeys(std::string_view text, std::set<std::string> keys, SentenceKind kind,
                            Vocabulary vocabulary);
// Counts those that one of the sentences carries.
TextCoverage CoverageOf(std::string_view text, const std::vector<std::string>& sentences,
                        SentenceKind kind, Vocabulary vocabulary);

// Adds the known words that nothing carries to those that were not understood, where these do not
// hold them already. What a warning quotes is told there.
void AddLost(const TextCoverage& coverage, const std::vector<std::string>& warnings,
             std::vector<std::string>* not_understood);

// Takes off what was not understood all words of which are carried by now.
void TakeOffCarried(const TextCoverage& coverage, SentenceKind kind, Vocabulary vocabulary,
                    std::vector<std::string>* not_understood);

// QuotedText finds the words of a text that sentences of the small language come from.
class QuotedText {
 public:
  QuotedText(std::string_view text, SentenceKind kind, Vocabulary vocabulary);

  // Returns the piece of the text, between two pauses, that says most of a sentence. Where none
  // says anything of it, the sentence itself is returned.
  std::string QuoteOf(const std::string& sentence) const;

 private:
  const std::string text_;
  const SentenceKind kind_;
  const Vocabulary vocabulary_;
  const std::vector<TextUnit> units_;
  const std::vector<std::size_t> stops_;  // where pauses are, then the text's end [bytes]
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_READING_COVERAGE_H_
