#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_AGENTS_AGENT_PHRASES_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_AGENTS_AGENT_PHRASES_H_

// This header is for agent_reader.cc and its neighbours only. It has phrases about agents as they
// are taken apart before anything is made of them.

#include <cstddef>
#include <optional>

#include "latticeworld/language/grounded/environment/agents/agent_groups.h"
#include "latticeworld/language/grounded/environment/count_reader.h"
#include "latticeworld/language/grounded/environment/heard_environment.h"
#include "latticeworld/language/places.h"

namespace latticeworld::internal {

// "half", "a third", "two thirds" of a group.
struct Fraction {
  int parts = 1;
  int of = 1;
  std::size_t tokens = 0;  // 0: no such share
};

// Words in a phrase of company that go back to a group: "next to them".
struct Reference {
  std::size_t tokens = 0;  // 0: no reference
  std::size_t group = kNone;
  bool land = false;  // may be of land just as well
  bool plural = false;
};

// A count without a noun of its own, with what stands behind it: "six of them", "50 in all".
struct LoneCount {
  Count count;              // of agents: "two pairs" are four
  std::size_t next = 0;     // the token after the number
  std::size_t of_them = 0;  // the tokens of "of them"
  std::size_t more = 0;     // the tokens of "more", "heads", "in all"
  bool heads = false;       // "heads", "members"
  bool each = false;        // so many are at each place
  std::size_t tokens = 0;   // all that it takes, number and all
  bool bare = false;        // nothing follows in its phrase

  bool IsPlain() const { return of_them == 0 && more == 0; }
};

// Words that say where agents are: "in each corner", "on the western shore of the lake".
struct PlacePhrase {
  std::size_t end = 0;  // the token after it; 0: there is no such phrase
  PlaceMatch place;
  std::optional<FeaturePlace> feature;
  bool each = false;     // each of the places has so many
  bool listed = false;   // land alone between pauses: "4 rovers, road, parked"
  bool negated = false;  // they are not there
};

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_AGENTS_AGENT_PHRASES_H_
