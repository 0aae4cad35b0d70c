#ifndef LATTICEWORLD_LANGUAGE_READING_READING_OF_SENTENCES_H_
#define LATTICEWORLD_LANGUAGE_READING_READING_OF_SENTENCES_H_

#include <string>
#include <vector>

#include "latticeworld/language/generator.h"
#include "latticeworld/language/reading/instruction_reader.h"

namespace latticeworld {

// Returns the reading of a text that was said in sentences of the small language: the plan and the
// claims, which quote the text, how much of the text the sentences carry, and what of it is not
// understood, which is sentences that fit no form and known words that no sentence carries.
LayoutReading ReadingOfSentences(const LayoutRequest& request, std::vector<std::string> sentences);
EnvironmentReading ReadingOfSentences(const EnvironmentRequest& request,
                                      std::vector<std::string> sentences);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_READING_READING_OF_SENTENCES_H_
