#include "latticeworld_ros/node/parameters.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>

namespace latticeworld {
namespace {

TEST(ParametersTest, NoneAtAllGivesTheDefaults) {
  const auto options = OptionsFromParameters(XmlRpc::XmlRpcValue());
  ASSERT_TRUE(options.ok()) << options.status().ToString();
  EXPECT_DOUBLE_EQ(options->simulator.step_s, 0.01);
}

TEST(ParametersTest, GivenOnesAreTaken) {
  XmlRpc::XmlRpcValue parameters;
  parameters["real_time_factor"] = 0;  // a whole number where a number is wanted
  parameters["step"] = 0.005;
  parameters["start_paused"] = true;
  parameters["worlds_directory"] = std::string("/srv/worlds");
  parameters["visual_directories"][0] = std::string("/srv/pictures");
  parameters["robot_max_slope"] = 0.3;
  const auto options = OptionsFromParameters(parameters);
  ASSERT_TRUE(options.ok()) << options.status().ToString();
  EXPECT_EQ(options->real_time_factor, 0.0);
  EXPECT_EQ(options->simulator.step_s, 0.005);
  EXPECT_TRUE(options->start_paused);
  EXPECT_EQ(options->worlds_directory, "/srv/worlds");
  EXPECT_EQ(options->visual_directories, std::vector<std::string>{"/srv/pictures"});
  EXPECT_EQ(options->robot.max_slope_rad, 0.3);
}

TEST(ParametersTest, EverythingWrongIsNamedAtOnce) {
  XmlRpc::XmlRpcValue parameters;
  parameters["setp"] = 0.01;
  parameters["step"] = std::string("fast");
  parameters["clock_rate"] = -3;
  parameters["generator"] = std::string("oracle");
  const auto options = OptionsFromParameters(parameters);
  ASSERT_FALSE(options.ok());
  EXPECT_EQ(options.status().violations().size(), 4u);
  for (const char* word : {"setp", "step", "clock_rate", "-3", "oracle", "grounded"}) {
    EXPECT_NE(options.status().message().find(word), std::string::npos) << word;
  }
}

TEST(ParametersTest, EveryNumberRefusesWhatIsNoNumber) {
  for (const char* name :
       {"real_time_factor", "step", "command_timeout", "pursuit_distance", "day_length",
        "clock_rate", "state_rate", "marker_rate", "octomap_resolution", "octomap_thickness",
        "robot_radius", "robot_max_slope", "robot_max_step", "robot_max_fording_depth",
        "robot_clearance", "robot_mass", "robot_grip"}) {
    for (const double value : {-1.5, 1e9, std::numeric_limits<double>::quiet_NaN(),
                               std::numeric_limits<double>::infinity()}) {
      XmlRpc::XmlRpcValue parameters;
      parameters[name] = value;
      const auto options = OptionsFromParameters(parameters);
      ASSERT_FALSE(options.ok()) << name << " = " << value;
      EXPECT_EQ(options.status().violations().size(), 1u) << options.status().ToString();
    }
  }
}

TEST(ParametersTest, MapsAreForTheFootprintOfTheWorldsRobots) {
  const auto radius_m = [](const char* species, double given_m) {
    XmlRpc::XmlRpcValue parameters;
    parameters["robot_species"] = std::string(species);
    parameters["robot_radius"] = given_m;
    const auto options = OptionsFromParameters(parameters);
    return options.ok() ? options->robot.radius_m : NAN;
  };
  EXPECT_EQ(OptionsFromParameters(XmlRpc::XmlRpcValue())->robot.radius_m,
            SpeciesCatalogue::BuiltIn()->Of(AgentCategory::kWheeledRobot).radius_m);
  EXPECT_EQ(WorldServerOptions().robot.radius_m,
            SpeciesCatalogue::BuiltIn()->Of(AgentCategory::kWheeledRobot).radius_m);
  for (const char* species : {"wheeled robot", "tractor", "differential_robot"}) {
    EXPECT_EQ(radius_m(species, -1.0), SpeciesCatalogue::BuiltIn()->Find(species)->radius_m);
    EXPECT_EQ(radius_m(species, 0.0), 0.0);
    EXPECT_EQ(radius_m(species, 0.25), 0.25);
  }
}

// The zones of UTM are 6 degrees wide from 180 W on; coordinates of a world near the border of two
// would jump by hundreds of kilometres within it.
TEST(ParametersTest, WorldsThatLieNowhereLieInTheMiddleOfAZoneOfUtm) {
  const double in_zone_deg = std::fmod(WorldServerOptions().longitude_deg + 180.0, 6.0);
  EXPECT_NEAR(in_zone_deg, 3.0, 1.0);
}

TEST(ParametersTest, PhysicsThreadsAreACount) {
  EXPECT_EQ(WorldServerOptions().simulator.physics_threads, 0);
  for (const int threads : {0, 1, 256}) {
    XmlRpc::XmlRpcValue parameters;
    parameters["physics_threads"] = threads;
    const auto options = OptionsFromParameters(parameters);
    ASSERT_TRUE(options.ok()) << options.status().ToString();
    EXPECT_EQ(options->simulator.physics_threads, threads);
  }
  for (const int threads : {-1, 257}) {
    XmlRpc::XmlRpcValue parameters;
    parameters["physics_threads"] = threads;
    const auto options = OptionsFromParameters(parameters);
    ASSERT_FALSE(options.ok());
    EXPECT_NE(options.status().message().find("physics_threads: must be from 0 to 256"),
              std::string::npos)
        << options.status().ToString();
  }
}

TEST(ParametersTest, SpeciesThatCannotBeReadAreNamed) {
  XmlRpc::XmlRpcValue parameters;
  parameters["species"] = std::string("/nowhere/species.json");
  parameters["robot_species"] = std::string("dragon");
  const auto options = OptionsFromParameters(parameters);
  ASSERT_FALSE(options.ok());
  ASSERT_EQ(options.status().violations().size(), 2u) << options.status().ToString();
  EXPECT_EQ(options.status().violations()[0].pointer, "species");
  EXPECT_EQ(options.status().violations()[1].pointer, "robot_species");
  for (const char* word : {"/nowhere/species.json", "dragon"}) {
    EXPECT_NE(options.status().message().find(word), std::string::npos) << word;
  }
}

TEST(ParametersTest, SensorsThatThereAreNotAreNamed) {
  XmlRpc::XmlRpcValue parameters;
  parameters["sensors"] = std::string("/nowhere/sensors.json");
  parameters["sensor_suite"] = std::string("crystal balls");
  parameters["sensor_threads"] = 65;
  parameters["sensor_seed"] = -1;
  parameters["longitude"] = 200.0;
  parameters["altitude"] = 1e6;
  parameters["geoid_undulation"] = -121.0;
  const auto options = OptionsFromParameters(parameters);
  ASSERT_FALSE(options.ok());
  EXPECT_EQ(options.status().violations().size(), 7u) << options.status().ToString();
  for (const char* word :
       {"/nowhere/sensors.json", "crystal balls", "none", "standard", "sensor_threads",
        "sensor_seed", "longitude", "altitude", "geoid_undulation"}) {
    EXPECT_NE(options.status().message().find(word), std::string::npos) << word;
  }
}

TEST(ParametersTest, FramesThatOthersPublishAreSwitchedOffForAllOrByName) {
  const auto defaults = OptionsFromParameters(XmlRpc::XmlRpcValue());
  EXPECT_TRUE(defaults->frames.map_to_odom);
  EXPECT_TRUE(defaults->frames.odom_to_base);
  XmlRpc::XmlRpcValue parameters;
  parameters["publish_map_to_odom"] = false;
  parameters["publish_odom_to_base"] = false;
  parameters["localised_elsewhere"][0] = std::string("scout");
  parameters["odometry_elsewhere"].setSize(0);
  const auto options = OptionsFromParameters(parameters);
  ASSERT_TRUE(options.ok()) << options.status().ToString();
  EXPECT_FALSE(options->frames.map_to_odom);
  EXPECT_FALSE(options->frames.odom_to_base);
  EXPECT_EQ(options->frames.localised_elsewhere, std::vector<std::string>{"scout"});
  EXPECT_TRUE(options->frames.odometry_elsewhere.empty());
  parameters["odometry_elsewhere"][0] = std::string();
  const auto refused = OptionsFromParameters(parameters);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.status().violations()[0].pointer, "odometry_elsewhere");
}

TEST(ParametersTest, MessagesAreOfNoMoreBytesThanCanBeReceived) {
  XmlRpc::XmlRpcValue parameters;
  parameters["most_message_bytes"] = 2000000;
  EXPECT_EQ(OptionsFromParameters(parameters)->most_message_bytes, 2000000u);
  for (const int bytes : {999999, 1000000001}) {
    parameters["most_message_bytes"] = bytes;
    const auto refused = OptionsFromParameters(parameters);
    ASSERT_FALSE(refused.ok()) << bytes;
    EXPECT_EQ(refused.status().violations()[0].pointer, "most_message_bytes");
  }
}

TEST(ParametersTest, MapValuesAndPointTimesAreNamed) {
  const auto defaults = OptionsFromParameters(XmlRpc::XmlRpcValue());
  EXPECT_EQ(defaults->map_values, MapValues::kGraded);
  EXPECT_EQ(defaults->point_times, PointTimes::kEnd);
  XmlRpc::XmlRpcValue parameters;
  parameters["map_values"] = std::string("trinary");
  parameters["point_times"] = std::string("begin");
  const auto options = OptionsFromParameters(parameters);
  ASSERT_TRUE(options.ok()) << options.status().ToString();
  EXPECT_EQ(options->map_values, MapValues::kTrinary);
  EXPECT_EQ(options->point_times, PointTimes::kBegin);
  parameters["map_values"] = std::string("binary");
  parameters["point_times"] = std::string("middle");
  const auto refused = OptionsFromParameters(parameters);
  ASSERT_FALSE(refused.ok());
  for (const char* word : {"graded, trinary", "end, begin"}) {
    EXPECT_NE(refused.status().message().find(word), std::string::npos) << word;
  }
}

XmlRpc::XmlRpcValue WithServer() {
  XmlRpc::XmlRpcValue parameters;
  parameters["remote_url"] = std::string("http://127.0.0.1:8080/v1");
  return parameters;
}

TEST(ParametersTest, AServerMakesRemoteALegalGenerator) {
  XmlRpc::XmlRpcValue parameters = WithServer();
  parameters["generator"] = std::string("remote");
  parameters["remote_dialect"] = std::string("llama.cpp");
  parameters["remote_total_timeout"] = 30;
  parameters["remote_max_answer_bytes"] = 4096;
  parameters["remote_fallback"] = true;
  const auto options = OptionsFromParameters(parameters);
  ASSERT_TRUE(options.ok()) << options.status().ToString();
  EXPECT_EQ(options->remote.server.dialect, ChatDialect::kLlamaCpp);
  EXPECT_EQ(options->remote.server.total_timeout_s, 30.0);
  EXPECT_EQ(options->remote.server.max_answer_bytes, 4096u);
  EXPECT_TRUE(options->remote.fallback);
  parameters["reader"] = std::string("remote");
  EXPECT_TRUE(OptionsFromParameters(parameters).ok());

  XmlRpc::XmlRpcValue alone;
  alone["generator"] = std::string("remote");
  const auto refused = OptionsFromParameters(alone);
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.status().message().find("remote_url"), std::string::npos);
}

