#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/scene/scene.h"
#include "latticeworld/simulation/found_things.h"
#include "scene/test_world.h"
#include "simulation/test_scene.h"

namespace latticeworld {
namespace {

// Level grassland of 96 m on which nothing grows, a thing of that kind in its middle, and a
// vehicle that drives at it from the west.
class ThingsInPhysicsTest : public testing::Test {
 protected:
  void Meet(const std::string& kind, const std::string& species, double size = 1.0) {
    ThingWish wish;
    wish.kind = kind;
    wish.name = "thing";
    wish.size = size;
    wish.position = WorldPoint{0.0, 0.0};
    wish.heading_rad = 0.0;
    SceneRequest request =
        MakeRequest(MakeUniform(Vocabulary::kSuburb, 'G', 96.0), MakeEnvironment(0.0), /*seed=*/3);
    request.things = {wish};
    auto scene = BuildScene(request, Progress());
    ASSERT_TRUE(scene.ok()) << scene.status().ToString();
    scene_ = scene->scene;
    ASSERT_EQ(scene_->things.size(), 1u);
    auto simulator = Simulator::Create(scene_, SimulatorOptions(), /*seed=*/1);
    ASSERT_TRUE(simulator.ok()) << simulator.status().ToString();
    simulator_ = std::move(simulator).value();
    constexpr double kRunUp_m = 8.0;  // to its front
    const double from_m = -0.5 * Thing().size_m.x() - kRunUp_m;
    SpawnRequest driver = RequestFor(species, "driver", from_m, 0.0);
    driver.controllable = true;
    driver.heading_rad = 0.0;
    MustSpawn(simulator_.get(), driver);
  }
  void Drive(double seconds, double speed_mps) {
    RunWith(simulator_.get(), seconds, "driver", Forward(speed_mps));
    for (Event& event : simulator_->TakeEvents()) events_.push_back(std::move(event));
  }
  FoundThing Thing() const {
    return FindThings(*scene_, simulator_->State().get(), {"thing"})->front();
  }
  double DriverX_m() const { return Now(*simulator_, "driver").position_m.x(); }
  bool Happened(EventKind kind) const {
    for (const Event& event : events_) {
      if (event.kind == kind) return true;
    }
    return false;
  }

  std::shared_ptr<const Scene> scene_;
  std::unique_ptr<Simulator> simulator_;
  std::vector<Event> events_;
};

TEST_F(ThingsInPhysicsTest, ACrateIsPushedAlong) {
  Meet("crate", "tractor");
  Drive(8.0, 2.0);
  EXPECT_GT(Thing().position_m.x(), 1.0);
  EXPECT_GT(DriverX_m(), -1.0);
  EXPECT_EQ(Thing().condition, ThingCondition::kStands);
}

TEST_F(ThingsInPhysicsTest, APostStopsASmallRobotAndBreaksUnderATractor) {
  Meet("post", "robotic dog");
  Drive(14.0, 0.8);
  EXPECT_EQ(Thing().condition, ThingCondition::kStands);
  EXPECT_LT(DriverX_m(), 0.0);
  Meet("post", "tractor");
  Drive(6.0, 4.0);
  EXPECT_EQ(Thing().condition, ThingCondition::kBroken);
  EXPECT_TRUE(Happened(EventKind::kBroke));
  EXPECT_GT(DriverX_m(), 1.0);
}

TEST_F(ThingsInPhysicsTest, ASmallTreeIsFelledByATractor) {
  Meet("fruit tree", "tractor", 0.6);
  Drive(8.0, 5.0);
  EXPECT_EQ(Thing().condition, ThingCondition::kFelled);
  EXPECT_TRUE(Happened(EventKind::kFelledTree));
}

TEST_F(ThingsInPhysicsTest, WhatIsRigidStopsATractorAndStaysWhereItIs) {
  for (const char* kind : {"boulder", "wall", "well", "church"}) {
    SCOPED_TRACE(kind);
    Meet(kind, "tractor", std::string(kind) == "boulder" ? 2.5 : 1.0);
    const FoundThing before = Thing();
    const double from_m = DriverX_m();
    Drive(8.0, 2.0);
    EXPECT_EQ(Thing().position_m, before.position_m);
    EXPECT_EQ(Thing().condition, ThingCondition::kStands);
    EXPECT_GT(DriverX_m(), from_m + 3.0);  // it came so far
    EXPECT_LT(DriverX_m(), -0.4 * before.size_m.x());
  }
}

TEST_F(ThingsInPhysicsTest, ABushLetsATractorThrough) {
  Meet("bush", "tractor");
  Drive(8.0, 2.0);
  EXPECT_GT(DriverX_m(), 3.0);
}

}  // namespace
}  // namespace latticeworld
