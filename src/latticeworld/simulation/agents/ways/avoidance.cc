#include "latticeworld/simulation/agents/ways/avoidance.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/simulation/agents/minds/nearest_few.h"
#include "latticeworld/simulation/agents/ways/agent_grid.h"

namespace latticeworld {
namespace {

using Eigen::Vector2d;

constexpr double kAround_m = 6.0;
constexpr std::size_t kMostBodies = 10;

double Cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }
Vector2d TurnedLeft(const Vector2d& v) { return {-v.y(), v.x()}; }

// Velocities v with normal . v >= bound are allowed.
struct HalfPlane {
  Vector2d normal;  // unit
  double bound;

  double Breach(const Vector2d& v) const { return bound - normal.dot(v); }
};

// The change of the relative velocity that leaves the velocity obstacle the shortest way, and the
// outward normal there. The obstacle: a disc of distance_m around the offset as seen from the
// origin, both divided by time, and all that lies behind the disc.
Vector2d WayOut(const AvoidedBody& body, const Vector2d& relative_mps, double time_s,
                Vector2d* normal) {
  const Vector2d from_disc = relative_mps - body.offset_m / time_s;
  const double squared = body.offset_m.squaredNorm();
  const double radius = body.distance_m, leg = std::sqrt(std::max(0.0, squared - radius * radius));
  const double along = from_disc.dot(body.offset_m);
  const bool overlaps = squared <= radius * radius;
  // Before the tangents' points of contact the disc's rim is nearest.
  if (overlaps || (along < 0.0 && along * along > radius * radius * from_disc.squaredNorm())) {
    const double length = from_disc.norm();
    *normal = length > 1e-9 ? Vector2d(from_disc / length)
                            : Vector2d(-body.offset_m / std::max(1e-9, std::sqrt(squared)));
    if (length <= 1e-9 && squared <= 1e-18) *normal = Vector2d::UnitX();
    return (radius / time_s - length) * *normal;
  }
  // Beside the disc, the tangent on that side is nearest.
  const double side = Cross(body.offset_m, from_disc) > 0.0 ? 1.0 : -1.0;
  const Vector2d tangent =
      (leg * body.offset_m + side * radius * TurnedLeft(body.offset_m)) / squared;
  *normal = side * TurnedLeft(tangent);
  return relative_mps.dot(tangent) * tangent - relative_mps;
}

// Best point of the rim of planes[which] that the first `which` planes and the disc allow: nearest
// to the goal, or farthest along it when it is a direction. False: there is none.
bool BestOnRim(const std::vector<HalfPlane>& planes, std::size_t which, double top_speed,
               const Vector2d& goal, bool is_direction, Vector2d* best) {
  const HalfPlane& plane = planes[which];
  const Vector2d foot = plane.bound * plane.normal, way = TurnedLeft(plane.normal);
  const double reach_squared = top_speed * top_speed - plane.bound * plane.bound;
  if (reach_squared < 0.0) return false;
  double low = -std::sqrt(reach_squared), high = -low;
  for (std::size_t i = 0; i < which; ++i) {
    const double slope = planes[i].normal.dot(way), breach = planes[i].Breach(foot);
    if (std::abs(slope) < 1e-9) {
      if (breach > 1e-9) return false;
      continue;
    }
    if (slope > 0.0) {
      low = std::max(low, breach / slope);
    } else {
      high = std::min(high, breach / slope);
    }
    if (low > high) return false;
  }
  const double wanted = is_direction ? (goal.dot(way) > 0.0 ? high : low) : goal.dot(way);
  *best = foot + std::clamp(wanted, low, high) * way;
  return true;
}

// Plane by plane (de Berg et al. 2008, Computational Geometry, chapter 4). The number of planes
// that *best keeps to: all of them, or up to the first that left nothing.
std::size_t BestInDisc(const std::vector<HalfPlane>& planes, double top_speed, const Vector2d& goal,
                       bool is_direction, Vector2d* best) {
  if (is_direction) {
    *best = top_speed * goal;
  } else {
    const double length = goal.norm();
    *best = length > top_speed ? Vector2d(goal * (top_speed / length)) : goal;
  }
  for (std::size_t i = 0; i < planes.size(); ++i) {
    if (planes[i].Breach(*best) <= 0.0) continue;
    const Vector2d before = *best;
    if (!BestOnRim(planes, i, top_speed, goal, is_direction, best)) {
      *best = before;
      return i;
    }
  }
  return planes.size();
}

// Finds the point of the disc whose greatest breach is least, from the plane `first` on: no point
// satisfies that one together with those before it.
void LeastBreach(const std::vector<HalfPlane>& planes, std::size_t first, double top_speed,
                 Vector2d* best) {
  double worst = 0.0;
  std::vector<HalfPlane> equals;  // where an earlier plane is breached no more than this one
  for (std::size_t i = first; i < planes.size(); ++i) {
    if (planes[i].Breach(*best) <= worst) continue;
    equals.clear();
    for (std::size_t j = 0; j < i; ++j) {
      const Vector2d difference = planes[j].normal - planes[i].normal;
      const double length = difference.norm();
      if (length < 1e-9) continue;  // parallel: breached alike, or the later one more
      equals.push_back({difference / length, (planes[j].bound - planes[i].bound) / length});
    }
    Vector2d candidate;
    if (BestInDisc(equals, top_speed, planes[i].normal, true, &candidate) == equals.size())
      *best = candidate;
    worst = std::max(worst, planes[i].Breach(*best));
  }
}

}  // namespace

