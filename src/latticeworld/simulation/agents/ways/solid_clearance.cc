#include "latticeworld/simulation/agents/ways/solid_clearance.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

#include "latticeworld/mapping/mapped_assets.h"

namespace latticeworld {
namespace {

using Eigen::Vector2d;

Vector2d ToVector(WorldPoint point) { return {point.x_m, point.y_m}; }

// Share of the way from a to b at which it is nearest to the point.
double NearestShare(const Vector2d& a, const Vector2d& b, const Vector2d& point) {
  const Vector2d way = b - a;
  const double squared = way.squaredNorm();
  return squared > 0.0 ? std::clamp((point - a).dot(way) / squared, 0.0, 1.0) : 0.0;
}

double DistanceToWay(const Vector2d& a, const Vector2d& b, const Vector2d& point) {
  return (a + NearestShare(a, b, point) * (b - a) - point).norm();
}

// The vector in a frame that is turned by yaw_rad.
Vector2d Turned(const Vector2d& v, double yaw_rad) {
  const double cosine = std::cos(yaw_rad), sine = std::sin(yaw_rad);
  return {cosine * v.x() + sine * v.y(), -sine * v.x() + cosine * v.y()};
}

// Distance between the way and the box |x| <= half.x, |y| <= half.y.
double DistanceToBox(const Vector2d& a, const Vector2d& b, const Vector2d& half) {
  // Clipped by the box's sides (Liang and Barsky 1984): is some of it inside?
  double enters = 0.0, leaves = 1.0;
  bool beside = false;
  for (int axis = 0; axis < 2; ++axis) {
    const double way = b[axis] - a[axis];
    if (way == 0.0) {
      beside = beside || std::abs(a[axis]) > half[axis];
      continue;
    }
    const double low = (-half[axis] - a[axis]) / way, high = (half[axis] - a[axis]) / way;
    enters = std::max(enters, std::min(low, high));
    leaves = std::min(leaves, std::max(low, high));
  }
  if (!beside && enters <= leaves) return 0.0;
  // Apart, the nearest pair has a corner of the box or an end of the way in it.
  double nearest = std::numeric_limits<double>::infinity();
  for (const double x : {-half.x(), half.x()}) {
    for (const double y : {-half.y(), half.y()})
      nearest = std::min(nearest, DistanceToWay(a, b, Vector2d(x, y)));
  }
  for (const Vector2d& end : {a, b})
    nearest = std::min(nearest, (end.cwiseAbs() - half).cwiseMax(0.0).norm());
  return nearest;
}

// Ends of the shortest bridge between two ways, as a share of the first one; its length in *length.
double NearestShareToWay(const Vector2d& a, const Vector2d& b, const Vector2d& c, const Vector2d& d,
                         double* length) {
  const Vector2d ab = b - a, cd = d - c;
  const double cross = ab.x() * cd.y() - ab.y() * cd.x();
  if (std::abs(cross) > 1e-12) {
    const Vector2d ac = c - a;
    const double along_ab = (ac.x() * cd.y() - ac.y() * cd.x()) / cross;
    const double along_cd = (ac.x() * ab.y() - ac.y() * ab.x()) / cross;
    if (along_ab >= 0.0 && along_ab <= 1.0 && along_cd >= 0.0 && along_cd <= 1.0) {
      *length = 0.0;
      return along_ab;
    }
  }
  // Apart, an end of one of them is in the nearest pair.
  double share = 0.0;
  *length = std::numeric_limits<double>::infinity();
  const auto consider = [&](double candidate, double distance) {
    if (distance >= *length) return;
    *length = distance;
    share = candidate;
  };
  consider(0.0, DistanceToWay(c, d, a));
  consider(1.0, DistanceToWay(c, d, b));
  for (const Vector2d& end : {c, d}) {
    const double candidate = NearestShare(a, b, end);
    consider(candidate, (a + candidate * ab - end).norm());
  }
  return share;
}

}  // namespace

double SolidDistance(const Asset& asset, WorldPoint from, WorldPoint to) {
  constexpr double kFar_m = std::numeric_limits<double>::infinity();
  if (!IsSolid(asset.kind)) return kFar_m;
  const Vector2d center = ToVector(asset.position());
  Vector2d a = ToVector(from) - center, b = ToVector(to) - center;
  if (asset.kind != AssetKind::kBuilding)
    return std::max(0.0, DistanceToWay(a, b, Vector2d::Zero()) - SolidRadius(asset));
  return DistanceToBox(Turned(a, asset.yaw_rad), Turned(b, asset.yaw_rad),
                       Vector2d(asset.half_length_m, asset.half_width_m));
}

double BlockDistance(const PropBlock& block, const HeightField& ground, WorldPoint from,
                     WorldPoint to, double height_m) {
  const Footprint& footprint = block.footprint;
  if (block.bottom_m - ground.HeightAt(footprint.centre) > height_m)
    return std::numeric_limits<double>::infinity();
  const Vector2d center = ToVector(footprint.centre);
  return DistanceToBox(Turned(ToVector(from) - center, footprint.yaw_rad),
                       Turned(ToVector(to) - center, footprint.yaw_rad),
                       Vector2d(footprint.half_length_m, footprint.half_width_m));
}

double StemDistance(const FallenTree& tree, const HeightField& ground, double trunk_radius_m,
                    WorldPoint from, WorldPoint to, double height_m) {
  // The stem counts as far as maps show the trunk.
  const Eigen::Vector3d top_m = tree.foot_m + kTrunkTop * (tree.tip_m - tree.foot_m);
  double distance_m = 0.0;
  const double share = NearestShareToWay(tree.foot_m.head<2>(), top_m.head<2>(), ToVector(from),
                                         ToVector(to), &distance_m);
  const Eigen::Vector3d nearest_m = tree.foot_m + share * (top_m - tree.foot_m);
  const double ground_m = ground.HeightAt({nearest_m.x(), nearest_m.y()});
  if (nearest_m.z() - trunk_radius_m - ground_m > height_m)
    return std::numeric_limits<double>::infinity();
  return std::max(0.0, distance_m - trunk_radius_m);
}

namespace {

// Whether a way comes nearer than margin_m to the stem. Most stems of a world are far away, and
// that is seen at little cost.
bool BlocksWay(const FallenTree& tree, const Scene& scene, WorldPoint from, WorldPoint to,
               double margin_m, double height_m) {
  const double trunk_m = scene.assets[tree.asset].trunk_radius_m;
  const Vector2d a = ToVector(from), b = ToVector(to);
  const Vector2d foot = tree.foot_m.head<2>(), tip = tree.tip_m.head<2>();
  const Vector2d gap =
      (a.cwiseMin(b) - foot.cwiseMax(tip)).cwiseMax(foot.cwiseMin(tip) - a.cwiseMax(b));
  if (gap.maxCoeff() >= margin_m + trunk_m) return false;
  return StemDistance(tree, scene.terrain->ground, trunk_m, from, to, height_m) < margin_m;
}

// The same of a prop.
bool BlocksWay(const PropBlock& block, const Scene& scene, WorldPoint from, WorldPoint to,
               double margin_m, double height_m) {
  const Footprint& footprint = block.footprint;
  const Vector2d center = ToVector(footprint.centre);
  const double reach_m = margin_m + footprint.radius_m();
  if (DistanceToWay(ToVector(from), ToVector(to), center) >= reach_m) return false;
  return BlockDistance(block, scene.terrain->ground, from, to, height_m) < margin_m;
}

}  // namespace

bool IsWayClear(const Scene& scene, const SceneChanges& changes, WorldPoint from, WorldPoint to,
                double margin_m, double height_m) {
  // The way is looked at in pieces, so that a long one asks about what lies along it and not about
  // a disc around it.
  constexpr double kPiece_m = 8.0;
  const double length_m = std::hypot(to.x_m - from.x_m, to.y_m - from.y_m);
  const int pieces = std::max(1, static_cast<int>(std::ceil(length_m / kPiece_m)));
  const auto at = [&](double share) {
    return WorldPoint{from.x_m + share * (to.x_m - from.x_m),
                      from.y_m + share * (to.y_m - from.y_m)};
  };
  for (int i = 0; i < pieces; ++i) {
    const WorldPoint a = at(static_cast<double>(i) / pieces);
    const WorldPoint b = at(static_cast<double>(i + 1) / pieces);
    bool clear = true;
    scene.index.ForEachNear(
        at((i + 0.5) / pieces), 0.5 * length_m / pieces + margin_m, [&](std::uint32_t asset) {
          clear = clear && (SolidDistance(scene.assets[asset], a, b) >= margin_m ||
                            !(changes.empty() || changes.Stands(asset)));
        });
    if (!clear) return false;
  }
  for (const FallenTree& tree : changes.fallen) {
    if (BlocksWay(tree, scene, from, to, margin_m, height_m)) return false;
  }
  const std::shared_ptr<const StandingProps> props = PropsIn(scene, changes);
  for (const PropBlock& block : props->blocks) {
    if (BlocksWay(block, scene, from, to, margin_m, height_m)) return false;
  }
  return true;
}

NearSolids::NearSolids(const Scene& scene, const SceneChanges& changes, WorldPoint place,
                       double radius_m, double height_m)
    : scene_(scene), height_m_(height_m), props_(PropsIn(scene, changes)) {
  scene.index.ForEachNear(place, radius_m, [&](std::uint32_t asset) {
    if (changes.empty() || changes.Stands(asset)) standing_.push_back(asset);
  });
  for (const FallenTree& tree : changes.fallen) {
    const double reach_m = scene.assets[tree.asset].height_m + radius_m;
    if (std::abs(tree.foot_m.x() - place.x_m) < reach_m &&
        std::abs(tree.foot_m.y() - place.y_m) < reach_m)
      lying_.push_back(&tree);
  }
  for (const PropBlock& block : props_->blocks) {
    const Vector2d off_m = ToVector(block.footprint.centre) - ToVector(place);
    if (off_m.norm() < block.footprint.radius_m() + radius_m) blocks_.push_back(&block);
  }
}

bool NearSolids::IsWayClear(WorldPoint from, WorldPoint to, double margin_m) const {
  for (const std::uint32_t asset : standing_) {
    if (SolidDistance(scene_.assets[asset], from, to) < margin_m) return false;
  }
  for (const FallenTree* const tree : lying_) {
    if (BlocksWay(*tree, scene_, from, to, margin_m, height_m_)) return false;
  }
  for (const PropBlock* const block : blocks_) {
    if (BlocksWay(*block, scene_, from, to, margin_m, height_m_)) return false;
  }
  return true;
}

}  // namespace latticeworld