TEST(ParametersTest, AModelThatReadsMakesItsReadersLegal) {
  XmlRpc::XmlRpcValue parameters;
  for (const char* reader : {"model", "checked"}) {
    parameters["reader"] = std::string(reader);
    const auto refused = OptionsFromParameters(parameters);
    ASSERT_FALSE(refused.ok());
    EXPECT_NE(refused.status().message().find("reader_model"), std::string::npos);
  }
  parameters["reader_model"] = std::string("reader.gguf");
  EXPECT_TRUE(OptionsFromParameters(parameters).ok());
  parameters["reader"] = std::string("oracle");
  EXPECT_NE(OptionsFromParameters(parameters).status().message().find("rules, controlled"),
            std::string::npos);
}

TEST(ParametersTest, ServerParametersOutOfRangeAreNamedAsTheyAreWritten) {
  for (const char* name :
       {"remote_connect_timeout", "remote_first_token_timeout", "remote_total_timeout",
        "remote_max_retries", "remote_backoff", "remote_max_answer_bytes", "remote_repair_turns",
        "remote_temperature", "remote_layout_max_tokens", "remote_environment_max_tokens"}) {
    XmlRpc::XmlRpcValue parameters = WithServer();
    parameters[name] = 2000000000;
    const auto options = OptionsFromParameters(parameters);
    ASSERT_FALSE(options.ok()) << name;
    ASSERT_EQ(options.status().violations().size(), 1u) << options.status().ToString();
    EXPECT_EQ(options.status().violations()[0].pointer, name);
  }
  for (const char* name : {"remote_url", "remote_dialect"}) {
    XmlRpc::XmlRpcValue parameters = WithServer();
    parameters[name] = std::string("gopher://hole");
    const auto options = OptionsFromParameters(parameters);
    ASSERT_FALSE(options.ok()) << name;
    EXPECT_EQ(options.status().violations()[0].pointer, name);
  }
}

