#include "latticeworld/simulation/water_forces.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "latticeworld/scene/weather/water_depth.h"
#include "latticeworld/terrain/terrain.h"

namespace latticeworld {
namespace {

constexpr double kWaterDensity_kgpm3 = 1000.0;
constexpr int kPoints = 8;  // of each shape
// Share of its speed that a body loses in a second to waves that it makes when half of it is under
// water, and to the water around it when all of it is: what floats comes to rest.
constexpr double kHeaveLoss_hz = 1.2;
constexpr double kWaveLoss_hz = 0.15;
constexpr double kViscousLoss_hz = 0.05;
// However light a body is, drag takes no more of its speed in a second: stable at any legal step.
constexpr double kMostLoss_hz = 10.0;
// A body rests as long as water lifts it by no more than this share of its weight beyond it.
constexpr double kWaking = 0.02;
constexpr double kAground_m = 0.05;  // a body this near to the ground lies on it
constexpr double kSmall_m = 1.0;     // bodies of this reach meet one water level

double VolumeOf(const BodyShape& shape) {
  const double r = shape.radius_m;
  switch (shape.form) {
    case ShapeForm::kBall:
      return 4.0 / 3.0 * M_PI * r * r * r;
    case ShapeForm::kCapsule:
      return M_PI * r * r * (4.0 / 3.0 * r + 2.0 * shape.half_length_m);
    case ShapeForm::kBox:
      return 8.0 * shape.half_extents_m.prod();
  }
  return 0.0;
}

// Share of a height that is below the surface.
double ShareUnder(double surface_m, double middle_m, double half_height_m) {
  if (half_height_m <= 0.0) return surface_m > middle_m ? 1.0 : 0.0;
  return std::clamp(0.5 + 0.5 * (surface_m - middle_m) / half_height_m, 0.0, 1.0);
}

class Water {
 public:
  Water(const Terrain& terrain, const Atmosphere& atmosphere, const BodyMotion& motion,
        bool one_level)
      : terrain_(terrain), atmosphere_(atmosphere), one_level_(one_level) {
    if (one_level_) level_m_ = LevelAt({motion.position_m.x(), motion.position_m.y()});
  }
  // Returns the height of the water's surface [m]; minus infinity: it is dry there.
  double SurfaceAt(const Eigen::Vector3d& point) const {
    return one_level_ ? level_m_ : LevelAt({point.x(), point.y()});
  }

 private:
  double LevelAt(WorldPoint place) const {
    const double depth_m = WaterDepthAt(terrain_, atmosphere_, place);
    return depth_m > 0.0 ? terrain_.ground.HeightAt(place) + depth_m
                         : -std::numeric_limits<double>::infinity();
  }
  const Terrain& terrain_;
  const Atmosphere& atmosphere_;
  const bool one_level_;
  double level_m_ = 0.0;
};

// What acts on a body, added up.
struct Acting {
  Eigen::Vector3d force_n = Eigen::Vector3d::Zero();
  Eigen::Vector3d torque_nm = Eigen::Vector3d::Zero();  // about base_link
  double lift_n = 0.0;
  double under = 0.0;  // share of the body's volume
};

class Hull {
 public:
  Hull(const Buoyancy& buoyancy, const BodySpec& spec, const BodyMotion& motion, const Water& water)
      : buoyancy_(buoyancy), mass_kg_(spec.total_mass_kg()), motion_(motion), water_(water) {
    double volume_m3 = 0.0;
    for (const BodyShape& shape : spec.shapes) volume_m3 += VolumeOf(shape);
    if (volume_m3 <= 0.0) return;
    for (const BodyShape& shape : spec.shapes) AddShape(shape, VolumeOf(shape) / volume_m3);
  }
  const Acting& acting() const { return acting_; }

 private:
  // share: of the body's volume.
  void AddShape(const BodyShape& shape, double share) {
    const Eigen::Matrix3d map_from_shape =
        (motion_.orientation * shape.orientation).toRotationMatrix();
    const Eigen::Vector3d middle = motion_.orientation * shape.center_m;  // from base_link, map
    switch (shape.form) {
      case ShapeForm::kBall:
        AddBall(middle, shape.radius_m, share);
        break;
      case ShapeForm::kCapsule:
        AddCapsule(shape, middle, map_from_shape.col(2), share);
        break;
      case ShapeForm::kBox:
        AddBox(shape.half_extents_m, middle, map_from_shape, share);
        break;
    }
  }

  void AddBall(const Eigen::Vector3d& arm, double radius_m, double share) {
    const Eigen::Vector3d point = motion_.position_m + arm;
    const double h = ShareUnder(water_.SurfaceAt(point), point.z(), radius_m);
    AddPart(arm, h * h * (3.0 - 2.0 * h), share);  // volume of the ball's cap
  }

  // Slices along the axis.
  void AddCapsule(const BodyShape& shape, const Eigen::Vector3d& middle,
                  const Eigen::Vector3d& axis, double share) {
    const double half_m = shape.half_length_m + 2.0 / 3.0 * shape.radius_m;  // same volume
    const double across = std::sqrt(std::max(0.0, 1.0 - axis.z() * axis.z()));
    const double half_height_m = std::abs(axis.z()) * half_m / kPoints + across * shape.radius_m;
    for (int i = 0; i < kPoints; ++i) {
      const Eigen::Vector3d arm = middle + axis * (half_m * ((2.0 * i + 1.0) / kPoints - 1.0));
      const Eigen::Vector3d point = motion_.position_m + arm;
      AddPart(arm, ShareUnder(water_.SurfaceAt(point), point.z(), half_height_m), share / kPoints);
    }
  }

