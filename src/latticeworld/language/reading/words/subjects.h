#ifndef LATTICEWORLD_LANGUAGE_READING_WORDS_SUBJECTS_H_
#define LATTICEWORLD_LANGUAGE_READING_WORDS_SUBJECTS_H_

#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/language/generator.h"
#include "latticeworld/language/sentences/sentence_tables.h"

namespace latticeworld {

// People describe a place in one text: land, weather, who is there. A model that was taught texts
// of land and texts of environments apart takes the one for the other; so each sentence is given to
// those of the two readers that it may be for.

// Returns the sentences of free text with the blanks behind them: joined they are the text. One
// ends with . ! ? or ; before a blank, or with a line.
std::vector<std::string_view> FreeSentences(std::string_view text);

// Returns the text without the sentences that are clearly of the other kind and have no word that
// strongly speaks for this one (data/subject_words.txt, made of the examples that the reader was
// taught). The result is blank where all are.
std::string TextOf(SentenceKind kind, std::string_view text);
// Returns what is read of the environment: its instruction, or where that is blank the sentences of
// the layout's that rather speak of an environment than of land, and are none of the small
// language.
std::string EnvironmentText(std::string_view layout_instruction,
                            std::string_view environment_instruction);

// Returns warnings, at most one of either, of the sentences of two instructions that nobody reads:
// they are left out of their own, and do not stand in the other one, which is not blank.
std::vector<std::string> WarningsOfUnread(std::string_view layout_instruction,
                                          std::string_view environment_instruction);

// Returns the request with the text of its kind as its instruction.
LayoutRequest OfItsKind(LayoutRequest request);
EnvironmentRequest OfItsKind(EnvironmentRequest request);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_READING_WORDS_SUBJECTS_H_
