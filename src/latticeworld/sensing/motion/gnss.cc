#include "latticeworld/sensing/motion/gnss.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/scene/scene.h"
#include "latticeworld/sensing/counter_noise.h"
#include "latticeworld/sensing/motion/geodesy.h"
#include "latticeworld/sensing/sensed_world.h"

namespace latticeworld {
namespace {

// No crown reaches further from its trunk.
constexpr double kWidestCrown_m = 15.0;

bool Stands(const SensedWorld& world, std::uint32_t asset) {
  const auto is_it = [asset](const FallenTree& tree) { return tree.asset == asset; };
  return std::none_of(world.felled.begin(), world.felled.end(), is_it) &&
         std::find(world.gone.begin(), world.gone.end(), asset) == world.gone.end();
}

}  // namespace

bool IsUnderTrees(const Scene& scene, const SensedWorld& world, const Eigen::Vector3d& point_m) {
  bool under = false;
  const WorldPoint place = {point_m.x(), point_m.y()};
  scene.index.ForEachNear(place, kWidestCrown_m, [&](std::uint32_t index) {
    const Asset& asset = scene.assets[index];
    if (under || asset.kind != AssetKind::kTree) return;
    const double away_m = std::hypot(asset.x_m - place.x_m, asset.y_m - place.y_m);
    under = away_m < asset.half_length_m && point_m.z() < asset.z_m + asset.height_m &&
            Stands(world, index);
  });
  return under;
}

GnssReceiver::GnssReceiver(const GnssModel& model, const GeoOrigin& origin, double rate_hz,
                           std::uint64_t key)
    : model_(model),
      origin_(origin),
      white_key_(KeyOf(key, 0)),
      wander_(KeyOf(key, 1),
              {model.horizontal_wander_m, model.horizontal_wander_m, model.vertical_wander_m},
              1.0 / rate_hz, model.wander_time_s) {}

GnssReading GnssReceiver::Read(const Eigen::Vector3d& antenna_m, bool under_trees,
                               std::uint64_t k) {
  const double factor = under_trees ? model_.canopy_factor : 1.0;
  const Eigen::Vector3d noise_m(model_.horizontal_noise_m, model_.horizontal_noise_m,
                                model_.vertical_noise_m);
  const Eigen::Vector3d white = noise_m.cwiseProduct(NormalsAt(white_key_, k));
  const GeoOrigin fix = GeoPointAt(origin_, antenna_m + factor * (white + wander_.At(k)));
  GnssReading reading;
  reading.latitude_deg = fix.latitude_deg;
  reading.longitude_deg = fix.longitude_deg;
  reading.altitude_m = fix.altitude_m;
  const double horizontal_m = std::hypot(model_.horizontal_noise_m, model_.horizontal_wander_m);
  const double vertical_m = std::hypot(model_.vertical_noise_m, model_.vertical_wander_m);
  reading.stddev_m = factor * Eigen::Vector3d(horizontal_m, horizontal_m, vertical_m);
  return reading;
}

}  // namespace latticeworld
