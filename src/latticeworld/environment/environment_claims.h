#ifndef LATTICEWORLD_ENVIRONMENT_ENVIRONMENT_CLAIMS_H_
#define LATTICEWORLD_ENVIRONMENT_ENVIRONMENT_CLAIMS_H_

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "latticeworld/common/enum_names.h"
#include "latticeworld/common/range.h"
#include "latticeworld/common/status.h"
#include "latticeworld/environment/environment_config.h"

namespace latticeworld {

enum class EnvironmentClaimKind : std::uint8_t {
  kCoarse,       // a coarse attribute has one of the values
  kDensity,      // an asset type's density lies in [least, most]
  kVariant,      // an asset type's season variant or material is one of the values
  kParameter,    // a continuous parameter of an asset type lies in [least, most]
  kAgents,       // there are so many agents of a category, in such a state, at such a place
  kNoAgents,     // there is no agent of the categories, or none at all
  kTotalAgents,  // there are so many agents in all
};
enum class CoarseKey : std::uint8_t { kTerrainType, kSeason, kArtisticStyle, kWeather, kTimeOfDay };
enum class VariantKey : std::uint8_t { kSeasonVariant, kMaterial };
enum class ParameterKey : std::uint8_t { kRotationYaw, kScale, kHeight, kWind, kSlope };

constexpr std::array<EnumName<EnvironmentClaimKind>, 7> EnumNames(EnvironmentClaimKind) {
  return {{{EnvironmentClaimKind::kCoarse, "coarse"},
           {EnvironmentClaimKind::kDensity, "density"},
           {EnvironmentClaimKind::kVariant, "variant"},
           {EnvironmentClaimKind::kParameter, "parameter"},
           {EnvironmentClaimKind::kAgents, "agents"},
           {EnvironmentClaimKind::kNoAgents, "no_agents"},
           {EnvironmentClaimKind::kTotalAgents, "total_agents"}}};
}
constexpr std::array<EnumName<CoarseKey>, 5> EnumNames(CoarseKey) {
  return {{{CoarseKey::kTerrainType, "terrain_type"},
           {CoarseKey::kSeason, "season"},
           {CoarseKey::kArtisticStyle, "artistic_style"},
           {CoarseKey::kWeather, "weather"},
           {CoarseKey::kTimeOfDay, "time_of_day"}}};
}
constexpr std::array<EnumName<VariantKey>, 2> EnumNames(VariantKey) {
  return {{{VariantKey::kSeasonVariant, "season_variant"}, {VariantKey::kMaterial, "material"}}};
}
constexpr std::array<EnumName<ParameterKey>, 5> EnumNames(ParameterKey) {
  return {{{ParameterKey::kRotationYaw, "rotation_yaw"},  // [degrees]
           {ParameterKey::kScale, "scale"},
           {ParameterKey::kHeight, "height_m"},
           {ParameterKey::kWind, "wind_mps"},
           {ParameterKey::kSlope, "slope_deg"}}};
}

// The legal values of a parameter.
const Range& RangeOf(ParameterKey key);

// One thing that an instruction says about an environment, checkable on the configuration alone.
// Which fields count depends on the kind; the others keep their defaults.
struct EnvironmentClaim {
  EnvironmentClaimKind kind = EnvironmentClaimKind::kCoarse;
  CoarseKey coarse_key = CoarseKey::kTerrainType;           // kCoarse
  AssetType asset = AssetType::kGrass;                      // kDensity, kVariant, kParameter
  VariantKey variant_key = VariantKey::kSeasonVariant;      // kVariant
  ParameterKey parameter_key = ParameterKey::kRotationYaw;  // kParameter
  std::vector<std::string> values;                          // kCoarse, kVariant: any of them
  double least = 0.0;                                       // kDensity, kParameter
  double most = 0.0;                      // inclusive; a yaw with least > most goes through 0
  std::vector<AgentCategory> categories;  // kAgents: any of them; kNoAgents: empty is every one
  int least_quantity = 1;                 // kAgents, kTotalAgents
  int most_quantity = kMaxAgents;
  std::vector<AgentState> states;  // kAgents: any of them; empty: any state
  std::vector<Region> positions;   // kAgents: any of them; empty: any place. kAnywhere is a value
                                   // of its own: no place is asked for
  std::string words;               // of the instruction
};

// What is wrong with a claim itself: values outside the tables (BuiltIn()'s only), ranges upside
// down, a parameter that the asset type lacks, nothing asked. Pointers name the JSON keys.
std::vector<Violation> Validate(const EnvironmentClaim& claim);

struct EnvironmentClaimMeasure {
  bool holds = false;
  double distance = 0.0;    // how far the configuration is from the claim: 0 when it holds, up to 1
  std::string explanation;  // "weather is rain; sunny or cloudy is asked"
};

// The claim must be valid. Agents hold when some of the groups that match category, state and place
// have together a quantity in the range: of "two goblins and five goblins" each half holds by
// itself.
EnvironmentClaimMeasure Measure(const EnvironmentClaim& claim, const EnvironmentConfig& config);

}  // namespace latticeworld

#endif  // LATTICEWORLD_ENVIRONMENT_ENVIRONMENT_CLAIMS_H_
