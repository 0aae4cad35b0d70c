// Robots come and go while somebody else asks who listens.

#include <gtest/gtest.h>
#include <ros/ros.h>

#include <atomic>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "latticeworld/sensing/sensor_suite.h"
#include "latticeworld/species/species_catalogue.h"
#include "latticeworld_ros/publishing/sensor_topics.h"

namespace {

using latticeworld::RobotWish;
using latticeworld::SensorCatalogue;
using latticeworld::SensorTopics;
using latticeworld::SpeciesCatalogue;

// The simulation's thread and that of the sensors ask in every step, another one makes and ends the
// topics.
TEST(SensorTopicsTest, AskingWhoListensIsSafeWhileRobotsComeAndGo) {
  const auto suite = SensorCatalogue::BuiltIn()->FindSuite("scanner");
  ASSERT_NE(suite, nullptr);
  SensorTopics topics(ros::NodeHandle(), std::make_shared<latticeworld::SensorSuite>(*suite),
                      SpeciesCatalogue::BuiltIn());
  std::vector<RobotWish> robots;
  for (int i = 0; i < 24; ++i)
    robots.push_back({"scout_" + std::to_string(i), true, "wheeled_robot"});
  topics.Apply(robots);

  std::atomic<bool> done{false};
  // More than there are cores, so that some wait in the midst of asking.
  std::vector<std::thread> askers;
  for (int i = 0; i < 8; ++i) {
    askers.emplace_back([&] {
      while (!done) {
        EXPECT_FALSE(topics.has_listeners());
        EXPECT_EQ(topics.listeners(), 0);
      }
    });
  }
  for (int round = 0; round < 40; ++round) {
    std::vector<RobotWish> fewer = robots;
    fewer.pop_back();
    topics.Apply(fewer);
    topics.Apply(robots);
  }
  done = true;
  for (std::thread& asker : askers) asker.join();
  EXPECT_EQ(topics.publishers()->size(), robots.size());
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "sensor_topics_test");
  ros::NodeHandle node;
  return RUN_ALL_TESTS();
}
