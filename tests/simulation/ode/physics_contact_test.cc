// How bodies of a PhysicsWorld meet assets, each other, and what is held fast.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "simulation/ode/back_ends.h"

namespace latticeworld {
namespace {

using PhysicsContactTest = PhysicsContract;

std::vector<Contact> Of(const PhysicsWorld& physics, ContactKind kind) {
  std::vector<Contact> found;
  for (const Contact& contact : physics.contacts()) {
    if (contact.kind == kind) found.push_back(contact);
  }
  return found;
}

TEST_P(PhysicsContactTest, RobotThatDrivesAtAWallNeitherFlipsNorClimbs) {
  TestScene scene;
  scene.AddBuilding(5.0, 0.0, 1.0, 6.0);
  BodySpec soft = Robot();
  for (WheelSpec& wheel : soft.wheels) {
    wheel.spring_npm = 2500.0;
    wheel.damper_nspm = 150.0;
    wheel.travel_m = 0.04;
  }
  for (const BodySpec& spec : {Robot(), soft}) {
    for (const double heading_rad : {0.0, 0.5}) {
      const auto physics = Make(scene);
      const BodyId robot = physics->Add(spec, {0.0, -1.0, 0.0}, heading_rad);
      DriveAll(physics.get(), robot, 2.0 / 0.12);
      double highest_m = 0.0, steepest = 1.0;
      for (int i = 0; i < 600; ++i) {
        physics->Step(kStep_s, static_cast<std::uint64_t>(i));
        const BodyMotion motion = physics->MotionOf(robot);
        highest_m = std::max(highest_m, motion.position_m.z());
        steepest = std::min(steepest, (motion.orientation * Eigen::Vector3d::UnitZ()).z());
        ASSERT_LT(motion.position_m.x(), 4.0);
      }
      EXPECT_LT(highest_m, 0.12);
      EXPECT_GT(steepest, std::cos(0.4));
      EXPECT_GT(physics->MotionOf(robot).position_m.x(), 3.2);
    }
  }
}

TEST_P(PhysicsContactTest, AContactTellsTheForceThatStopsTheBody) {
  TestScene scene;
  scene.AddBuilding(5.0, 0.0, 1.0, 6.0);
  const auto physics = Make(scene);
  const BodyId ball = physics->Add(Ball(4.0, 0.3), {3.6, 0.0, 1.0}, 0.0);
  BodyMotion motion = physics->MotionOf(ball);
  motion.linear_velocity_mps = {3.0, 0.0, 0.0};
  physics->Place(ball, motion);
  double impulse_ns = 0.0, fastest_mps = 0.0;
  for (int i = 0; i < 30; ++i) {
    physics->Step(kStep_s, static_cast<std::uint64_t>(i));
    for (const Contact& contact : Of(*physics, ContactKind::kAsset)) {
      EXPECT_EQ(contact.body, ball);
      EXPECT_EQ(contact.other, 0U);
      EXPECT_NEAR(contact.normal.x(), -1.0, 1e-6);
      EXPECT_GT(contact.depth_m, 0.0);
      impulse_ns += contact.force_n.x() * kStep_s;
      fastest_mps = std::max(fastest_mps, contact.approach_mps);
    }
  }
  EXPECT_NEAR(fastest_mps, 3.0, 1e-6);
  // Of the centre: base_link is at the ball's lowest point and turns with it.
  const BodyMotion end = physics->MotionOf(ball);
  const Eigen::Vector3d arm = end.orientation * Eigen::Vector3d(0.0, 0.0, 0.3);
  const Eigen::Vector3d center_mps =
      end.linear_velocity_mps + end.angular_velocity_radps.cross(arm);
  EXPECT_NEAR(impulse_ns, 4.0 * (center_mps.x() - 3.0), 1e-6);
}

TEST_P(PhysicsContactTest, AssetsThatWentStopNobody) {
  TestScene scene;
  scene.AddTree(3.0, 0.0, 0.3);
  for (const bool present : {true, false}) {
    const auto physics = Make(scene);
    physics->SetAssetPresent(0, false);
    physics->SetAssetPresent(0, present);
    physics->SetAssetPresent(12345, false);  // none of the scene's: nothing to take away
    const BodyId walker = physics->Add(Walker(70.0, 0.3), {0.0, 0.0, 0.0}, 0.0);
    physics->SetWalkVelocity(walker, {1.5, 0.0, 0.0});
    StepFor(physics.get(), 4.0);
    if (present) {
      EXPECT_NEAR(physics->MotionOf(walker).position_m.x(), 2.4, 0.1);
    } else {
      EXPECT_GT(physics->MotionOf(walker).position_m.x(), 4.0);
    }
  }
}

// A stem that leans takes the blow over some way: less force than a wall, and back it comes.
TEST_P(PhysicsContactTest, AThinStemIsSofterThanAWall) {
  TestScene scene;
  scene.AddTree(3.0, 0.0, 0.03);
  const auto catalogue = Catalogue::BuiltIn();
  while (catalogue->models()[scene.assets[0].model].kind != AssetKind::kTree) {
    ++scene.assets[0].model;
  }
  scene.AddBuilding(3.97, 10.0, 1.0, 2.0);
  const auto physics = Make(scene);
  double most_n[2] = {0.0, 0.0};
  BodySpec spec = Ball(30.0, 0.4);
  spec.ground_samples.clear();
  for (int which = 0; which < 2; ++which) {
    BodyMotion motion;
    motion.position_m = {2.4, 10.0 * which, 0.5};
    motion.linear_velocity_mps = {2.0, 0.0, 0.5};
    const BodyId ball = physics->Add(spec, motion);
    for (int i = 0; i < 200; ++i) {
      physics->Step(0.002, static_cast<std::uint64_t>(i));
      for (const Contact& contact : Of(*physics, ContactKind::kAsset)) {
        most_n[which] = std::max(most_n[which], contact.force_n.norm());
      }
    }
    physics->Remove(ball);
  }
  EXPECT_GT(most_n[0], 100.0);
  EXPECT_LT(most_n[0], 0.2 * most_n[1]);
}

// The step is so long that the stem's axis is in the box when they first meet.
TEST_P(PhysicsContactTest, AFastBoxDoesNotPassAThinTrunk) {
  TestScene scene;
  scene.AddTree(3.0, 0.1, 0.06);
  const auto physics = Make(scene);
  BodyMotion motion;
  motion.position_m = {0.87, 0.0, 0.5};
  motion.linear_velocity_mps = {9.0, 0.0, 0.0};
  const BodyId box = physics->Add(Box(300.0, {1.0, 0.6, 0.3}), motion);
  for (int i = 0; i < 50; ++i) {
    physics->Step(0.02, static_cast<std::uint64_t>(i));
    ASSERT_LT(physics->MotionOf(box).position_m.x(), 2.3);
  }
  EXPECT_LT(physics->MotionOf(box).position_m.x(), 2.0);
}

// Lets one kind of thing give way, and keeps what it was asked.
class Judge : public ContactJudge {
 public:
  explicit Judge(bool yields) : yields_(yields) {}
  bool GivesWay(const Contact& contact) override {
    asked.push_back(contact);
    return yields_;
  }
  std::vector<Contact> asked;

