#ifndef LATTICEWORLD_VIEWER_PAYLOADS_WORLD_PAYLOADS_H_
#define LATTICEWORLD_VIEWER_PAYLOADS_WORLD_PAYLOADS_H_

#include <memory>
#include <string>

#include "latticeworld/common/progress.h"
#include "latticeworld/common/result.h"
#include "latticeworld/viewer/payloads/payload.h"

namespace latticeworld {

class SpeciesCatalogue;
struct World;

// A world as HTTP serves it: docs/viewer.md, "HTTP". Immutable once made.
struct WorldPayloads {
  std::string key;  // the world's id and a digest of the payloads
  std::string world_id;
  Payload description;  // world.json
  PayloadMap files;     // by path: "/api/worlds/<key>/height.bin"
};

// Takes about a second for 512 m, in a thread of the caller's. species: what agents can be of.
// moves: whether a simulation runs it. Reports the stage "viewer". Errors: CANCELLED, INTERNAL (a
// picture or mesh cannot be made).
Result<std::shared_ptr<const WorldPayloads>> MakeWorldPayloads(const World& world,
                                                               const SpeciesCatalogue& species,
                                                               bool moves,
                                                               const Progress& progress);

}  // namespace latticeworld

#endif  // LATTICEWORLD_VIEWER_PAYLOADS_WORLD_PAYLOADS_H_
