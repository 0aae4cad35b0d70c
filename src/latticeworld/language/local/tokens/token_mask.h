#ifndef LATTICEWORLD_LANGUAGE_LOCAL_TOKENS_TOKEN_MASK_H_
#define LATTICEWORLD_LANGUAGE_LOCAL_TOKENS_TOKEN_MASK_H_

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "latticeworld/language/local/tokens/grammar.h"
#include "latticeworld/language/local/tokens/tokenizer.h"

namespace latticeworld {

// The tokens that spell bytes, as a tree of their first bytes, so that all that
// a grammar allows are found without trying each.
class TokenTree {
 public:
  explicit TokenTree(const Tokenizer& tokenizer);

  struct Node {
    std::vector<TokenId> tokens;  // that are spelled so
    std::map<unsigned char, std::uint32_t> children;
  };
  const std::vector<Node>& nodes() const { return nodes_; }  // [0]: the root

 private:
  std::vector<Node> nodes_;
};

// Keeps a model's answer within a grammar: which tokens may come next, and
// which did.
class TokenMask {
 public:
  // All outlive it. end: the token that ends an answer.
  TokenMask(const Grammar& grammar, const Tokenizer& tokenizer, const TokenTree& tree, TokenId end);

  // Those that keep the text one that can still be ended; increasing. The token
  // of the end is among them where the text may end. Never empty, but where
  // only bytes that no token spells would do.
  const std::vector<TokenId>& Allowed();
  // token: an allowed one, not that of the end.
  void Take(TokenId token);

 private:
  const Tokenizer& tokenizer_;
  const TokenTree& tree_;
  const TokenId end_;
  GrammarMatcher matcher_;
  GrammarMatcher::State state_;
  std::map<GrammarMatcher::State, std::vector<TokenId>> known_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_LOCAL_TOKENS_TOKEN_MASK_H_
