#ifndef LATTICEWORLD_EXPORTING_VIEW_SCOUT_H_
#define LATTICEWORLD_EXPORTING_VIEW_SCOUT_H_

#include <optional>
#include <vector>

#include "latticeworld/geometry/grid.h"
#include "latticeworld/geometry/grid_geometry.h"

namespace latticeworld {

struct Scene;

// What a picture may be of.
enum class Motif { kStreet, kShore, kForest, kHill };

struct Viewpoint {
  WorldPoint position;
  double heading_rad = 0.0;
  double score = 0.0;
};

// Looks for places with a good view: scores places over the world and headings at each by what lies
// ahead.
class ViewScout {
 public:
  explicit ViewScout(const Scene& scene);

  // The best place for it; nullopt where the world has none.
  std::optional<Viewpoint> Find(Motif motif) const;
  // The free place nearest to the middle of the world, looking north; the middle where none is
  // free.
  Viewpoint Anywhere() const;

 private:
  // What lies ahead, near (10 to 35 m) and farther (35 to 110 m), in a sector of 60 degrees.
  struct Outlook {
    double houses_near = 0, houses = 0, trees_near = 0, trees = 0;  // weighted counts
    double water = 0;   // share of the places that are wet, up to 60 m
    double drop_m = 0;  // of the ground below the eye's place, mean up to 200 m
    double inside = 0;  // share of the places that are inside the world
  };
  Outlook LookAhead(WorldPoint from, double heading_rad) const;
  // Nothing solid at the place, and neither ground nor trunk or wall close before the eye.
  bool IsFree(WorldPoint from) const;
  bool IsOpenAhead(WorldPoint from, double heading_rad) const;
  bool Suits(Motif motif, WorldPoint from) const;
  double Score(Motif motif, WorldPoint from, double heading_rad) const;

  const Scene& scene_;
  GridGeometry buckets_;
  Grid<float> houses_, trees_;  // how many stand in a bucket, bushes a quarter
  double highest_m_, lowest_m_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_EXPORTING_VIEW_SCOUT_H_