TEST(ParametersTest, TildeIsTheHomeDirectory) {
  ASSERT_EQ(setenv("HOME", "/home/somebody", 1), 0);
  EXPECT_EQ(ExpandHome("~/worlds"), "/home/somebody/worlds");
  EXPECT_EQ(ExpandHome("~"), "/home/somebody");
  EXPECT_EQ(ExpandHome("~other/worlds"), "~other/worlds");
  EXPECT_EQ(ExpandHome("/worlds"), "/worlds");
}

TEST(ParametersTest, TheFolderOfRosIsWhereRosHasIt) {
  ASSERT_EQ(setenv("HOME", "/home/somebody", 1), 0);
  ASSERT_EQ(unsetenv("ROS_HOME"), 0);
  EXPECT_EQ(ExpandHome("~/.ros/worlds"), "/home/somebody/.ros/worlds");
  ASSERT_EQ(setenv("ROS_HOME", "/var/ros", 1), 0);
  EXPECT_EQ(ExpandHome("~/.ros/worlds"), "/var/ros/worlds");
  EXPECT_EQ(ExpandHome("~/.ros"), "/var/ros");
  EXPECT_EQ(ExpandHome("~/.rosy"), "/home/somebody/.rosy");
  ASSERT_EQ(unsetenv("ROS_HOME"), 0);
}

}  // namespace
}  // namespace latticeworld
