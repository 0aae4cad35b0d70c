#include "language/grounded/synthesis/synthesis_plans.h"

#include <utility>

#include "language/grounded/synthesis/plan_writer.h"

namespace latticeworld {
namespace {

using Kind = ClaimKind;
using Tie = RelationKind;

constexpr double kUnsaid = Claim::kUnsaid;

// Each kind of thing, place, amount and shape by itself.
std::vector<NamedPlan> Single() {
  return {
      PlanWriter('G').Spread('F').Claims({Says(Kind::kPresent, 'F')}).As("forest"),
      PlanWriter('G')
          .Spread('F', {"northern third"})
          .Claims({Says(Kind::kPresent, 'F', "northern third", 0.2)})
          .As("forest in the north"),
      PlanWriter('G')
          .Spread('F', {"northern half"})
          .Dominant()
          .Claims({Says(Kind::kDominant, 'F', "northern half"),
                   Says(Kind::kAmount, 'F', "northern half", 0.5)})
          .As("the northern half is forest"),
      PlanWriter('G')
          .Patch('W', {"upper left"})
          .Claims(
              {Says(Kind::kPresent, 'W', "upper left"), Says(Kind::kCount, 'W', "anywhere", 1, 1)})
          .As("a single lake in the north-west"),
      PlanWriter('F')
          .Spread('F')
          .Dominant()
          .Patch('W', {"center"})
          .Claims({Says(Kind::kDominant, 'F'), Says(Kind::kPresent, 'W', "center")})
          .As("mostly forest with a lake in the centre"),
      PlanWriter('G')
          .Spread('F')
          .Share(0.5)
          .Spread('A')
          .Share(0.5)
          .Claims({Says(Kind::kAmount, 'F', "anywhere", 0.4, 0.6),
                   Says(Kind::kAmount, 'A', "anywhere", 0.4, 0.6)})
          .As("half forest half fields"),
      PlanWriter('G')
          .Spread('A')
          .Share(0.25)
          .Claims({Says(Kind::kAmount, 'A', "anywhere", 0.17, 0.33)})
          .As("a quarter is fields"),
      PlanWriter('G')
          .Patch('W')
          .Cells(110)
          .Claims({Says(Kind::kAmount, 'W', "anywhere", 0.08)})
          .As("a vast lake"),
      PlanWriter('G')
          .Patch('W')
          .Pieces(3, 25)
          .Claims({Says(Kind::kCount, 'W', "anywhere", 3, 3)})
          .As("three lakes"),
      PlanWriter('G')
          .Patch('W')
          .Pieces(5, 8)
          .Claims({Says(Kind::kCount, 'W', "anywhere", 5, 5)})
          .As("five ponds"),
      PlanWriter('G')
          .Patch('W', {"western half"})
          .Pieces(7, 6)
          .Claims({Says(Kind::kCount, 'W', "western half", 7, 7)})
          .As("seven ponds in the west"),
      PlanWriter('G')
          .Patch('W')
          .Patch('W')
          .Claims({Says(Kind::kCount, 'W', "anywhere", 2, 2)})
          .As("a lake and a lake"),
      PlanWriter('G')
          .Patch('B')
          .Cells(3)
          .Scattered()
          .Claims({Says(Kind::kScattered, 'B')})
          .As("scattered houses"),
      PlanWriter('G')
          .Spread('F', {"southern half"})
          .Scattered()
          .Claims({Says(Kind::kScattered, 'F', "southern half")})
          .As("scattered trees in the south"),
      PlanWriter('G')
          .Spread('F', {"north-west corner", "north-east corner", "south-west corner",
                        "south-east corner"})
          .Claims({Says(Kind::kPresent, 'F', "north-west corner"),
                   Says(Kind::kPresent, 'F', "north-east corner"),
                   Says(Kind::kPresent, 'F', "south-west corner"),
                   Says(Kind::kPresent, 'F', "south-east corner")})
          .As("woods in the four corners"),
      PlanWriter('G')
          .Spread('F', {"edges"})
          .Claims({Says(Kind::kLocated, 'F', "edges"), Says(Kind::kPresent, 'F', "edges", 0.2)})
          .As("forest along the edges"),
      PlanWriter('G')
          .Patch('W')
          .Shape(ClaimShape::kRound)
          .Claims({Shaped('W', ClaimShape::kRound)})
          .As("a round lake"),
      PlanWriter('G')
          .Patch('W')
          .Shape(ClaimShape::kElongated)
          .Claims({Shaped('W', ClaimShape::kElongated)})
          .As("a long lake"),
      PlanWriter('G')
          .Patch('W')
          .Shape(ClaimShape::kBent)
          .Claims({Shaped('W', ClaimShape::kBent)})
          .As("a crescent lake"),
      PlanWriter('G')
          .Patch('W')
          .Shape(ClaimShape::kRing)
          .Claims({Shaped('W', ClaimShape::kRing)})
          .As("a ring of water"),
      PlanWriter('G')
          .Line('R')
          .Shape(ClaimShape::kStraight)
          .Meander(0.0)
          .Claims({Shaped('R', ClaimShape::kStraight)})
          .As("a straight road"),
      PlanWriter('G')
          .Line('W')
          .Shape(ClaimShape::kWinding)
          .Meander(2.0)
          .Claims({Shaped('W', ClaimShape::kWinding)})
          .As("a winding river"),
      PlanWriter('G')
          .Line('R')
          .Shape(ClaimShape::kGridded)
          .Claims({Shaped('R', ClaimShape::kGridded)})
          .As("a grid of streets"),
      PlanWriter('G')
          .Line('R')
          .Shape(ClaimShape::kRing)
          .Claims({Shaped('R', ClaimShape::kRing)})
          .As("a ring road"),
      PlanWriter('G')
          .Line('R')
          .Shape(ClaimShape::kBent)
          .Claims({Shaped('R', ClaimShape::kBent)})
          .As("a bent road"),
      PlanWriter('G')
          .Line('W', "northern edge", "southern edge")
          .Claims({Course('W', "northern edge", "southern edge")})
          .As("a river from north to south"),
      PlanWriter('G')
          .Line('R', "north-west corner", "south-east corner")
          .Claims({Course('R', "north-west corner", "south-east corner")})
          .As("a road from corner to corner"),
      PlanWriter('G')
          .Line('W', "western edge", "northern edge")
          .Wide()
          .Claims({Course('W', "western edge", "northern edge")})
          .As("a wide river from west to north"),
      PlanWriter('G')
          .Line('R')
          .In("southern edge")
          .Claims({Says(Kind::kAlong, 'R', "southern edge")})
          .As("a road along the southern edge"),
      PlanWriter('G')
          .Spread('F')
          .Without('W')
          .Without('B', "eastern third")
          .Claims({Says(Kind::kPresent, 'F')})
          .As("no water, no houses in the east"),
  };
}

// Each relation by itself.
std::vector<NamedPlan> Related() {
  return {
      PlanWriter('G')
          .Patch('B')
          .Patch('W')
          .Relate(Tie::kAdjacent, 0, 1)
          .Claims({Gap(Kind::kAdjacent, 'B', 'W', kUnsaid, 2)})
          .As("a village at the lake"),
      PlanWriter('G')
          .Patch('B')
          .Spread('F', {"eastern third"})
          .Relate(Tie::kNear, 0, 1)
          .Claims({Gap(Kind::kAdjacent, 'B', 'F', kUnsaid, 4),
                   Says(Kind::kPresent, 'F', "eastern third", 0.2)})
          .As("a village near the eastern forest"),
      PlanWriter('G')
          .Patch('B')
          .Line('W', "northern edge", "southern edge")
          .Relate(Tie::kAdjacent, 0, 1)
          .Claims({Gap(Kind::kAdjacent, 'B', 'W', kUnsaid, 2),
                   Course('W', "northern edge", "southern edge"), Says(Kind::kPresent, 'B')})
          .As("a village by the river"),
      PlanWriter('G')
          .Patch('B')
          .Patch('W', {"center"})
          .Relate(Tie::kApart, 0, 1)
          .Claims({Gap(Kind::kApart, 'B', 'W', 6, kUnsaid), Says(Kind::kPresent, 'W', "center")})
          .As("a village far from the lake"),
      PlanWriter('G')
          .Spread('F')
          .Patch('W')
          .Relate(Tie::kSurrounds, 0, 1)
          .Claims({About(Kind::kSurrounds, 'F', 'W')})
          .As("a lake surrounded by forest"),
      PlanWriter('A')
          .Patch('B')
          .Patch('W')
          .Relate(Tie::kSurrounds, 0, 1)
          .Claims({About(Kind::kSurrounds, 'B', 'W')})
          .As("houses around a lake"),
      PlanWriter('F')
          .Line('R')
          .Patch('W')
          .Relate(Tie::kSurrounds, 0, 1)
          .Claims({About(Kind::kSurrounds, 'R', 'W')})
          .As("a road around the lake"),
      PlanWriter('G')
          .Patch('F')
          .Cells(7)
          .Patch('W')
          .Relate(Tie::kWithin, 0, 1)
          .Claims({About(Kind::kWithin, 'F', 'W'), Says(Kind::kCount, 'W', "anywhere", 1, 1)})
          .As("a wooded island in a lake"),
      PlanWriter('F')
          .Spread('F')
          .Dominant()
          .Patch('G')
          .Relate(Tie::kWithin, 1, 0)
          .Claims({Says(Kind::kDominant, 'F'), About(Kind::kWithin, 'G', 'F')})
          .As("a clearing in the forest"),
      PlanWriter('G')
          .Spread('F')
          .Patch('B')
          .Relate(Tie::kWithin, 1, 0)
          .Claims({About(Kind::kWithin, 'B', 'F')})
          .As("a village in a wood"),
      PlanWriter('G')
          .Spread('A')
          .Line('W', "northern edge", "southern edge")
          .Relate(Tie::kBothSides, 0, 1)
          .Claims(
              {About(Kind::kBothSides, 'A', 'W'), Course('W', "northern edge", "southern edge")})
          .As("fields on both sides of the river"),
      PlanWriter('G')
          .Patch('B')
          .Cells(6)
          .Line('R', "western edge", "eastern edge")
          .Relate(Tie::kBothSides, 0, 1)
          .Claims({About(Kind::kBothSides, 'B', 'R'), Course('R', "western edge", "eastern edge")})
          .As("houses on either side of the road"),
      PlanWriter('G')
          .Patch('B')
          .Patch('W')
          .Spread('F')
          .Relate(Tie::kBetween, 0, 1, 2)
          .Claims({About(Kind::kBetween, 'B', 'W', 'F')})
          .As("a village between lake and forest"),
      PlanWriter('G')
          .Patch('B')
          .Patch('W')
          .Pieces(2, 30)
          .Relate(Tie::kBetween, 0, 1, 1)
          .Claims({About(Kind::kBetween, 'B', 'W', 'W'), Says(Kind::kCount, 'W', "anywhere", 2, 2)})
          .As("a village between two lakes"),
      PlanWriter('G')
          .Line('W')
          .Spread('F')
          .Spread('A')
          .Relate(Tie::kBetween, 0, 1, 2)
          .Claims({About(Kind::kBetween, 'W', 'F', 'A')})
          .As("a river between forest and fields"),
      PlanWriter('G')
          .Patch('B')
          .Patch('W')
          .Head(0, 1, 0, -1)
          .Claims({Toward('B', 'W', 0, -1)})
          .As("a village north of the lake"),
      PlanWriter('G')
          .Spread('F')
          .Patch('B', {"lower left"})
          .Head(0, 1, 1, -1)
          .Claims({Toward('F', 'B', 1, -1), Says(Kind::kPresent, 'B', "lower left")})
          .As("forest north-east of the town in the south-west"),
      PlanWriter('G')
          .Spread('F')
          .Spread('A')
          .Relate(Tie::kMoreThan, 0, 1)
          .Claims({About(Kind::kMoreThan, 'F', 'A'), Says(Kind::kPresent, 'A')})
          .As("more forest than fields"),
      PlanWriter('G')
          .Line('R')
          .Line('W', "northern edge", "southern edge")
          .Relate(Tie::kAlong, 0, 1)
          .Claims({About(Kind::kAlong, 'R', 'W'), Course('W', "northern edge", "southern edge")})
          .As("a road along the river"),
      PlanWriter('G')
          .Line('R')
          .Patch('W', {"center"})
          .Relate(Tie::kAlong, 0, 1)
          .Claims({Gap(Kind::kAdjacent, 'R', 'W', kUnsaid, 2)})
          .As("a road along the shore"),
      PlanWriter('G')
          .Spread('F')
          .Line('W', "western edge", "eastern edge")
          .Relate(Tie::kAlong, 0, 1)
          .Claims({About(Kind::kAlong, 'F', 'W'), Course('W', "western edge", "eastern edge")})
          .As("forest along the river"),
      PlanWriter('G')
          .Patch('B')
          .Cells(4)
          .Line('R', "western edge", "eastern edge")
          .Relate(Tie::kAlong, 0, 1)
          .Claims({About(Kind::kAlong, 'B', 'R'), Course('R', "western edge", "eastern edge")})
          .As("houses along the road"),
      PlanWriter('G')
          .Line('R')
          .Spread('F')
          .Relate(Tie::kThrough, 0, 1)
          .Claims({About(Kind::kThrough, 'R', 'F')})
          .As("a road through the forest"),
      PlanWriter('G')
          .Line('W')
          .Patch('B')
          .Cells(30)
          .Relate(Tie::kThrough, 0, 1)
          .Claims({About(Kind::kThrough, 'W', 'B')})
          .As("a river through the town"),
      PlanWriter('G')
          .Line('R')
          .Line('W')
          .Relate(Tie::kCrosses, 0, 1)
          .Claims({About(Kind::kCrosses, 'R', 'W'), Says(Kind::kCount, 'W', "anywhere", 1, 1)})
          .As("a road crosses a river"),
      PlanWriter('G')
          .Line('R')
          .Line('W', "western edge", "eastern edge")
          .Relate(Tie::kParallel, 0, 1)
          .Claims({About(Kind::kParallel, 'R', 'W'), Course('W', "western edge", "eastern edge")})
          .As("a road parallel to the river"),
      PlanWriter('G')
          .Line('R')
          .Patch('B', {"upper left"})
          .Patch('W', {"lower right"})
          .Relate(Tie::kConnects, 0, 1, 2)
          .Claims({About(Kind::kConnects, 'R', 'B', 'W'), Says(Kind::kPresent, 'B', "upper left"),
                   Says(Kind::kPresent, 'W', "lower right")})
          .As("a road connects village and lake"),
      PlanWriter('G')
          .Line('R')
          .Patch('B')
          .Pieces(2, 12)
          .Relate(Tie::kConnects, 0, 1, 1)
          .Claims(
              {About(Kind::kConnects, 'R', 'B', 'B'), Says(Kind::kCount, 'B', "anywhere", 2, 2)})
          .As("a road connects two villages"),
      PlanWriter('G')
          .Patch('W', {"lower"})
          .Line('W', "northern edge")
          .ToFeature(0)
          .Claims({Says(Kind::kPresent, 'W', "lower"), Course('W', "northern edge", "lower")})
          .As("a river into the lake"),
      PlanWriter('F')
          .Patch('B', {"center"})
          .Line('R', "western edge")
          .ToFeature(0)
          .Claims({Says(Kind::kPresent, 'B', "center"), Gap(Kind::kAdjacent, 'R', 'B', kUnsaid, 2)})
          .As("a road to the village"),
      PlanWriter('G')
          .Spread('F', {"northern third"})
          .Spread('A', {"middle rows"})
          .Patch('W', {"southern third"})
          .Claims({Order("FAW", 0, 1)})
          .As("from north to south forest fields lake"),
  };
}

// Several things at once.
std::vector<NamedPlan> Combined() {
  return {
      PlanWriter('G')
          .Line('W', "northern edge", "southern edge")
          .Spread('F', {"upper left"})
          .Spread('A', {"eastern third"})
          .Line('R', "western edge", "eastern edge")
          .Patch('B', {"center"})
          .Relate(Tie::kBetween, 0, 1, 2)
          .Claims({Course('W', "northern edge", "southern edge"),
                   Course('R', "western edge", "eastern edge"),
                   Says(Kind::kPresent, 'F', "upper left"),
                   Says(Kind::kPresent, 'A', "eastern third", 0.2),
                   Says(Kind::kPresent, 'B', "center"), About(Kind::kBetween, 'W', 'F', 'A')})
          .As("the river between forest and farmland, a road, a village"),
      PlanWriter('A')
          .Spread('A')
          .FillsRest()
          .Spread('F')
          .Patch('W', {"center"})
          .Relate(Tie::kSurrounds, 1, 2)
          .Claims({Says(Kind::kPresent, 'W', "center"), About(Kind::kSurrounds, 'F', 'W'),
                   Rest('A', "FW"), Says(Kind::kDominant, 'A')})
          .As("a lake surrounded by forest, the rest farmland"),
      PlanWriter('A')
          .Spread('A')
          .Dominant()
          .Line('W', "north-west corner", "south-east corner")
          .Patch('B', {"upper right"})
          .Patch('B', {"lower left"})
          .Line('R')
          .FromFeature(2)
          .ToFeature(3)
          .Relate(Tie::kCrosses, 4, 1)
          .Claims(
              {Says(Kind::kDominant, 'A'), Course('W', "north-west corner", "south-east corner"),
               Says(Kind::kPresent, 'B', "upper right"), Says(Kind::kPresent, 'B', "lower left"),
               Says(Kind::kCount, 'B', "anywhere", 2, 2), About(Kind::kConnects, 'R', 'B', 'B'),
               About(Kind::kCrosses, 'R', 'W')})
          .As("two villages across a river, joined by a road"),
      PlanWriter('G')
          .Patch('W', {"north-western quarter"})
          .Patch('B')
          .Spread('F')
          .Line('R', "southern edge")
          .ToFeature(1)
          .Head(1, 0, 0, 1)
          .Relate(Tie::kNear, 1, 0)
          .Relate(Tie::kWithin, 1, 2)
          .Claims({Says(Kind::kPresent, 'W', "north-western quarter"), Toward('B', 'W', 0, 1),
                   Gap(Kind::kAdjacent, 'B', 'W', kUnsaid, 4),
                   Gap(Kind::kAdjacent, 'R', 'B', kUnsaid, 2)})
          .As("a village south of the lake, near it, in a wood, with a road"),
      PlanWriter('G')
          .Spread('F', {"western half"})
          .Dominant()
          .Spread('A', {"eastern half"})
          .Dominant()
          .Line('W', "northern edge", "southern edge")
          .Patch('B')
          .Pieces(3, 8)
          .Relate(Tie::kBetween, 2, 0, 1)
          .Without('D')
          .Claims({Says(Kind::kDominant, 'F', "western half"),
                   Says(Kind::kDominant, 'A', "eastern half"),
                   Course('W', "northern edge", "southern edge"),
                   Says(Kind::kCount, 'B', "anywhere", 3, 3)})
          .As("forest west, fields east, a river between, three hamlets"),
      PlanWriter('B', Vocabulary::kWild)
          .Spread('S', {"northern third"})
          .Spread('R', {"middle rows"})
          .Spread('F', {"southern third"})
          .Patch('W', {"lower right"})
          .Claims({Order("SRF", 0, 1), Says(Kind::kPresent, 'S', "northern third", 0.2),
                   Says(Kind::kPresent, 'R', "middle rows", 0.2),
                   Says(Kind::kDominant, 'F', "southern third"),
                   Says(Kind::kPresent, 'W', "lower right")})
          .As("snow, rock, forest from north to south and a lake"),
      PlanWriter('R', Vocabulary::kWild)
          .Spread('R')
          .Dominant()
          .Spread('S', {"north-east corner"})
          .Line('W', "north-east corner", "southern edge")
          .Meander(2.0)
          .Shape(ClaimShape::kWinding)
          .Spread('F')
          .Relate(Tie::kAlong, 3, 2)
          .Claims({Says(Kind::kDominant, 'R'), Says(Kind::kPresent, 'S', "north-east corner", 0.2),
                   Course('W', "north-east corner", "southern edge"),
                   Shaped('W', ClaimShape::kWinding), About(Kind::kAlong, 'F', 'W')})
          .As("a winding river out of the snow, woods along it"),
      PlanWriter('G')
          .Patch('W')
          .Cells(90)
          .Patch('F')
          .Cells(6)
          .Patch('B')
          .Cells(4)
          .Line('R')
          .Relate(Tie::kWithin, 1, 0)
          .Relate(Tie::kAdjacent, 2, 0)
          .Relate(Tie::kAdjacent, 3, 2)
          .Claims({Says(Kind::kAmount, 'W', "anywhere", 0.08), About(Kind::kWithin, 'F', 'W'),
                   Gap(Kind::kAdjacent, 'B', 'W', kUnsaid, 2),
                   Gap(Kind::kAdjacent, 'R', 'B', kUnsaid, 2),
                   Says(Kind::kCount, 'W', "anywhere", 1, 1)})
          .As("a large lake with an island, a farm on its shore, a road to it"),
      PlanWriter('G')
          .Spread('F')
          .Share(0.3)
          .Spread('A')
          .Share(0.3)
          .Spread('D')
          .Share(0.2)
          .Patch('B')
          .Pieces(4, 6)
          .Claims({Says(Kind::kAmount, 'F', "anywhere", 0.22, 0.38),
                   Says(Kind::kAmount, 'A', "anywhere", 0.22, 0.38),
                   Says(Kind::kAmount, 'D', "anywhere", 0.12, 0.28),
                   Says(Kind::kCount, 'B', "anywhere", 4, 4)})
          .As("thirty percent forest, thirty fields, twenty bare, four farms"),
  };
}

}  // namespace

std::vector<NamedPlan> SynthesisPlans() {
  std::vector<NamedPlan> plans = Single();
  for (NamedPlan& plan : Related()) plans.push_back(std::move(plan));
  for (NamedPlan& plan : Combined()) plans.push_back(std::move(plan));
  return plans;
}

}  // namespace latticeworld
