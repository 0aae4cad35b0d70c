#include "latticeworld/simulation/bridge_bodies.h"

#include "latticeworld/terrain/terrain.h"

namespace latticeworld {
namespace {

constexpr double kDensity_kgpm3 = 2400.0;  // of concrete and stone; they stay where they are

BodySpec BodyOf(const BridgePart& part) {
  BodyShape box;
  box.form = ShapeForm::kBox;
  box.half_extents_m = 0.5 * part.size_m();
  const Eigen::Vector3d size_m = part.size_m(), square = size_m.cwiseProduct(size_m);
  BodySpec spec;
  spec.mass_kg = kDensity_kgpm3 * size_m.prod();
  spec.inertia_kgm2 =
      spec.mass_kg / 12.0 *
      Eigen::Vector3d(square.y() + square.z(), square.x() + square.z(), square.x() + square.y());
  spec.shapes.push_back(box);
  spec.anchor = AnchorSpec();
  return spec;
}

}  // namespace

void AddBridgeBodies(const Terrain& terrain, PhysicsWorld* physics) {
  for (const Bridge& bridge : terrain.bridges) {
    for (const BridgePart& part : PartsOf(bridge, terrain.ground)) {
      BodyMotion motion;
      motion.position_m = {part.middle.x_m, part.middle.y_m, part.middle_z_m()};
      motion.orientation = Eigen::AngleAxisd(part.yaw_rad, Eigen::Vector3d::UnitZ());
      physics->Add(BodyOf(part), motion);
    }
  }
}

}  // namespace latticeworld
