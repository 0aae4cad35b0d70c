#ifndef LATTICEWORLD_LAYOUT_CLAIMS_CLAIM_HEADINGS_H_
#define LATTICEWORLD_LAYOUT_CLAIMS_CLAIM_HEADINGS_H_

#include <array>
#include <string_view>

#include "latticeworld/layout/claims/claims.h"

// The compass in words; for the .cc files of this room.
namespace latticeworld::internal {

struct NamedHeading {
  Claim::Heading heading;
  std::string_view name;
};

inline constexpr std::array<NamedHeading, 8> kHeadings = {{{{0, -1}, "north"},
                                                           {{1, -1}, "north-east"},
                                                           {{1, 0}, "east"},
                                                           {{1, 1}, "south-east"},
                                                           {{0, 1}, "south"},
                                                           {{-1, 1}, "south-west"},
                                                           {{-1, 0}, "west"},
                                                           {{-1, -1}, "north-west"}}};

// "nowhere" for no heading of the compass.
inline std::string_view NameOf(Claim::Heading heading) {
  for (const NamedHeading& named : kHeadings) {
    if (named.heading == heading) return named.name;
  }
  return "nowhere";
}

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_LAYOUT_CLAIMS_CLAIM_HEADINGS_H_
