#ifndef LATTICEWORLD_SCENE_PROPS_THING_SITES_H_
#define LATTICEWORLD_SCENE_PROPS_THING_SITES_H_

#include <optional>
#include <string>
#include <vector>

#include "latticeworld/common/random.h"
#include "latticeworld/layout/layout_mask.h"
#include "latticeworld/layout/thing_wish.h"
#include "latticeworld/scene/footprint.h"
#include "latticeworld/scene/land_finder.h"

namespace latticeworld {

// How far things that are said to be near, around, along or in front of something stand from its
// edge at most [m]; claims allow the same.
inline constexpr double kFarthestNear_m = 15.0;

// Returns the distance between the middles of neighbours [m]: as said, or usual for the kind and
// its size.
double SpacingOf(const ThingWish& wish);

// Draws sites for the things of a wish: where each would stand if nothing were in the way.
class ThingSites {
 public:
  struct Slot {
    WorldPoint place;
    double yaw_rad = 0.0;
  };

  // own: what one of the things covers. standing: of each wish before this one, what stands of it.
  // All but own outlive this.
  ThingSites(const ThingWish& wish, const Footprint& own,
             const std::vector<std::vector<Footprint>>& standing, const Terrain& terrain,
             LandFinder* land);

  // What there is not that the wish needs: then things stand anywhere in its zone. "": all is.
  const std::string& problem() const { return problem_; }
  // Whether the relation alone says how several things stand: around, along.
  bool arranges_by_itself() const;
  // tried: how many were drawn before; later ones keep less to what is only usual.
  std::vector<Slot> Draw(int count, int tried, int tries, RandomStream* random) const;
  // A point of water that footbridges may cross, in the zone, near the target of the relation where
  // there is one; anywhere where the world has no water.
  WorldPoint DrawWater(RandomStream* random) const;

 private:
  struct Anchor {
    WorldPoint place;
    double toward_rad = 0.0;  // to the target
    bool has_target = false;
    double around_m = 0.0;  // how far away a site may lie where there is no room
  };
  bool IsThere(const ThingTarget& target) const;
  bool InZone(WorldPoint point) const;
  bool IsOnSide(WorldPoint point) const;
  // The heading across a long zone, along which a row lies: "in a row along the eastern edge".
  std::optional<double> AcrossZone() const;
  // Away from the world's edges, where things are seen whole.
  bool IsInner(WorldPoint point) const;
  WorldPoint DrawInZone(RandomStream* random) const;
  // A cell of the class in the zone; one outside where there is none.
  WorldPoint DrawCell(char letter, RandomStream* random) const;
  double OwnRadius() const;
  double DrawGap(double least_m, double most_m, RandomStream* random) const;
  // The heading away from the target: to the side that is said, or anywhere.
  double DrawWayOut(RandomStream* random) const;
  Anchor DrawAnchor(double depth_m, RandomStream* random) const;
  Anchor BesideLand(double depth_m, RandomStream* random) const;
  Anchor BesideThing(double depth_m, RandomStream* random) const;
  Anchor Between(RandomStream* random) const;
  Anchor BetweenPieces(RandomStream* random) const;
  Anchor BetweenThings(RandomStream* random) const;
  static Anchor BetweenPoints(WorldPoint from, WorldPoint to);
  std::vector<Slot> Arrange(const Anchor& anchor, int count, double turn_rad) const;
  std::vector<Slot> AroundThing(int count, double turn_rad) const;
  std::vector<Slot> RunAroundThing(int most) const;
  std::vector<Slot> AroundLand(int count, double turn_rad) const;
  std::vector<Slot> AlongThing(int count, RandomStream* random) const;
  std::vector<Slot> AlongLand(int count, RandomStream* random) const;
  // Pieces end to end over nodes that were walked, on a line without their jitter.
  std::vector<Slot> EndToEnd(std::vector<Slot> nodes) const;
  // One way along the edge of the class from a place beside it. Ends at the world's edge, and
  // before it comes back to its begin.
  std::vector<Slot> WalkAlong(WorldPoint from, int count, double gap_m, double side_rad) const;
  void Turn(RandomStream* random, std::vector<Slot>* slots) const;
  std::optional<WorldPoint> NearestOf(const ThingTarget& target, WorldPoint point) const;

  const ThingWish& wish_;
  const Footprint own_;
  const std::vector<std::vector<Footprint>>& standing_;
  const Terrain& terrain_;
  LandFinder* land_;
  LayoutMask zone_;
  bool is_run_;  // its pieces stand end to end
  ThingRelation relation_;
  std::string problem_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SCENE_PROPS_THING_SITES_H_
