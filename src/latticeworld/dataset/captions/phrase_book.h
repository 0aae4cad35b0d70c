#ifndef LATTICEWORLD_DATASET_CAPTIONS_PHRASE_BOOK_H_
#define LATTICEWORLD_DATASET_CAPTIONS_PHRASE_BOOK_H_

#include <array>
#include <cstdint>
#include <initializer_list>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/common/enum_names.h"
#include "latticeworld/common/random.h"
#include "latticeworld/common/result.h"

namespace latticeworld {

// How a person writes.
enum class Voice : std::uint8_t { kTerse, kLiterary, kSpoken, kTechnical };

constexpr std::array<EnumName<Voice>, 4> EnumNames(Voice) {
  return {{{Voice::kTerse, "terse"},
           {Voice::kLiterary, "literary"},
           {Voice::kSpoken, "spoken"},
           {Voice::kTechnical, "technical"}}};
}

// Words to write with: several phrases a key, some for certain voices only (data/*_phrases.txt says
// how a file is written).
class PhraseBook {
 public:
  // Errors: INVALID_ARGUMENT, with every line that is not of the form.
  static Result<PhraseBook> Parse(std::string_view text);
  // The one that is compiled in, of all files of data/.
  static const PhraseBook& BuiltIn();

  bool Has(std::string_view key) const { return phrases_.find(key) != phrases_.end(); }
  // One of the key's phrases for the voice. A key that has none is a bug of the caller.
  const std::string& Pick(std::string_view key, Voice voice, RandomStream* random) const;
  std::vector<std::string> keys() const;
  // All phrases of a key, whatever the voice.
  std::vector<std::string> PhrasesOf(std::string_view key) const;

 private:
  struct Phrase {
    std::string text;
    std::uint8_t voices = 0;  // by bit
  };
  std::map<std::string, std::vector<Phrase>, std::less<>> phrases_;
};

struct Slot {
  std::string_view name;
  std::string text;
};

// The phrase with the slots' texts for {name}, and one of each "[lies|lie]": the first for a
// singular, the second for a plural. A name that no slot has is a bug of the caller.
std::string FillPhrase(std::string_view phrase, const std::vector<Slot>& slots, bool plural);

// The first letter in upper case; the letter before in lower case.
std::string Capitalised(std::string text);
// "seven"; from 13 on in digits.
std::string NumberWord(int number);
// `text` with one letter in so many swapped with its neighbour, doubled or left out, never the
// first of a word, never in a word with a digit.
std::string Mistyped(std::string text, double share_of_words, RandomStream* random);

}  // namespace latticeworld

#endif  // LATTICEWORLD_DATASET_CAPTIONS_PHRASE_BOOK_H_
