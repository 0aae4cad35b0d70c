#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_HEARD_ENVIRONMENT_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_HEARD_ENVIRONMENT_H_

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "latticeworld/environment/environment_claims.h"
#include "latticeworld/geometry/region.h"
#include "latticeworld/language/places.h"

namespace latticeworld {

// What an instruction says of one coarse attribute.
struct HeardCoarse {
  std::string value;  // "": nothing is said
  std::string words;
  bool hint = false;                   // only given away by something else
  std::vector<std::string> also;       // values that the words allow as well
  std::vector<std::string> ruled_out;  // "no rain"
  std::string ruled_out_words;
};

// What it says of one property of one asset type: the claim, and the value to make of it.
struct FineWish {
  EnvironmentClaim claim;  // kDensity, kVariant or kParameter
  double value = 0.0;      // kDensity, kParameter
};

// Land that agents are at, by its letters in either vocabulary.
struct FeaturePlace {
  std::string name;  // "water"
  std::string suburb;
  std::string wild;
  bool near = false;          // beside it rather than in it
  std::optional<Heading> on;  // "north of the lake"; of no direction: in its middle
  bool shore = false;         // "on the northern shore": beside it, not beyond
  // Other land that it is told by: "between the lake and the village", "on the far side of the
  // lake, seen from the village".
  enum class Way : std::uint8_t { kNone, kBetween, kHalfway, kBehind } way = Way::kNone;
  std::string other_name{};
  std::string other_suburb{};
  std::string other_wild{};
  std::vector<FeaturePlace> beside{};  // "on the grass by the village": where both are true
};

// Agents as an instruction asks for them, before they are fitted to a world.
struct AgentWish {
  std::vector<AgentCategory> categories;  // several: a kind, what they do decides
  bool exact = true;                      // false: only the nearest category
  std::string name;                       // "wolves", as said
  int least = 1;
  int quantity = 1;  // as said; may be beyond the limits
  int most = 1;
  bool counted = false;             // the text gives a number
  std::optional<AgentState> state;  // nullopt: not said
  std::vector<Place> places;        // several: spread over them
  bool each = false;                // the quantity is meant for each place
  std::optional<FeaturePlace> feature;
  std::vector<FeaturePlace> more_land;  // "in the fields and by the lake": shared out, as places
  std::string words;

  bool IsPlaced() const { return !places.empty() || feature.has_value(); }
  void ForgetPlace() {
    places.clear();
    feature.reset();
    more_land.clear();
  }
};

struct HeardEnvironment {
  std::array<HeardCoarse, EnumNames(CoarseKey{}).size()> coarse;
  std::vector<FineWish> fine;
  std::vector<AgentWish> agents;
  std::vector<EnvironmentClaim> absences;  // kNoAgents, kTotalAgents
  std::vector<std::string> warnings;
  std::vector<std::string> not_understood;

  HeardCoarse& coarse_of(CoarseKey key) { return coarse[static_cast<std::size_t>(key)]; }
  const HeardCoarse& coarse_of(CoarseKey key) const {
    return coarse[static_cast<std::size_t>(key)];
  }
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_ENVIRONMENT_HEARD_ENVIRONMENT_H_
