#include "latticeworld/simulation/ode/prism.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace latticeworld {
namespace {

// A body whose base is at most this far below the top of a thing stands on it.
constexpr double kTopTolerance_m = 0.1;

struct FlatContact {
  Eigen::Vector2d position_m;
  Eigen::Vector2d normal;  // into a
  double depth_m;
};
struct FlatContacts {
  std::array<FlatContact, 8> contact;
  int count = 0;
  void Add(const FlatContact& one) { contact[static_cast<std::size_t>(count++)] = one; }
};

Eigen::Vector2d LeftOf(const Eigen::Vector2d& v) { return {-v.y(), v.x()}; }

Eigen::Vector2d ToLocal(const Prism& box, const Eigen::Vector2d& point) {
  const Eigen::Vector2d d = point - box.center_m;
  return {d.dot(box.forward), d.dot(LeftOf(box.forward))};
}
Eigen::Vector2d FromLocalVector(const Prism& box, const Eigen::Vector2d& v) {
  return v.x() * box.forward + v.y() * LeftOf(box.forward);
}

void RoundRound(const Prism& a, const Prism& b, FlatContacts* out) {
  const Eigen::Vector2d d = a.center_m - b.center_m;
  const double distance = d.norm();
  const double depth = a.radius_m + b.radius_m - distance;
  if (depth <= 0.0) return;
  const Eigen::Vector2d normal = distance > 1e-9 ? Eigen::Vector2d(d / distance) : a.forward;
  out->Add({b.center_m + normal * b.radius_m, normal, depth});
}

// a round, b a box.
void RoundBox(const Prism& a, const Prism& b, FlatContacts* out) {
  const Eigen::Vector2d p = ToLocal(b, a.center_m);
  const Eigen::Vector2d half(b.half_length_m, b.half_width_m);
  const Eigen::Vector2d nearest = p.cwiseMax(-half).cwiseMin(half);
  Eigen::Vector2d d = p - nearest;
  const double distance = d.norm();
  if (distance > 1e-9) {
    const double depth = a.radius_m - distance;
    if (depth <= 0.0) return;
    const Eigen::Vector2d normal = FromLocalVector(b, d / distance);
    out->Add({a.center_m - normal * distance, normal, depth});
    return;
  }
  // The centre is inside: out through the nearest side.
  const Eigen::Vector2d gap = half - p.cwiseAbs();
  const int axis = gap.x() < gap.y() ? 0 : 1;
  d.setZero();
  d[axis] = p[axis] < 0.0 ? -1.0 : 1.0;
  const Eigen::Vector2d normal = FromLocalVector(b, d);
  out->Add({a.center_m, normal, gap[axis] + a.radius_m});
}

// Half the width of the box along a unit axis.
double Support(const Prism& box, const Eigen::Vector2d& axis) {
  return box.half_length_m * std::abs(box.forward.dot(axis)) +
         box.half_width_m * std::abs(LeftOf(box.forward).dot(axis));
}

// Corners of `corners` that lie in `box`, each with its depth along the normal into a.
void CornersInside(const Prism& corners, const Prism& box, const Eigen::Vector2d& normal,
                   double total_depth, bool corners_are_a, FlatContacts* out) {
  const Prism& a = corners_are_a ? corners : box;
  const Prism& b = corners_are_a ? box : corners;
  const double face_of_b = b.center_m.dot(normal) + Support(b, normal);
  const double face_of_a = a.center_m.dot(normal) - Support(a, normal);
  for (int i = 0; i < 4; ++i) {
    const Eigen::Vector2d local((i & 1) != 0 ? corners.half_length_m : -corners.half_length_m,
                                (i & 2) != 0 ? corners.half_width_m : -corners.half_width_m);
    const Eigen::Vector2d corner = corners.center_m + FromLocalVector(corners, local);
    const Eigen::Vector2d in_box = ToLocal(box, corner);
    if (std::abs(in_box.x()) > box.half_length_m || std::abs(in_box.y()) > box.half_width_m) {
      continue;
    }
    const double along = corner.dot(normal);
    const double depth = corners_are_a ? face_of_b - along : along - face_of_a;
    if (depth > 0.0) out->Add({corner, normal, std::min(depth, total_depth)});
  }
}

// Separating axes (Gottschalk et al. 1996, in the plane), then the corners of each in the other.
void BoxBox(const Prism& a, const Prism& b, FlatContacts* out) {
  const Eigen::Vector2d axes[4] = {a.forward, LeftOf(a.forward), b.forward, LeftOf(b.forward)};
  double depth = std::numeric_limits<double>::infinity();
  Eigen::Vector2d normal = a.forward;
  for (const Eigen::Vector2d& axis : axes) {
    const double offset = (a.center_m - b.center_m).dot(axis);
    const double overlap = Support(a, axis) + Support(b, axis) - std::abs(offset);
    if (overlap <= 0.0) return;
    if (overlap < depth) {
      depth = overlap;
      normal = offset < 0.0 ? Eigen::Vector2d(-axis) : axis;
    }
  }
  CornersInside(a, b, normal, depth, true, out);
  CornersInside(b, a, normal, depth, false, out);
  if (out->count == 0) out->Add({0.5 * (a.center_m + b.center_m), normal, depth});
  // Where the boxes cross, no corner inside is as deep as the boxes are.
  const auto end = out->contact.begin() + out->count;
  std::max_element(out->contact.begin(), end, [](const FlatContact& one, const FlatContact& two) {
    return one.depth_m < two.depth_m;
  })->depth_m = depth;
}

}  // namespace

