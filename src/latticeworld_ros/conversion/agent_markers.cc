#include "latticeworld_ros/conversion/agent_markers.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/geometry/upright.h"
#include "latticeworld_ros/conversion/agent_conversion.h"
#include "latticeworld_ros/conversion/geometry_conversion.h"

namespace latticeworld {
namespace {

using visualization_msgs::Marker;

std_msgs::ColorRGBA Color(double r, double g, double b, double a = 1.0) {
  std_msgs::ColorRGBA color;
  color.r = static_cast<float>(r);
  color.g = static_cast<float>(g);
  color.b = static_cast<float>(b);
  color.a = static_cast<float>(a);
  return color;
}

std_msgs::ColorRGBA TeamColor(const AgentSnapshot& agent) {
  // Neutral, robots, adversaries, and two more that teams of one's own take turns with.
  static constexpr std::array<std::array<double, 3>, 5> kColors = {{{0.90, 0.85, 0.70},
                                                                    {0.10, 0.40, 0.90},
                                                                    {0.85, 0.10, 0.10},
                                                                    {0.15, 0.65, 0.25},
                                                                    {0.60, 0.20, 0.75}}};
  const std::size_t team = agent.team <= 2 ? static_cast<std::size_t>(std::max(0, agent.team))
                                           : 3 + static_cast<std::size_t>(agent.team - 3) % 2;
  const auto& [r, g, b] = kColors[team];
  return Color(r, g, b, agent.behaviour == Behaviour::kDead ? 0.3 : 1.0);
}

// A marker's type and size, and its middle in the frame of what it shows.
struct Form {
  int type = Marker::CUBE;
  Eigen::Vector3d size_m = Eigen::Vector3d::Ones();
  Eigen::Vector3d middle_m = Eigen::Vector3d::Zero();
};

Form FormOf(const Species& species) {
  const double height_m = species.height_m, width_m = 2.0 * species.radius_m;
  switch (species.plan) {
    case BodyPlan::kVehicle:
      if (species.vehicle) {
        const VehicleDesign& design = *species.vehicle;
        const double body_m = std::max(0.05, height_m - design.ground_clearance_m);
        return {Marker::CUBE,
                {design.chassis_length_m, design.chassis_width_m, body_m},
                {0.0, 0.0, design.ground_clearance_m + body_m / 2.0}};
      }
      break;
    case BodyPlan::kQuadruped:
      if (species.quadruped) {
        const QuadrupedDesign& design = *species.quadruped;
        return {Marker::CUBE,
                {design.trunk_length_m, design.trunk_width_m, design.trunk_height_m},
                {0.0, 0.0, design.stance_height_m + design.foot_radius_m}};
      }
      break;
    case BodyPlan::kBiped:
      return {Marker::CYLINDER, {width_m, width_m, height_m}, {0.0, 0.0, height_m / 2.0}};
    case BodyPlan::kGrazer:
      return {Marker::CUBE, {width_m, width_m / 2.0, 0.6 * height_m}, {0.0, 0.0, 0.7 * height_m}};
    case BodyPlan::kFlyer:
    case BodyPlan::kSwimmer:
      return {Marker::SPHERE, {width_m, width_m, height_m}, {0.0, 0.0, height_m / 2.0}};
  }
  return {Marker::CUBE, {width_m, width_m, height_m}, {0.0, 0.0, height_m / 2.0}};
}

Form FormOf(const PropSnapshot& prop) {
  const Eigen::Vector3d& size_m = prop.size_m;
  const Eigen::Vector3d middle_m(0.0, 0.0, size_m.z() / 2.0);
  switch (prop.kind) {
    case PropKind::kLooseStone:
      return {Marker::SPHERE, size_m, middle_m};
    case PropKind::kGate:
      return {Marker::CUBE, size_m, middle_m + Eigen::Vector3d(size_m.x() / 2.0, 0.0, 0.0)};
    case PropKind::kPost:
      return {Marker::CYLINDER, size_m, middle_m};
    case PropKind::kCrate:
    case PropKind::kBridge:
      break;
  }
  return {Marker::CUBE, size_m, middle_m};
}

std_msgs::ColorRGBA ColorOf(const PropSnapshot& prop) {
  const double alpha = prop.broken ? 0.5 : 1.0;
  return prop.kind == PropKind::kLooseStone ? Color(0.52, 0.50, 0.48, alpha)
                                            : Color(0.62, 0.43, 0.22, alpha);
}

class Markers {
 public:
  explicit Markers(ros::Time stamp) {
    marker_.header.stamp = stamp;
    marker_.header.frame_id = kMapFrame;
    marker_.action = Marker::DELETEALL;
    array_.markers.push_back(marker_);
    marker_.action = Marker::ADD;
  }

