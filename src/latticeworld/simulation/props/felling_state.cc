#include <cmath>

#include "latticeworld/common/digest.h"
#include "latticeworld/simulation/props/felling.h"
#include "latticeworld/simulation/props/tree_body.h"

namespace latticeworld {
namespace {

// Trees do not fall exactly where they lean to.
constexpr double kFallMargin_m = 1.0;

void Add(Digest* digest, const Eigen::Vector3d& vector) {
  for (int i = 0; i < 3; ++i) digest->Add(vector[i]);
}

}  // namespace

void Felling::Restore(const State& state) {
  state_ = state;
  falls_.clear();
  ListChanges();
}

void Felling::ListChanges() {
  changes_ = {};
  for (const auto& [asset, tree] : state_.trees) {
    if (tree.at_rest) {
      changes_.fallen.push_back(tree.lies);
    } else {
      changes_.gone.push_back(asset);
    }
  }
}

std::vector<FelledTree> Felling::Snapshots() const {
  std::vector<FelledTree> felled;
  for (const auto& [asset, tree] : state_.trees) {
    FelledTree one;
    one.at_rest = tree.at_rest;
    // One that left the world is where it was seen last, and never at rest.
    one.tree = tree.at_rest || tree.body == 0
                   ? tree.lies
                   : StemOf(asset, scene_.assets[asset], physics_->MotionOf(tree.body));
    felled.push_back(one);
  }
  return felled;
}

std::vector<Footprint> Felling::Obstacles() const {
  std::vector<Footprint> obstacles;
  const auto add = [&obstacles](const FallenTree& stem, double half_width_m) {
    const Eigen::Vector2d foot = stem.foot_m.head<2>(), way = stem.tip_m.head<2>() - foot;
    const Eigen::Vector2d middle = foot + 0.5 * way;
    obstacles.push_back({{middle.x(), middle.y()},
                         std::atan2(way.y(), way.x()),
                         0.5 * way.norm() + half_width_m,
                         half_width_m});
  };
  for (const auto& [asset, tree] : state_.trees) {
    if (tree.body == 0) continue;
    const Asset& stood = scene_.assets[asset];
    FallenTree stem = StemOf(asset, stood, physics_->MotionOf(tree.body));
    add(stem, stood.trunk_radius_m);
    if (tree.at_rest) continue;
    const Eigen::Vector2d toward = stood.height_m * tree.toward;
    stem.tip_m = stem.foot_m + Eigen::Vector3d(toward.x(), toward.y(), 0.0);
    add(stem, stood.trunk_radius_m + kFallMargin_m);
  }
  return obstacles;
}

std::optional<std::uint32_t> Felling::AssetOf(BodyId body) const {
  for (const auto& [asset, tree] : state_.trees) {
    if (tree.body == body && body != 0) return asset;
  }
  return std::nullopt;
}

void Felling::AddTo(Digest* digest) const {
  digest->Add<std::uint64_t>(state_.trees.size());
  for (const auto& [asset, tree] : state_.trees) {
    digest->Add(asset);
    digest->Add(tree.body);
    digest->Add(tree.still_s);
    digest->Add(tree.falling_s);
    digest->Add(tree.at_rest);
    Add(digest, tree.lies.foot_m);
    Add(digest, tree.lies.tip_m);
    digest->Add(tree.toward.x());
    digest->Add(tree.toward.y());
  }
  digest->Add<std::uint64_t>(state_.pushes.size());
  for (const auto& [asset, moment_nm] : state_.pushes) {
    digest->Add(asset);
    digest->Add(moment_nm.x());
    digest->Add(moment_nm.y());
  }
}

}  // namespace latticeworld
