#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_AGENTS_AGENT_GROUPS_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_AGENTS_AGENT_GROUPS_H_

// This header is for agent_reader.cc and its neighbours only. It has what is kept of the groups of
// agents while they are read.

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "latticeworld/language/grounded/environment/count_reader.h"
#include "latticeworld/language/grounded/environment/heard_environment.h"
#include "latticeworld/language/places.h"

namespace latticeworld::internal {

inline constexpr std::size_t kNone = static_cast<std::size_t>(-1);
inline constexpr std::size_t kPhraseTokens = 6;  // a noun phrase, from its count to its noun
inline constexpr Count kSomeSeen{2, 3, 12, 0};   // what a bare plural stands for

// Whether each of `some` is one of `all`.
inline bool Contains(const std::vector<AgentCategory>& all,
                     const std::vector<AgentCategory>& some) {
  return std::all_of(some.begin(), some.end(), [&](AgentCategory category) {
    return std::find(all.begin(), all.end(), category) != all.end();
  });
}

// Whether a number is said, or a bound: "40", "at most 40", "at least 40".
inline bool SaysNumber(const AgentWish& wish) {
  const bool at_most = wish.least == 1 && wish.quantity > 1 && wish.quantity == wish.most;
  return wish.counted || at_most || wish.most > kMaxAgents;
}

// A group as it is read, with what the reader needs to know of it.
struct Group {
  AgentWish wish;
  std::size_t begin = 0;  // byte of the instruction where its words begin
  std::size_t end = 0;
  std::size_t sentence = 0;
  bool removed = false;
  std::size_t with = kNone;    // beside the group that is at this place in the order of naming
  std::size_t unlike = kNone;  // does something else than the group at that place
  bool inherited = false;      // its place is only that of those it was split off
  int taken = 0;               // so many were split off it under a name of their own
  bool purpose = false;        // only what the world is for ("to see how robots behave")
};

// What a clause says of where its agents are before it names them.
struct Lead {
  bool set = false;
  std::vector<Place> places;
  std::optional<FeaturePlace> feature;
  bool each = false;
  std::size_t with = kNone;  // as the group of that place
  std::size_t end = kNone;   // the token after its words
};

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_AGENTS_AGENT_GROUPS_H_
