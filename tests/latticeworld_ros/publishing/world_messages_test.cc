#include "latticeworld_ros/publishing/world_messages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

#include "common/refused_threads.h"
#include "latticeworld/generation/world_generator.h"

namespace latticeworld {
namespace {

std::shared_ptr<const World> SmallForest() {
  GenerationRequest request;
  request.layout_instruction = "Dense forest everywhere.";
  request.environment_instruction = "A sunny summer noon.";
  request.seed = 3;
  request.size_m = 64.0;
  return MakeDefaultWorldGenerator().Generate(request, Progress()).value();
}

std::uint32_t FirstTree(const Scene& scene) {
  std::uint32_t i = 0;
  while (scene.assets[i].kind != AssetKind::kTree) ++i;
  return i;
}

// The heights of all corners of all triangles.
std::vector<double> Corners(const visualization_msgs::MarkerArray& array) {
  std::vector<double> heights_m;
  for (const visualization_msgs::Marker& marker : array.markers) {
    for (const geometry_msgs::Point& point : marker.points) heights_m.push_back(point.z);
  }
  return heights_m;
}

TEST(WorldMessagesTest, AreTheSameWhereNoMoreThreadsCanBeHad) {
  const auto world = SmallForest();
  const WorldServerOptions options;
  std::vector<StageTime> stages;
  const WorldMessages beside = BuildWorldMessages(*world, options, Progress(), &stages).value();
  const RefusedThreads refused;
  const auto alone = BuildWorldMessages(*world, options, Progress(), &stages);
  ASSERT_TRUE(alone.ok()) << alone.status().ToString();
  EXPECT_EQ(alone->octomap_full->data, beside.octomap_full->data);
  EXPECT_EQ(alone->octomap_binary->data, beside.octomap_binary->data);
  EXPECT_EQ(alone->map->data, beside.map->data);
}

TEST(WorldMessagesTest, ATreeThatFallsMakesNewMapsAndLeavesTheRestAsItIs) {
  const auto world = SmallForest();
  const WorldServerOptions options;
  std::vector<StageTime> stages;
  WorldMessages before = BuildWorldMessages(*world, options, Progress(), &stages).value();
  SetStamp(ros::Time(1, 0), &before);
  const std::vector<std::int8_t> data_before = before.octomap_binary->data;

  const std::uint32_t tree = FirstTree(*world->scene);
  const Asset& asset = world->scene->assets[tree];
  const Eigen::Vector3d foot_m(asset.x_m, asset.y_m, asset.z_m);
  const Eigen::Vector3d along(std::cos(0.5), std::sin(0.5), 0.0);
  const SceneChanges changes = {{{tree, foot_m, foot_m + asset.height_m * along}}, {}};
  const WorldMessages after =
      RebuildMaps(*world, options, changes, ros::Time(2, 0), Progress(), {before, {}}).value();
  EXPECT_NE(after.octomap_binary->data, before.octomap_binary->data);
  EXPECT_NE(after.octomap_full->data, before.octomap_full->data);
  EXPECT_NE(after.map->data, before.map->data);
  EXPECT_NE(after.scan_map->data, before.scan_map->data);
  for (const ros::Time stamp :
       {after.octomap_binary->header.stamp, after.octomap_full->header.stamp,
        after.map->header.stamp, after.scan_map->header.stamp, after.height_map->info.header.stamp})
    EXPECT_EQ(stamp, ros::Time(2, 0));
  EXPECT_EQ(after.info, before.info);
  EXPECT_EQ(after.layout, before.layout);
  EXPECT_EQ(after.environment, before.environment);
  EXPECT_EQ(after.height_image, before.height_image);
  EXPECT_NE(Corners(*after.markers), Corners(*before.markers));
  // What was published stays as it was.
  EXPECT_EQ(before.octomap_binary->data, data_before);
  EXPECT_EQ(before.map->header.stamp, ros::Time(1, 0));

  // Upright again it is the old map.
  const WorldMessages back =
      RebuildMaps(*world, options, {}, ros::Time(3, 0), Progress(), {after, changes}).value();
  EXPECT_EQ(back.octomap_full->data, before.octomap_full->data);
  EXPECT_EQ(back.map->data, before.map->data);
  EXPECT_EQ(Corners(*back.markers), Corners(*before.markers));
}

TEST(WorldMessagesTest, WeatherMakesOnlyTheMapsAnewThatSayWhereARobotCanGo) {
  const auto world = SmallForest();
  const WorldServerOptions options;
  std::vector<StageTime> stages;
  const WorldMessages before = BuildWorldMessages(*world, options, Progress(), &stages).value();
  SceneChanges snow;
  snow.ground = GroundState{0.0, 0.4, 0.0};
  const WorldMessages after =
      RebuildMaps(*world, options, snow, ros::Time(2, 0), Progress(), {before, {}}).value();
  EXPECT_NE(after.map->data, before.map->data);
  EXPECT_EQ(after.map->header.stamp, ros::Time(2, 0));
  EXPECT_NE(after.height_map, before.height_map);
  EXPECT_EQ(after.octomap_full, before.octomap_full);
  EXPECT_EQ(after.octomap_binary, before.octomap_binary);
  EXPECT_EQ(after.markers, before.markers);
  EXPECT_EQ(after.scan_map, before.scan_map);
}

TEST(WorldMessagesTest, RefusesChangesOfAssetsThatAreNotThere) {
  const auto world = SmallForest();
  const WorldServerOptions options;
  std::vector<StageTime> stages;
  const WorldMessages before = BuildWorldMessages(*world, options, Progress(), &stages).value();
  const SceneChanges changes = {{}, {static_cast<std::uint32_t>(world->scene->assets.size())}};
  EXPECT_EQ(RebuildMaps(*world, options, changes, ros::Time(2, 0), Progress(), {before, {}})
                .status()
                .code(),
            StatusCode::kInvalidArgument);
}

TEST(WorldMessagesTest, ATrinaryMapHasTheObstaclesOfTheGradedOneAndNothingBetween) {
  GenerationRequest request;
  request.layout_instruction = "A high mountain in the center, forest around it.";
  request.seed = 3;
  request.size_m = 64.0;
  const auto world = MakeDefaultWorldGenerator().Generate(request, Progress()).value();
  std::vector<StageTime> stages;
  WorldServerOptions options;
  const WorldMessages graded = BuildWorldMessages(*world, options, Progress(), &stages).value();
  options.map_values = MapValues::kTrinary;
  const WorldMessages trinary = BuildWorldMessages(*world, options, Progress(), &stages).value();
  ASSERT_EQ(trinary.map->data.size(), graded.map->data.size());
  bool between = false;
  for (std::size_t i = 0; i < graded.map->data.size(); ++i) {
    between = between || (graded.map->data[i] > 0 && graded.map->data[i] < 100);
    EXPECT_EQ(trinary.map->data[i], graded.map->data[i] == 100 ? 100 : 0);
  }
  EXPECT_TRUE(between);
  EXPECT_EQ(trinary.height_map->layers, graded.height_map->layers);
}

TEST(WorldMessagesTest, WhatWouldBeTooLargeToBeReceivedIsMadeCoarser) {
  const auto world = SmallForest();
  std::vector<StageTime> stages;
  WorldServerOptions options;
  const WorldMessages whole = BuildWorldMessages(*world, options, Progress(), &stages).value();
  options.most_message_bytes =
      std::min<std::uint64_t>(whole.octomap_full->data.size(),
                              ros::serialization::serializationLength(*whole.height_map)) /
      2;
  const WorldMessages coarse = BuildWorldMessages(*world, options, Progress(), &stages).value();
  EXPECT_LT(coarse.octomap_full->data.size(), options.most_message_bytes);
  EXPECT_GT(coarse.octomap_full->resolution, whole.octomap_full->resolution);
  EXPECT_EQ(coarse.octomap_binary->resolution, coarse.octomap_full->resolution);
  EXPECT_LT(ros::serialization::serializationLength(*coarse.height_map),
            options.most_message_bytes);
  EXPECT_GT(coarse.height_map->info.resolution, whole.height_map->info.resolution);
  EXPECT_EQ(coarse.height_map->layers, whole.height_map->layers);
  EXPECT_EQ(coarse.map->data, whole.map->data);
}

TEST(WorldMessagesTest, MarkersThatWouldBeTooLargeAreFewer) {
  const auto world = SmallForest();
  std::vector<StageTime> stages;
  WorldServerOptions options;
  options.marker_terrain_cells = 64;
  const WorldMessages whole = BuildWorldMessages(*world, options, Progress(), &stages).value();
  options.most_message_bytes = ros::serialization::serializationLength(*whole.markers) / 3;
  const WorldMessages fewer = BuildWorldMessages(*world, options, Progress(), &stages).value();
  EXPECT_LT(ros::serialization::serializationLength(*fewer.markers), options.most_message_bytes);
  EXPECT_GT(Corners(*fewer.markers).size(), Corners(*whole.markers).size() / 20);
  // What fell meanwhile changes nothing about that.
  const SceneChanges changes = {{}, {FirstTree(*world->scene)}};
  const WorldMessages after =
      RebuildMaps(*world, options, changes, ros::Time(2, 0), Progress(), {fewer, {}}).value();
  EXPECT_LT(ros::serialization::serializationLength(*after.markers), options.most_message_bytes);
  EXPECT_NE(Corners(*after.markers), Corners(*fewer.markers));
}

TEST(WorldMessagesTest, TheHeightMapHasTheDistanceToWhatTheMapHasOccupied) {
  const auto world = SmallForest();
  std::vector<StageTime> stages;
  const WorldMessages messages =
      BuildWorldMessages(*world, WorldServerOptions(), Progress(), &stages).value();
  const auto& layers = messages.height_map->layers;
  const auto layer = std::find(layers.begin(), layers.end(), "distance") - layers.begin();
  ASSERT_LT(layer, static_cast<std::ptrdiff_t>(layers.size()));
  const std::vector<float>& distance_m = messages.height_map->data[layer].data;
  const std::size_t count = messages.map->data.size();
  ASSERT_EQ(distance_m.size(), count);
  // The grid map begins in the north-east, the map in the south-west.
  for (std::size_t i = 0; i < count; ++i)
    EXPECT_EQ(messages.map->data[i] == 100, distance_m[count - 1 - i] == 0.0f);
}

}  // namespace
}  // namespace latticeworld
