#ifndef LATTICEWORLD_LAYOUT_CLAIMS_H_
#define LATTICEWORLD_LAYOUT_CLAIMS_H_

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "latticeworld/common/enum_names.h"
#include "latticeworld/geometry/region.h"
#include "latticeworld/layout/symbolic_layout.h"

namespace latticeworld {

enum class ClaimKind : std::uint8_t {
  kPresent,    // subject occurs in the region
  kAbsent,     // subject does not occur in the region
  kMostly,     // subject covers more of the region than any other class
  kLittle,     // subject occurs in the region, and covers little of it
  kMoreThan,   // subject covers more of the region than object
  kClustered,  // subject lies in few pieces
  kScattered,  // subject lies in many small pieces
  kAdjacent,   // subject and object touch
  kSurrounds,  // object's cells are mostly bordered by subject
  kCourse,     // subject runs connected from region `from` to region `to`
};

constexpr std::array<EnumName<ClaimKind>, 10> EnumNames(ClaimKind) {
  return {{{ClaimKind::kPresent, "present"},
           {ClaimKind::kAbsent, "absent"},
           {ClaimKind::kMostly, "mostly"},
           {ClaimKind::kLittle, "little"},
           {ClaimKind::kMoreThan, "more_than"},
           {ClaimKind::kClustered, "clustered"},
           {ClaimKind::kScattered, "scattered"},
           {ClaimKind::kAdjacent, "adjacent"},
           {ClaimKind::kSurrounds, "surrounds"},
           {ClaimKind::kCourse, "course"}}};
}

// One thing that an instruction says about a layout, checkable on the layout alone.
struct Claim {
  ClaimKind kind = ClaimKind::kPresent;
  char subject = '?';               // letter
  char object = '\0';               // letter; kMoreThan, kAdjacent, kSurrounds
  std::vector<Region> regions;      // where; empty: the whole layout. Several: each of them
  Region from = Region::kAnywhere;  // kCourse
  Region to = Region::kAnywhere;    // kCourse
  std::string words;                // of the instruction
};

struct ClaimMeasure {
  bool holds = false;
  double distance = 0.0;    // how far the layout is from the claim: 0 when it holds, up to 1
  std::string explanation;  // "forest covers 0.41 of upper left; more than 0.05 is asked"
};

ClaimMeasure Measure(const Claim& claim, const SymbolicLayout& layout);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LAYOUT_CLAIMS_H_
