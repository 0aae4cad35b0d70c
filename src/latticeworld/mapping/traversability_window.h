#ifndef LATTICEWORLD_MAPPING_TRAVERSABILITY_WINDOW_H_
#define LATTICEWORLD_MAPPING_TRAVERSABILITY_WINDOW_H_

#include "latticeworld/mapping/ground_effort.h"
#include "latticeworld/mapping/traversability.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {

// Cells [row_begin, row_end) x [col_begin, col_end) of a scene's geometry.
struct CellWindow {
  int row_begin = 0, row_end = 0;
  int col_begin = 0, col_end = 0;

  int rows() const { return row_end - row_begin; }
  int cols() const { return col_end - col_begin; }
};

// The traversability of parts of a scene, for who needs to know only what is around him, or only
// what has changed. What a window costs grows with its size and what stands in it, not with the
// scene.
class TraversabilityWindow {
 public:
  // Legal as for BuildTraversability, and clearance_m 0: crowns are no matter. scene: outlives
  // this.
  TraversabilityWindow(const Scene& scene, const RobotLimits& limits);

  // values: (rows x cols) of the window, row-major: those that BuildTraversability has there. The
  // window must lie in the scene, the changes be legal and the gone ones of them increase.
  void Fill(const CellWindow& window, const SceneChanges& changes, float* values) const;

 private:
  const Scene& scene_;
  RobotLimits limits_;
  GroundEffort ground_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_MAPPING_TRAVERSABILITY_WINDOW_H_