Vector2d AvoidingVelocity(const Vector2d& velocity_mps, const Vector2d& preferred_mps,
                          const std::vector<AvoidedBody>& bodies, const AvoidanceOptions& options) {
  std::vector<HalfPlane> planes;
  planes.reserve(bodies.size());
  for (const AvoidedBody& body : bodies) {
    const bool overlaps = body.offset_m.squaredNorm() <= body.distance_m * body.distance_m;
    Vector2d normal;
    const Vector2d out = WayOut(body, velocity_mps - body.velocity_mps,
                                overlaps ? options.step_s : options.horizon_s, &normal);
    planes.push_back({normal, normal.dot(velocity_mps + body.share * out)});
  }
  Vector2d best;
  const std::size_t kept = BestInDisc(planes, options.top_speed_mps, preferred_mps, false, &best);
  if (kept < planes.size()) LeastBreach(planes, kept, options.top_speed_mps, &best);
  return best;
}

std::vector<AvoidedBody> BodiesToAvoid(const Agent& agent, const Surroundings& world) {
  NearestFew<kMostBodies> nearest;
  const Eigen::Vector3d& here_m = agent.motion.position_m;
  world.near->ForEachNear(agent.place(), kAround_m, [&](const Agent& other) {
    if (other.id == agent.id || other.id == agent.mind.target) return;
    // Above or below each other they are not in the way.
    const double above_m = other.motion.position_m.z() - here_m.z();
    constexpr double kSpare_m = 1.0;
    if (above_m > agent.species->height_m + kSpare_m ||
        -above_m > other.species->height_m + kSpare_m)
      return;
    nearest.Offer(other,
                  (other.motion.position_m - here_m).head<2>().norm() - other.species->radius_m);
  });
  std::vector<AvoidedBody> bodies(nearest.size());
  for (std::size_t i = 0; i < nearest.size(); ++i) {
    const Agent& other = *nearest[i].agent;
    constexpr double kBetween_m = 0.1;  // bodies follow what is wanted of them only so well
    bodies[i].offset_m = (other.motion.position_m - here_m).head<2>();
    bodies[i].distance_m = agent.species->radius_m + other.species->radius_m + kBetween_m;
    bodies[i].velocity_mps = other.motion.linear_velocity_mps.head<2>();
    const bool avoids =
        other.able() && !other.command.has_value() && other.mind.steering.speed_mps > 0.0;
    bodies[i].share = avoids ? 0.5 : 1.0;
  }
  return bodies;
}

}  // namespace latticeworld
