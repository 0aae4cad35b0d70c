#include "latticeworld/exporting/simulators/usd_things.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "latticeworld/exporting/simulators/usd_text.h"
#include "latticeworld/scene/asset.h"
#include "latticeworld/scene/props/prop.h"

namespace latticeworld {
namespace {

constexpr float kThinnest_m = 1e-3f;

void Extent(const Eigen::Vector3d& half, UsdText* world) {
  UsdExtent extent;
  extent.Add((-half).cast<float>());
  extent.Add(half.cast<float>());
  world->Value("float3[] extent", extent.Text());
}

}  // namespace

void AddUsdSolid(const Asset& asset, Collision form, const std::string& name, UsdText* world) {
  const double height_m = std::max(kThinnest_m, asset.height_m);
  const Eigen::Vector3d middle_m(asset.x_m, asset.y_m, asset.z_m + 0.5 * height_m);
  const bool box = form == Collision::kBox;
  world->Open(
      {box ? "Cube" : "Cylinder", name, {"PhysicsCollisionAPI", "SemanticsLabelsAPI:class"}});
  world->Value("uniform token purpose", "\"guide\"");
  world->Label(NameOf(asset.kind));
  if (box) {
    world->Number("double size", 2.0);
    Extent(Eigen::Vector3d::Ones(), world);
    world->Place(middle_m, asset.yaw_rad,
                 {std::max(kThinnest_m, asset.half_length_m),
                  std::max(kThinnest_m, asset.half_width_m), 0.5 * height_m});
  } else {
    const double radius_m = std::max(
        kThinnest_m, form == Collision::kTrunk ? asset.trunk_radius_m : asset.half_length_m);
    world->Value("uniform token axis", "\"Z\"");
    world->Number("double height", height_m);
    world->Number("double radius", radius_m);
    Extent({radius_m, radius_m, 0.5 * height_m}, world);
    world->Place(middle_m, asset.yaw_rad);
  }
  world->Close();
}

void AddUsdProp(const Prop& prop, UsdText* world) {
  const bool moves = prop.kind == PropKind::kCrate || prop.kind == PropKind::kLooseStone;
  const bool ball = prop.kind == PropKind::kLooseStone;
  const Eigen::Vector3d& size = prop.size_m;
  // A gate's origin is at its hinge, others' in the middle; a ball rests on its lowest point.
  const Eigen::Vector3d center(prop.kind == PropKind::kGate ? 0.5 * size.x() : 0.0, 0.0,
                               0.5 * size.z());
  const Eigen::Vector3d middle_m =
      Eigen::Vector3d(prop.position.x_m, prop.position.y_m, prop.z_m) +
      Eigen::AngleAxisd(prop.yaw_rad, Eigen::Vector3d::UnitZ()) * center;
  UsdPrim prim = {
      ball ? "Sphere" : "Cube", prop.name, {"PhysicsCollisionAPI", "SemanticsLabelsAPI:class"}};
  if (moves) prim.schemas.insert(prim.schemas.end(), {"PhysicsRigidBodyAPI", "PhysicsMassAPI"});
  world->Open(prim);
  world->Label(NameOf(prop.kind));
  world->Value("color3f[] primvars:displayColor",
               ball ? "[(0.26, 0.23, 0.2)]" : "[(0.32, 0.17, 0.064)]");
  if (moves) world->Number("float physics:mass", prop.mass_kg);
  if (ball) {
    world->Number("double radius", 0.5 * size.x());
    Extent(Eigen::Vector3d::Constant(0.5 * size.x()), world);
    world->Place(middle_m, prop.yaw_rad);
  } else {
    world->Number("double size", 1.0);
    Extent(Eigen::Vector3d::Constant(0.5), world);
    world->Place(middle_m, prop.yaw_rad, size);
  }
  world->Close();
}

}  // namespace latticeworld
