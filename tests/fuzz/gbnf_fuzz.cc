// Grammars in llama.cpp's notation. A line of dashes ends the grammar; what follows is matched
// against it.

#include <algorithm>

#include "fuzz/fuzz_target.h"
#include "latticeworld/language/local/tokens/grammar.h"

using latticeworld::Grammar;
using latticeworld::GrammarMatcher;
using latticeworld::fuzz::Expect;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::string_view kEnd = "\n---\n";
  constexpr std::size_t kMostMatched = 64;
  const std::string_view text = latticeworld::fuzz::TextOf(data, size);
  const std::size_t end = std::min(text.find(kEnd), text.size());
  const auto grammar = Grammar::FromGbnf(text.substr(0, end));
  if (!grammar.ok()) return 0;
  for (const Grammar::Node& node : grammar->nodes()) {
    Expect(node.next < grammar->nodes().size() && node.other < grammar->nodes().size(),
           "a grammar's nodes lead to nodes");
  }
  GrammarMatcher matcher(*grammar);
  GrammarMatcher::State state = matcher.Begin();
  const std::string_view rest = text.substr(std::min(end + kEnd.size(), text.size()));
  for (const char byte : rest.substr(0, kMostMatched)) {
    (void)matcher.Accepts(state);
    state = matcher.After(state, static_cast<unsigned char>(byte));
    if (state.empty()) break;
  }
  return 0;
}
