#ifndef LATTICEWORLD_ENVIRONMENT_FINE_PARAMETER_H_
#define LATTICEWORLD_ENVIRONMENT_FINE_PARAMETER_H_

#include <array>
#include <cstdint>
#include <string>

#include "latticeworld/common/enum_names.h"
#include "latticeworld/common/range.h"
#include "latticeworld/environment/fine_attributes.h"

namespace latticeworld {

// The continuous parameters of fine attributes, by the names that rules call them.
enum class FineParameter : std::uint8_t {
  kDensity,
  kRoll,
  kPitch,
  kYaw,
  kScale,
  kHeight,
  kWind,
  kSlope
};
inline constexpr int kFineParameterCount = 8;

constexpr std::array<EnumName<FineParameter>, kFineParameterCount> EnumNames(FineParameter) {
  return {{{FineParameter::kDensity, "density"},
           {FineParameter::kRoll, "roll"},    // [degrees]
           {FineParameter::kPitch, "pitch"},  // [degrees]
           {FineParameter::kYaw, "yaw"},      // [degrees]
           {FineParameter::kScale, "scale"},
           {FineParameter::kHeight, "height"},  // [m]
           {FineParameter::kWind, "wind"},      // [m/s]
           {FineParameter::kSlope, "slope"}}};  // [degrees]
}

// The values that are legal whatever the coarse attributes say.
const Range& RangeOf(FineParameter parameter);
// Whether assets of the type have the parameter.
bool HasParameter(const AssetTypeValues& values, FineParameter parameter);

double ValueOf(const FineAttribute& fine, FineParameter parameter);
void SetValue(FineParameter parameter, double value, FineAttribute* fine);

// Returns the pointer to the parameter in the JSON of its type: "/density", "/rotation/2".
std::string PointerOf(FineParameter parameter);

}  // namespace latticeworld

#endif  // LATTICEWORLD_ENVIRONMENT_FINE_PARAMETER_H_
