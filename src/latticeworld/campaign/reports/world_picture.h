#ifndef LATTICEWORLD_CAMPAIGN_REPORTS_WORLD_PICTURE_H_
#define LATTICEWORLD_CAMPAIGN_REPORTS_WORLD_PICTURE_H_

#include <string>
#include <vector>

#include "latticeworld/campaign/reports/tables.h"
#include "latticeworld/common/result.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {

// Figure of a world for a page: its map from above as a JPEG within the text, and over it as SVG
// the tasks' shortest ways (dashed) and the driven ones, by how they ended. trials: of that world.
// Errors: INTERNAL.
Result<std::string> WorldFigure(const Scene& scene, const std::vector<FinishedTrial>& trials,
                                int width_px);

}  // namespace latticeworld

#endif  // LATTICEWORLD_CAMPAIGN_REPORTS_WORLD_PICTURE_H_
