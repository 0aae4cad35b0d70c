#ifndef LATTICEWORLD_LANGUAGE_SENTENCES_PATTERN_H_
#define LATTICEWORLD_LANGUAGE_SENTENCES_PATTERN_H_

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/common/result.h"

namespace latticeworld {

// Pattern says what may stand at one place of a sentence; data/slots.txt describes how a pattern is
// written.
struct Pattern {
  enum class Kind : std::uint8_t {
    kWords,     // one of `words`, each a single token
    kSlot,      // what the slot `name` takes
    kSequence,  // all `parts`, one after the other
    kChoice,    // one of `parts`
    kOptional,  // parts[0] or nothing
    kRepeat,    // parts[0], any number of times
  };
  Kind kind = Kind::kSequence;
  std::vector<std::string> words;
  std::string name;
  std::vector<Pattern> parts;
};

// Reads a pattern. Errors: INVALID_ARGUMENT that quotes the pattern and names what is wrong:
// brackets without their fellow, nothing between them, a slot without a name.
Result<Pattern> ParsePattern(std::string_view text);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_SENTENCES_PATTERN_H_
