// Free text as instructions of a land and of an environment, as far as a request may carry it, read
// by the rules and as the small language.

#include "fuzz/fuzz_target.h"
#include "latticeworld/language/reading/instruction_reader.h"

namespace {

using namespace latticeworld;

const SymbolicLayout& Meadow() {
  static const SymbolicLayout meadow = {Vocabulary::kSuburb,
                                        Grid<char>(kLayoutSize, kLayoutSize, 'G')};
  return meadow;
}

void Read(InstructionReader* reader, const std::string& text) {
  const Progress progress;
  std::vector<ModelReply> replies;
  LayoutRequest layout;
  layout.instruction = text;
  for (const Vocabulary vocabulary : {Vocabulary::kSuburb, Vocabulary::kWild}) {
    layout.vocabulary = vocabulary;
    if (Validate(layout).ok()) (void)reader->ReadLayout(layout, progress, &replies);
  }
  EnvironmentRequest environment;
  environment.instruction = text;
  environment.layout = &Meadow();
  if (Validate(environment).ok()) (void)reader->ReadEnvironment(environment, progress, &replies);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const auto rules = MakeRuleReader();
  static const auto controlled = MakeControlledReader();
  const std::string text(fuzz::TextOf(data, size));
  Read(rules.get(), text);
  Read(controlled.get(), text);
  return 0;
}
