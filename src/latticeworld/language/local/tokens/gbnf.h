#ifndef LATTICEWORLD_LANGUAGE_LOCAL_TOKENS_GBNF_H_
#define LATTICEWORLD_LANGUAGE_LOCAL_TOKENS_GBNF_H_

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/language/local/tokens/grammar.h"

namespace latticeworld {

// What stands on the right of a rule, as it is written.
struct GrammarExpression {
  enum class Kind : std::uint8_t { kBytes, kRule, kSequence, kChoice, kRepeat };
  Kind kind = Kind::kSequence;
  Grammar::Bytes bytes;
  std::string rule;
  int line = 0;
  std::vector<GrammarExpression> parts;
  int least = 0;
  int most = 0;  // -1: no limit
};

// The rules of a grammar in llama.cpp's notation, by name. Errors: as Grammar::FromGbnf.
Result<std::map<std::string, GrammarExpression>> ParseGbnf(std::string_view text);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_LOCAL_TOKENS_GBNF_H_
