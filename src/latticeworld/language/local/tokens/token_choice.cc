#include "latticeworld/language/local/tokens/token_choice.h"

#include <cmath>
#include <limits>

namespace latticeworld {

std::optional<TokenId> ChooseToken(const std::vector<float>& logits,
                                   const std::vector<TokenId>& allowed, double temperature,
                                   RandomStream* random) {
  std::optional<TokenId> best;
  float highest = -std::numeric_limits<float>::infinity();
  for (const TokenId token : allowed) {
    if (!(logits[token] > highest)) continue;  // nor is NaN
    highest = logits[token];
    best = token;
  }
  if (!best || temperature <= 0.0 || allowed.size() == 1 || !std::isfinite(highest)) return best;
  std::vector<double> weights;
  weights.reserve(allowed.size());
  for (const TokenId token : allowed) {
    const double below = (double{logits[token]} - highest) / temperature;
    weights.push_back(below <= 0.0 ? std::exp(below) : 0.0);
  }
  return allowed[random->Weighted(weights)];
}

double LogProbability(const std::vector<float>& logits, const std::vector<TokenId>& allowed,
                      TokenId chosen) {
  double sum = 0.0;
  for (const TokenId token : allowed) {
    const double above = double{logits[token]} - logits[chosen];
    if (!std::isnan(above)) sum += std::exp(above);
  }
  return -std::log(sum);
}

}  // namespace latticeworld
