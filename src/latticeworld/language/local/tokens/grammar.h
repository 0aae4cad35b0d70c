#ifndef LATTICEWORLD_LANGUAGE_LOCAL_TOKENS_GRAMMAR_H_
#define LATTICEWORLD_LANGUAGE_LOCAL_TOKENS_GRAMMAR_H_

#include <bitset>
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "latticeworld/common/result.h"

namespace latticeworld {

// A set of texts, as an automaton over bytes whose rules call each other (a
// recursive transition network: Woods 1970).
class Grammar {
 public:
  using Bytes = std::bitset<256>;
  using NodeId = std::uint32_t;
  struct Node {
    enum class Kind : std::uint8_t { kBytes, kSplit, kCall, kReturn };
    Kind kind = Kind::kReturn;
    std::uint32_t bytes = 0;  // of kBytes: index of the set that may stand here
    NodeId next = 0;          // after it; of kSplit one of the two ways
    NodeId other = 0;         // of kSplit the second way; of kCall where the called rule begins
  };

  // llama.cpp's notation: `name ::= ...`, the whole text being `root`;
  // "literals", [classes] and
  // [^classes] of single bytes, groups, |, ?, *, +, {n}, {n,}, {n,m}, comments
  // from # on. Errors: INVALID_ARGUMENT naming the line and what is wrong: what
  // is not of the notation, rules that are not there, more than a million
  // nodes.
  static Result<Grammar> FromGbnf(std::string_view text);

  const std::vector<Node>& nodes() const { return nodes_; }
  const Bytes& bytes(std::uint32_t index) const { return sets_[index]; }
  NodeId root() const { return root_; }

 private:
  friend class GrammarBuilder;
  std::vector<Node> nodes_;
  std::vector<Bytes> sets_;
  NodeId root_ = 0;
};

// Follows texts that a grammar allows, byte by byte: it keeps where in the grammar they may stand
// after the bytes so far. One thread owns it.
class GrammarMatcher {
 public:
  // One way of having read the bytes so far: the node that awaits the next byte
  // (or the end of root), and where the rules around it go on, as an index of
  // stacks_.
  struct Thread {
    Grammar::NodeId node = 0;
    std::uint32_t stack = 0;
    bool operator==(const Thread& other) const {
      return node == other.node && stack == other.stack;
    }
    bool operator<(const Thread& other) const {
      return node < other.node || (node == other.node && stack < other.stack);
    }
  };
  using State = std::vector<Thread>;  // sorted, each once; empty: no text goes
                                      // on like that

  // The grammar outlives it.
  explicit GrammarMatcher(const Grammar& grammar) : grammar_(grammar), stacks_{{0, 0}} {}

  State Begin();
  State After(const State& state, unsigned char byte);
  // Whether the text may end here.
  bool Accepts(const State& state) const;

 private:
  struct Frame {
    Grammar::NodeId node = 0;  // where it goes on
    std::uint32_t below = 0;
  };
  // All that wait for a byte from there on.
  State Reach(std::vector<Thread> open);
  std::uint32_t Push(Grammar::NodeId node, std::uint32_t below);

  const Grammar& grammar_;
  std::vector<Frame> stacks_;                               // [0]: the empty one
  std::unordered_map<std::uint64_t, std::uint32_t> known_;  // the indices of frames, by both parts
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_LOCAL_TOKENS_GRAMMAR_H_
