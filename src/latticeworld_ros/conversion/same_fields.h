#ifndef LATTICEWORLD_ROS_CONVERSION_SAME_FIELDS_H_
#define LATTICEWORLD_ROS_CONVERSION_SAME_FIELDS_H_

#include <ros/message_traits.h>

namespace latticeworld {

// Whether two message types have the same constants and the same fields in the same order. ROS sums
// these up in a type's MD5, which is known when the program is built.
template <typename A, typename B>
constexpr bool HaveSameFields() {
  using SumOfA = ros::message_traits::MD5Sum<A>;
  using SumOfB = ros::message_traits::MD5Sum<B>;
  return SumOfA::static_value1 == SumOfB::static_value1 &&
         SumOfA::static_value2 == SumOfB::static_value2;
}

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_CONVERSION_SAME_FIELDS_H_
