#ifndef LATTICEWORLD_VIEWER_PAYLOADS_STILL_VIEW_H_
#define LATTICEWORLD_VIEWER_PAYLOADS_STILL_VIEW_H_

#include "latticeworld/viewer/viewer_backend.h"
#include "latticeworld/viewer/viewer_feed.h"

namespace latticeworld {

class SpeciesCatalogue;
struct World;

// A world that nothing simulates: everything stands where it begins.

// Agents and props where the scene has them.
void ShowStart(const World& world, const SpeciesCatalogue& species, ViewerFeed* feed);

// Refuses whatever would change something, and says why.
class StillBackend : public ViewerBackend {
 public:
  void Do(const ViewerRequest& request, Done done) override;
  void OnDemand(const LayerDemand&) override {}
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_VIEWER_PAYLOADS_STILL_VIEW_H_
