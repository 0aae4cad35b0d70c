#include "latticeworld/species/species_file.h"

#include <cstddef>
#include <limits>
#include <nlohmann/json.hpp>

#include "latticeworld/common/data_files.h"
#include "latticeworld/common/strict_json.h"
#include "latticeworld/common/text.h"
#include "latticeworld/species/species_rules.h"

namespace latticeworld {
namespace {

using Json = nlohmann::json;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

template <typename Struct>
struct NumberKey {
  const char* name;
  double Struct::*field;
};

constexpr NumberKey<Species> kSpeciesKeys[] = {
    {"mass_kg", &Species::mass_kg},
    {"height_m", &Species::height_m},
    {"radius_m", &Species::radius_m},
    {"eye_height_m", &Species::eye_height_m},
    {"cruise_mps", &Species::cruise_mps},
    {"top_speed_mps", &Species::top_speed_mps},
    {"acceleration_mps2", &Species::acceleration_mps2},
    {"turn_rate_radps", &Species::turn_rate_radps},
    {"max_slope_rad", &Species::max_slope_rad},
    {"wade_depth_m", &Species::wade_depth_m},
    {"grip", &Species::grip},
    {"altitude_m", &Species::altitude_m},
    {"drag_area_m2", &Species::drag_area_m2},
    {"water_drag_area_m2", &Species::water_drag_area_m2},
    {"density_kgpm3", &Species::density_kgpm3},
    {"drowning_depth_m", &Species::drowning_depth_m},
    {"drowning_time_s", &Species::drowning_time_s},
    {"field_of_view_rad", &Species::field_of_view_rad},
    {"sight_m", &Species::sight_m},
    {"hearing_m", &Species::hearing_m},
    {"hit_points", &Species::hit_points},
    {"attack_reach_m", &Species::attack_reach_m},
    {"attack_damage", &Species::attack_damage},
    {"attack_pause_s", &Species::attack_pause_s},
    {"attack_impulse_ns", &Species::attack_impulse_ns},
    {"knock_over_mps", &Species::knock_over_mps},
    {"get_up_s", &Species::get_up_s},
    {"hurt_share", &Species::hurt_share},
    {"respawn_s", &Species::respawn_s},
};

constexpr NumberKey<VehicleDesign> kVehicleKeys[] = {
    {"wheel_radius_m", &VehicleDesign::wheel_radius_m},
    {"wheel_width_m", &VehicleDesign::wheel_width_m},
    {"wheel_mass_kg", &VehicleDesign::wheel_mass_kg},
    {"track_m", &VehicleDesign::track_m},
    {"wheelbase_m", &VehicleDesign::wheelbase_m},
    {"max_torque_nm", &VehicleDesign::max_torque_nm},
    {"max_steering_rad", &VehicleDesign::max_steering_rad},
    {"spring_npm", &VehicleDesign::spring_npm},
    {"damper_nspm", &VehicleDesign::damper_nspm},
    {"travel_m", &VehicleDesign::travel_m},
    {"chassis_length_m", &VehicleDesign::chassis_length_m},
    {"chassis_width_m", &VehicleDesign::chassis_width_m},
    {"ground_clearance_m", &VehicleDesign::ground_clearance_m},
    {"center_height_m", &VehicleDesign::center_height_m},
};

constexpr NumberKey<QuadrupedDesign> kQuadrupedKeys[] = {
    {"hip_x_m", &QuadrupedDesign::hip_x_m},
    {"hip_y_m", &QuadrupedDesign::hip_y_m},
    {"abductor_m", &QuadrupedDesign::abductor_m},
    {"thigh_m", &QuadrupedDesign::thigh_m},
    {"shank_m", &QuadrupedDesign::shank_m},
    {"foot_radius_m", &QuadrupedDesign::foot_radius_m},
    {"leg_mass_kg", &QuadrupedDesign::leg_mass_kg},
    {"stance_height_m", &QuadrupedDesign::stance_height_m},
    {"swing_height_m", &QuadrupedDesign::swing_height_m},
    {"stride_period_s", &QuadrupedDesign::stride_period_s},
    {"max_effort_nm", &QuadrupedDesign::max_effort_nm},
    {"max_rate_radps", &QuadrupedDesign::max_rate_radps},
    {"trunk_length_m", &QuadrupedDesign::trunk_length_m},
    {"trunk_width_m", &QuadrupedDesign::trunk_width_m},
    {"trunk_height_m", &QuadrupedDesign::trunk_height_m},
};

// What the json has of the keys; others stay as they are.
template <typename Struct, std::size_t kCount>
void ReadNumbers(const Json& json, const NumberKey<Struct> (&keys)[kCount], Struct* to) {
  for (const NumberKey<Struct>& key : keys) {
    const auto found = json.find(key.name);
    if (found != json.end()) to->*key.field = static_cast<double>(*found);
  }
}

// json: keeps to the schema.
Species ReadSpecies(const Json& json) {
  Species species;
  species.name = json.at("name").get<std::string>();
  species.category = *FromName<AgentCategory>(json.at("category").get<std::string>());
  species.plan = *FromName<BodyPlan>(json.at("plan").get<std::string>());
  species.drowning_depth_m = kInfinity;
  species.knock_over_mps = kInfinity;
  ReadNumbers(json, kSpeciesKeys, &species);
  if (json.contains("vehicle")) {
    VehicleDesign& design = species.vehicle.emplace();
    design.drive = *FromName<DriveKind>(json.at("vehicle").at("drive").get<std::string>());
    design.max_steering_rad = 0.0;
    ReadNumbers(json.at("vehicle"), kVehicleKeys, &design);
  }
  if (json.contains("quadruped")) {
    ReadNumbers(json.at("quadruped"), kQuadrupedKeys, &species.quadruped.emplace());
  }
  return species;
}

}  // namespace

std::vector<SpeciesEntry> ReadSpeciesFile(const std::string& file_name, const std::string& text,
                                          const SchemaChecker& checker,
                                          std::vector<Violation>* violations) {
  std::vector<SpeciesEntry> entries;
  std::vector<Violation> found;
  const std::string origin = file_name + "#";
  Json json;
  if (ParseStrictly(text, origin, JsonLimits(), &json, &found)) {
    checker.Check(json, origin, &found);
    if (json.is_object() && json.contains("species") && json.at("species").is_array()) {
      for (std::size_t i = 0; i < json.at("species").size(); ++i) {
        std::string pointer = origin + "/species/" + std::to_string(i);
        if (!IsSound(pointer, found)) continue;
        Species species = ReadSpecies(json.at("species")[i]);
        CheckSpecies(species, pointer, &found);
        entries.push_back({std::move(species), std::move(pointer)});
      }
    }
  }
  violations->insert(violations->end(), found.begin(), found.end());
  return entries;
}

}  // namespace latticeworld
