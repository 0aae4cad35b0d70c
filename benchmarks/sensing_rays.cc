#include "sensing_rays.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "latticeworld/sensing/lidar/ray_packet.h"

namespace latticeworld {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

// direction(column, row) of every place of a raster, in blocks of 4 x 4.
template <typename Direction>
std::vector<Ray> Blocks(const Eigen::Vector3f& eye_m, int columns, int rows, float to_m,
                        Direction&& direction) {
  std::vector<Ray> rays;
  rays.reserve(static_cast<std::size_t>(columns) * rows);
  for (int row = 0; row < rows; row += 4) {
    for (int column = 0; column < columns; column += 4) {
      for (int i = 0; i < 16; ++i) {
        Ray ray;
        ray.origin_m = eye_m;
        ray.direction = direction(column + i % 4, row + i / 4).normalized();
        ray.from_m = 0.3f;
        ray.to_m = to_m;
        rays.push_back(ray);
      }
    }
  }
  return rays;
}

// Where a ray enters the ellipsoid around `middle`.
float EnterEllipsoid(const Ray& ray, const Eigen::Vector3f& middle, const Eigen::Vector3f& radius) {
  const Eigen::Vector3f o = (ray.origin_m - middle).cwiseQuotient(radius);
  const Eigen::Vector3f d = ray.direction.cwiseQuotient(radius);
  const float a = d.squaredNorm(), b = o.dot(d), c = o.squaredNorm() - 1.0f;
  const float discriminant = b * b - a * c;
  if (discriminant < 0.0f) return kInfinity;
  const float t = (-b - std::sqrt(discriminant)) / a;
  return t >= ray.from_m ? t : kInfinity;
}

float EnterCylinder(const Ray& ray, const Asset& tree) {
  const Eigen::Vector2f o = ray.origin_m.head<2>() - Eigen::Vector2f(tree.x_m, tree.y_m);
  const Eigen::Vector2f d = ray.direction.head<2>();
  const float a = d.squaredNorm(), b = o.dot(d);
  const float c = o.squaredNorm() - tree.trunk_radius_m * tree.trunk_radius_m;
  const float discriminant = b * b - a * c;
  if (discriminant < 0.0f || a == 0.0f) return kInfinity;
  const float t = (-b - std::sqrt(discriminant)) / a;
  const float z_m = ray.origin_m.z() + t * ray.direction.z() - tree.z_m;
  return t >= ray.from_m && z_m >= 0.0f && z_m <= tree.height_m ? t : kInfinity;
}

}  // namespace

std::vector<Ray> LidarRays(const Eigen::Vector3f& eye_m) {
  constexpr int kColumns = 1024, kRings = 64;
  const auto pi = static_cast<float>(M_PI);
  return Blocks(eye_m, kColumns, kRings, 120.0f, [&](int column, int ring) {
    const float azimuth = 2.0f * pi * static_cast<float>(column) / kColumns;
    const float elevation =
        (-16.6f + 33.2f * static_cast<float>(ring) / (kRings - 1)) * pi / 180.0f;
    return Eigen::Vector3f(std::cos(elevation) * std::cos(azimuth),
                           std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
  });
}

std::vector<Ray> DepthRays(const Eigen::Vector3f& eye_m) {
  return Blocks(eye_m, 640, 480, 100.0f, [](int u, int v) {
    return Eigen::Vector3f(320.0f, 319.5f - static_cast<float>(u), 239.5f - static_cast<float>(v));
  });
}

std::vector<RTCRayHit16> PacketsOf(const std::vector<Ray>& rays) {
  std::vector<RTCRayHit16> packets;
  RayPacket packet;
  for (std::size_t first = 0; first + 16 <= rays.size(); first += 16) {
    packet.Load(&rays[first], 16, ~0u);
    packets.push_back(packet.rays);
  }
  return packets;
}

RayMarch::RayMarch(const Scene& scene, const Eigen::Vector3f& eye_m, float range_m)
    : scene_(scene) {
  for (const Asset& asset : scene.assets)
    if (std::hypot(asset.x_m - eye_m.x(), asset.y_m - eye_m.y()) <= range_m)
      near_.push_back(&asset);
}

float RayMarch::Distance(const Ray& ray) const {
  float nearest_m = kInfinity;
  for (const Asset* tree : near_) {
    const Eigen::Vector3f crown_m(tree->x_m, tree->y_m, tree->z_m + 0.65f * tree->height_m);
    const Eigen::Vector3f radius_m(tree->half_length_m, tree->half_length_m,
                                   0.35f * tree->height_m);
    nearest_m = std::min(nearest_m, EnterEllipsoid(ray, crown_m, radius_m));
    nearest_m = std::min(nearest_m, EnterCylinder(ray, *tree));
  }
  const HeightField& ground = scene_.terrain->ground;
  const auto step_m = static_cast<float>(0.5 * ground.geometry().resolution_m());
  for (float t_m = ray.from_m; t_m < std::min(nearest_m, ray.to_m); t_m += step_m) {
    const Eigen::Vector3f at = ray.origin_m + t_m * ray.direction;
    if (at.z() < ground.HeightAt({at.x(), at.y()})) return t_m;
  }
  return nearest_m <= ray.to_m ? nearest_m : kInfinity;
}

}  // namespace latticeworld
