#ifndef LATTICEWORLD_LANGUAGE_SENTENCES_SENTENCE_GUIDE_H_
#define LATTICEWORLD_LANGUAGE_SENTENCES_SENTENCE_GUIDE_H_

#include <string>

#include "latticeworld/language/sentences/sentence_tables.h"

namespace latticeworld {

// The small language in words, for the prompt of a model that does not know it: a form a line, as
// the table writes it, with its example.
std::string FormsInWords(SentenceKind kind);

// What the slots of these forms take, a slot a line: its pattern, or the words of its list.
std::string SlotsInWords(SentenceKind kind);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_SENTENCES_SENTENCE_GUIDE_H_
