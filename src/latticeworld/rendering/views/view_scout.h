#ifndef LATTICEWORLD_RENDERING_VIEWS_VIEW_SCOUT_H_
#define LATTICEWORLD_RENDERING_VIEWS_VIEW_SCOUT_H_

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
  // The place nearest to the middle of the world that is free and open ahead, looking as near to
  // north as it is; the middle where there is none.
  Viewpoint Anywhere() const;

 private:
  // What lies ahead, near (10 to 35 m) and farther (35 to 110 m), in a sector of 60 degrees.
  struct Outlook {
    double houses_near = 0, houses = 0;      // weighted counts
    double trees_near_ha = 0, trees_ha = 0;  // how many stand on a hectare
    double water = 0;                        // share of the places that are wet, up to 60 m
    double forest = 0;                       // share that is forest floor, up to 110 m
    double drop_m = 0;  // of the ground below the eye's place, mean up to 200 m
    double inside = 0;  // share of the places that are inside the world
  };
  Outlook LookAhead(WorldPoint from, double heading_rad) const;
  // IsFree: nothing solid and no crown is at the place. IsOpenAhead: neither ground nor trunk nor
  // wall is close before the eye. crowns: how much of their width counts.
  bool IsFree(WorldPoint from, double crowns) const;
  bool IsOpenAhead(WorldPoint from, double heading_rad, double crowns) const;
  bool Suits(Motif motif, WorldPoint from, double crowns) const;
  double Score(Motif motif, WorldPoint from, double heading_rad) const;
  std::optional<Viewpoint> Find(Motif motif, double crowns) const;
  std::optional<Viewpoint> Anywhere(double crowns) const;

  const Scene& scene_;
  GridGeometry buckets_;
  Grid<float> houses_, trees_;  // how many stand in a bucket, bushes a quarter
  double highest_m_, lowest_m_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_RENDERING_VIEWS_VIEW_SCOUT_H_
