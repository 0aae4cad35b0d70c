#ifndef LATTICEWORLD_LANGUAGE_SENTENCES_SENTENCE_GUIDE_H_
#define LATTICEWORLD_LANGUAGE_SENTENCES_SENTENCE_GUIDE_H_

#include <string>

#include "latticeworld/language/sentences/sentence_tables.h"

namespace latticeworld {

// Describes the small language for the prompt of a model that does not know it: a line for each
// form, as the table writes it, with its example.
std::string FormsInWords(SentenceKind kind);

// Describes what the slots of these forms take: a line for each slot, with its pattern or the words
// of its list.
std::string SlotsInWords(SentenceKind kind);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_SENTENCES_SENTENCE_GUIDE_H_
