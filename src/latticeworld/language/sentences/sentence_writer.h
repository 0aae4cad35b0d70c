#ifndef LATTICEWORLD_LANGUAGE_SENTENCES_SENTENCE_WRITER_H_
#define LATTICEWORLD_LANGUAGE_SENTENCES_SENTENCE_WRITER_H_

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "latticeworld/language/sentences/sentence_tables.h"

namespace latticeworld {

// Filling names a slot of a sentence and says what it is filled with. Slots of one name are filled
// in their order.
using Filling = std::pair<std::string_view, std::string>;

// Writes a sentence of a form of the tables: the words of the form's pattern with its slots filled,
// with a capital letter and, as SplitSentences gives sentences, without a stop. An optional part is
// written where a filling is left for it. A verb agrees with {x}: "forest covers", "the lakes
// cover". The tables must have the form, and `fillings` one filling for each slot that is not
// optional.
std::string WriteSentence(SentenceKind kind, std::string_view form,
                          const std::vector<Filling>& fillings);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_SENTENCES_SENTENCE_WRITER_H_
