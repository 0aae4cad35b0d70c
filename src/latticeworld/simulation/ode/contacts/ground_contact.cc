#include "latticeworld/simulation/ode/contacts/ground_contact.h"

#include <algorithm>
#include <cmath>

namespace latticeworld {
namespace {

// A foot of a perpendicular further than this from the surface belongs to another triangle.
constexpr double kFootTolerance_m = 2e-3;
constexpr double kSamePlaneCosine = 0.9995;

// The plane of the triangle below a point, from one look at the grid; as HeightField has it.
struct Facet {
  double height_m;
  double dz_dx, dz_dy;  // [m/m]

  Eigen::Vector3d Normal() const { return Eigen::Vector3d(-dz_dx, -dz_dy, 1.0).normalized(); }
};

// whole: set where the square of half a side radius_m around the point lies in the one triangle.
Facet FacetAt(const HeightField& ground, double x_m, double y_m, double radius_m, bool* whole) {
  const GridGeometry& geometry = ground.geometry();
  const Grid<float>& height_m = ground.height_m();
  const double last = geometry.rows() - 1;
  // Limits in this order make 0 of what is not a number.
  const double row = std::max(0.0, std::min(geometry.RowOf(y_m), last));
  const double col = std::max(0.0, std::min(geometry.ColOf(x_m), geometry.cols() - 1.0));
  const int r = std::min(static_cast<int>(row), geometry.rows() - 2);
  const int c = std::min(static_cast<int>(col), geometry.cols() - 2);
  const double v = row - r, u = col - c;
  const double north_west = height_m(r, c), south_east = height_m(r + 1, c + 1);
  double dz_du, dz_dv;
  if (u >= v) {
    const double north_east = height_m(r, c + 1);
    dz_du = north_east - north_west;
    dz_dv = south_east - north_east;
  } else {
    const double south_west = height_m(r + 1, c);
    dz_du = south_east - south_west;
    dz_dv = south_west - north_west;
  }
  if (whole != nullptr) {
    const double reach = radius_m / geometry.resolution_m();  // [cells]
    *whole = u >= reach && v >= reach && u + reach <= 1.0 && v + reach <= 1.0 &&
             std::abs(u - v) >= 2.0 * reach;
  }
  return {north_west + u * dz_du + v * dz_dv, dz_du / geometry.resolution_m(),
          -dz_dv / geometry.resolution_m()};
}

// A crest or peak: the nearest sampled point of it, or straight up where the centre is below.
GroundContacts TouchCrest(const Eigen::Vector3d& center_m, double radius_m, const Facet& below,
                          const Eigen::Vector3d& nearest) {
  GroundContacts found;
  const double height_m = below.height_m;
  const Eigen::Vector3d from_ground = center_m - nearest;
  const double distance_m = from_ground.norm();
  if (center_m.z() <= height_m) {
    const Eigen::Vector3d normal = below.Normal();
    found.contact[0] = {{center_m.x(), center_m.y(), height_m},
                        normal,
                        (height_m - center_m.z()) * normal.z() + radius_m};
    found.count = 1;
  } else if (distance_m < radius_m) {
    found.contact[0] = {nearest, from_ground / distance_m, radius_m - distance_m};
    found.count = 1;
  }
  return found;
}

}  // namespace

GroundContacts TouchGround(const HeightField& ground, const Eigen::Vector3d& center_m,
                           double radius_m) {
  GroundContacts found;
  if (center_m.z() - radius_m > ground.max_m()) return found;
  bool whole = false;
  const Facet below = FacetAt(ground, center_m.x(), center_m.y(), radius_m, &whole);
  const double height_m = below.height_m;
  if (radius_m <= 0.0) {
    if (center_m.z() >= height_m) return found;
    const Eigen::Vector3d normal = below.Normal();
    found.contact[0] = {center_m, normal, (height_m - center_m.z()) * normal.z()};
    found.count = 1;
    return found;
  }
  if (whole && center_m.z() > height_m) {
    const Eigen::Vector3d normal = below.Normal();
    const double distance_m = (center_m.z() - height_m) * normal.z();
    if (distance_m >= radius_m) return found;
    found.contact[0] = {center_m - distance_m * normal, normal, radius_m - distance_m};
    found.count = 1;
    return found;
  }

  const double offsets[5][2] = {{0, 0}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}};
  Eigen::Vector3d nearest(center_m.x(), center_m.y(), height_m);
  Facet known[5];
  double known_x_m[5], known_y_m[5];
  int known_count = 0;
  // Facets of one plane, most of all those of the one triangle, need to be looked at once.
  const auto same_plane = [](const Facet& a, const Facet& b, double dx_m, double dy_m) {
    return a.dz_dx == b.dz_dx && a.dz_dy == b.dz_dy &&
           std::abs(a.height_m + a.dz_dx * dx_m + a.dz_dy * dy_m - b.height_m) < 1e-9;
  };
  for (const auto& offset : offsets) {
    const double x_m = center_m.x() + offset[0] * radius_m;
    const double y_m = center_m.y() + offset[1] * radius_m;
    const Facet facet =
        known_count == 0 ? below : FacetAt(ground, x_m, y_m, 0.0, nullptr);  // the first is below
    const Eigen::Vector3d on_ground(x_m, y_m, facet.height_m);
    if ((on_ground - center_m).squaredNorm() < (nearest - center_m).squaredNorm()) {
      nearest = on_ground;
    }
    bool again = false;
    for (int i = 0; i < known_count; ++i) {
      const double dx_m = x_m - known_x_m[i], dy_m = y_m - known_y_m[i];
      again = again || same_plane(known[i], facet, dx_m, dy_m);
    }
    if (again) continue;
    known_x_m[known_count] = x_m;
    known_y_m[known_count] = y_m;
    known[known_count++] = facet;
    const Eigen::Vector3d normal = facet.Normal();
    const double distance_m = (center_m - on_ground).dot(normal);
    if (distance_m >= radius_m) continue;
    // The plane counts only where it is the ground: beyond a crest it runs on through the air.
    const Eigen::Vector3d foot = center_m - distance_m * normal;
    const double at_foot_m = FacetAt(ground, foot.x(), foot.y(), 0.0, nullptr).height_m;
    if (std::abs(at_foot_m - foot.z()) > kFootTolerance_m) continue;
    bool same = false;
    for (int i = 0; i < found.count; ++i) {
      same |= found.contact[static_cast<std::size_t>(i)].normal.dot(normal) > kSamePlaneCosine;
    }
    if (same) continue;
    found.contact[static_cast<std::size_t>(found.count++)] = {foot, normal, radius_m - distance_m};
    if (found.count == 3) return found;
  }
  if (found.count > 0) return found;

  return TouchCrest(center_m, radius_m, below, nearest);
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
