#include "latticeworld/simulation/ode/ground_contact.h"

#include <algorithm>
#include <cmath>

namespace latticeworld {
namespace {

// A foot of a perpendicular further than this from the surface belongs to another triangle.
constexpr double kFootTolerance_m = 2e-3;
constexpr double kSamePlaneCosine = 0.9995;

}  // namespace

GroundContacts TouchGround(const HeightField& ground, const Eigen::Vector3d& center_m,
                           double radius_m) {
  GroundContacts found;
  if (center_m.z() - radius_m > ground.max_m()) return found;
  const WorldPoint below{center_m.x(), center_m.y()};
  const double height_m = ground.HeightAt(below);
  if (radius_m <= 0.0) {
    if (center_m.z() >= height_m) return found;
    const Eigen::Vector3d normal = ground.NormalAt(below);
    found.contact[0] = {center_m, normal, (height_m - center_m.z()) * normal.z()};
    found.count = 1;
    return found;
  }

  const double offsets[5][2] = {{0, 0}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}};
  Eigen::Vector3d nearest(below.x_m, below.y_m, height_m);
  for (const auto& offset : offsets) {
    const WorldPoint at{below.x_m + offset[0] * radius_m, below.y_m + offset[1] * radius_m};
    const Eigen::Vector3d on_ground(at.x_m, at.y_m, ground.HeightAt(at));
    if ((on_ground - center_m).squaredNorm() < (nearest - center_m).squaredNorm()) {
      nearest = on_ground;
    }
    const Eigen::Vector3d normal = ground.NormalAt(at);
    const double distance_m = (center_m - on_ground).dot(normal);
    if (distance_m >= radius_m) continue;
    // The plane counts only where it is the ground: beyond a crest it runs on through the air.
    const Eigen::Vector3d foot = center_m - distance_m * normal;
    if (std::abs(ground.HeightAt({foot.x(), foot.y()}) - foot.z()) > kFootTolerance_m) continue;
    bool known = false;
    for (int i = 0; i < found.count; ++i) {
      known |= found.contact[static_cast<std::size_t>(i)].normal.dot(normal) > kSamePlaneCosine;
    }
    if (known) continue;
    found.contact[static_cast<std::size_t>(found.count++)] = {foot, normal, radius_m - distance_m};
    if (found.count == 3) return found;
  }
  if (found.count > 0) return found;

  // A crest or peak: the nearest sampled point of it, or straight up where the centre is below.
  const Eigen::Vector3d from_ground = center_m - nearest;
  const double distance_m = from_ground.norm();
  if (center_m.z() <= height_m) {
    const Eigen::Vector3d normal = ground.NormalAt(below);
    found.contact[0] = {{below.x_m, below.y_m, height_m},
                        normal,
                        (height_m - center_m.z()) * normal.z() + radius_m};
    found.count = 1;
  } else if (distance_m < radius_m) {
    found.contact[0] = {nearest, from_ground / distance_m, radius_m - distance_m};
    found.count = 1;
  }
  return found;
}

double DepthBelowGround(const HeightField& ground, const Eigen::Vector3d& center_m,
                        double radius_m) {
  const GroundContacts contacts = TouchGround(ground, center_m, radius_m);
  double depth_m = 0.0;
  for (int i = 0; i < contacts.count; ++i) {
    depth_m = std::max(depth_m, contacts.contact[static_cast<std::size_t>(i)].depth_m);
  }
  return depth_m;
}

}  // namespace latticeworld
