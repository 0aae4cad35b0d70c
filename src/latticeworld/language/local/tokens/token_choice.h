#ifndef LATTICEWORLD_LANGUAGE_LOCAL_TOKENS_TOKEN_CHOICE_H_
#define LATTICEWORLD_LANGUAGE_LOCAL_TOKENS_TOKEN_CHOICE_H_

#include <optional>
#include <vector>

#include "latticeworld/common/random.h"
#include "latticeworld/language/local/decoding/llama_decoder.h"

namespace latticeworld {

// One of the allowed tokens (increasing): at temperature 0, and where a logit is
// infinity, the one of the highest logit, the first of equals; else drawn by the
// softmax of logits / temperature over the allowed. Tokens whose logit is NaN or
// -infinity are never chosen; none: there are no others.
std::optional<TokenId> ChooseToken(const std::vector<float>& logits,
                                   const std::vector<TokenId>& allowed, double temperature,
                                   RandomStream* random);

// The natural logarithm of the softmax of logits over the allowed tokens, at `chosen`, one of them.
double LogProbability(const std::vector<float>& logits, const std::vector<TokenId>& allowed,
                      TokenId chosen);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_LOCAL_TOKENS_TOKEN_CHOICE_H_
