#include "latticeworld/sensing/camera/camera_model.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

namespace latticeworld {
namespace {

// How far from the axis the search for a fold goes: the tangent of 84 degrees.
constexpr double kSearchedRadius = 10.0;
constexpr int kSearchSteps = 400;
constexpr int kMaxIterations = 50;
// The tolerance is in normalised coordinates: a ten-thousandth of a pixel at any legal focal length
// is more.
constexpr double kTolerance = 1e-12;

bool IsDistorted(const CameraModel& model) {
  return std::any_of(model.distortion.begin(), model.distortion.end(),
                     [](double k) { return k != 0.0; });
}

// Brown's model on the plane z = 1.
Eigen::Vector2d Distort(const CameraModel& model, const Eigen::Vector2d& p) {
  const auto& [k1, k2, p1, p2, k3] = model.distortion;
  const double r2 = p.squaredNorm();
  const double radial = 1.0 + r2 * (k1 + r2 * (k2 + r2 * k3));
  return {p.x() * radial + 2.0 * p1 * p.x() * p.y() + p2 * (r2 + 2.0 * p.x() * p.x()),
          p.y() * radial + p1 * (r2 + 2.0 * p.y() * p.y()) + 2.0 * p2 * p.x() * p.y()};
}

Eigen::Matrix2d DistortionJacobian(const CameraModel& model, const Eigen::Vector2d& p) {
  const auto& [k1, k2, p1, p2, k3] = model.distortion;
  const double x = p.x(), y = p.y(), r2 = p.squaredNorm();
  const double radial = 1.0 + r2 * (k1 + r2 * (k2 + r2 * k3));
  const double slope = 2.0 * (k1 + r2 * (2.0 * k2 + r2 * 3.0 * k3));  // d radial / d r2, times 2
  Eigen::Matrix2d jacobian;
  jacobian << radial + slope * x * x + 2.0 * p1 * y + 6.0 * p2 * x,
      slope * x * y + 2.0 * p1 * x + 2.0 * p2 * y,  //
      slope * x * y + 2.0 * p1 * x + 2.0 * p2 * y,
      radial + slope * y * y + 6.0 * p1 * y + 2.0 * p2 * x;
  return jacobian;
}

}  // namespace

double MonotonousRadius(const CameraModel& model) {
  if (!IsDistorted(model)) return std::numeric_limits<double>::infinity();
  const auto slope_at = [&](double r) {
    const auto& [k1, k2, p1, p2, k3] = model.distortion;
    const double r2 = r * r;
    // Tangential terms turn with the angle; at worst they take 6 r (|p1| + |p2|).
    return 1.0 + r2 * (3.0 * k1 + r2 * (5.0 * k2 + r2 * 7.0 * k3)) -
           6.0 * r * (std::abs(p1) + std::abs(p2));
  };
  double low = 0.0, high = 0.0;
  for (int i = 1; i <= kSearchSteps; ++i) {
    high = kSearchedRadius * i / kSearchSteps;
    if (slope_at(high) <= 0.0) break;
    low = high;
  }
  if (low == high) return kSearchedRadius;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (low + high);
    (slope_at(middle) > 0.0 ? low : high) = middle;
  }
  return low;
}

std::optional<Eigen::Vector2d> Undistort(const CameraModel& model,
                                         const Eigen::Vector2d& distorted) {
  if (!IsDistorted(model)) return distorted;
  const double limit = MonotonousRadius(model);
  Eigen::Vector2d p = distorted;
  if (p.norm() > 0.9 * limit) p *= 0.9 * limit / p.norm();
  for (int i = 0; i < kMaxIterations; ++i) {
    const Eigen::Vector2d error = Distort(model, p) - distorted;
    if (error.norm() < kTolerance * std::max(1.0, distorted.norm())) return p;
    const Eigen::Matrix2d jacobian = DistortionJacobian(model, p);
    if (jacobian.determinant() <= 0.0) return std::nullopt;
    Eigen::Vector2d next = p - jacobian.inverse() * error;
    // Newton's step must not jump over the fold.
    if (next.norm() > limit) next *= limit / next.norm();
    if ((next - p).norm() < 1e-15) break;
    p = next;
  }
  const bool found = (Distort(model, p) - distorted).norm() < 1e-9;
  return found ? std::optional<Eigen::Vector2d>(p) : std::nullopt;
}

Eigen::Vector3d DirectionOf(const CameraModel& model, double u_px, double v_px) {
  const Eigen::Vector2d distorted((u_px - model.cx_px) / model.fx_px,
                                  (v_px - model.cy_px) / model.fy_px);
  Eigen::Vector2d p = distorted;
  if (const auto found = Undistort(model, distorted)) {
    p = *found;
  } else {
    // Nothing falls there: the rim of what does, on the same side.
    const double limit = MonotonousRadius(model);
    if (p.norm() > limit) p *= limit / p.norm();
  }
  return Eigen::Vector3d(p.x(), p.y(), 1.0).normalized();
}

std::optional<Eigen::Vector2d> Project(const CameraModel& model, const Eigen::Vector3d& point_m) {
  if (!(point_m.z() > 0.0)) return std::nullopt;
  const Eigen::Vector2d p(point_m.x() / point_m.z(), point_m.y() / point_m.z());
  if (!p.allFinite()) return std::nullopt;
  if (!IsDistorted(model)) {
    return Eigen::Vector2d(model.fx_px * p.x() + model.cx_px, model.fy_px * p.y() + model.cy_px);
  }
  if (p.norm() > MonotonousRadius(model)) return std::nullopt;
  const Eigen::Vector2d distorted = Distort(model, p);
  return Eigen::Vector2d(model.fx_px * distorted.x() + model.cx_px,
                         model.fy_px * distorted.y() + model.cy_px);
}

}  // namespace latticeworld
