// JSON schemas of answers: what is made of one is a grammar.

#include "fuzz/fuzz_target.h"
#include "latticeworld/language/local/tokens/grammar.h"
#include "latticeworld/language/local/tokens/schema_grammar.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto gbnf = latticeworld::SchemaGrammar(latticeworld::fuzz::TextOf(data, size));
  if (!gbnf.ok()) return 0;
  const auto grammar = latticeworld::Grammar::FromGbnf(*gbnf);
  latticeworld::fuzz::Expect(
      grammar.ok() || grammar.status().message().find("nodes") != std::string::npos,
      "what is made of a schema is a grammar, or too large for one");
  return 0;
}