  // Octants. An octant lifts in the middle of what of it is under water; arms across the waterline
  // are those of the second moment of a rectangle (2/3 of its half side where two points stand for
  // it, whose heights are taken at 1/2), so that small tilts right themselves as they do.
  void AddBox(const Eigen::Vector3d& half_m, const Eigen::Vector3d& middle,
              const Eigen::Matrix3d& map_from_shape, double share) {
    const Eigen::Vector3d up = map_from_shape.row(2);
    const double half_height_m = 0.5 * up.cwiseAbs().dot(half_m);
    for (int i = 0; i < kPoints; ++i) {
      const Eigen::Vector3d sign((i & 1) != 0 ? 0.5 : -0.5, (i & 2) != 0 ? 0.5 : -0.5,
                                 (i & 4) != 0 ? 0.5 : -0.5);
      const Eigen::Vector3d octant = sign.cwiseProduct(half_m);
      const Eigen::Vector3d point = motion_.position_m + middle + map_from_shape * octant;
      const double under = ShareUnder(water_.SurfaceAt(point), point.z(), half_height_m);
      Eigen::Vector3d arm = octant;
      for (int axis = 0; axis < 3; ++axis) {
        const double upright = up[axis] * up[axis];
        arm[axis] *= 1.0 + (1.0 - upright) / 3.0;
        arm[axis] -= up[axis] * std::abs(up[axis]) * 0.5 * half_m[axis] * (1.0 - under);
      }
      AddPart(middle + map_from_shape * arm, under, share / kPoints);
    }
  }

  // arm: from base_link, map frame. under: share of the part under water. share: of the body.
  void AddPart(const Eigen::Vector3d& arm, double under, double share) {
    if (under <= 0.0) return;
    const double lift_n = kWaterDensity_kgpm3 * kGravity_mps2 * buoyancy_.volume_m3 * share * under;
    const Eigen::Vector3d velocity =
        motion_.linear_velocity_mps + motion_.angular_velocity_radps.cross(arm);
    const double waves = 4.0 * under * (1.0 - under);
    const double drag_hz =
        0.5 * kWaterDensity_kgpm3 * buoyancy_.drag_area_m2 * under * velocity.norm() / mass_kg_ +
        kViscousLoss_hz * under + kWaveLoss_hz * waves;
    const double heave_hz = drag_hz + kHeaveLoss_hz * waves;
    const double part_kg = mass_kg_ * share;
    Eigen::Vector3d force = -part_kg * std::min(drag_hz, kMostLoss_hz) * velocity;
    force.z() = lift_n - part_kg * std::min(heave_hz, kMostLoss_hz) * velocity.z();
    acting_.force_n += force;
    acting_.torque_nm += arm.cross(force);
    acting_.lift_n += lift_n;
    acting_.under += share * under;
  }

  const Buoyancy& buoyancy_;
  const double mass_kg_;
  const BodyMotion& motion_;
  const Water& water_;
  Acting acting_;
};

bool IsAground(const HeightField& ground, const PhysicsWorld& physics, BodyId body) {
  const BodySpec& spec = physics.SpecOf(body);
  const auto touches = [&ground](const BodyMotion& frame, const Eigen::Vector3d& in_frame_m,
                                 double radius_m) {
    const Eigen::Vector3d point = frame.position_m + frame.orientation * in_frame_m;
    return point.z() - radius_m < ground.HeightAt({point.x(), point.y()}) + kAground_m;
  };
  const BodyMotion motion = physics.MotionOf(body);
  for (const GroundSample& sample : spec.ground_samples) {
    if (touches(motion, sample.offset_m, sample.radius_m)) return true;
  }
  for (const WheelSpec& wheel : spec.wheels) {
    if (touches(motion, wheel.center_m, wheel.radius_m)) return true;
  }
  for (std::size_t i = 0; i < spec.links.size(); ++i) {
    const LinkSpec& link = spec.links[i];
    if (link.ground_samples.empty()) continue;
    const BodyMotion frame = physics.LinkMotionOf(body, i);
    for (const GroundSample& foot : link.ground_samples) {
      if (touches(frame, foot.offset_m - link.anchor_m, foot.radius_m)) return true;
    }
  }
  return false;
}

}  // namespace

bool ActOfWater(const Terrain& terrain, const Atmosphere& atmosphere, const Buoyancy& buoyancy,
                BodyId body, PhysicsWorld* physics) {
  const BodyMotion motion = physics->MotionOf(body);
  const BodySpec& spec = physics->SpecOf(body);
  const bool is_small = spec.reach_m() < kSmall_m;
  const WorldPoint place = {motion.position_m.x(), motion.position_m.y()};
  if (is_small && terrain.WaterDepthAt(place) <= 0.0) return false;
  const Water water(terrain, atmosphere, motion, is_small);
  const Acting acting = Hull(buoyancy, spec, motion, water).acting();
  if (acting.under <= 0.0) return false;
  if (physics->IsResting(body)) {
    const double weight_n = spec.total_mass_kg() * kGravity_mps2;
    const bool lifts = acting.lift_n > (1.0 + kWaking) * weight_n;
    const bool sinks =
        acting.lift_n < (1.0 - kWaking) * weight_n && !IsAground(terrain.ground, *physics, body);
    if (!lifts && !sinks) return true;
  }
  // The same as all of the parts' forces, at base_link and about it.
  physics->AddForceAt(body, acting.force_n, motion.position_m);
  physics->AddTorque(body, acting.torque_nm);
  return true;
}

}  // namespace latticeworld
