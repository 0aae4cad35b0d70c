#include "latticeworld_ros/viewer/viewer_conversion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

#include "latticeworld_ros/conversion/agent_conversion.h"
#include "latticeworld_ros/conversion/agent_markers.h"
#include "latticeworld_ros/conversion/geometry_conversion.h"
#include "latticeworld_ros/conversion/scene_conversion.h"
#include "latticeworld_ros/conversion/weather_conversion.h"
#include "latticeworld_ros/server/diagnostics.h"

namespace latticeworld {
namespace {

WorldState SomeState() {
  WorldState state;
  AgentSnapshot agent;
  agent.name = "robot";
  agent.species = "wheeled robot";
  agent.team = 1;
  agent.controllable = true;
  agent.behaviour = Behaviour::kControlled;
  agent.health = 0.75;
  agent.position_m = {1.234, -20.5, 3.0};
  agent.orientation = Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitZ());
  state.agents.push_back(agent);
  PropSnapshot gate;
  gate.name = "gate_1";
  gate.kind = PropKind::kGate;
  gate.position_m = {4.0, 5.0, 6.0};
  gate.opening_rad = 1.2;
  gate.broken = true;
  state.props.push_back(gate);
  return state;
}

TEST(ViewerConversionTest, MessagesGiveTheStreamOfTheStateThatTheyWereMadeOf) {
  const WorldState state = SomeState();
  const auto agents = Streamed(ToAgentStates(state, ros::Time(1.0), "world"));
  const auto wanted = Streamed(state.agents);
  EXPECT_EQ(agents.rows, wanted.rows);
  EXPECT_EQ(agents.things, wanted.things);
  const auto props = Streamed(ToElementStates(state, ros::Time(1.0), "world"));
  EXPECT_EQ(props.rows, Streamed(state.props).rows);
  EXPECT_EQ(props.things, Streamed(state.props).things);
}

TEST(ViewerConversionTest, MessagesOfOthersBreakNothing) {
  latticeworld_msgs::AgentStates states;
  states.agents.resize(70000);
  states.agents[0].behaviour = "dancing";
  states.agents[0].health = std::nan("");
  states.agents[0].pose.position.x = std::numeric_limits<double>::infinity();
  const auto streamed = Streamed(states);
  EXPECT_EQ(streamed.things.size(), 65535u);
  EXPECT_EQ(streamed.things[0].behaviour, static_cast<int>(Behaviour::kIdle));
  EXPECT_EQ(streamed.things[0].health, 0);
}

TEST(ViewerConversionTest, WeatherComesBackAsItWas) {
  Atmosphere atmosphere;
  atmosphere.weather = Weather::kSandstorm;
  atmosphere.visibility_m = 321.0;
  atmosphere.wind_mps = {1.0, -2.0, 0.0};
  atmosphere.sun_direction = {0.6, 0.0, 0.8};
  atmosphere.water_rise_m = -0.5;
  const Atmosphere back = ToAtmosphere(ToWeatherMessage(atmosphere, 0.0, ros::Time(1.0), "world"));
  EXPECT_EQ(back.weather, atmosphere.weather);
  EXPECT_EQ(back.visibility_m, atmosphere.visibility_m);
  EXPECT_EQ(back.wind_mps, atmosphere.wind_mps);
  EXPECT_EQ(back.sun_direction, atmosphere.sun_direction);
  EXPECT_EQ(back.water_rise_m, atmosphere.water_rise_m);
}

TEST(ViewerConversionTest, FallingTreesStandWhereTheirMarkersShowThem) {
  visualization_msgs::MarkerArray markers;
  markers.markers.resize(3);
  visualization_msgs::Marker& stem = markers.markers[1];
  stem.ns = "trees";
  stem.id = 2 * 17;
  stem.scale.z = 10.0;
  const Eigen::Vector3d foot_m(3.0, 4.0, 1.0), along = Eigen::Vector3d(0.6, 0.0, 0.8);
  stem.pose = ToPose(ToIsometry(
      foot_m + 5.0 * along, Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), along)));
  markers.markers[2] = stem;  // its crown
  markers.markers[2].id = 2 * 17 + 1;
  markers.markers[2].scale.z = 99.0;
  std::vector<LyingTree> trees(2);
  trees[0].asset = 17;
  trees[1].asset = 18;
  trees[1].at_rest = true;
  UpdateFalling(markers, &trees);
  EXPECT_LT((trees[0].foot_m - foot_m).norm(), 1e-9);
  EXPECT_LT((trees[0].tip_m - (foot_m + 10.0 * along)).norm(), 1e-9);
  EXPECT_EQ(trees[1].tip_m, Eigen::Vector3d::Zero());
}

