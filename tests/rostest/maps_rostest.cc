// The maps of a world that the real launch file runs, against each other and against the ground as
// query_terrain tells it.

#include <grid_map_msgs/GridMap.h>
#include <gtest/gtest.h>
#include <nav_msgs/GetMap.h>
#include <nav_msgs/OccupancyGrid.h>
#include <octomap/OcTree.h>
#include <octomap_msgs/GetOctomap.h>
#include <octomap_msgs/Octomap.h>
#include <ros/ros.h>
#include <ros/topic.h>
#include <sensor_msgs/Image.h>

#include <boost/make_shared.hpp>
#include <cmath>
#include <cstdint>
#include <memory>
#include <random>
#include <vector>

#define latticeworld latticeworld_msgs
#include <latticeworld/GenerateWorld.h>
#include <latticeworld/QueryTerrain.h>
#undef latticeworld

namespace {

constexpr double kSize_m = 128.0;
constexpr double kMaxSlope_rad = 0.5236;  // as launch_cfg/world_server.yaml says
constexpr double kMaxFordingDepth_m = 0.2;

template <typename Service>
typename Service::Response Call(const std::string& name, const typename Service::Request& request) {
  typename Service::Response response;
  EXPECT_TRUE(ros::service::waitForService(name, 60000)) << name;
  EXPECT_TRUE(ros::service::call(name, const_cast<typename Service::Request&>(request), response))
      << name;
  return response;
}

template <typename Message>
boost::shared_ptr<const Message> Wait(const std::string& topic) {
  ros::NodeHandle node;
  auto message = ros::topic::waitForMessage<Message>(topic, node);
  EXPECT_NE(message, nullptr) << topic;
  return message;
}

std::vector<latticeworld_msgs::TerrainSample> Query(
    const std::vector<geometry_msgs::Point>& points) {
  latticeworld_msgs::QueryTerrain::Request request;
  request.points = points;
  const auto response = Call<latticeworld_msgs::QueryTerrain>("query_terrain", request);
  EXPECT_EQ(response.status.code, latticeworld_msgs::Status::OK) << response.status.message;
  EXPECT_EQ(response.samples.size(), points.size());
  return response.samples;
}

std::unique_ptr<octomap::OcTree> ReadTree(const octomap_msgs::Octomap& message) {
  EXPECT_EQ(message.id, "OcTree");
  auto tree = std::make_unique<octomap::OcTree>(message.resolution);
  std::stringstream stream(std::string(message.data.begin(), message.data.end()));
  if (message.binary) {
    tree->readBinaryData(stream);
  } else {
    tree->readData(stream);
  }
  return tree;
}

class MapsTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    latticeworld_msgs::GenerateWorld::Request request;
    request.layout_instruction =
        "A lake in the lower left, dense forest in the upper left, farmland on the right, a road "
        "from the west to the east, and a small village in the center.";
    request.seed = 7;
    request.size = kSize_m;
    const auto response = Call<latticeworld_msgs::GenerateWorld>("generate_world", request);
    ASSERT_EQ(response.status.code, latticeworld_msgs::Status::OK) << response.status.message;
  }
};

// The highest voxel of the ground is the one that holds the ground: what stands above it (trees,
// houses) is left out by looking around the queried height only.
TEST_F(MapsTest, OctomapSurfaceIsTheGroundWithinOneVoxel) {
  const auto full = Wait<octomap_msgs::Octomap>("octomap_full");
  const auto tree = ReadTree(*full);
  EXPECT_FALSE(full->binary);
  EXPECT_EQ(full->header.frame_id, "map");

  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-0.5 * kSize_m + 1.0, 0.5 * kSize_m - 1.0);
  std::vector<geometry_msgs::Point> points(1000);
  for (auto& point : points) {
    point.x = uniform(random);
    point.y = uniform(random);
  }
  const auto samples = Query(points);
  const double voxel_m = full->resolution;
  int open_above = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    bool occupied = false;
    for (const double offset_m : {-voxel_m, 0.0, voxel_m}) {
      const auto* node = tree->search(points[i].x, points[i].y, samples[i].height + offset_m);
      occupied |= node != nullptr && tree->isNodeOccupied(node);
    }
    EXPECT_TRUE(occupied) << "no ground at " << points[i].x << ", " << points[i].y;
    const auto* above = tree->search(points[i].x, points[i].y, samples[i].height + 2.0 * voxel_m);
    open_above += above == nullptr || !tree->isNodeOccupied(above);
  }
  // Most of the land is open to the sky: the surface is where the query says, not above.
  EXPECT_GT(open_above, 500);
}

TEST_F(MapsTest, OctomapTopicsAndServicesAreOneTree) {
  const auto full = Wait<octomap_msgs::Octomap>("octomap_full");
  const auto binary = Wait<octomap_msgs::Octomap>("octomap_binary");
  EXPECT_TRUE(binary->binary);
  const auto full_tree = ReadTree(*full), binary_tree = ReadTree(*binary);
  EXPECT_GT(full_tree->size(), 1000u);
  EXPECT_EQ(full_tree->size(), binary_tree->size());
  EXPECT_EQ(full_tree->getNumLeafNodes(), binary_tree->getNumLeafNodes());
  EXPECT_EQ(Call<octomap_msgs::GetOctomap>("octomap_full", {}).map.data, full->data);
  EXPECT_EQ(Call<octomap_msgs::GetOctomap>("octomap_binary", {}).map.data, binary->data);
}