Prism Prism::Round(Eigen::Vector2d center_m, double radius_m, double low_m, double high_m) {
  Prism prism;
  prism.center_m = center_m;
  prism.radius_m = radius_m;
  prism.low_m = low_m;
  prism.high_m = high_m;
  return prism;
}

Prism Prism::Box(Eigen::Vector2d center_m, double yaw_rad, double half_length_m,
                 double half_width_m, double low_m, double high_m) {
  Prism prism = Round(center_m, std::hypot(half_length_m, half_width_m), low_m, high_m);
  prism.forward = {std::cos(yaw_rad), std::sin(yaw_rad)};
  prism.half_length_m = half_length_m;
  prism.half_width_m = half_width_m;
  return prism;
}

PrismContacts Overlap(const Prism& a, const Prism& b) {
  PrismContacts contacts;
  const double low = std::max(a.low_m, b.low_m);
  const double high = std::min(a.high_m, b.high_m);
  const double reach = a.radius_m + b.radius_m;
  if (low >= high || (a.center_m - b.center_m).squaredNorm() >= reach * reach) return contacts;
  FlatContacts flat;
  if (a.round()) {
    b.round() ? RoundRound(a, b, &flat) : RoundBox(a, b, &flat);
  } else if (b.round()) {
    RoundBox(b, a, &flat);
    for (int i = 0; i < flat.count; ++i) {
      FlatContact& one = flat.contact[static_cast<std::size_t>(i)];
      one.normal = -one.normal;
    }
  } else {
    BoxBox(a, b, &flat);
  }
  if (flat.count == 0) return contacts;

  const double below_top = b.high_m - a.low_m;
  const double below_top_of_a = a.high_m - b.low_m;
  const double sideways = flat.contact[0].depth_m;
  const auto stack = [&](double sign, double depth) {
    contacts.contact[0] = {Eigen::Vector3d(a.center_m.x(), a.center_m.y(), low),
                           Eigen::Vector3d(0.0, 0.0, sign), depth};
    contacts.count = 1;
  };
  if (below_top < std::min(kTopTolerance_m, sideways)) {
    stack(1.0, below_top);
  } else if (below_top_of_a < std::min(kTopTolerance_m, sideways)) {
    stack(-1.0, below_top_of_a);
  } else {
    const double middle = 0.5 * (low + high);
    for (int i = 0; i < flat.count; ++i) {
      const FlatContact& one = flat.contact[static_cast<std::size_t>(i)];
      contacts.contact[static_cast<std::size_t>(i)] = {
          Eigen::Vector3d(one.position_m.x(), one.position_m.y(), middle),
          Eigen::Vector3d(one.normal.x(), one.normal.y(), 0.0), one.depth_m};
    }
    contacts.count = flat.count;
  }
  return contacts;
}

}  // namespace latticeworld