  void Add(const char* ns, int id, const Form& form, const Eigen::Isometry3d& map_from_thing,
           const std_msgs::ColorRGBA& color, const std::string& text = "") {
    marker_.ns = ns;
    marker_.id = id;
    marker_.type = form.type;
    marker_.pose = latticeworld::ToPose(map_from_thing * Eigen::Translation3d(form.middle_m));
    marker_.scale = ToVector3(form.size_m);
    marker_.color = color;
    marker_.text = text;
    array_.markers.push_back(marker_);
  }

  visualization_msgs::MarkerArray Take() { return std::move(array_); }

 private:
  Marker marker_;
  visualization_msgs::MarkerArray array_;
};

void AddAgent(int id, const AgentSnapshot& agent, const SpeciesCatalogue& catalogue,
              Markers* markers) {
  const Species* known = catalogue.Find(agent.species);
  const Species& species = known != nullptr ? *known : catalogue.Of(agent.category);
  const Eigen::Isometry3d pose = PoseOf(agent);
  const std_msgs::ColorRGBA color = TeamColor(agent);
  markers->Add("bodies", id, FormOf(species), pose, color);
  // Arrows lie along x and begin at their pose.
  const double length_m = 1.5 * species.radius_m;
  markers->Add("headings", id,
               {Marker::ARROW,
                {length_m, 0.2 * length_m, 0.2 * length_m},
                {0.0, 0.0, 0.9 * species.height_m}},
               pose, color);
  // The name stands above it however it lies; z is the height of a letter.
  const Eigen::Isometry3d upright(
      Eigen::Translation3d(agent.position_m + Eigen::Vector3d(0.0, 0.0, species.height_m + 0.5)));
  markers->Add("names", id, {Marker::TEXT_VIEW_FACING, {0.0, 0.0, 0.8}, Eigen::Vector3d::Zero()},
               upright, color, agent.name);
}

void AddFallingTree(const FallenTree& tree, const Asset& asset, Markers* markers) {
  constexpr double kStemShare = 0.03;  // of the height: its thickness, as it is drawn
  const Eigen::Vector3d stem_m = tree.tip_m - tree.foot_m;
  const double length_m = stem_m.norm();
  const Eigen::Isometry3d pose = ToIsometry(tree.foot_m, TurnFromUp(stem_m));
  const int id = static_cast<int>(2 * tree.asset);
  const double crown_m = 2.0 * asset.half_length_m;
  markers->Add("trees", id,
               {Marker::CYLINDER,
                {kStemShare * length_m, kStemShare * length_m, length_m},
                {0.0, 0.0, length_m / 2.0}},
               pose, Color(0.38, 0.30, 0.20));
  markers->Add("trees", id + 1,
               {Marker::SPHERE, {crown_m, crown_m, 0.7 * length_m}, {0.0, 0.0, 0.65 * length_m}},
               pose, Color(0.30, 0.45, 0.20, 0.9));
}

}  // namespace

visualization_msgs::MarkerArray ToMarkerArray(const WorldState& state, const Scene& scene,
                                              const SpeciesCatalogue& catalogue, ros::Time stamp) {
  Markers markers(stamp);
  int id = 0;
  for (const AgentSnapshot& agent : state.agents) AddAgent(id++, agent, catalogue, &markers);
  id = 0;
  for (const PropSnapshot& prop : state.props) {
    markers.Add("elements", id++, FormOf(prop), ToIsometry(prop.position_m, prop.orientation),
                ColorOf(prop));
  }
  for (const FelledTree& felled : state.felled) {
    // Those at rest are in world/markers.
    if (!felled.at_rest) AddFallingTree(felled.tree, scene.assets[felled.tree.asset], &markers);
  }
  return markers.Take();
}

}  // namespace latticeworld
