#ifndef LATTICEWORLD_LANGUAGE_SENTENCES_SENTENCE_GRAMMAR_H_
#define LATTICEWORLD_LANGUAGE_SENTENCES_SENTENCE_GRAMMAR_H_

#include <string>

#include "latticeworld/language/sentences/sentence_tables.h"

namespace latticeworld {

// A model may answer with so many sentences at most.
inline constexpr int kMostSentences = 64;

// Returns a grammar in llama.cpp's notation (GBNF). It allows up to kMostSentences sentences of a
// kind, parted by blanks, each with a capital letter and a stop, or a dash where there is nothing
// to say.
std::string SentenceGrammar(SentenceKind kind);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_SENTENCES_SENTENCE_GRAMMAR_H_
