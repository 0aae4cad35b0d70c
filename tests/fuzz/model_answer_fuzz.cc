// What a language model says: a layout, an environment, sentences, with anything around them.

#include "fuzz/fuzz_target.h"
#include "latticeworld/language/interpreted/sentences.h"
#include "latticeworld/language/remote/environment_reader.h"
#include "latticeworld/language/remote/json_objects.h"
#include "latticeworld/language/remote/layout_reader.h"
#include "latticeworld/language/remote/thinking_filter.h"

namespace {

using namespace latticeworld;

// A layout is found letter by letter as in one piece.
void ReadLayout(std::string_view answer, Vocabulary vocabulary) {
  LayoutReader whole(vocabulary), by_letter(vocabulary);
  whole.Feed(answer);
  for (std::size_t i = 0; i < answer.size(); ++i) {
    by_letter.Feed(answer.substr(i, 1));
    fuzz::Expect(by_letter.rows() >= 0, "a number of rows is none below 0");
    (void)by_letter.hopeless();
  }
  whole.Finish();
  by_letter.Finish();
  fuzz::Expect(whole.matrix() == by_letter.matrix(), "pieces of an answer make no difference");
  (void)ReadLayoutAnswer(answer, vocabulary);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string_view answer = fuzz::TextOf(data, size);
  switch (fuzz::TakeChoice(&answer, 4)) {
    case 0:
      ReadLayout(answer, Vocabulary::kSuburb);
      break;
    case 1:
      ReadLayout(answer, Vocabulary::kWild);
      break;
    case 2: {
      std::vector<std::string> changes;
      const auto environment = ReadMendedEnvironmentAnswer(answer, *Catalogue::BuiltIn(), &changes);
      fuzz::Expect(!environment.ok() || Validate(*environment).empty(),
                   "an environment that was mended is legal");
      (void)ReadEnvironmentAnswer(answer);
      break;
    }
    default:
      (void)ReadSentences(answer);
      (void)WithoutThinking(answer);
  }
  return 0;
}
