#ifndef LATTICEWORLD_TERRAIN_WAYS_STREET_GROWTH_H_
#define LATTICEWORLD_TERRAIN_WAYS_STREET_GROWTH_H_

#include <deque>
#include <optional>
#include <vector>

#include "latticeworld/common/random.h"
#include "latticeworld/terrain/ways/streets.h"

namespace latticeworld::internal {

// Lets streets grow out of what there is, one area after the other.
class StreetGrower {
 public:
  // All must outlive the grower.
  StreetGrower(const StreetField& field, const StreetRule& rule, RandomStream* random,
               StreetNetwork* network);

  // A street that begins at the layout's road beside `edge`, if there is room for one.
  void BeginAtRoad(const BuiltUpArea& area, WorldPoint edge, double heading_rad);
  // A way from a road into the area, which runs on from its end.
  void BeginWithLane(const BuiltUpArea& area, std::vector<WorldPoint> lane);
  // A main street through the area's heart.
  void BeginAtHeart(const BuiltUpArea& area);
  // A way from the network to a place that it does not serve yet.
  void AddBranch(std::vector<WorldPoint> way);
  // Streets that branch off those added since the last call, and off these, until there is no room
  // for more.
  void BranchOff(const BuiltUpArea& area);

 private:
  enum class End { kDead, kJoined, kAtBorder };
  struct Trace {
    std::vector<WorldPoint> line;
    End end = End::kDead;
    double length_m = 0.0;
  };
  // Follows the field from a place of the street `parent` (-1: none). spacing_m: to streets that
  // run along it.
  Trace Follow(WorldPoint start, double heading_rad, double spacing_m, int parent);
  // Leads a trace that ended to the nearest street or road ahead; false: nothing there.
  bool JoinAhead(double spacing_m, int parent, Trace* trace) const;
  // The street that a step passes over, nullopt: none.
  std::optional<StreetNetwork::Node> Crossed(WorldPoint place, double heading_rad) const;
  bool HasRoom(WorldPoint start, double heading_rad, double spacing_m) const;
  // How far apart streets are that run along the heading.
  double SpacingOf(const BuiltUpArea& area, double heading_rad) const;
  void Add(std::vector<WorldPoint> line, double width_m);
  void BranchOffStreet(const BuiltUpArea& area, int street);
  bool IsOpenWay(WorldPoint from, WorldPoint to) const;

  const StreetField& field_;
  StreetRule rule_;
  RandomStream* random_;
  StreetNetwork* network_;
  double step_m_;
  std::deque<int> added_;  // streets that may have branches
};

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_TERRAIN_WAYS_STREET_GROWTH_H_
