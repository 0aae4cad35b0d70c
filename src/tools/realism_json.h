#ifndef LATTICEWORLD_TOOLS_REALISM_JSON_H_
#define LATTICEWORLD_TOOLS_REALISM_JSON_H_

#include <string>
#include <vector>

#include "tools/realism_summary.h"

namespace latticeworld::tools {

// What was measured of each land, and of all together, for programs. NaN becomes null. lands: not
// empty.
std::string LandsToJson(const std::vector<MeasuredLand>& lands);

}  // namespace latticeworld::tools

#endif  // LATTICEWORLD_TOOLS_REALISM_JSON_H_
