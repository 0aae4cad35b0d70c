#include "latticeworld_ros/publishing/world_messages.h"

#include <ros/console.h>
#include <ros/serialization.h>

#include <algorithm>
#include <boost/make_shared.hpp>
#include <cstddef>
#include <deque>
#include <exception>
#include <future>
#include <string>
#include <utility>

#include "latticeworld/mapping/bridge_decks.h"
#include "latticeworld/mapping/octree/octree.h"
#include "latticeworld/mapping/scan_map.h"
#include "latticeworld/mapping/traversability.h"
#include "latticeworld/scene/scene_changes.h"
#include "latticeworld_ros/conversion/grid_conversion.h"
#include "latticeworld_ros/conversion/octomap_conversion.h"
#include "latticeworld_ros/conversion/world_conversion.h"
#include "latticeworld_ros/conversion/world_markers.h"
#include "latticeworld_ros/node/stopwatch.h"

namespace latticeworld {
namespace {

constexpr char kStage[] = "maps";
constexpr char kTooLarge[] =
    " bytes, more than most_message_bytes; cells of twice the size, or 4, 8 ... times, are "
    "published";
constexpr int kFewestMarkerCells = 16;
constexpr std::uint64_t kHeaderBytes = 1024;  // of a message beside its data, and more
constexpr int kEveryCore = 0, kOneThread = 1;

Status BuildOctomaps(const Scene& scene, const WorldServerOptions& options,
                     const SceneChanges& changes, int threads, const Progress& progress,
                     WorldMessages* messages) {
  OctreeOptions octree_options;
  octree_options.threads = threads;
  octree_options.resolution_m = options.octomap_resolution_m > 0.0
                                    ? options.octomap_resolution_m
                                    : scene.geometry().resolution_m();
  octree_options.thickness_m = options.octomap_thickness_m;
  LW_ASSIGN_OR_RETURN(OctreeData binary, BuildBinaryData(scene, octree_options, progress, changes));
  LW_ASSIGN_OR_RETURN(OctreeData full, BuildFullData(scene, octree_options, progress, changes));
  // Both have voxels of one size.
  while (full.bytes.size() + kHeaderBytes >= options.most_message_bytes) {
    if (messages->octomap_full == nullptr) {
      ROS_WARN_STREAM("octomap_full of " << octree_options.resolution_m << " m has "
                                         << full.bytes.size() << kTooLarge);
    }
    octree_options.resolution_m *= 2.0;
    LW_ASSIGN_OR_RETURN(binary, BuildBinaryData(scene, octree_options, progress, changes));
    LW_ASSIGN_OR_RETURN(full, BuildFullData(scene, octree_options, progress, changes));
  }
  const double resolution_m = octree_options.resolution_m;
  messages->octomap_binary =
      boost::make_shared<octomap_msgs::Octomap>(ToOctomap(std::move(binary), resolution_m, true));
  messages->octomap_full =
      boost::make_shared<octomap_msgs::Octomap>(ToOctomap(std::move(full), resolution_m, false));
  return Status();
}

// Half as many assets and as fine a ground, or a quarter, an eighth ..., where that is needed.
boost::shared_ptr<visualization_msgs::MarkerArray> MakeMarkers(const Scene& scene,
                                                               const WorldServerOptions& options,
                                                               const SceneChanges& changes,
                                                               bool warns) {
  WorldMarkerOptions drawn = {options.marker_terrain_cells, options.marker_max_assets};
  auto markers =
      boost::make_shared<visualization_msgs::MarkerArray>(ToMarkerArray(scene, drawn, changes));
  for (;;) {
    const std::size_t bytes = ros::serialization::serializationLength(*markers);
    if (bytes < options.most_message_bytes || drawn.max_assets == 0) return markers;
    if (warns) {
      ROS_WARN_STREAM("world/markers of " << drawn.max_assets << " assets has " << bytes
                                          << " bytes, more than most_message_bytes; half of them "
                                             "are drawn, and the ground half as finely");
    }
    drawn.max_assets /= 2;
    drawn.terrain_cells = std::max(kFewestMarkerCells, drawn.terrain_cells / 2);
    *markers = ToMarkerArray(scene, drawn, changes);
  }
}

void SetStamp(ros::Time stamp, visualization_msgs::MarkerArray* array) {
  for (visualization_msgs::Marker& marker : array->markers) marker.header.stamp = stamp;
}

// map and world/height_map.
Status BuildGridMaps(const Scene& scene, const WorldServerOptions& options,
                     const SceneChanges& changes, int threads, const Progress& progress,
                     WorldMessages* messages) {
  const Terrain& terrain = *scene.terrain;
  const GridGeometry& geometry = scene.geometry();
  const Grid<std::int8_t> occupancy = BuildOccupancy(scene, options.robot, changes, threads);
  messages->map = boost::make_shared<nav_msgs::OccupancyGrid>(
      ToOccupancyGrid(geometry, WithValues(occupancy, options.map_values)));
  LW_RETURN_IF_ERROR(progress.CheckCancelled());
  const Grid<float> distance_m = BuildDistanceField(occupancy, geometry.resolution_m());
  const Grid<float> traversability = BuildTraversability(scene, options.robot, changes, threads);
  const Grid<float> slope_rad = BuildSlope(scene, threads);
  const Grid<float> deck_m = BuildDeckHeight(scene, changes, threads);
  LW_RETURN_IF_ERROR(progress.CheckCancelled());
  std::vector<GridLayer> layers = {{"elevation", &terrain.ground.height_m()},
                                   {"water", &terrain.water_level_m},
                                   {"bridge_deck", &deck_m, CellMerge::kMost},
                                   {"slope", &slope_rad, CellMerge::kMost},
                                   {"distance", &distance_m, CellMerge::kLeast}};
  std::deque<Grid<float>> weights;  // keeps its props in their place
  for (const ClassWeight& entry : terrain.weights.classes) {
    const LayoutClass* layout_class = FindClass(terrain.weights.vocabulary, entry.letter);
    layers.push_back({"class_" + std::string(layout_class->name),
                      &weights.emplace_back(entry.weight.ToFloat())});
  }
  layers.push_back({"traversability", &traversability, CellMerge::kLeast});
  const int coarsening = CoarseningFor(geometry.cols(), layers.size(), options.most_message_bytes);
  if (coarsening > 1 && messages->height_map == nullptr) {
    ROS_WARN_STREAM("world/height_map of "
                    << geometry.cols() << " cells a side and " << layers.size() << " layers has "
                    << layers.size() * terrain.ground.height_m().size() * sizeof(float)
                    << kTooLarge);
  }
  messages->height_map =
      boost::make_shared<grid_map_msgs::GridMap>(ToGridMap(geometry, layers, coarsening));
  return progress.CheckCancelled();
}

boost::shared_ptr<nav_msgs::OccupancyGrid> MakeScanMap(const Scene& scene,
                                                       const SceneChanges& changes, int threads) {
  return boost::make_shared<nav_msgs::OccupancyGrid>(
      ToOccupancyGrid(scene.geometry(), BuildScanMap(scene, kScanHeight_m, changes, threads)));
}

void SetStamp(ros::Time stamp, nav_msgs::OccupancyGrid* map) {
  map->header.stamp = stamp;
  map->info.map_load_time = stamp;
}

// All but the octomaps.
Status BuildOthers(const World& world, const WorldServerOptions& options, const Progress& progress,
                   WorldMessages* messages) {
  const Scene& scene = *world.scene;
  progress.Report(kStage, 0.0);
  messages->info = boost::make_shared<latticeworld_msgs::WorldInfo>(ToWorldInfo(world));
  messages->layout = boost::make_shared<latticeworld_msgs::Layout>(ToLayout(world));
  messages->environment = boost::make_shared<latticeworld_msgs::Environment>(ToEnvironment(world));
  LW_RETURN_IF_ERROR(BuildGridMaps(scene, options, {}, kEveryCore, progress, messages));
  messages->scan_map = MakeScanMap(scene, {}, kEveryCore);
  progress.Report(kStage, 0.7);
  messages->height_image =
      boost::make_shared<sensor_msgs::Image>(ToImage(scene.terrain->ground.height_m()));
  messages->markers = MakeMarkers(scene, options, {}, /*warns=*/true);
  progress.Report(kStage, 1.0);
  return Status();
}

}  // namespace

Result<WorldMessages> BuildWorldMessages(const World& world, const WorldServerOptions& options,
                                         const Progress& progress, std::vector<StageTime>* stages) {
  WorldMessages messages;
  double octomap_s = 0.0;
  // The octomaps are the longest of them: they get a thread of their own, where one can be had. It
  // tells nobody how far it is, for the other thread reports, but it hears a cancel.
  std::future<Status> octomaps = std::async(std::launch::async | std::launch::deferred, [&] {
    const Stopwatch watch;
    const Status status = BuildOctomaps(*world.scene, options, {}, kEveryCore, progress, &messages);
    octomap_s = watch.seconds();
    return status;
  });
  const Stopwatch watch;
  const Status others = BuildOthers(world, options, progress, &messages);
  const double others_s = watch.seconds();
  LW_RETURN_IF_ERROR(octomaps.get());
  LW_RETURN_IF_ERROR(others);
  stages->push_back({"octomap", octomap_s});
  stages->push_back({"maps", others_s});
  return messages;
}

Result<WorldMessages> RebuildMaps(const World& world, const WorldServerOptions& options,
                                  const SceneChanges& changes, ros::Time stamp,
                                  const Progress& progress, const ShownMaps& before) {
  WorldMessages messages = before.messages;
  SceneChanges on_same_ground = changes;
  on_same_ground.ground = before.changes.ground;
  if (!(on_same_ground == before.changes)) {
    LW_RETURN_IF_ERROR(
        BuildOctomaps(*world.scene, options, changes, kOneThread, progress, &messages));
    messages.markers = MakeMarkers(*world.scene, options, changes, /*warns=*/false);
    SetStamp(stamp, messages.markers.get());
    messages.scan_map = MakeScanMap(*world.scene, changes, kOneThread);
    SetStamp(stamp, messages.scan_map.get());
    messages.octomap_full->header.stamp = stamp;
    messages.octomap_binary->header.stamp = stamp;
  }
  LW_RETURN_IF_ERROR(
      BuildGridMaps(*world.scene, options, changes, kOneThread, progress, &messages));
  SetStamp(stamp, messages.map.get());
  messages.height_map->info.header.stamp = stamp;
  return messages;
}

void SetStamp(ros::Time stamp, WorldMessages* messages) {
  messages->info->header.stamp = stamp;
  messages->layout->header.stamp = stamp;
  messages->environment->header.stamp = stamp;
  messages->octomap_full->header.stamp = stamp;
  messages->octomap_binary->header.stamp = stamp;
  SetStamp(stamp, messages->map.get());
  SetStamp(stamp, messages->scan_map.get());
  messages->height_map->info.header.stamp = stamp;
  messages->height_image->header.stamp = stamp;
  SetStamp(stamp, messages->markers.get());
}

}  // namespace latticeworld
