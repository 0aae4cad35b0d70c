#include "latticeworld/language/local/tokens/grammar.h"

#include <algorithm>
#include <unordered_set>
#include <utility>

namespace latticeworld {
namespace {

using Node = Grammar::Node;

// Rules within rules; what a grammar of answers has stays far below, and left
// recursion ends here.
constexpr std::size_t kMostStacks = 1u << 20;
constexpr std::size_t kMostReached = 1u << 14;

std::uint64_t Both(std::uint32_t high, std::uint32_t low) {
  return std::uint64_t{high} << 32 | low;
}

}  // namespace

std::uint32_t GrammarMatcher::Push(Grammar::NodeId node, std::uint32_t below) {
  const auto [found, fresh] =
      known_.try_emplace(Both(node, below), static_cast<std::uint32_t>(stacks_.size()));
  if (fresh) stacks_.push_back({node, below});
  return found->second;
}

GrammarMatcher::State GrammarMatcher::Reach(std::vector<Thread> open) {
  State state;
  std::unordered_set<std::uint64_t> seen;
  const auto see = [&](Thread thread) {
    return seen.insert(Both(thread.node, thread.stack)).second;
  };
  for (const Thread& thread : open) see(thread);
  const auto visit = [&](Thread next) {
    if (seen.size() < kMostReached && see(next)) open.push_back(next);
  };
  while (!open.empty()) {
    const Thread at = open.back();
    open.pop_back();
    const Node& node = grammar_.nodes()[at.node];
    switch (node.kind) {
      case Node::Kind::kBytes:
        state.push_back(at);
        break;
      case Node::Kind::kSplit:
        visit({node.next, at.stack});
        visit({node.other, at.stack});
        break;
      case Node::Kind::kCall:
        if (stacks_.size() < kMostStacks) visit({node.other, Push(node.next, at.stack)});
        break;
      case Node::Kind::kReturn:
        if (at.stack == 0) {
          state.push_back(at);
        } else {
          visit({stacks_[at.stack].node, stacks_[at.stack].below});
        }
        break;
    }
  }
  std::sort(state.begin(), state.end());
  return state;
}

GrammarMatcher::State GrammarMatcher::Begin() { return Reach({{grammar_.root(), 0}}); }

GrammarMatcher::State GrammarMatcher::After(const State& state, unsigned char byte) {
  // All at once, so that the limit holds for the byte and not for each way of having read it.
  std::vector<Thread> next;
  for (const Thread& thread : state) {
    const Node& node = grammar_.nodes()[thread.node];
    if (node.kind == Node::Kind::kBytes && grammar_.bytes(node.bytes)[byte])
      next.push_back({node.next, thread.stack});
  }
  std::sort(next.begin(), next.end());
  next.erase(std::unique(next.begin(), next.end()), next.end());
  return Reach(std::move(next));
}

bool GrammarMatcher::Accepts(const State& state) const {
  return std::any_of(state.begin(), state.end(), [&](const Thread& thread) {
    return grammar_.nodes()[thread.node].kind == Node::Kind::kReturn;
  });
}

}  // namespace latticeworld
