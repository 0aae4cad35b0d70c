#ifndef LATTICEWORLD_ROS_CONVERSION_POINT_TIMES_H_
#define LATTICEWORLD_ROS_CONVERSION_POINT_TIMES_H_

#include <array>

#include "latticeworld/common/enum_names.h"

namespace latticeworld {

// What the stamp of a lidar's points is, from which the time of each point counts [s].
enum class PointTimes {
  kEnd,   // the revolution's end: times are never above 0
  kBegin  // the revolution's begin: times are never below 0
};
constexpr std::array<EnumName<PointTimes>, 2> EnumNames(PointTimes) {
  return {{{PointTimes::kEnd, "end"}, {PointTimes::kBegin, "begin"}}};
}

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_CONVERSION_POINT_TIMES_H_