TEST_F(MapsTest, OccupancyKnowsClassesSlopesAndWater) {
  const auto map = Wait<nav_msgs::OccupancyGrid>("map");
  ASSERT_EQ(map->data.size(), static_cast<std::size_t>(map->info.width) * map->info.height);
  EXPECT_EQ(Call<nav_msgs::GetMap>("static_map", {}).map.data, map->data);
  EXPECT_DOUBLE_EQ(map->info.origin.position.x, -0.5 * kSize_m);

  std::vector<geometry_msgs::Point> points;
  for (std::uint32_t row = 0; row < map->info.height; ++row) {
    for (std::uint32_t col = 0; col < map->info.width; ++col) {
      geometry_msgs::Point point;
      point.x = map->info.origin.position.x + (col + 0.5) * map->info.resolution;
      point.y = map->info.origin.position.y + (row + 0.5) * map->info.resolution;
      points.push_back(point);
    }
  }
  const auto samples = Query(points);
  int deep = 0, free_count = 0, road = 0, road_free = 0, trees = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const int cost = map->data[i];
    ASSERT_TRUE(cost >= 0 && cost <= 100);
    if (samples[i].water_depth > kMaxFordingDepth_m) {
      ++deep;
      EXPECT_EQ(cost, 100) << "deep water is free at " << points[i].x << ", " << points[i].y;
    }
    if (cost < 50) {
      ++free_count;
      // The map's slope is the mean around the cell, the query's that of one triangle.
      EXPECT_LT(samples[i].slope, kMaxSlope_rad + 0.3);
    }
    trees += cost == 100 && samples[i].surface == "forest floor";
    if (samples[i].surface == "road" && samples[i].slope < 0.3) {
      ++road;
      road_free += cost < 50;
    }
  }
  EXPECT_GT(deep, 100);
  EXPECT_GT(trees, 100);
  EXPECT_GT(road, 100);
  EXPECT_GT(road_free, 0.9 * road);
  EXPECT_GT(free_count, static_cast<int>(samples.size() / 3));
}

TEST_F(MapsTest, GridMapAgreesWithTheGroundAndTheOccupancyMap) {
  const auto grid = Wait<grid_map_msgs::GridMap>("world/height_map");
  const auto map = Wait<nav_msgs::OccupancyGrid>("map");
  ASSERT_EQ(grid->layers.size(), grid->data.size());
  ASSERT_EQ(grid->layers.front(), "elevation");
  ASSERT_EQ(grid->layers.back(), "traversability");
  const auto& elevation = grid->data.front();
  ASSERT_EQ(elevation.layout.dim.size(), 2u);
  EXPECT_EQ(elevation.layout.dim[0].label, "column_index");
  EXPECT_EQ(elevation.layout.dim[1].label, "row_index");
  const std::uint32_t n = elevation.layout.dim[1].size;
  ASSERT_EQ(elevation.data.size(), static_cast<std::size_t>(n) * elevation.layout.dim[0].size);

  // grid_map's cell (i, j): x falls with i, y with j, from the +x +y corner.
  std::vector<geometry_msgs::Point> points;
  for (std::uint32_t j = 0; j < n; ++j) {
    for (std::uint32_t i = 0; i < n; ++i) {
      geometry_msgs::Point point;
      point.x = 0.5 * grid->info.length_x - (i + 0.5) * grid->info.resolution;
      point.y = 0.5 * grid->info.length_y - (j + 0.5) * grid->info.resolution;
      points.push_back(point);
    }
  }
  const auto samples = Query(points);
  for (std::uint32_t j = 0; j < n; ++j) {
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::size_t at = static_cast<std::size_t>(j) * n + i;
      ASSERT_NEAR(elevation.data[at], samples[at].height, 1e-3);
      const std::size_t in_map =
          static_cast<std::size_t>(n - 1 - j) * n + static_cast<std::size_t>(n - 1 - i);
      ASSERT_EQ(grid->data.back().data[at] == 0.0f, map->data[in_map] == 100);
    }
  }
}

TEST_F(MapsTest, HeightImageHasTheGroundNorthUp) {
  const auto image = Wait<sensor_msgs::Image>("world/height_image");
  EXPECT_EQ(image->encoding, "32FC1");
  const auto* heights = reinterpret_cast<const float*>(image->data.data());
  std::vector<geometry_msgs::Point> points(2);
  const double edge_m = 0.5 * kSize_m - 0.5 * kSize_m / image->width;
  points[0].x = -edge_m;  // first pixel: north-west
  points[0].y = edge_m;
  points[1].x = edge_m;  // last pixel of the first row: north-east
  points[1].y = edge_m;
  const auto samples = Query(points);
  EXPECT_NEAR(heights[0], samples[0].height, 1e-3);
  EXPECT_NEAR(heights[image->width - 1], samples[1].height, 1e-3);
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "maps_test");
  ros::NodeHandle node;
  return RUN_ALL_TESTS();
}
