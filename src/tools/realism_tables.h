#ifndef LATTICEWORLD_TOOLS_REALISM_TABLES_H_
#define LATTICEWORLD_TOOLS_REALISM_TABLES_H_

#include <iosfwd>
#include <vector>

#include "tools/realism_summary.h"

namespace latticeworld::tools {

// One land: a line a measure, with nature's range beside it.
void PrintLand(const MeasuredLand& land, std::ostream* out);

// Several: a line a land, then mean, spread (standard deviation between them), nature's range and
// how many lie in it. Not empty.
void PrintLands(const std::vector<MeasuredLand>& lands, std::ostream* out);

}  // namespace latticeworld::tools

#endif  // LATTICEWORLD_TOOLS_REALISM_TABLES_H_
