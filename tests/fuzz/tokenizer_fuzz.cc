// Texts as tokens: what is written with byte-level pieces alone comes back when it is read.

#include "fuzz/fuzz_target.h"
#include "latticeworld/language/local/tokens/byte_pairs.h"

using latticeworld::fuzz::Expect;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = latticeworld::fuzz::TextOf(data, size);
  for (const bool single_digits : {false, true}) {
    std::string joined;
    for (const std::string_view word : latticeworld::ByteLevelWords(text, single_digits)) {
      Expect(!word.empty(), "no word of a text is empty");
      joined += word;
    }
    Expect(joined == text, "the words of a text are the text");
  }
  (void)latticeworld::BytesOfPiece(text);
  return 0;
}
