// The small language: any text is split into sentences, and each is read or is none.

#include "fuzz/fuzz_target.h"
#include "latticeworld/language/sentences/sentence.h"

using latticeworld::ReadSentence;
using latticeworld::SentenceKind;
using latticeworld::fuzz::Expect;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  for (const std::string& text :
       latticeworld::SplitSentences(latticeworld::fuzz::TextOf(data, size))) {
    for (const SentenceKind kind : {SentenceKind::kLayout, SentenceKind::kEnvironment}) {
      const auto sentence = ReadSentence(text, kind);
      if (!sentence) continue;
      const auto again = ReadSentence(sentence->whole.text, kind);
      Expect(again.has_value() && again->form == sentence->form,
             "the words of a sentence are a sentence of the same form");
    }
  }
  return 0;
}
