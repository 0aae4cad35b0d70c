#include "latticeworld/species/species_rules.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/common/text.h"
#include "latticeworld/species/vehicle_outline.h"

namespace latticeworld {
namespace {

// A leg that is nearly straight cannot push, one that is nearly folded cannot swing.
constexpr double kMostLegStretch = 0.97;
constexpr double kLeastLegStretch = 0.4;
// Half the track over the tightest turn's radius: at 1 a car turns about its own inner wheel.
constexpr double kTightestTurn = 0.9;

bool Fits(BodyPlan plan, Locomotion locomotion) {
  switch (plan) {
    case BodyPlan::kVehicle:
      return locomotion == Locomotion::kWheels;
    case BodyPlan::kQuadruped:
    case BodyPlan::kBiped:
    case BodyPlan::kGrazer:
      return locomotion == Locomotion::kLegs;
    case BodyPlan::kFlyer:
      return locomotion == Locomotion::kWings;
    case BodyPlan::kSwimmer:
      return locomotion == Locomotion::kFins;
  }
  return false;
}

class Checker {
 public:
  Checker(const std::string& pointer, std::vector<Violation>* violations)
      : pointer_(pointer), violations_(violations) {}

  void Demand(bool holds, const char* key, const std::string& message, double given) {
    if (holds) return;
    violations_->push_back({"out_of_range", pointer_ + "/" + key, message, FormatDouble(given)});
  }
  void DemandPart(bool wanted, bool there, const char* key, BodyPlan plan) {
    if (wanted == there) return;
    const std::string plan_name(NameOf(plan));
    violations_->push_back({wanted ? "missing_key" : "unknown_key", pointer_ + "/" + key,
                            wanted ? "is missing; the plan " + plan_name + " needs it"
                                   : "the plan " + plan_name + " has none",
                            ""});
  }
  void Add(const char* code, const char* key, const std::string& message,
           const std::string& given) {
    violations_->push_back({code, pointer_ + "/" + key, message, given});
  }

 private:
  const std::string pointer_;
  std::vector<Violation>* const violations_;
};

void CheckVehicle(const Species& species, Checker* check) {
  const VehicleDesign& design = *species.vehicle;
  const bool steered = design.drive == DriveKind::kAckermann;
  const int wheels = design.drive == DriveKind::kDifferential ? 3 : 4;
  check->Demand(wheels * design.wheel_mass_kg <= 0.8 * species.mass_kg, "vehicle/wheel_mass_kg",
                "its wheels may have at most 0.8 of its mass", design.wheel_mass_kg);
  check->Demand(steered == (design.max_steering_rad > 0.0), "vehicle/max_steering_rad",
                steered ? "an ackermann vehicle needs it over 0" : "it steers no wheel",
                design.max_steering_rad);
  const double tightest =
      0.5 * design.track_m * std::tan(design.max_steering_rad) / design.wheelbase_m;
  check->Demand(!steered || tightest < kTightestTurn, "vehicle/max_steering_rad",
                "it would turn about its own wheels; half the track times the tangent must be "
                "below 0.9 of the wheelbase of " +
                    FormatDouble(design.wheelbase_m),
                design.max_steering_rad);
  const bool sprung = design.spring_npm > 0.0;
  check->Demand(sprung == (design.damper_nspm > 0.0), "vehicle/damper_nspm",
                sprung ? "a spring needs a damper" : "there is no spring", design.damper_nspm);
  check->Demand(sprung == (design.travel_m > 0.0), "vehicle/travel_m",
                sprung ? "a spring needs travel" : "there is no spring", design.travel_m);
  check->Demand(design.ground_clearance_m < species.height_m, "vehicle/ground_clearance_m",
                "the chassis begins below the height of " + FormatDouble(species.height_m),
                design.ground_clearance_m);
  check->Demand(design.center_height_m < species.height_m, "vehicle/center_height_m",
                "it lies below the height of " + FormatDouble(species.height_m),
                design.center_height_m);
  const double reach_m = CircumscribedRadius(design);
  check->Demand(species.radius_m >= reach_m, "radius_m",
                "wheels and chassis reach out to " + FormatDouble(reach_m), species.radius_m);
}

void CheckQuadruped(const Species& species, Checker* check) {
  const QuadrupedDesign& design = *species.quadruped;
  check->Demand(4.0 * design.leg_mass_kg <= 0.6 * species.mass_kg, "quadruped/leg_mass_kg",
                "its legs may have at most 0.6 of its mass", design.leg_mass_kg);
  const double leg_m = design.thigh_m + design.shank_m;
  const double stretch = (design.stance_height_m - design.foot_radius_m) / leg_m;
  check->Demand(stretch > kLeastLegStretch && stretch < kMostLegStretch,
                "quadruped/stance_height_m",
                "without the foot it must be 0.4 to 0.97 of the leg's " + FormatDouble(leg_m),
                design.stance_height_m);
  check->Demand(0.5 * design.trunk_height_m < design.stance_height_m - design.swing_height_m,
                "quadruped/trunk_height_m", "the trunk must clear its swinging feet",
                design.trunk_height_m);
  const double reach_m =
      std::hypot(std::max(design.hip_x_m, 0.5 * design.trunk_length_m),
                 std::max(design.hip_y_m + design.abductor_m, 0.5 * design.trunk_width_m));
  check->Demand(species.radius_m >= reach_m, "radius_m",
                "trunk and feet reach out to " + FormatDouble(reach_m), species.radius_m);
}

}  // namespace

void CheckSpecies(const Species& species, const std::string& pointer,
                  std::vector<Violation>* violations) {
  Checker check(pointer, violations);
  if (!Fits(species.plan, LocomotionOf(species.category))) {
    check.Add("unknown_value", "plan",
              "a " + std::string(NameOf(species.category)) + " is not built so",
              Quote(NameOf(species.plan)));
  }
  check.Demand(species.cruise_mps <= species.top_speed_mps, "cruise_mps",
               "must not be over top_speed_mps, " + FormatDouble(species.top_speed_mps),
               species.cruise_mps);
  check.Demand(species.eye_height_m <= species.height_m, "eye_height_m",
               "must not be over height_m, " + FormatDouble(species.height_m),
               species.eye_height_m);
  check.Demand(species.plan != BodyPlan::kFlyer || species.altitude_m > 0.0, "altitude_m",
               "a flyer needs it over 0", species.altitude_m);
  check.Demand(species.attack_reach_m > 0.0 || species.attack_damage == 0.0, "attack_damage",
               "what has no attack_reach_m cannot strike", species.attack_damage);
  check.Demand(
      species.plan == BodyPlan::kSwimmer || species.wade_depth_m <= species.drowning_depth_m,
      "wade_depth_m", "it would drown, from " + FormatDouble(species.drowning_depth_m) + " on",
      species.wade_depth_m);
  check.Demand(species.plan == BodyPlan::kBiped || std::isinf(species.knock_over_mps),
               "knock_over_mps", "only a biped has it; the others fall as physics has it",
               species.knock_over_mps);
  check.DemandPart(species.plan == BodyPlan::kVehicle, species.vehicle.has_value(), "vehicle",
                   species.plan);
  check.DemandPart(species.plan == BodyPlan::kQuadruped, species.quadruped.has_value(), "quadruped",
                   species.plan);
  if (species.vehicle) CheckVehicle(species, &check);
  if (species.quadruped) CheckQuadruped(species, &check);
}

}  // namespace latticeworld
