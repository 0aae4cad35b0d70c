#ifndef LATTICEWORLD_LANGUAGE_SENTENCES_SENTENCE_GRAMMAR_H_
#define LATTICEWORLD_LANGUAGE_SENTENCES_SENTENCE_GRAMMAR_H_

#include <string>

#include "latticeworld/language/sentences/sentence_tables.h"

namespace latticeworld {

// The most sentences that a model may answer with.
inline constexpr int kMostSentences = 64;

// The grammar, in llama.cpp's notation (GBNF), of up to kMostSentences sentences of a kind, parted
// by blanks, each with a capital letter and a stop; or of a dash, where there is nothing to say.
std::string SentenceGrammar(SentenceKind kind);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_SENTENCES_SENTENCE_GRAMMAR_H_
