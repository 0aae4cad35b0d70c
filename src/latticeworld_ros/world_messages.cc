#include "latticeworld_ros/world_messages.h"

#include <boost/make_shared.hpp>
#include <exception>
#include <future>
#include <string>
#include <utility>

#include "latticeworld/mapping/octree.h"
#include "latticeworld/mapping/traversability.h"
#include "latticeworld_ros/grid_conversion.h"
#include "latticeworld_ros/octomap_conversion.h"
#include "latticeworld_ros/stopwatch.h"
#include "latticeworld_ros/world_conversion.h"
#include "latticeworld_ros/world_markers.h"

namespace latticeworld {
namespace {

constexpr char kStage[] = "maps";

Status BuildOctomaps(const World& world, const WorldServerOptions& options,
                     const Progress& progress, WorldMessages* messages) {
  OctreeOptions octree_options;
  octree_options.resolution_m = options.octomap_resolution_m > 0.0
                                    ? options.octomap_resolution_m
                                    : world.scene->geometry().resolution_m();
  octree_options.thickness_m = options.octomap_thickness_m;
  LW_ASSIGN_OR_RETURN(const auto tree, BuildOctree(*world.scene, octree_options, progress));
  LW_RETURN_IF_ERROR(progress.CheckCancelled());
  messages->octomap_binary = boost::make_shared<octomap_msgs::Octomap>(ToRos(*tree, true));
  messages->octomap_full = boost::make_shared<octomap_msgs::Octomap>(ToRos(*tree, false));
  return Status();
}

Status BuildGrids(const World& world, const WorldServerOptions& options, const Progress& progress,
                  WorldMessages* messages) {
  const Scene& scene = *world.scene;
  const Terrain& terrain = *scene.terrain;
  const GridGeometry& geometry = scene.geometry();
  progress.Report(kStage, 0.0);
  messages->info = boost::make_shared<latticeworld_msgs::WorldInfo>(ToInfo(world));
  messages->layout = boost::make_shared<latticeworld_msgs::Layout>(ToLayout(world));
  messages->environment = boost::make_shared<latticeworld_msgs::Environment>(ToEnvironment(world));
  messages->map = boost::make_shared<nav_msgs::OccupancyGrid>(
      ToOccupancyGrid(geometry, BuildOccupancy(scene, options.robot)));
  LW_RETURN_IF_ERROR(progress.CheckCancelled());
  progress.Report(kStage, 0.2);
  const Grid<float> traversability = BuildTraversability(scene, options.robot);
  LW_RETURN_IF_ERROR(progress.CheckCancelled());
  progress.Report(kStage, 0.4);
  const Grid<float> slope_rad = BuildSlope(scene);
  std::vector<GridLayer> layers = {{"elevation", &terrain.ground.height_m()},
                                   {"water", &terrain.water_level_m},
                                   {"slope", &slope_rad}};
  for (const ClassWeight& entry : terrain.weights.classes) {
    const LayoutClass* layout_class = FindClass(terrain.weights.vocabulary, entry.letter);
    layers.push_back({"class_" + std::string(layout_class->name), &entry.weight});
  }
  layers.push_back({"traversability", &traversability});
  messages->height_map = boost::make_shared<grid_map_msgs::GridMap>(ToGridMap(geometry, layers));
  LW_RETURN_IF_ERROR(progress.CheckCancelled());
  progress.Report(kStage, 0.7);
  messages->height_image =
      boost::make_shared<sensor_msgs::Image>(ToImage(terrain.ground.height_m()));
  messages->markers = boost::make_shared<visualization_msgs::MarkerArray>(
      ToMarkers(scene, {options.marker_terrain_cells, options.marker_max_assets}));
  progress.Report(kStage, 1.0);
  return Status();
}

}  // namespace

Result<WorldMessages> BuildWorldMessages(const World& world, const WorldServerOptions& options,
                                         const Progress& progress, std::vector<StageTime>* stages) {
  WorldMessages messages;
  double octomap_s = 0.0;
  // The octree is the longest of them: it gets a thread of its own. It tells nobody how far it is,
  // for the other thread reports, but it hears a cancel.
  std::future<Status> octomaps = std::async(std::launch::async, [&] {
    const Stopwatch watch;
    const Status status = BuildOctomaps(world, options, progress, &messages);
    octomap_s = watch.seconds();
    return status;
  });
  const Stopwatch watch;
  const Status grids = BuildGrids(world, options, progress, &messages);
  const double grids_s = watch.seconds();
  LW_RETURN_IF_ERROR(octomaps.get());
  LW_RETURN_IF_ERROR(grids);
  stages->push_back({"octomap", octomap_s});
  stages->push_back({"maps", grids_s});
  return messages;
}

void SetStamp(ros::Time stamp, WorldMessages* messages) {
  messages->info->header.stamp = stamp;
  messages->layout->header.stamp = stamp;
  messages->environment->header.stamp = stamp;
  messages->octomap_full->header.stamp = stamp;
  messages->octomap_binary->header.stamp = stamp;
  messages->map->header.stamp = stamp;
  messages->map->info.map_load_time = stamp;
  messages->height_map->info.header.stamp = stamp;
  messages->height_image->header.stamp = stamp;
  for (visualization_msgs::Marker& marker : messages->markers->markers) {
    marker.header.stamp = stamp;
  }
}

}  // namespace latticeworld
