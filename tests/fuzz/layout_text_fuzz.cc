// Layouts as text (SymbolicLayout): what is read is written as it was read.

#include "fuzz/fuzz_target.h"
#include "latticeworld/layout/symbolic_layout.h"

using latticeworld::ParseLayout;
using latticeworld::Vocabulary;
using latticeworld::fuzz::Expect;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = latticeworld::fuzz::TextOf(data, size);
  for (const Vocabulary vocabulary : {Vocabulary::kSuburb, Vocabulary::kWild}) {
    const auto layout = ParseLayout(text, vocabulary);
    if (!layout.ok()) continue;
    const auto again = ParseLayout(ToText(*layout), vocabulary);
    Expect(again.ok() && ToText(*again) == ToText(*layout), "a layout is written as it was read");
  }
  return 0;
}
