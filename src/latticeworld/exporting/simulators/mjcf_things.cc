#include "latticeworld/exporting/simulators/mjcf_things.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "latticeworld/exporting/bridge_colors.h"
#include "latticeworld/exporting/simulators/mjcf_text.h"
#include "latticeworld/scene/asset.h"
#include "latticeworld/scene/props/prop.h"
#include "latticeworld/terrain/ways/bridge.h"

namespace latticeworld {
namespace {

constexpr float kThinnest_m = 1e-3f;

}  // namespace

void AddMjcfCollision(const Asset& asset, Collision form, const Eigen::Vector3d& base_m,
                      const std::string& name, MjcfText* world) {
  const double half_height_m = 0.5 * std::max(kThinnest_m, asset.height_m);
  const std::string place = MjcfNumbers(base_m + Eigen::Vector3d(0.0, 0.0, half_height_m));
  MjcfAttributes attributes = {{"class", "solid"}, {"name", name}, {"pos", place}};
  if (form == Collision::kBox) {
    attributes.insert(
        attributes.end(),
        {{"quat", MjcfYaw(asset.yaw_rad)},
         {"type", "box"},
         {"size", MjcfNumbers({std::max(kThinnest_m, asset.half_length_m),
                               std::max(kThinnest_m, asset.half_width_m), half_height_m})}});
  } else {
    const float radius_m = form == Collision::kTrunk ? asset.trunk_radius_m : asset.half_length_m;
    attributes.insert(attributes.end(),
                      {{"type", "cylinder"},
                       {"size", MjcfNumbers({std::max(kThinnest_m, radius_m), half_height_m})}});
  }
  world->Leaf("geom", attributes);
}

void AddMjcfProp(const Prop& prop, const std::string& name, const Eigen::Vector3d& place_m,
                 MjcfText* world) {
  const bool moves = prop.kind == PropKind::kCrate || prop.kind == PropKind::kLooseStone;
  const bool ball = prop.kind == PropKind::kLooseStone;
  const Eigen::Vector3d& size = prop.size_m;
  // A gate's origin is at its hinge, others' in the middle; a ball rests on its lowest point.
  const Eigen::Vector3d center(prop.kind == PropKind::kGate ? 0.5 * size.x() : 0.0, 0.0,
                               0.5 * size.z());
  const Eigen::Vector3d middle_m =
      place_m + Eigen::AngleAxisd(prop.yaw_rad, Eigen::Vector3d::UnitZ()) * center;
  const MjcfAttributes place = {{"pos", MjcfNumbers(middle_m)}, {"quat", MjcfYaw(prop.yaw_rad)}};
  MjcfAttributes geom = {
      {"class", "element"},
      {"name", name},
      {"type", ball ? "sphere" : "box"},
      {"size", ball ? MjcfNumbers({0.5 * size.x()}) : MjcfNumbers(0.5 * size)},
      {"rgba", ball ? "0.55 0.52 0.49 1" : "0.6 0.45 0.28 1"},
  };
  if (!moves) {
    geom.insert(geom.end(), place.begin(), place.end());
    world->Leaf("geom", geom);
    return;
  }
  MjcfAttributes body = {{"name", name}};
  body.insert(body.end(), place.begin(), place.end());
  world->Open("body", body);
  world->Leaf("freejoint", {{"name", name}});
  geom.emplace_back("mass", MjcfNumbers({prop.mass_kg}));
  world->Leaf("geom", geom);
  world->Close("body");
}

void AddMjcfBridge(const Bridge& bridge, const std::vector<BridgePart>& parts,
                   const std::string& name, const Eigen::Vector3d& origin_m, MjcfText* world) {
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const BridgePart& part = parts[i];
    const Eigen::Vector3d middle_m =
        Eigen::Vector3d(part.middle.x_m, part.middle.y_m, part.middle_z_m()) - origin_m;
    world->Leaf("geom", {{"class", "element"},
                         {"name", name + "_" + std::to_string(i)},
                         {"type", "box"},
                         {"size", MjcfNumbers(0.5 * part.size_m())},
                         {"rgba", ExportedColorOf(bridge.kind, part.kind)},
                         {"pos", MjcfNumbers(middle_m)},
                         {"quat", MjcfYaw(part.yaw_rad)}});
  }
}

}  // namespace latticeworld
