#include "latticeworld_ros/navigator/navigator_input.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace latticeworld {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

SensorPoseAt Standing() {
  return [](ros::Time) { return std::optional<Eigen::Isometry3d>(Eigen::Isometry3d::Identity()); };
}

// East at 2 m/s from x = 0 at second 100.
SensorPoseAt Moving() {
  return [](ros::Time time) {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.translation().x() = 2.0 * (time.toSec() - 100.0);
    return std::optional<Eigen::Isometry3d>(pose);
  };
}

nav_msgs::OccupancyGrid MapOf(std::uint32_t side, float resolution_m) {
  nav_msgs::OccupancyGrid map;
  map.header.frame_id = "map";
  map.info.resolution = resolution_m;
  map.info.width = map.info.height = side;
  map.info.origin.position.x = map.info.origin.position.y = -0.5 * side * resolution_m;
  map.info.origin.orientation.w = 1.0;
  map.data.assign(side * side, 0);
  return map;
}

TEST(NavigatorInputTest, AMapsFirstRowIsTheSouth) {
  nav_msgs::OccupancyGrid map = MapOf(40, 0.5f);
  map.data[3] = 100;            // south edge, fourth from the west
  map.data[39 * 40 + 39] = -1;  // north-east corner
  const auto read = ToCostMap(map);
  ASSERT_TRUE(read.ok()) << read.status().ToString();
  EXPECT_EQ(read->geometry.rows(), 40);
  EXPECT_DOUBLE_EQ(read->geometry.size_m(), 20.0);
  EXPECT_EQ(read->cost(39, 3), 100);
  EXPECT_EQ(read->cost(0, 39), -1);
  EXPECT_EQ(read->cost(0, 3), 0);
}

TEST(NavigatorInputTest, MapsThatItCannotUseAreRefusedWithWhatIsLegal) {
  std::vector<std::pair<nav_msgs::OccupancyGrid, std::string>> cases;
  const auto with = [&](const char* word, auto change) {
    nav_msgs::OccupancyGrid map = MapOf(40, 0.5f);
    change(&map);
    cases.emplace_back(std::move(map), word);
  };
  with("square", [](auto* map) { map->info.height = 41; });
  with("one a cell", [](auto* map) { map->data.pop_back(); });
  with("one a cell", [](auto* map) { map->info.width = map->info.height = 0xffffffffu; });
  with("resolution", [](auto* map) { map->info.resolution = 0.0f; });
  with("resolution", [](auto* map) { map->info.resolution = kNaN; });
  with("middle", [](auto* map) { map->info.origin.position.x += 1.0; });
  with("middle", [](auto* map) { map->info.origin.position.y = NAN; });
  with("turned", [](auto* map) { map->info.origin.orientation.z = 1.0; });
  with("101", [](auto* map) { map->data[7] = 101; });
  with("-2", [](auto* map) { map->data[7] = -2; });
  with("one a cell", [](auto* map) { map->data.clear(); });
  for (const auto& [map, word] : cases) {
    const Status status = ToCostMap(map).status();
    EXPECT_EQ(status.code(), StatusCode::kInvalidArgument) << word;
    EXPECT_NE(status.message().find(word), std::string::npos) << word << ": " << status.message();
  }
}

sensor_msgs::LaserScan ScanOf(std::vector<float> ranges) {
  sensor_msgs::LaserScan scan;
  scan.header.stamp = ros::Time(100.0);
  scan.angle_increment = static_cast<float>(M_PI / 2.0);
  scan.range_min = 0.1f;
  scan.range_max = 30.0f;
  scan.ranges = std::move(ranges);
  return scan;
}

TEST(NavigatorInputTest, AScanHitsClearsAndSaysNothing) {
  const auto sighting = ToSighting(ScanOf({5.0f, 25.0f, kInfinity, kNaN, 0.05f}), 10.0, Standing());
  ASSERT_TRUE(sighting.ok()) << sighting.status().ToString();
  EXPECT_TRUE(sighting->planar);
  ASSERT_EQ(sighting->hits_m.size(), 1u);
  EXPECT_LT((sighting->hits_m[0] - Eigen::Vector3f(5.0f, 0.0f, 0.0f)).norm(), 1e-4f);
  // What is farther than is looked, and what met nothing: free as far as is looked.
  ASSERT_EQ(sighting->misses_m.size(), 2u);
  EXPECT_LT((sighting->misses_m[0] - Eigen::Vector3f(0.0f, 10.0f, 0.0f)).norm(), 1e-4f);
  EXPECT_LT((sighting->misses_m[1] - Eigen::Vector3f(-10.0f, 0.0f, 0.0f)).norm(), 1e-4f);
}

TEST(NavigatorInputTest, WhatAMovingScannerMetIsToldFromItsPlaceAtTheEnd) {
  sensor_msgs::LaserScan scan = ScanOf(std::vector<float>(101, 4.0f));
  scan.angle_increment = 0.0f;   // all ahead
  scan.time_increment = 0.001f;  // of 0.1 s in all, in which it goes 0.2 m
  const auto sighting = ToSighting(scan, 10.0, Moving());
  ASSERT_TRUE(sighting.ok()) << sighting.status().ToString();
  EXPECT_NEAR(sighting->time_s, 100.1, 1e-6);
  EXPECT_NEAR(sighting->map_from_sensor.translation().x(), 0.2, 1e-6);
  ASSERT_EQ(sighting->hits_m.size(), 101u);
  EXPECT_NEAR(sighting->hits_m.front().x(), 3.8, 0.02);
  EXPECT_NEAR(sighting->hits_m.back().x(), 4.0, 0.02);
}

