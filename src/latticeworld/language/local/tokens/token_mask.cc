#include "latticeworld/language/local/tokens/token_mask.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

namespace latticeworld {

TokenTree::TokenTree(const Tokenizer& tokenizer) : nodes_(1) {
  for (TokenId token = 0; token < tokenizer.size(); ++token) {
    const std::string& bytes = tokenizer.BytesOf(token);
    if (bytes.empty()) continue;
    std::uint32_t at = 0;
    for (const char c : bytes) {
      const auto [found, fresh] = nodes_[at].children.try_emplace(
          static_cast<unsigned char>(c), static_cast<std::uint32_t>(nodes_.size()));
      const std::uint32_t child = found->second;
      if (fresh) nodes_.emplace_back();
      at = child;
    }
    nodes_[at].tokens.push_back(token);
  }
}

TokenMask::TokenMask(const Grammar& grammar, const Tokenizer& tokenizer, const TokenTree& tree,
                     TokenId end)
    : tokenizer_(tokenizer), tree_(tree), end_(end), matcher_(grammar), state_(matcher_.Begin()) {}

const std::vector<TokenId>& TokenMask::Allowed() {
  const auto known = known_.find(state_);
  if (known != known_.end()) return known->second;
  std::vector<TokenId> allowed;
  if (matcher_.Accepts(state_)) allowed.push_back(end_);
  std::vector<std::pair<std::uint32_t, GrammarMatcher::State>> open = {{0, state_}};
  while (!open.empty()) {
    const auto [at, state] = std::move(open.back());
    open.pop_back();
    const TokenTree::Node& node = tree_.nodes()[at];
    // A token that ends the answer spells nothing, whatever the file says of it.
    std::remove_copy(node.tokens.begin(), node.tokens.end(), std::back_inserter(allowed), end_);
    for (const auto& [byte, child] : node.children) {
      GrammarMatcher::State next = matcher_.After(state, byte);
      if (!next.empty()) open.emplace_back(child, std::move(next));
    }
  }
  std::sort(allowed.begin(), allowed.end());
  return known_.emplace(state_, std::move(allowed)).first->second;
}

void TokenMask::Take(TokenId token) {
  for (const char c : tokenizer_.BytesOf(token))
    state_ = matcher_.After(state_, static_cast<unsigned char>(c));
}

}  // namespace latticeworld
