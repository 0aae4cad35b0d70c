#ifndef LATTICEWORLD_RENDERING_VIEWS_CONTACT_SHEET_H_
#define LATTICEWORLD_RENDERING_VIEWS_CONTACT_SHEET_H_

#include <cstdint>
#include <string>

#include "latticeworld/environment/environment_config.h"
#include "latticeworld/rendering/picture.h"

namespace latticeworld {

// The environment under other coarse attributes. Fine attributes stay where the new ones allow it:
// seasonal variants become the typical one where the typical one changes or theirs is excluded,
// materials where theirs is excluded; numbers move to the nearest that is legal.
EnvironmentConfig ChangedEnvironment(const EnvironmentConfig& environment,
                                     const CoarseAttributes& coarse, const Catalogue& catalogue);

// PNG of one land in four seasons, three styles, six weathers and seven hours: a small view from
// the south each, labelled, the seasons and styles on a sunny afternoon. Terrain, agents, catalogue
// and fine attributes are the scene's, the latter as ChangedEnvironment keeps them; assets are
// placed anew with the seed for each environment, since seasons and weathers change what grows.
// options.width_px: of the whole sheet, [700, 4096]. Errors: INVALID_ARGUMENT and those of the
// views.
Result<std::string> DrawContactSheet(const Scene& scene, std::uint64_t seed,
                                     const PictureOptions& options);

}  // namespace latticeworld

#endif  // LATTICEWORLD_RENDERING_VIEWS_CONTACT_SHEET_H_
