#ifndef LATTICEWORLD_LANGUAGE_SENTENCES_SENTENCE_H_
#define LATTICEWORLD_LANGUAGE_SENTENCES_SENTENCE_H_

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/language/sentences/sentence_tables.h"

namespace latticeworld {

// Phrase is what a slot of a sentence was filled with, and the slots within it in their order.
struct Phrase {
  std::string slot;
  std::string text;  // its words, parted by blanks
  std::vector<Phrase> parts;

  // Find returns the first slot of that name among the parts and what they hold, depth first, or
  // nullptr; FindAll returns all of them in that order.
  const Phrase* Find(std::string_view name) const;
  std::vector<const Phrase*> FindAll(std::string_view name) const;
  bool Has(std::string_view name) const { return Find(name) != nullptr; }
};

// Sentence is a sentence of the small language, read.
struct Sentence {
  const SentenceForm* form = nullptr;  // never null
  Phrase whole;                        // of the slot "": all words, all slots

  bool Says(std::string_view word) const;  // whether it is one of the sentence's words
};

// Returns the sentences of a text, without their stops and the blanks around them. A stop ends a
// sentence where a blank or the end of the text follows, and so does a line break.
std::vector<std::string> SplitSentences(std::string_view text);

// Reads one sentence, with or without its stop. Upper and lower case count for labels alone.
// Returns nullopt where the sentence fits no form of the kind.
std::optional<Sentence> ReadSentence(std::string_view text, SentenceKind kind);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_SENTENCES_SENTENCE_H_
