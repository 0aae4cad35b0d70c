#ifndef LATTICEWORLD_LAYOUT_CLAIMS_CLAIMS_JSON_H_
#define LATTICEWORLD_LAYOUT_CLAIMS_CLAIMS_JSON_H_

#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/layout/claims/claims.h"

namespace latticeworld {

// Claims as JSON: an array with one object a claim. A key that a kind has no use for is an error,
// and so is one that it needs and lacks; `least`, `most`, `words` and a zone that is anywhere may
// be left out. A zone is a name of ZoneNames() or
//   {"name": "a band", "boxes": [[u_min, u_max, v_min, v_max], ...]}
// A heading is "north", "north-east", ... Shares lie in [0, 1]; numbers of pieces and of steps are
// whole.
//
//   {"kind": "present", "subject": "F", "zone": "upper left", "words": "a forest up there"}
//   {"kind": "amount", "subject": "A", "zone": "eastern half", "least": 0.4, "most": 0.6}
//   {"kind": "count", "subject": "W", "least": 3, "most": 3}
//   {"kind": "direction", "subject": "B", "object": "W", "heading": "north"}
//   {"kind": "order", "sequence": "SRFW", "heading": "south"}
//   {"kind": "course", "subject": "R", "from": "western edge", "to": "eastern edge"}
//   {"kind": "between", "subject": "B", "object": "W", "second_object": "F"}
//   {"kind": "shape", "subject": "W", "shape": "round"}
//   {"kind": "rest", "subject": "G", "sequence": "WB"}
//
// Errors: INVALID_ARGUMENT with every violation and its JSON pointer: letters that the vocabulary
// has not, unknown kinds, zones, shapes, headings and keys, keys said twice, bounds that no layout
// can meet; or saying that the text is no JSON, or too large or too deep.
Result<std::vector<Claim>> DecodeClaims(std::string_view json, Vocabulary vocabulary);
// One claim a line. What a kind has no use for is left out.
std::string EncodeClaims(const std::vector<Claim>& claims);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LAYOUT_CLAIMS_CLAIMS_JSON_H_