TEST(ViewerConversionTest, DiagnosticsTellWhetherTimeStandsStill) {
  LoopStatistics statistics;
  statistics.wanted_factor = 3.0;
  statistics.real_time_factor = 2.5;
  auto report = ReportOf(ToDiagnosticArray(statistics, SensorStatistics(), nullptr));
  ASSERT_TRUE(report.has_value());
  EXPECT_FALSE(report->has_world);
  EXPECT_EQ(report->speed, 3.0);
  EXPECT_EQ(report->real_time_factor, 2.5);
  EXPECT_FALSE(ReportOf(diagnostic_msgs::DiagnosticArray()).has_value());
}

sensor_msgs::PointCloud2 CloudOf(const std::vector<Eigen::Vector3f>& points) {
  sensor_msgs::PointCloud2 cloud;
  cloud.height = 1;
  cloud.width = static_cast<std::uint32_t>(points.size());
  cloud.point_step = 16;
  for (int i = 0; i < 3; ++i) {
    cloud.fields.emplace_back();
    cloud.fields.back().name = std::string(1, static_cast<char>('x' + i));
    cloud.fields.back().datatype = sensor_msgs::PointField::FLOAT32;
    cloud.fields.back().offset = static_cast<std::uint32_t>(4 * i);
  }
  cloud.data.resize(16 * points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::memcpy(&cloud.data[16 * i], points[i].data(), 12);
  }
  return cloud;
}

TEST(ViewerConversionTest, CloudsTurnWithTheirSensor) {
  const float nan = std::nanf("");
  const auto cloud = CloudOf({{1.0f, 0.0f, 0.5f}, {nan, nan, nan}, {0.0f, 2.0f, 0.0f}});
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(M_PI / 2.0, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  const auto points = PointsOf(cloud, turn);
  ASSERT_EQ(points.size(), 2u);
  EXPECT_LT((points[0].from_sensor_m - Eigen::Vector3f(0.0f, 1.0f, 0.5f)).norm(), 1e-6f);
  EXPECT_LT((points[1].from_sensor_m - Eigen::Vector3f(-2.0f, 0.0f, 0.0f)).norm(), 1e-6f);
}

TEST(ViewerConversionTest, CloudsThatLieAboutTheirSizeAreReadNoFurtherThanTheyGo) {
  const Eigen::Matrix3d still = Eigen::Matrix3d::Identity();
  auto cloud = CloudOf({{1.0f, 0.0f, 0.5f}, {0.0f, 2.0f, 0.0f}});
  cloud.width = 4000000000u;
  cloud.height = 4000000000u;
  EXPECT_EQ(PointsOf(cloud, still).size(), 2u);
  cloud.data.resize(20);
  EXPECT_EQ(PointsOf(cloud, still).size(), 1u);
  cloud.fields[2].offset = 4294967295u;
  EXPECT_TRUE(PointsOf(cloud, still).empty());
  cloud.point_step = 0;
  EXPECT_TRUE(PointsOf(cloud, still).empty());
}

TEST(ViewerConversionTest, ScansGiveWhatIsWithinTheirReach) {
  sensor_msgs::LaserScan scan;
  scan.angle_min = 0.0f;
  scan.angle_increment = static_cast<float>(M_PI / 2.0);
  scan.range_min = 0.1f;
  scan.range_max = 10.0f;
  scan.ranges = {5.0f, std::numeric_limits<float>::infinity(), 2.0f, std::nanf(""), 0.01f};
  const auto points = PointsOf(scan, Eigen::Matrix3d::Identity());
  ASSERT_EQ(points.size(), 2u);
  EXPECT_LT((points[0].from_sensor_m - Eigen::Vector3f(5.0f, 0.0f, 0.0f)).norm(), 1e-5f);
  EXPECT_LT((points[1].from_sensor_m - Eigen::Vector3f(-2.0f, 0.0f, 0.0f)).norm(), 1e-5f);
}

TEST(ViewerConversionTest, LongPathsKeepTheirEnds) {
  nav_msgs::Path path;
  for (int i = 0; i < 3001; ++i) {
    path.poses.emplace_back();
    path.poses.back().pose.position.x = i;
  }
  const auto points = PointsOf(path);
  EXPECT_LE(points.size(), 500u);
  EXPECT_GT(points.size(), 300u);
  EXPECT_EQ(points.front().x(), 0.0);
  EXPECT_EQ(points.back().x(), 3000.0);
  EXPECT_TRUE(PointsOf(nav_msgs::Path()).empty());
}

}  // namespace
}  // namespace latticeworld
