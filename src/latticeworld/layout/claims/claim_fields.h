#ifndef LATTICEWORLD_LAYOUT_CLAIMS_CLAIM_FIELDS_H_
#define LATTICEWORLD_LAYOUT_CLAIMS_CLAIM_FIELDS_H_

#include <cstdint>

#include "latticeworld/layout/claims/claims.h"

// Which fields of a claim its kind uses; for the .cc files of this room.
namespace latticeworld::internal {

enum ClaimField : std::uint16_t {
  kSubject = 1 << 0,
  kObject = 1 << 1,
  kSecondObject = 1 << 2,
  kSequence = 1 << 3,
  kZone = 1 << 4,
  kObjectZone = 1 << 5,
  kFrom = 1 << 6,
  kTo = 1 << 7,
  kHeading = 1 << 8,
  kShapeName = 1 << 9,
  kLeast = 1 << 10,
  kMost = 1 << 11,
};

// What least and most count.
enum class BoundUnit : std::uint8_t { kShare, kPieces, kSteps };

struct ClaimFields {
  unsigned needed = 0;   // of ClaimField
  unsigned allowed = 0;  // besides those needed
  BoundUnit unit = BoundUnit::kShare;

  bool Uses(ClaimField field) const { return ((needed | allowed) & field) != 0; }
};

ClaimFields FieldsOf(ClaimKind kind);

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_LAYOUT_CLAIMS_CLAIM_FIELDS_H_
