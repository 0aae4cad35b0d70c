#include "latticeworld/exporting/simulators/sdf_things.h"

#include <algorithm>

#include "latticeworld/exporting/bridge_colors.h"
#include "latticeworld/exporting/simulators/sdf_text.h"
#include "latticeworld/scene/asset.h"
#include "latticeworld/scene/props/prop.h"
#include "latticeworld/terrain/ways/bridge.h"

namespace latticeworld {
namespace {

constexpr float kThinnest_m = 1e-3f;

}  // namespace

void AddSdfCollision(const Asset& asset, Collision form, const Eigen::Vector3d& base_m,
                     const std::string& name, SdfText* world) {
  const double height_m = std::max(kThinnest_m, asset.height_m);
  world->Open("collision", name);
  world->Pose(base_m + Eigen::Vector3d(0.0, 0.0, 0.5 * height_m), asset.yaw_rad);
  world->Open("geometry");
  if (form == Collision::kBox) {
    world->Open("box");
    world->Numbers("size", {2.0 * std::max(kThinnest_m, asset.half_length_m),
                            2.0 * std::max(kThinnest_m, asset.half_width_m), height_m});
    world->Close("box");
  } else {
    const float radius_m = form == Collision::kTrunk ? asset.trunk_radius_m : asset.half_length_m;
    world->Open("cylinder");
    world->Numbers("radius", {std::max(kThinnest_m, radius_m)});
    world->Numbers("length", {height_m});
    world->Close("cylinder");
  }
  world->Close("geometry");
  world->Close("collision");
}

void AddSdfProp(const Prop& prop, const std::string& name, const Eigen::Vector3d& place_m,
                SdfText* world) {
  const bool moves = prop.kind == PropKind::kCrate || prop.kind == PropKind::kLooseStone;
  const bool ball = prop.kind == PropKind::kLooseStone;
  const Eigen::Vector3d& size = prop.size_m;
  const double radius_m = 0.5 * size.x();
  // A gate's origin is at its hinge, others' in the middle; a ball rests on its lowest point.
  const Eigen::Vector3d center(prop.kind == PropKind::kGate ? 0.5 * size.x() : 0.0, 0.0,
                               0.5 * size.z());
  world->Open("model", name);
  if (!moves) world->Leaf("static", "true");
  world->Pose(place_m, prop.yaw_rad);
  world->Open("link", "link");
  world->Pose(center, 0.0);
  const double mass = prop.mass_kg;
  const Eigen::Vector3d squares = size.cwiseProduct(size);
  const double sphere = 0.4 * mass * radius_m * radius_m;
  world->Open("inertial");
  world->Numbers("mass", {mass});
  world->Open("inertia");
  world->Numbers("ixx", {ball ? sphere : mass / 12.0 * (squares.y() + squares.z())});
  world->Numbers("iyy", {ball ? sphere : mass / 12.0 * (squares.x() + squares.z())});
  world->Numbers("izz", {ball ? sphere : mass / 12.0 * (squares.x() + squares.y())});
  world->Numbers("ixy", {0.0});
  world->Numbers("ixz", {0.0});
  world->Numbers("iyz", {0.0});
  world->Close("inertia");
  world->Close("inertial");
  for (const char* role : {"collision", "visual"}) {
    world->Open(role, role);
    world->Open("geometry");
    world->Open(ball ? "sphere" : "box");
    if (ball)
      world->Numbers("radius", {radius_m});
    else
      world->Numbers("size", {size.x(), size.y(), size.z()});
    world->Close(ball ? "sphere" : "box");
    world->Close("geometry");
    if (std::string(role) == "visual") {
      world->Open("material");
      const char* color = ball ? "0.55 0.52 0.49 1" : "0.6 0.45 0.28 1";
      world->Leaf("ambient", color);
      world->Leaf("diffuse", color);
      world->Close("material");
    }
    world->Close(role);
  }
  world->Close("link");
  world->Close("model");
}

void AddSdfBridge(const Bridge& bridge, const std::vector<BridgePart>& parts,
                  const std::string& name, const Eigen::Vector3d& origin_m, SdfText* world) {
  world->Open("model", name);
  world->Leaf("static", "true");
  world->Open("link", "link");
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const BridgePart& part = parts[i];
    const Eigen::Vector3d middle_m =
        Eigen::Vector3d(part.middle.x_m, part.middle.y_m, part.middle_z_m()) - origin_m;
    const Eigen::Vector3d size = part.size_m();
    for (const char* role : {"collision", "visual"}) {
      world->Open(role, std::string(role) + "_" + std::to_string(i));
      world->Pose(middle_m, part.yaw_rad);
      world->Open("geometry");
      world->Open("box");
      world->Numbers("size", {size.x(), size.y(), size.z()});
      world->Close("box");
      world->Close("geometry");
      if (std::string(role) == "visual") {
        const std::string color = ExportedColorOf(bridge.kind, part.kind);
        world->Open("material");
        world->Leaf("ambient", color);
        world->Leaf("diffuse", color);
        world->Close("material");
      }
      world->Close(role);
    }
  }
  world->Close("link");
  world->Close("model");
}

}  // namespace latticeworld
