#ifndef LATTICEWORLD_TERRAIN_WAYS_STREETS_H_
#define LATTICEWORLD_TERRAIN_WAYS_STREETS_H_

#include <cstdint>
#include <vector>

#include "latticeworld/terrain/terrain.h"
#include "latticeworld/terrain/ways/street_field.h"
#include "latticeworld/terrain/ways/street_network.h"

namespace latticeworld::internal {

// The measures of local streets.
struct StreetRule {
  double main_width_m = 5.0;  // of the street that an area begins with
  double lane_width_m = 4.0;
  double block_length_m = 88.0;   // between streets across the area's main direction
  double block_depth_m = 64.0;    // between streets along it: two rows of plots
  double road_reach_m = 60.0;     // of land outside of the area that a lane to a road crosses
  double least_area_m2 = 1500.0;  // smaller ones have no street
};

// Streets are paved in worlds whose cells are no larger than this [m]: a lane must not look wider
// than it is by more than a cell.
inline constexpr double kCoarsestPaved_m = 4.0;

// Lays out the local streets of every built-up area: beginning at the road of the layout that
// touches it, or with a lane that leads to the next one within reach, or else with a main street
// through its middle, streets branch off streets at about the distance of a block until the area is
// served. So every area's streets hang together. Small areas get one lane and dead ends, large ones
// blocks.
std::vector<Street> LayOutStreets(const StreetGround& ground, const StreetRule& rule,
                                  std::uint64_t seed);

// Marks the streets' cells on the lattice, and points them to their centre lines, as GradeRoads
// wants it. road: gets 1 there.
void MarkStreets(const GridGeometry& lattice, const std::vector<Street>& streets,
                 const Grid<unsigned char>& wet, Grid<unsigned char>* road, DecodedLayout* lines);

// Makes dry ground within the streets' width road.
void PaveStreets(const std::vector<Street>& streets, Terrain* terrain);

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_TERRAIN_WAYS_STREETS_H_
