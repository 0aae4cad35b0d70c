#include "latticeworld/simulation/agents/bodies/leg_kinematics.h"

#include <gtest/gtest.h>

#include <cmath>

#include "latticeworld/simulation/agents/bodies/bodies.h"
#include "latticeworld/simulation/agents/bodies/quadruped_gait.h"
#include "latticeworld/species/species_catalogue.h"

namespace latticeworld {
namespace {

const Species& Dog() { return SpeciesCatalogue::BuiltIn()->Of(AgentCategory::kRoboticDog); }

TEST(LegKinematicsTest, StandsOnTheGroundBelowItsHips) {
  for (int leg = 0; leg < kLegs; ++leg) {
    const LegKinematics kinematics(*Dog().quadruped, leg);
    const Eigen::Vector3d foot_m = kinematics.NominalFoot();
    EXPECT_NEAR(foot_m.z(), Dog().quadruped->foot_radius_m, 1e-12);
    EXPECT_NEAR((foot_m - kinematics.PitchJoint()).head<2>().norm(), 0.0, 1e-12);
    EXPECT_GT(foot_m.x() * (leg < 2 ? 1.0 : -1.0), 0.0);
    EXPECT_GT(foot_m.y() * (leg % 2 == 0 ? 1.0 : -1.0), 0.0);
  }
}

TEST(LegKinematicsTest, SolvesWhatItsAnglesGive) {
  for (int leg = 0; leg < kLegs; ++leg) {
    const LegKinematics kinematics(*Dog().quadruped, leg);
    for (const double roll : {-0.4, 0.0, 0.3}) {
      for (const double pitch : {-0.5, 0.1, 0.6}) {
        for (const double knee : {-0.6, 0.0, 0.5}) {
          const Eigen::Vector3d angles(roll, pitch, knee);
          const Eigen::Vector3d solved = kinematics.Solve(kinematics.Foot(angles));
          EXPECT_NEAR((solved - angles).norm(), 0.0, 1e-9) << leg << " " << angles.transpose();
        }
      }
    }
  }
}

TEST(LegKinematicsTest, JacobianIsTheFootsDerivative) {
  const LegKinematics kinematics(*Dog().quadruped, 1);
  const Eigen::Vector3d angles(0.2, -0.3, 0.25);
  const Eigen::Matrix3d jacobian = kinematics.Jacobian(angles);
  for (int i = 0; i < 3; ++i) {
    Eigen::Vector3d ahead = angles, behind = angles;
    ahead[i] += 1e-6;
    behind[i] -= 1e-6;
    const Eigen::Vector3d slope = (kinematics.Foot(ahead) - kinematics.Foot(behind)) / 2e-6;
    EXPECT_NEAR((slope - jacobian.col(i)).norm(), 0.0, 1e-8);
  }
}

TEST(LegKinematicsTest, TheBodysFeetAreWhereTheLegsSayTheyAre) {
  const BodySpec body = BodyOf(Dog());
  ASSERT_EQ(body.links.size(), 12u);
  for (int leg = 0; leg < kLegs; ++leg) {
    const LinkSpec& shank = body.links[static_cast<std::size_t>(3 * leg + 2)];
    ASSERT_EQ(shank.ground_samples.size(), 1u);
    EXPECT_NEAR(
        (shank.ground_samples[0].offset_m - LegKinematics(*Dog().quadruped, leg).NominalFoot())
            .norm(),
        0.0, 1e-12);
  }
  EXPECT_NEAR(body.total_mass_kg(), Dog().mass_kg, 1e-9);
}

TEST(GaitTest, DiagonalLegsStepTogetherAndThreeNeverSwing) {
  for (double phase = 0.0; phase < 1.0; phase += 0.01) {
    bool swings[kLegs];
    for (int leg = 0; leg < kLegs; ++leg) swings[leg] = PhaseOf(phase, leg, 0.5).swings;
    EXPECT_EQ(swings[0], swings[3]);
    EXPECT_EQ(swings[1], swings[2]);
    EXPECT_FALSE(swings[0] && swings[1]) << phase;
    EXPECT_EQ(AllStand(phase), !swings[0] && !swings[1]);
  }
}

}  // namespace
}  // namespace latticeworld
