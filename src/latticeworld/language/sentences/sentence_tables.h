#ifndef LATTICEWORLD_LANGUAGE_SENTENCES_SENTENCE_TABLES_H_
#define LATTICEWORLD_LANGUAGE_SENTENCES_SENTENCE_TABLES_H_

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/language/sentences/pattern.h"

namespace latticeworld {

enum class SentenceKind : std::uint8_t { kLayout, kEnvironment };

// SentenceForm is one of the forms that sentences can have.
struct SentenceForm {
  std::string name;
  Pattern pattern;
  std::string written;  // the pattern as the table has it
  std::string example;  // a sentence, with its stop
};

// Returns the forms of a kind, in the order of data/layout_forms.txt or data/environment_forms.txt.
const std::vector<SentenceForm>& SentenceForms(SentenceKind kind);

// Returns the pattern of a slot of data/slots.txt; nullptr where the slot is a list of words, or
// {n} or {label}.
const Pattern* SlotPattern(std::string_view slot);
// Returns the pattern as the file writes it; "" where SlotPattern returns nullptr.
std::string_view SlotText(std::string_view slot);

// Returns the words of a list of data/words.txt, in its order; a list NAME_s has the plurals of
// NAME. The result is empty for another name.
const std::vector<std::string>& SentenceWords(std::string_view list);

// Returns the English plural of a noun ("beaches", "valleys", "oases", "robotic dogs").
std::string PluralNoun(std::string_view noun);
// Returns the word of a list whose plural `noun` is; `noun` itself where it is the plural of none.
std::string SingularNoun(std::string_view list, std::string_view noun);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_SENTENCES_SENTENCE_TABLES_H_
