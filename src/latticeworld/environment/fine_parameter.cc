#include "latticeworld/environment/fine_parameter.h"

#include "latticeworld/environment/ranges.h"

namespace latticeworld {

const Range& RangeOf(FineParameter parameter) {
  switch (parameter) {
    case FineParameter::kRoll:
    case FineParameter::kPitch:
    case FineParameter::kYaw:
      return kRotationRange;
    case FineParameter::kScale:
      return kScaleRange;
    case FineParameter::kHeight:
      return kHeightRange;
    case FineParameter::kWind:
      return kWindRange;
    case FineParameter::kSlope:
      return kSlopeRange;
    case FineParameter::kDensity:
      break;
  }
  return kDensityRange;
}

bool HasParameter(const AssetTypeValues& values, FineParameter parameter) {
  switch (parameter) {
    case FineParameter::kDensity:
      return true;
    case FineParameter::kRoll:
    case FineParameter::kPitch:
    case FineParameter::kYaw:
      return values.has_rotation;
    case FineParameter::kScale:
      return values.has_scale;
    case FineParameter::kHeight:
      return values.has_height;
    case FineParameter::kWind:
      return values.has_wind;
    case FineParameter::kSlope:
      return values.has_slope;
  }
  return false;
}

double ValueOf(const FineAttribute& fine, FineParameter parameter) {
  switch (parameter) {
    case FineParameter::kDensity:
      return fine.density;
    case FineParameter::kRoll:
      return fine.rotation_deg[0];
    case FineParameter::kPitch:
      return fine.rotation_deg[1];
    case FineParameter::kYaw:
      return fine.rotation_deg[2];
    case FineParameter::kScale:
      return fine.scale;
    case FineParameter::kHeight:
      return fine.height_m;
    case FineParameter::kWind:
      return fine.wind_mps;
    case FineParameter::kSlope:
      return fine.slope_deg;
  }
  return 0.0;
}

void SetValue(FineParameter parameter, double value, FineAttribute* fine) {
  switch (parameter) {
    case FineParameter::kDensity:
      fine->density = value;
      break;
    case FineParameter::kRoll:
      fine->rotation_deg[0] = value;
      break;
    case FineParameter::kPitch:
      fine->rotation_deg[1] = value;
      break;
    case FineParameter::kYaw:
      fine->rotation_deg[2] = value;
      break;
    case FineParameter::kScale:
      fine->scale = value;
      break;
    case FineParameter::kHeight:
      fine->height_m = value;
      break;
    case FineParameter::kWind:
      fine->wind_mps = value;
      break;
    case FineParameter::kSlope:
      fine->slope_deg = value;
      break;
  }
}

std::string PointerOf(FineParameter parameter) {
  switch (parameter) {
    case FineParameter::kRoll:
      return "/rotation/0";
    case FineParameter::kPitch:
      return "/rotation/1";
    case FineParameter::kYaw:
      return "/rotation/2";
    default:
      return "/" + std::string(NameOf(parameter));
  }
}

}  // namespace latticeworld
