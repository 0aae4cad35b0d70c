#include "latticeworld/geometry/upright.h"

#include <gtest/gtest.h>

namespace latticeworld {
namespace {

const Eigen::Vector3d kUp = Eigen::Vector3d::UnitZ();

TEST(TurnFromUpTest, CarriesUpToEveryDirectionOfAnyLength) {
  for (const Eigen::Vector3d& direction :
       {Eigen::Vector3d(0.0, 0.0, 2.0), Eigen::Vector3d(1.0, 0.0, 0.0),
        Eigen::Vector3d(-3.0, 4.0, 0.5), Eigen::Vector3d(0.0, 0.5, -5.0)})
    EXPECT_TRUE((TurnFromUp(direction) * kUp).isApprox(direction.normalized(), 1e-9))
        << direction.transpose();
}

TEST(TurnFromUpTest, TurnsDownwardToo) {
  EXPECT_TRUE((TurnFromUp(-kUp) * kUp).isApprox(-kUp, 1e-9));
}

TEST(TurnFromUpTest, TurnsAboutALevelAxis) {
  // The shortest turn leaves what is level and across the direction where it is.
  const Eigen::Vector3d direction(2.0, 1.0, 3.0), across(-1.0, 2.0, 0.0);
  EXPECT_TRUE((TurnFromUp(direction) * across).isApprox(across, 1e-9));
}

}  // namespace
}  // namespace latticeworld
