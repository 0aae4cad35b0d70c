#ifndef LATTICEWORLD_SPECIES_SPECIES_H_
#define LATTICEWORLD_SPECIES_SPECIES_H_

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "latticeworld/common/enum_names.h"
#include "latticeworld/environment/agent_group.h"

namespace latticeworld {

// How a body is built and gets about.
enum class BodyPlan : std::uint8_t {
  kVehicle,    // wheels on a chassis
  kQuadruped,  // a trunk on four legs of three actuated joints each
  kBiped,      // an upright character that can be knocked over and gets up again
  kGrazer,     // an upright animal on four stiff legs
  kFlyer,      // thrust, drag, wind
  kSwimmer     // buoyancy, strokes, drag
};
constexpr std::array<EnumName<BodyPlan>, 6> EnumNames(BodyPlan) {
  return {{{BodyPlan::kVehicle, "vehicle"},
           {BodyPlan::kQuadruped, "quadruped"},
           {BodyPlan::kBiped, "biped"},
           {BodyPlan::kGrazer, "grazer"},
           {BodyPlan::kFlyer, "flyer"},
           {BodyPlan::kSwimmer, "swimmer"}}};
}

inline bool IsOnLegs(BodyPlan plan) {
  return plan == BodyPlan::kQuadruped || plan == BodyPlan::kBiped || plan == BodyPlan::kGrazer;
}
// Returns whether it moves in the air or in water, where nothing holds it but itself.
inline bool KeepsAfloat(BodyPlan plan) {
  return plan == BodyPlan::kFlyer || plan == BodyPlan::kSwimmer;
}

enum class DriveKind : std::uint8_t {
  kDifferential,  // two driven wheels, and a castor that follows
  kSkidSteer,     // every wheel driven, the wheels of a side together
  kAckermann      // rear wheels driven, front wheels steered
};
constexpr std::array<EnumName<DriveKind>, 3> EnumNames(DriveKind) {
  return {{{DriveKind::kDifferential, "differential"},
           {DriveKind::kSkidSteer, "skid_steer"},
           {DriveKind::kAckermann, "ackermann"}}};
}

struct VehicleDesign {
  DriveKind drive = DriveKind::kSkidSteer;
  double wheel_radius_m = 0.12;
  double wheel_width_m = 0.06;
  double wheel_mass_kg = 1.5;
  double track_m = 0.46;          // between the contact points of the left and right wheels
  double wheelbase_m = 0.36;      // between front and rear axle (differential: axle and castor)
  double max_torque_nm = 14.0;    // of one driven wheel
  double max_steering_rad = 0.6;  // kAckermann: of the middle of the steered axle
  double spring_npm = 0.0;        // of one wheel's suspension; 0: axles are rigid
  double damper_nspm = 0.0;       // of one wheel's suspension
  double travel_m = 0.0;          // of a wheel, up and down from rest
  double chassis_length_m = 0.56;
  double chassis_width_m = 0.36;
  double ground_clearance_m = 0.1;
  double center_height_m = 0.16;  // of the chassis' centre of mass
};

// How much of a wheel's grip along holds sideways: all of a tyre's that rolls; a skid steer's give
// way, or it could not turn.
inline constexpr double kTyreSideGrip = 1.0;
inline constexpr double kSkidSideGrip = 0.55;

struct QuadrupedDesign {
  double hip_x_m = 0.2;      // hips before and behind the middle
  double hip_y_m = 0.08;     // hips beside it
  double abductor_m = 0.08;  // from the hip's roll joint out to the leg
  double thigh_m = 0.25, shank_m = 0.25;
  double foot_radius_m = 0.025;
  double leg_mass_kg = 2.0;       // of one leg
  double stance_height_m = 0.36;  // hip above foot, standing
  double swing_height_m = 0.07;   // of a foot, walking
  double stride_period_s = 0.5;   // of a trot
  double max_effort_nm = 60.0;    // of a joint
  double max_rate_radps = 20.0;   // of a joint
  double trunk_length_m = 0.5, trunk_width_m = 0.25, trunk_height_m = 0.15;
};

// What a kind of agent is and can do. Lengths are those of the standing body; base_link is at its
// lowest point at rest.
struct Species {
  std::string name;  // unique; letters, digits and single spaces: "sheep", "ackermann car"
  AgentCategory category = AgentCategory::kSheep;  // whose words, states, team and spawn rules
  BodyPlan plan = BodyPlan::kGrazer;

  double mass_kg = 60.0;  // all of it
  double height_m = 1.0;
  // The radius of the vertical cylinder around it: the one footprint that spawning, paths, maps and
  // tasks take.
  double radius_m = 0.5;
  double eye_height_m = 0.9;  // above base_link

  double cruise_mps = 1.0;         // when it goes about its business
  double top_speed_mps = 3.0;      // at most, commanded or hunting
  double acceleration_mps2 = 3.0;  // at most
  double turn_rate_radps = 2.0;    // at most
  double max_slope_rad = 0.6;      // steepest ground that it goes onto
  double wade_depth_m = 0.2;       // deepest water that it goes into by itself; swimmers:
                                   // shallowest that they swim in
  double grip = 1.0;               // times the friction of the surface
  double altitude_m = 0.0;         // flyers: above ground and obstacles when they fly by themselves
  double drag_area_m2 = 0.4;       // drag coefficient times area, in air, from the side
  double water_drag_area_m2 = 0.5;  // the same in water
  double density_kgpm3 = 1000.0;    // of the whole body: below 1000 it floats
  double drowning_depth_m = 1.0;    // water above base_link that harms it; infinity: never
  double drowning_time_s = 5.0;     // unharmed to dead in such water

  double field_of_view_rad = 3.5;  // (0, 2 pi]
  double sight_m = 60.0;           // in clear air and daylight
  double hearing_m = 15.0;         // of a running agent, in calm air

  double hit_points = 30.0;
  double attack_reach_m = 0.0;     // between the two bodies' sides; 0: it cannot strike
  double attack_damage = 0.0;      // hit points a blow
  double attack_pause_s = 1.0;     // between blows
  double attack_impulse_ns = 0.0;  // that a blow gives to who is hit [N s]
  double knock_over_mps = 2.5;     // change of speed in a blow or collision that fells it;
                                   // infinity: never (kBiped; the others follow physics)
  double get_up_s = 2.0;           // from lying still to standing
  double hurt_share = 0.3;         // of its hit points below which it retreats; 0: never
  double respawn_s = 0.0;          // after its death, at its start; 0: it stays dead

  std::optional<VehicleDesign> vehicle;      // kVehicle, and only there
  std::optional<QuadrupedDesign> quadruped;  // kQuadruped, and only there
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SPECIES_SPECIES_H_