 private:
  const bool yields_;
};

TEST_P(PhysicsContactTest, TheJudgeDecidesWhetherATreeHolds) {
  constexpr double kTree_m = 3.0, kTrunk_m = 0.2;
  for (const bool yields : {false, true}) {
    TestScene scene;
    scene.AddTree(kTree_m, 0.0, kTrunk_m);
    const auto physics = Make(scene);
    Judge judge(yields);
    physics->SetJudge(&judge);
    const BodyId robot = physics->Add(Robot(), {0.0, 0.0, 0.0}, 0.0);
    DriveAll(physics.get(), robot, 1.5 / 0.12);
    StepFor(physics.get(), 3.5);
    ASSERT_FALSE(judge.asked.empty());
    EXPECT_EQ(judge.asked[0].kind, ContactKind::kAsset);
    EXPECT_EQ(judge.asked[0].body, robot);
    EXPECT_NEAR(judge.asked[0].approach_mps, 1.45, 0.1);
    for (const Contact& contact : judge.asked) {
      EXPECT_GT(contact.approach_mps, 0.05);
      EXPECT_EQ(contact.force_n, Eigen::Vector3d::Zero());
    }
    // Slow touches, about which nobody is asked, hold it up on its way through.
    EXPECT_EQ(physics->MotionOf(robot).position_m.x() > kTree_m - kTrunk_m, yields);
    physics->SetJudge(nullptr);
    StepFor(physics.get(), 0.1);
  }
}

TEST_P(PhysicsContactTest, TheJudgeIsAskedAboutWhatIsHeldFastAndNotAboutTheRest) {
  const auto physics = Make();
  Judge judge(true);
  physics->SetJudge(&judge);
  BodySpec post_spec = Box(20.0, {0.1, 0.1, 0.6});
  post_spec.anchor = AnchorSpec();
  const BodyId post = physics->Add(post_spec, {3.0, 0.0, 0.0}, 0.0);
  const BodyId crate = physics->Add(Box(4.0, {0.2, 0.2, 0.2}), {1.2, 0.0, 0.0}, 0.0);
  const BodyId robot = physics->Add(Robot(), {0.0, 0.0, 0.0}, 0.0);
  DriveAll(physics.get(), robot, 1.5 / 0.12);
  for (int i = 0; i < 400; ++i) {
    physics->Step(kStep_s, static_cast<std::uint64_t>(i));
    if (!judge.asked.empty()) physics->SetAnchored(post, false);
  }
  ASSERT_FALSE(judge.asked.empty());
  for (const Contact& contact : judge.asked) {
    EXPECT_EQ(contact.kind, ContactKind::kBody);
    EXPECT_EQ(contact.other, post);
    EXPECT_TRUE(contact.body == crate || contact.body == robot);
  }
  EXPECT_GT(physics->MotionOf(robot).position_m.x(), 3.1);
}

TEST_P(PhysicsContactTest, CratesStackAndSleepAndWakeWhenTheLowestGoes) {
  const auto physics = Make();
  std::vector<BodyId> crates;
  for (int i = 0; i < 4; ++i) {
    crates.push_back(physics->Add(Box(10.0, {0.25, 0.25, 0.25}), {0.0, 0.0, 0.505 * i}, 0.0));
  }
  StepFor(physics.get(), 4.0);
  for (int i = 0; i < 4; ++i) {
    const Eigen::Vector3d at = physics->MotionOf(crates[static_cast<std::size_t>(i)]).position_m;
    EXPECT_NEAR(at.z(), 0.5 * i, 0.02);
    EXPECT_LT(at.head<2>().norm(), 0.03);
    EXPECT_TRUE(physics->IsResting(crates[static_cast<std::size_t>(i)]));
  }
  physics->Remove(crates[0]);
  StepFor(physics.get(), 3.0);
  for (int i = 1; i < 4; ++i) {
    EXPECT_NEAR(physics->MotionOf(crates[static_cast<std::size_t>(i)]).position_m.z(),
                0.5 * (i - 1), 0.05);
  }
}

TEST_P(PhysicsContactTest, ARobotPushesACrateAndAWallOfCratesHoldsABall) {
  const auto physics = Make();
  const BodyId crate = physics->Add(Box(6.0, {0.2, 0.3, 0.2}), {1.0, 0.0, 0.0}, 0.0);
  const BodyId robot = physics->Add(Robot(), {0.0, 0.0, 0.0}, 0.0);
  StepFor(physics.get(), 1.5);
  EXPECT_TRUE(physics->IsResting(crate));
  DriveAll(physics.get(), robot, 1.0 / 0.12);
  StepFor(physics.get(), 4.0);
  EXPECT_GT(physics->MotionOf(crate).position_m.x(), 2.0);
  EXPECT_GT(physics->MotionOf(crate).position_m.x(), physics->MotionOf(robot).position_m.x());
}

TEST_P(PhysicsContactTest, UprightBodyFallsOverWhenLetGoAndStandsUpAgain) {
  const auto physics = Make();
  BodySpec spec = Walker(70.0, 0.25, 1.7);
  // Samples all along it hold it up when it lies.
  for (const double z : {0.25, 0.85, 1.45}) spec.ground_samples.push_back({{0.0, 0.0, z}, 0.25});
  const BodyId walker = physics->Add(spec, {0.0, 0.0, 0.0}, 0.7);
  physics->AddImpulse(walker, {100.0, 0.0, 0.0}, {0.0, 0.0, 1.5});
  StepFor(physics.get(), 0.5);
  const auto up = [&] {
    return (physics->MotionOf(walker).orientation * Eigen::Vector3d::UnitZ()).z();
  };
  EXPECT_NEAR(up(), 1.0, 1e-9);
  EXPECT_TRUE(physics->IsUpright(walker));
  physics->SetUpright(walker, false);
  physics->AddImpulse(walker, {100.0, 0.0, 0.0}, {0.0, 0.0, 1.5});
  StepFor(physics.get(), 2.5);
  EXPECT_LT(up(), 0.3);
  EXPECT_FALSE(physics->IsUpright(walker));
  const Eigen::Vector3d lay = physics->MotionOf(walker).position_m;
  physics->SetUpright(walker, true);
  EXPECT_NEAR(up(), 1.0, 1e-9);
  EXPECT_LT((physics->MotionOf(walker).position_m - lay).head<2>().norm(), 0.01);
  EXPECT_LT(physics->SinkageOf(walker), 1e-9);
  physics->SetWalkVelocity(walker, {1.0, 0.0, 0.0});
  StepFor(physics.get(), 2.0);
  EXPECT_NEAR(physics->MotionOf(walker).linear_velocity_mps.x(), 1.0, 0.05);
}

TEST_P(PhysicsContactTest, WalkersAndRobotsCrossADeckThatFeelsTheirWeight) {
  const auto physics = Make();
  BodySpec deck = Box(500.0, {2.0, 1.0, 0.1});
  deck.anchor = AnchorSpec();
  const BodyId bridge = physics->Add(deck, {0.0, 0.0, 3.0}, 0.0);
  const BodyId walker = physics->Add(Walker(80.0, 0.3), {-1.2, 0.4, 3.21}, 0.0);
  const BodyId robot = physics->Add(Robot(), {-1.2, -0.4, 3.21}, 0.0);
  StepFor(physics.get(), 0.5);
  physics->SetWalkVelocity(walker, {0.8, 0.0, 0.0});
  DriveAll(physics.get(), robot, 0.8 / 0.12);
  double load_n = 0.0;
  for (int i = 0; i < 200; ++i) {
    physics->Step(kStep_s, static_cast<std::uint64_t>(i));
    for (const Contact& contact : Of(*physics, ContactKind::kBody)) {
      if (contact.other == bridge) load_n += contact.force_n.z() / 200.0;
    }
  }
  EXPECT_NEAR(load_n, 110.0 * kGravity_mps2, 40.0);
  for (const BodyId body : {walker, robot}) {
    EXPECT_NEAR(physics->MotionOf(body).position_m.x(), 0.4, 0.15);
    EXPECT_NEAR(physics->MotionOf(body).position_m.z(), 3.2, 0.02);
  }
  StepFor(physics.get(), 4.0);
  EXPECT_LT(physics->MotionOf(walker).position_m.z(), 0.1);  // over the edge
}

TEST_P(PhysicsContactTest, NobodyLeavesTheWorld) {
  TestScene scene;
  const auto physics = Make(scene);
  const BodyId robot = physics->Add(Robot(), {29.0, 0.0, 0.0}, 0.0);
  const BodyId walker = physics->Add(Walker(70.0, 0.3), {0.0, -30.0, 0.0}, 0.0);
  DriveAll(physics.get(), robot, 3.0 / 0.12);
  physics->SetWalkVelocity(walker, {0.0, -3.0, 0.0});
  StepFor(physics.get(), 4.0);
  EXPECT_NEAR(physics->MotionOf(robot).position_m.x(), 31.65, 0.15);
  EXPECT_NEAR(physics->MotionOf(walker).position_m.y(), -31.7, 0.1);
  const std::vector<Contact> edge = Of(*physics, ContactKind::kBoundary);
  ASSERT_EQ(edge.size(), 2U);
  EXPECT_EQ(edge[0].normal, Eigen::Vector3d(-1.0, 0.0, 0.0));
  EXPECT_EQ(edge[1].normal, Eigen::Vector3d(0.0, 1.0, 0.0));
}

TEST_P(PhysicsContactTest, EnergyIsThatOfAllParts) {
  const auto physics = Make();
  BodyMotion motion;
  motion.position_m = {0.0, 0.0, 10.0};
  motion.linear_velocity_mps = {3.0, 0.0, 0.0};
  const BodyId robot = physics->Add(Robot(), motion);
  const double height_j = kGravity_mps2 * (26.0 * 10.16 + 4.0 * 10.12);
  EXPECT_NEAR(physics->EnergyOf(robot), height_j + 0.5 * 30.0 * 9.0, 1e-6);
  StepFor(physics.get(), 0.5);
  EXPECT_NEAR(physics->EnergyOf(robot), height_j + 0.5 * 30.0 * 9.0, 0.02 * height_j);
}

LATTICEWORLD_ON_EVERY_BACK_END(PhysicsContactTest);

}  // namespace
}  // namespace latticeworld
