#ifndef LATTICEWORLD_ENVIRONMENT_RANGES_H_
#define LATTICEWORLD_ENVIRONMENT_RANGES_H_

namespace latticeworld {

// The legal values of a continuous parameter, for validation and schema alike.
struct Range {
  double low;
  double high;
  bool half_open = false;  // high itself is excluded
};

inline constexpr Range kDensityRange{0.0, 1.0};
inline constexpr Range kRotationRange{0.0, 360.0, true};  // [degrees]
inline constexpr Range kScaleRange{0.25, 4.0};
inline constexpr Range kHeightRange{-5.0, 5.0};  // [m]
inline constexpr Range kWindRange{0.0, 40.0};    // [m/s]
inline constexpr Range kSlopeRange{0.0, 90.0};   // [degrees]

}  // namespace latticeworld

#endif  // LATTICEWORLD_ENVIRONMENT_RANGES_H_
