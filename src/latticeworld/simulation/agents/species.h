#ifndef LATTICEWORLD_SIMULATION_AGENTS_SPECIES_H_
#define LATTICEWORLD_SIMULATION_AGENTS_SPECIES_H_

#include "latticeworld/environment/agent_group.h"

namespace latticeworld {

// What a category can do.
struct Species {
  AgentCategory category;
  double mass_kg;
  double height_m;           // of the body
  double eye_height_m;       // above base_link
  double cruise_mps;         // speed when it goes about its business
  double top_speed_mps;      // at most, commanded or hunting
  double acceleration_mps2;  // at most
  double turn_rate_radps;    // at most
  double max_slope_rad;      // steepest ground that it walks onto
  double wade_depth_m;       // deepest water that it walks into; fins: shallowest that it swims in
  double grip;               // times the friction of the surface
  double altitude_m;         // wings: above ground and obstacles when it flies by itself
  double drag_area_m2;       // drag coefficient times the area that wind from the side meets
  double hit_points;
  double attack_reach_m;  // between the two bodies' sides; 0: does not attack
  double attack_damage;   // hit points a blow
  double attack_pause_s;  // between blows
};

const Species& SpeciesOf(AgentCategory category);

// 0 neutral, 1 robots and everything controlled from outside, 2 adversaries.
int TeamOf(AgentCategory category, bool controllable);
// What a category does when nobody says.
AgentState UsualState(AgentCategory category);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_AGENTS_SPECIES_H_
