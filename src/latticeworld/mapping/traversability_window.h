#ifndef LATTICEWORLD_MAPPING_TRAVERSABILITY_WINDOW_H_
#define LATTICEWORLD_MAPPING_TRAVERSABILITY_WINDOW_H_

#include "latticeworld/mapping/cell_window.h"
#include "latticeworld/mapping/traversability.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {

// The traversability of parts of a scene, for who needs to know only what is around him, or only
// what has changed. What a window costs grows with its size and what stands in it, not with the
// scene.
class TraversabilityWindow {
 public:
  // Legal as for BuildTraversability, and clearance_m 0: crowns are no matter. scene: outlives
  // this. coarse: cells a side of the squares, counted from the north-west corner of the scene, in
  // which whoever asks looks at it, >= 1: whether a deck carries is asked of the middles of those.
  TraversabilityWindow(const Scene& scene, const RobotLimits& limits, int coarse = 1);

  // values: (rows x cols) of the window, row-major: those that BuildTraversability has there (but
  // for decks, where coarse is above 1). The window must lie in the scene, the changes be legal and
  // the gone ones of them increase.
  void Fill(const CellWindow& window, const SceneChanges& changes, float* values) const;

 private:
  const Scene& scene_;
  RobotLimits limits_;
  int coarse_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_MAPPING_TRAVERSABILITY_WINDOW_H_
