#ifndef LATTICEWORLD_LANGUAGE_SENTENCES_SENTENCE_H_
#define LATTICEWORLD_LANGUAGE_SENTENCES_SENTENCE_H_

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/language/sentences/sentence_tables.h"

namespace latticeworld {

// What a slot of a sentence was filled with, and the slots within it in their order.
struct Phrase {
  std::string slot;
  std::string text;  // its words, parted by blanks
  std::vector<Phrase> parts;

  // The first slot of that name among the parts and what they hold, depth first; nullptr: none.
  const Phrase* Find(std::string_view name) const;
  std::vector<const Phrase*> FindAll(std::string_view name) const;
  bool Has(std::string_view name) const { return Find(name) != nullptr; }
};

// A sentence of the small language.
struct Sentence {
  const SentenceForm* form = nullptr;  // never null
  Phrase whole;                        // of the slot "": all words, all slots

  bool Says(std::string_view word) const;  // whether it is one of the sentence's words
};

// The sentences of a text without their stops and the blanks around them. A stop ends a sentence
// where a blank or the end of the text follows, and so does a line break.
std::vector<std::string> SplitSentences(std::string_view text);

// Reads one sentence, with or without its stop. Case counts for labels alone. nullopt: no form of
// the kind has it.
std::optional<Sentence> ReadSentence(std::string_view text, SentenceKind kind);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_SENTENCES_SENTENCE_H_
