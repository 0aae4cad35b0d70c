// What the scanner of the shipped suites sees, beside the map that a robot is to localise by.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "latticeworld/mapping/scan_map.h"
#include "latticeworld/species/species_catalogue.h"
#include "scene/test_world.h"
#include "sensing/rig_world_for_tests.h"

namespace latticeworld {
namespace {

constexpr double kSize_m = 96.0;
// What stands there by the letters of the layout.
constexpr std::array<AssetKind, 4> kSeen = {AssetKind::kCrop, AssetKind::kBush, AssetKind::kTree,
                                            AssetKind::kBuilding};

// Level ground: rows of ripe crops in the west, forest in the north-east, houses in the south-east,
// and grass between them.
std::shared_ptr<const Scene> Village() {
  TestGround ground;
  ground.size_m = kSize_m;
  ground.cells = 192;
  ground.letter_at = [](WorldPoint at) {
    if (at.x_m < 0.0) return 'G';
    return at.y_m > 12.0 ? 'F' : at.y_m < -12.0 ? 'B' : 'G';
  };
  const Scene scene = *Build(MakeTerrain(ground), MakeEnvironment(0.5), 3).scene;
  std::vector<Asset> assets = scene.assets;
  for (float x_m = -44.0f; x_m < -8.0f; x_m += 6.0f) {
    for (float y_m = -44.0f; y_m < 44.0f; y_m += 2.0f) {
      assets.push_back(MakeRound(AssetKind::kCrop, x_m, y_m, 0.9f, 0.4f));
    }
  }
  return std::make_shared<Scene>(WithAssets(scene, std::move(assets)));
}

SensorSpec ShippedScan() {
  const std::vector<SensorSpec>& sensors =
      SensorCatalogue::BuiltIn()->FindSuite("scanner")->sensors;
  return *std::find_if(sensors.begin(), sensors.end(),
                       [](const SensorSpec& sensor) { return sensor.name == "scan"; });
}

// Places of what a level robot's scan meets from there [m].
std::vector<WorldPoint> HitsFrom(SensorRig* rig, const SensorSpec& scan, SensedAgent robot,
                                 WorldPoint place) {
  robot.map_from_base.translation() = Eigen::Vector3d(place.x_m, place.y_m, 0.0);
  rig->Restart(1);
  const auto frames = FramesOf(rig, 10, [&](std::uint64_t step) { return WorldAt(step, {robot}); });
  const auto& sweep = std::get<LidarSweep>(frames.at(0).reading);
  const auto& model = std::get<LidarModel>(scan.model);
  const Eigen::Isometry3d map_from_sensor =
      robot.map_from_base * BaseFromSensor(scan, robot.height_m);
  std::vector<WorldPoint> hits;
  for (int column = 0; column < sweep.columns; ++column) {
    if (!std::isfinite(sweep.ranges_m[column])) continue;
    const double azimuth_rad =
        model.first_azimuth_rad + column * model.field_of_view_rad / model.columns;
    const Eigen::Vector3d at =
        map_from_sensor * (static_cast<double>(sweep.ranges_m[column]) *
                           Eigen::Vector3d(std::cos(azimuth_rad), std::sin(azimuth_rad), 0.0));
    if (std::max(std::abs(at.x()), std::abs(at.y())) < 0.5 * kSize_m) {
      hits.push_back({at.x(), at.y()});
    }
  }
  return hits;
}

bool IsInOrBesideOccupied(const Grid<std::int8_t>& map, CellIndex cell) {
  for (int row = std::max(0, cell.row - 1); row <= std::min(map.rows() - 1, cell.row + 1); ++row) {
    for (int col = std::max(0, cell.col - 1); col <= std::min(map.cols() - 1, cell.col + 1);
         ++col) {
      if (map(row, col) == 100) return true;
    }
  }
  return false;
}

// Whether a thing of that kind is where something was met.
bool IsOf(const Scene& scene, AssetKind kind, WorldPoint hit) {
  return std::any_of(scene.assets.begin(), scene.assets.end(), [&](const Asset& asset) {
    if (asset.kind != kind) return false;
    const double away_m = std::hypot(asset.x_m - hit.x_m, asset.y_m - hit.y_m);
    const bool is_plant = kind == AssetKind::kCrop || kind == AssetKind::kBush;
    return is_plant ? away_m < asset.half_length_m : SolidContains(asset, hit, 0.1);
  });
}

TEST(ScanOnMapTest, WhatTheScannerMeetsOnLevelGroundIsOnTheMapToLocaliseBy) {
  const auto scene = Village();
  const Grid<std::int8_t> map = BuildScanMap(*scene);
  const SensorSpec scan = ShippedScan();
  const auto rig = RigOf(*scene, {scan});
  SensedAgent robot = RobotAt(0.0, Eigen::Vector3d::Zero(), 0.0);
  robot.height_m = SpeciesCatalogue::BuiltIn()->Find("wheeled robot")->height_m;
  ASSERT_NEAR(BaseFromSensor(scan, robot.height_m).translation().z(), kScanHeight_m, 0.011);
  std::array<int, kSeen.size()> of_kind = {};
  int met = 0, on_map = 0;
  for (double x_m = -40.0; x_m <= 40.0; x_m += 10.0) {
    for (double y_m = -40.0; y_m <= 40.0; y_m += 10.0) {
      const bool is_free =
          std::none_of(scene->assets.begin(), scene->assets.end(), [&](const Asset& asset) {
            return SolidContains(asset, {x_m, y_m}, 0.4);
          });
      if (!is_free) continue;
      for (const WorldPoint hit : HitsFrom(rig.get(), scan, robot, {x_m, y_m})) {
        ++met;
        on_map += IsInOrBesideOccupied(map, scene->geometry().CellAt(hit));
        for (std::size_t i = 0; i < kSeen.size(); ++i) of_kind[i] += IsOf(*scene, kSeen[i], hit);
      }
    }
  }
  for (std::size_t i = 0; i < kSeen.size(); ++i) EXPECT_GT(of_kind[i], 200) << NameOf(kSeen[i]);
  EXPECT_GE(on_map, 0.95 * met) << met << " were met";
  // The map says more than that something is everywhere.
  EXPECT_LT(std::count(map.begin(), map.end(), std::int8_t{100}), 0.4 * map.size());
}

}  // namespace
}  // namespace latticeworld
