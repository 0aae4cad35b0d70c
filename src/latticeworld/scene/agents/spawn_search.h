#ifndef LATTICEWORLD_SCENE_AGENTS_SPAWN_SEARCH_H_
#define LATTICEWORLD_SCENE_AGENTS_SPAWN_SEARCH_H_

#include <array>
#include <vector>

#include "latticeworld/common/random.h"
#include "latticeworld/common/result.h"
#include "latticeworld/scene/agents/spawn_site.h"
#include "latticeworld/scene/scene.h"
#include "latticeworld/scene/surface_table.h"

namespace latticeworld {

// Distance between the centres of two bodies that are placed one after the other [m].
double SpawnClearance(double body_radius_m);

// Finds places for bodies of one kind in one region: random tries, first on ground that suits the
// category, then a scan of the whole region in steps of at most kScanStep_m, the body's radius, or
// 1/256 of the region, whichever is largest. The scan goes on where the last one stopped, because
// what was refused once stays refused: `taken` may only grow between calls. Robots on the ground
// are put wholly inside the world less its outermost cells, which planners take for closed.
class SpawnSearch {
 public:
  static constexpr double kScanStep_m = 0.5;

  // Where a body may be put: on ground that it stands still on (HoldingSlope_deg), or wherever it
  // may legally be.
  enum class Slopes { kHeld, kLegal };

  // scene, atmosphere, changes: outlive this; the waters are those of that weather. changes: assets
  // that do not stand are in nobody's way; null: all stand.
  SpawnSearch(const Scene& scene, const Atmosphere& atmosphere, AgentCategory category,
              double body_radius_m, Region region, const SceneChanges* changes = nullptr,
              Slopes slopes = Slopes::kLegal);

  // A place anywhere in the region. NOT_FOUND says why the places that were tried are none.
  Result<WorldPoint> Find(const std::vector<WorldPoint>& taken, RandomStream* random);
  // The same, near `centre` (normally distributed with that spread) where a few tries succeed.
  Result<WorldPoint> FindNear(WorldPoint centre, double spread_m,
                              const std::vector<WorldPoint>& taken, RandomStream* random);

 private:
  struct Box {
    double x_min_m, x_max_m, y_min_m, y_max_m;
  };
  // True when the body can be there; else counts why not.
  bool Try(WorldPoint position, const std::vector<WorldPoint>& taken);
  bool Suits(WorldPoint position) const;
  bool Holds(WorldPoint position, const SpawnSite& site) const;
  // Uniform anywhere; in a region about its middle (triangular), as "in the center" is meant.
  double Draw(double low_m, double high_m, RandomStream* random) const;
  Status Failure() const;

  const Scene& scene_;
  const Atmosphere& atmosphere_;
  const SceneChanges* changes_;
  AgentCategory category_;
  double body_radius_m_;
  Region region_;
  Slopes slopes_;
  SurfaceTable surfaces_;  // under that weather
  Box box_;                // of the body's centre; empty when the body does not fit into the region
  double step_m_ = 0.0;
  int scan_cols_ = 0, scan_rows_ = 0;
  int scan_next_ = 0;
  bool random_tries_help_ = true;
  std::array<long, kSpawnFlawCount> flaws_{};  // how often each was met
  long taken_ = 0;                             // how often somebody else was too near
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SCENE_AGENTS_SPAWN_SEARCH_H_
