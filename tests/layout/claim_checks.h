#ifndef LATTICEWORLD_TESTS_LAYOUT_CLAIM_CHECKS_H_
#define LATTICEWORLD_TESTS_LAYOUT_CLAIM_CHECKS_H_

#include "latticeworld/layout/claims/claims.h"
#include "layout/claim_making.h"

namespace latticeworld {

// Measured, with what is true of every measure checked: words, range, and that a search sees the
// same distance.
ClaimMeasure Measured(const Claim& claim, const SymbolicLayout& layout);
bool Holds(const Claim& claim, const SymbolicLayout& layout);
double Distance(const Claim& claim, const SymbolicLayout& layout);

}  // namespace latticeworld

#endif  // LATTICEWORLD_TESTS_LAYOUT_CLAIM_CHECKS_H_
