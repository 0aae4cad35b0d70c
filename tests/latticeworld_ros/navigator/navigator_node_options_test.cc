#include "latticeworld_ros/navigator/navigator_node_options.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "latticeworld/species/species_catalogue.h"

namespace latticeworld {
namespace {

TEST(NavigatorNodeOptionsTest, WhatIsNotSaidKeepsItsDefault) {
  const auto none = NavigatorOptionsFromParameters(XmlRpc::XmlRpcValue());
  ASSERT_TRUE(none.ok()) << none.status().ToString();
  EXPECT_EQ(none->sensor, NavigatorSensor::kScan);
  EXPECT_TRUE(std::isinf(none->navigator.goal_heading_tolerance_rad));
  EXPECT_TRUE(std::isinf(none->navigator.time_limit_s));
  XmlRpc::XmlRpcValue parameters;
  parameters["robot"] = "scout";
  parameters["sensor"] = "both";
  parameters["goal_radius"] = 2;
  parameters["goal_heading_tolerance"] = 0.25;
  parameters["time_limit"] = 90.0;
  parameters["closed_cost"] = 70;
  parameters["map_is_inflated"] = false;
  const auto some = NavigatorOptionsFromParameters(parameters);
  ASSERT_TRUE(some.ok()) << some.status().ToString();
  EXPECT_EQ(some->robot, "scout");
  EXPECT_EQ(some->sensor, NavigatorSensor::kBoth);
  EXPECT_EQ(some->navigator.goal_radius_m, 2.0);
  EXPECT_EQ(some->navigator.goal_heading_tolerance_rad, 0.25);
  EXPECT_EQ(some->navigator.time_limit_s, 90.0);
  EXPECT_EQ(some->navigator.closed_cost, 70);
  EXPECT_FALSE(some->navigator.map_is_inflated);
  EXPECT_EQ(some->control_rate_hz, none->control_rate_hz);
}

TEST(NavigatorNodeOptionsTest, TheRadiusIsThatOfTheSpeciesUnlessItIsSaid) {
  const SpeciesCatalogue& catalogue = *SpeciesCatalogue::BuiltIn();
  const double usual_m = catalogue.Of(AgentCategory::kWheeledRobot).radius_m;
  EXPECT_EQ(NavigatorOptionsFromParameters(XmlRpc::XmlRpcValue())->navigator.robot.radius_m,
            usual_m);
  EXPECT_EQ(NavigatorRobot().radius_m, usual_m);
  XmlRpc::XmlRpcValue parameters;
  parameters["robot_species"] = "tractor";
  EXPECT_EQ(NavigatorOptionsFromParameters(parameters)->navigator.robot.radius_m,
            catalogue.Find("tractor")->radius_m);
  parameters["robot_radius"] = 0.75;
  EXPECT_EQ(NavigatorOptionsFromParameters(parameters)->navigator.robot.radius_m, 0.75);
  parameters["robot_species"] = "rover of mine";
  EXPECT_TRUE(NavigatorOptionsFromParameters(parameters).ok());
  parameters["robot_radius"] = 0.0;
  const Status status = NavigatorOptionsFromParameters(parameters).status();
  ASSERT_EQ(status.violations().size(), 1u);
  EXPECT_EQ(status.violations()[0].pointer, "robot_species");
}

TEST(NavigatorNodeOptionsTest, EveryViolationIsNamedAtOnceByItsParameter) {
  XmlRpc::XmlRpcValue parameters;
  parameters["robbot"] = "x";
  parameters["robot"] = "two words";
  parameters["global_frame"] = "";
  parameters["sensor"] = "nose";
  parameters["control_rate"] = 0;
  parameters["odom_timeout"] = "long";
  parameters["goal_heading_tolerance"] = 7.0;
  parameters["time_limit"] = -1;
  parameters["robot_radius"] = -0.3;
  parameters["max_yaw_rate"] = NAN;
  const Status status = NavigatorOptionsFromParameters(parameters).status();
  EXPECT_EQ(status.code(), StatusCode::kInvalidArgument);
  for (const char* pointer :
       {"robbot", "robot", "global_frame", "sensor", "control_rate", "odom_timeout",
        "goal_heading_tolerance", "time_limit", "robot_radius", "max_yaw_rate"}) {
    bool named = false;
    for (const Violation& violation : status.violations())
      named = named || violation.pointer == pointer;
    EXPECT_TRUE(named) << pointer << "\n" << status.message();
  }
  EXPECT_EQ(status.violations().size(), 10u) << status.message();
  EXPECT_NE(status.message().find("none, scan, points, both"), std::string::npos);
  EXPECT_FALSE(NavigatorOptionsFromParameters(XmlRpc::XmlRpcValue("text")).ok());
}

}  // namespace
}  // namespace latticeworld
