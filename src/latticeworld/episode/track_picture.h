#ifndef LATTICEWORLD_EPISODE_TRACK_PICTURE_H_
#define LATTICEWORLD_EPISODE_TRACK_PICTURE_H_

#include <string>

#include "latticeworld/common/result.h"
#include "latticeworld/episode/episode_record.h"
#include "latticeworld/rendering/picture.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {

// PNG of the world from above with the ways that agents went, one colour a team: a ring where each
// began, a disc where it ended, a cross where somebody died, and a legend. Errors: INVALID_ARGUMENT
// (options), INTERNAL.
Result<std::string> DrawTracks(const Scene& scene, const EpisodeRecord& record,
                               const PictureOptions& options);

}  // namespace latticeworld

#endif  // LATTICEWORLD_EPISODE_TRACK_PICTURE_H_