// Fields x, y, z, time as drivers have them.
sensor_msgs::PointCloud2 CloudOf(const std::vector<std::array<float, 4>>& points) {
  sensor_msgs::PointCloud2 cloud;
  cloud.header.stamp = ros::Time(100.1);
  cloud.height = 1;
  cloud.width = static_cast<std::uint32_t>(points.size());
  cloud.point_step = 16;
  cloud.row_step = cloud.width * cloud.point_step;
  std::uint32_t offset = 0;
  for (const char* name : {"x", "y", "z", "time"}) {
    sensor_msgs::PointField field;
    field.name = name;
    field.offset = offset;
    field.datatype = sensor_msgs::PointField::FLOAT32;
    field.count = 1;
    cloud.fields.push_back(field);
    offset += 4;
  }
  cloud.data.resize(cloud.row_step);
  std::memcpy(cloud.data.data(), points.data(), cloud.data.size());
  return cloud;
}

TEST(NavigatorInputTest, ACloudsPointsAreToldFromWhereTheSensorEnded) {
  const auto cloud = CloudOf({{4.0f, 0.0f, 1.0f, -0.1f},
                              {4.0f, 0.0f, 1.0f, 0.0f},
                              {30.0f, 0.0f, 0.0f, 0.0f},
                              {kNaN, 0.0f, 0.0f, 0.0f}});
  const auto sighting = ToSighting(cloud, 10.0, Moving());
  ASSERT_TRUE(sighting.ok()) << sighting.status().ToString();
  EXPECT_FALSE(sighting->planar);
  EXPECT_TRUE(sighting->misses_m.empty());
  ASSERT_EQ(sighting->hits_m.size(), 2u);
  EXPECT_NEAR(sighting->hits_m[0].x(), 3.8, 0.02);
  EXPECT_NEAR(sighting->hits_m[0].z(), 1.0, 1e-5);
  EXPECT_NEAR(sighting->hits_m[1].x(), 4.0, 0.02);
}

TEST(NavigatorInputTest, DamagedMessagesAreRefused) {
  sensor_msgs::LaserScan scan = ScanOf({1.0f});
  scan.angle_increment = kNaN;
  EXPECT_EQ(ToSighting(scan, 10.0, Standing()).status().code(), StatusCode::kInvalidArgument);
  const sensor_msgs::PointCloud2 good = CloudOf({{1.0f, 0.0f, 0.0f, 0.0f}});
  const auto refused = [&](auto change) {
    sensor_msgs::PointCloud2 cloud = good;
    change(&cloud);
    return ToSighting(cloud, 10.0, Standing()).status().code() == StatusCode::kInvalidArgument;
  };
  EXPECT_FALSE(refused([](auto*) {}));
  EXPECT_TRUE(refused([](auto* cloud) { cloud->data.pop_back(); }));
  EXPECT_TRUE(refused([](auto* cloud) { cloud->width = 0xffffffffu; }));
  EXPECT_TRUE(refused([](auto* cloud) { cloud->height = 0xffffffffu; }));
  EXPECT_TRUE(refused([](auto* cloud) { cloud->height = 2, cloud->row_step = 0; }));
  EXPECT_TRUE(refused([](auto* cloud) { cloud->fields.pop_back(), cloud->fields.pop_back(); }));
  EXPECT_TRUE(refused([](auto* cloud) { cloud->fields[2].offset = 0xfffffffeu; }));
  EXPECT_TRUE(refused([](auto* cloud) { cloud->fields[0].datatype = 8; }));
  EXPECT_TRUE(refused([](auto* cloud) { cloud->is_bigendian = true; }));
  EXPECT_TRUE(refused([](auto* cloud) { cloud->point_step = 0; }));
}

TEST(NavigatorInputTest, TimesThatAreNoneAreNotBelieved) {
  for (const float time : {kNaN, kInfinity, -1e9f, 1e30f}) {
    const auto cloud = CloudOf({{4.0f, 0.0f, 0.0f, time}, {4.0f, 0.0f, 0.0f, 0.0f}});
    const auto sighting = ToSighting(cloud, 10.0, Moving());
    ASSERT_TRUE(sighting.ok()) << time << sighting.status().ToString();
    EXPECT_EQ(sighting->hits_m[0], sighting->hits_m[1]);
    sensor_msgs::LaserScan scan = ScanOf({4.0f, 4.0f});
    scan.time_increment = time;
    EXPECT_TRUE(ToSighting(scan, 10.0, Moving()).ok()) << time;
  }
}

TEST(NavigatorInputTest, AnUnknownPlaceOfTheSensorIsUnavailable) {
  const SensorPoseAt nowhere = [](ros::Time) { return std::optional<Eigen::Isometry3d>(); };
  EXPECT_EQ(ToSighting(ScanOf({1.0f}), 10.0, nowhere).status().code(), StatusCode::kUnavailable);
  EXPECT_EQ(ToSighting(CloudOf({{1.0f, 0.0f, 0.0f, 0.0f}}), 10.0, nowhere).status().code(),
            StatusCode::kUnavailable);
}

// Once all of them were gone through.
TEST(NavigatorInputTest, FourThousandMillionRowsOfNothingAreNoPoints) {
  sensor_msgs::PointCloud2 cloud = CloudOf({{1.0f, 0.0f, 0.0f, 0.0f}});
  cloud.width = cloud.row_step = 0;
  cloud.height = 0xffffffffu;
  const auto sighting = ToSighting(cloud, 10.0, Standing());
  ASSERT_TRUE(sighting.ok()) << sighting.status().ToString();
  EXPECT_TRUE(sighting->hits_m.empty());
}

}  // namespace
}  // namespace latticeworld
