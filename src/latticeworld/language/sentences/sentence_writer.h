#ifndef LATTICEWORLD_LANGUAGE_SENTENCES_SENTENCE_WRITER_H_
#define LATTICEWORLD_LANGUAGE_SENTENCES_SENTENCE_WRITER_H_

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "latticeworld/language/sentences/sentence_tables.h"

namespace latticeworld {

// What a slot of a sentence is filled with. Slots of one name are filled in their order.
using Filling = std::pair<std::string_view, std::string>;

// Says a sentence of a form of the tables, with a capital letter and, as SplitSentences gives them,
// without a stop: the words of the form's pattern, its slots filled. What may be missing is said
// where a filling is left for it. A verb agrees with {x}: "forest covers", "the lakes cover". The
// form and a filling for each slot that may not be missing have to be there.
std::string WriteSentence(SentenceKind kind, std::string_view form,
                          const std::vector<Filling>& fillings);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_SENTENCES_SENTENCE_WRITER_H_
