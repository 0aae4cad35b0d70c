#ifndef LATTICEWORLD_SCENE_SETTLEMENTS_SETTLEMENT_RULES_H_
#define LATTICEWORLD_SCENE_SETTLEMENTS_SETTLEMENT_RULES_H_

namespace latticeworld {

// This header says where buildings stand. Distances are between walls, edges of streets and borders
// of land; none of them grows with the buildings' scale.

// The least distance between the walls of two buildings. The houses of a terrace touch.
inline constexpr double kLeastWallGap_m = 3.0;
// The greatest distance from a building's wall to the next street, or to the wall of another
// building.
inline constexpr double kMostToNeighbour_m = 60.0;
// The distance from the edge of the street to the wall of a building that fronts it.
inline constexpr double kLeastSetback_m = 2.0;
inline constexpr double kMostSetback_m = 12.0;
// Turn of a front against its street, either way, beyond the environment's own rotation.
inline constexpr double kMostTurn_deg = 4.0;
// Difference between the highest and the lowest ground under a building; also no more than
// kSteepestForBuildings_deg over its shorter side.
inline constexpr double kMostReliefBelow_m = 2.0;
// Share of built-up land under the middle of a building; barns and sheds may stand at its hem.
inline constexpr double kLeastBuiltUp = 0.5;
inline constexpr double kLeastBuiltUpOfBarns = 0.05;

// Scatter of the order in which a settlement grows from its heart outwards, in reaches of it.
inline constexpr double kPlotScatter = 0.5;
// Pieces of built-up land from this size have a building at least.
inline constexpr double kLeastSettlement_m2 = 60.0;

// What is built where.
inline constexpr double kFarmReach_m = 60.0;       // farms stand so near to fields
inline constexpr double kHamletBelow_m2 = 4000.0;  // smaller areas without a street
inline constexpr double kTownFrom_m2 = 20000.0;    // areas from this size have terraces
inline constexpr double kCityFrom_m2 = 60000.0;    // and from this apartment blocks and towers
inline constexpr double kChurchFrom_m2 = 7000.0;   // and from this a church
inline constexpr double kInner_m = 40.0;           // from the area's border: its denser part

}  // namespace latticeworld

#endif  // LATTICEWORLD_SCENE_SETTLEMENTS_SETTLEMENT_RULES_H_
