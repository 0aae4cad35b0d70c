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
  // In this order what is not a number becomes 0.
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
  Facet facet;
  facet.height_m = north_west + u * dz_du + v * dz_dv;
  facet.dz_dx = dz_du / geometry.resolution_m();
  facet.dz_dy = -dz_dv / geometry.resolution_m();
  return facet;
}

struct Ball {
  const Eigen::Vector3d& center_m;
  double radius_m;
};

// The next one of a ball's contacts, to be filled in.
GroundContact& NextOf(GroundContacts* found) {
  return found->contact[static_cast<std::size_t>(found->count++)];
}

void TouchWithPoint(const Eigen::Vector3d& point_m, const Facet& below, GroundContacts* found) {
  if (point_m.z() >= below.height_m) return;
  GroundContact& contact = NextOf(found);
  contact.position_m = point_m;
  contact.normal = below.Normal();
  contact.depth_m = (below.height_m - point_m.z()) * contact.normal.z();
}

// Of a ball whose centre is above the facet, and that can touch no other one.
void TouchFacet(const Ball& ball, const Facet& below, GroundContacts* found) {
  const Eigen::Vector3d normal = below.Normal();
  const double distance_m = (ball.center_m.z() - below.height_m) * normal.z();
  if (distance_m >= ball.radius_m) return;
  GroundContact& contact = NextOf(found);
  contact.position_m = ball.center_m - distance_m * normal;
  contact.normal = normal;
  contact.depth_m = ball.radius_m - distance_m;
}

constexpr int kSamples = 5;  // of the ground around a ball

// Facets of one plane, most of all those of the one triangle, need to be looked at once.
class KnownPlanes {
 public:
  // Takes in the plane of a facet at a place; false: it is known.
  bool Add(const Facet& facet, double x_m, double y_m) {
    for (int i = 0; i < count_; ++i) {
      if (IsSame(facets_[i], facet, x_m - x_m_[i], y_m - y_m_[i])) return false;
    }
    x_m_[count_] = x_m;
    y_m_[count_] = y_m;
    facets_[count_++] = facet;
    return true;
  }

 private:
  static bool IsSame(const Facet& a, const Facet& b, double dx_m, double dy_m) {
    return a.dz_dx == b.dz_dx && a.dz_dy == b.dz_dy &&
           std::abs(a.height_m + a.dz_dx * dx_m + a.dz_dy * dy_m - b.height_m) < 1e-9;
  }

  Facet facets_[kSamples];
  double x_m_[kSamples], y_m_[kSamples];
  int count_ = 0;
};

// Adds a ball's contact with the plane of a facet, where there is one in no direction that is
// known. on_ground: a point of the facet.
void TouchPlane(const HeightField& ground, const Ball& ball, const Facet& facet,
                const Eigen::Vector3d& on_ground, GroundContacts* found) {
  const Eigen::Vector3d normal = facet.Normal();
  const double distance_m = (ball.center_m - on_ground).dot(normal);
  if (distance_m >= ball.radius_m) return;
  // The plane counts only where it is the ground: beyond a crest it runs on through the air.
  const Eigen::Vector3d foot = ball.center_m - distance_m * normal;
  const double at_foot_m = FacetAt(ground, foot.x(), foot.y(), 0.0, nullptr).height_m;
  if (std::abs(at_foot_m - foot.z()) > kFootTolerance_m) return;
  bool same = false;
  for (int i = 0; i < found->count; ++i) {
    same |= found->contact[static_cast<std::size_t>(i)].normal.dot(normal) > kSamePlaneCosine;
  }
  if (same) return;
  GroundContact& contact = NextOf(found);
  contact.position_m = foot;
  contact.normal = normal;
  contact.depth_m = ball.radius_m - distance_m;
}

// Adds a ball's contact with a crest or peak: the nearest sampled point of it, or straight up where
// the centre is below.
void TouchCrest(const Ball& ball, const Facet& below, const Eigen::Vector3d& nearest,
                GroundContacts* found) {
  const Eigen::Vector3d& center_m = ball.center_m;
  const Eigen::Vector3d from_ground = center_m - nearest;
  const double distance_m = from_ground.norm();
  if (center_m.z() <= below.height_m) {
    GroundContact& contact = NextOf(found);
    contact.position_m = Eigen::Vector3d(center_m.x(), center_m.y(), below.height_m);
    contact.normal = below.Normal();
    contact.depth_m = (below.height_m - center_m.z()) * contact.normal.z() + ball.radius_m;
  } else if (distance_m < ball.radius_m) {
    GroundContact& contact = NextOf(found);
    contact.position_m = nearest;
    contact.normal = from_ground / distance_m;
    contact.depth_m = ball.radius_m - distance_m;
  }
}

}  // namespace

GroundContacts TouchGround(const HeightField& ground, const Eigen::Vector3d& center_m,
                           double radius_m) {
  GroundContacts found;
  if (center_m.z() - radius_m > ground.max_m()) return found;
  bool whole = false;
  const Facet below = FacetAt(ground, center_m.x(), center_m.y(), radius_m, &whole);
  if (radius_m <= 0.0) {
    TouchWithPoint(center_m, below, &found);
    return found;
  }
  const Ball ball{center_m, radius_m};
  if (whole && center_m.z() > below.height_m) {
    TouchFacet(ball, below, &found);
    return found;
  }

  constexpr double kOffsets[kSamples][2] = {{0, 0}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}};
  Eigen::Vector3d nearest(center_m.x(), center_m.y(), below.height_m);
  KnownPlanes known;
  for (int i = 0; i < kSamples; ++i) {
    const double x_m = center_m.x() + kOffsets[i][0] * radius_m;
    const double y_m = center_m.y() + kOffsets[i][1] * radius_m;
    const Facet facet = i == 0 ? below : FacetAt(ground, x_m, y_m, 0.0, nullptr);
    const Eigen::Vector3d on_ground(x_m, y_m, facet.height_m);
    if ((on_ground - center_m).squaredNorm() < (nearest - center_m).squaredNorm()) {
      nearest = on_ground;
    }
    if (!known.Add(facet, x_m, y_m)) continue;
    TouchPlane(ground, ball, facet, on_ground, &found);
    if (found.count == 3) return found;
  }
  if (found.count == 0) TouchCrest(ball, below, nearest, &found);
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
