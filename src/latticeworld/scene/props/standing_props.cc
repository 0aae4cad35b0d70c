#include "latticeworld/scene/props/standing_props.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/scene/props/props.h"
#include "latticeworld/scene/scene.h"
#include "latticeworld/scene/scene_changes.h"

namespace latticeworld {
namespace {

// No place of any world is farther from its centre [m].
constexpr double kFarthest_m = 1e5;
// No prop and no part of a bridge is longer than that [m].
constexpr double kLongest_m = 500.0;
// Nor has any world more: roads of 32 x 32 cells take some hundreds of bridges at most.
constexpr std::size_t kMaxBridgeParts = 20000;

bool IsSame(const Footprint& a, const Footprint& b) {
  return a.centre.x_m == b.centre.x_m && a.centre.y_m == b.centre.y_m && a.yaw_rad == b.yaw_rad &&
         a.half_length_m == b.half_length_m && a.half_width_m == b.half_width_m;
}

PropBlock BallAround(const Eigen::Vector3d& middle_m, double radius_m) {
  return {{{middle_m.x(), middle_m.y()}, 0.0, radius_m, radius_m},
          middle_m.z() - radius_m,
          middle_m.z() + radius_m};
}

// Returns the block around a box that may lean: along and across its most level edge.
PropBlock AroundBox(const Eigen::Vector3d& middle_m, const Eigen::Matrix3d& axes,
                    const Eigen::Vector3d& half_m) {
  int along = 0;
  axes.row(2).cwiseAbs().minCoeff(&along);
  const double yaw_rad = std::atan2(axes(1, along), axes(0, along));
  const auto reach = [&](const Eigen::Vector3d& way) {
    return (axes.transpose() * way).cwiseAbs().dot(half_m);
  };
  PropBlock block;
  block.footprint = {{middle_m.x(), middle_m.y()},
                     yaw_rad,
                     reach({std::cos(yaw_rad), std::sin(yaw_rad), 0.0}),
                     reach({-std::sin(yaw_rad), std::cos(yaw_rad), 0.0})};
  const double up_m = reach(Eigen::Vector3d::UnitZ());
  block.bottom_m = middle_m.z() - up_m;
  block.top_m = middle_m.z() + up_m;
  return block;
}

}  // namespace

bool operator==(const PropBlock& a, const PropBlock& b) {
  return IsSame(a.footprint, b.footprint) && a.bottom_m == b.bottom_m && a.top_m == b.top_m &&
         a.hangs == b.hangs && a.carries_kg == b.carries_kg;
}

bool operator==(const PropDeck& a, const PropDeck& b) {
  return IsSame(a.footprint, b.footprint) && a.bottom_m == b.bottom_m && a.top_m == b.top_m &&
         a.carries_kg == b.carries_kg;
}

bool operator==(const StandingProps& a, const StandingProps& b) {
  return a.blocks == b.blocks && a.decks == b.decks && a.below == b.below;
}

PropBlock BoxAround(const Prop& prop, const Eigen::Vector3d& position_m,
                    const Eigen::Quaterniond& orientation) {
  const Eigen::Vector3d half_m = 0.5 * prop.size_m;
  const bool is_stone = prop.kind == PropKind::kLooseStone;
  Eigen::Vector3d middle_m(0.0, 0.0, (is_stone ? kStoneLies : 1.0) * half_m.z());
  if (prop.kind == PropKind::kGate) middle_m.x() = half_m.x();  // it turns about its end
  middle_m = position_m + orientation * middle_m;
  if (is_stone) return BallAround(middle_m, half_m.x());
  return AroundBox(middle_m, orientation.toRotationMatrix(), half_m);
}

std::optional<PropBlock> BlockOf(const Prop& prop, const Eigen::Vector3d& position_m,
                                 const Eigen::Quaterniond& orientation) {
  if (prop.kind == PropKind::kBridge) return std::nullopt;
  const PropBlock block = BoxAround(prop, position_m, orientation);
  if (block.top_m - block.bottom_m < kLowestBlock_m) return std::nullopt;
  return block;
}

PropDeck DeckOf(const Prop& bridge) {
  return {FootprintOf(bridge), bridge.z_m, bridge.z_m + bridge.size_m.z(), bridge.strength};
}

StandingProps StandingAtBegin(const std::vector<Prop>& props) {
  StandingProps standing;
  for (const Prop& prop : props) {
    if (prop.kind == PropKind::kBridge) {
      standing.decks.push_back(DeckOf(prop));
      continue;
    }
    const Eigen::Quaterniond orientation(Eigen::AngleAxisd(prop.yaw_rad, Eigen::Vector3d::UnitZ()));
    const std::optional<PropBlock> block =
        BlockOf(prop, {prop.position.x_m, prop.position.y_m, prop.z_m}, orientation);
    if (block) standing.blocks.push_back(*block);
  }
  return standing;
}

StandingProps StandingAtBegin(const Scene& scene) {
  StandingProps standing = StandingAtBegin(scene.props);
  AddBridges(*scene.terrain, &standing);
  return standing;
}

void AddBridges(const Terrain& terrain, StandingProps* standing) {
  for (const Bridge& bridge : terrain.bridges) {
    for (const BridgePart& part : PartsOf(bridge, terrain.ground)) {
      const Footprint footprint = {part.middle, part.yaw_rad, part.half_length_m,
                                   part.half_width_m};
      switch (part.kind) {
        case BridgePartKind::kDeck:
          standing->decks.push_back({footprint, part.bottom_m, part.top_m, bridge.load_kg});
          break;
        case BridgePartKind::kRailing:
          standing->blocks.push_back({footprint, part.bottom_m, part.top_m, true, bridge.load_kg});
          break;
        case BridgePartKind::kPier:
          standing->below.push_back({footprint, part.bottom_m, part.top_m});
          break;
        case BridgePartKind::kArch:
          standing->below.push_back({footprint, part.bottom_m, part.top_m, true});
          break;
      }
    }
  }
}

std::shared_ptr<const StandingProps> PropsIn(const Scene& scene, const SceneChanges& changes) {
  if (changes.props != nullptr) return changes.props;
  return std::make_shared<const StandingProps>(StandingAtBegin(scene));
}

std::vector<Violation> Validate(const StandingProps& props) {
  std::vector<Violation> violations;
  const std::size_t count = props.blocks.size() + props.decks.size() + props.below.size();
  if (count > kMaxProps + kMaxBridgeParts) {
    violations.push_back({"too_many", "elements",
                          "a world holds at most " + std::to_string(kMaxProps) + " elements and " +
                              std::to_string(kMaxBridgeParts) + " parts of bridges",
                          std::to_string(count)});
  }
  // Every footprint and height must lie within the limits.
  const auto check = [&violations](const std::string& field, const Footprint& footprint,
                                   double bottom_m, double top_m) {
    const auto add = [&](double value, double low, double high, const char* name) {
      if (value >= low && value <= high) return;
      violations.push_back({"out_of_range", field + "/" + name,
                            "must be in [" + FormatDouble(low) + ", " + FormatDouble(high) + "]",
                            FormatDouble(value)});
    };
    add(footprint.centre.x_m, -kFarthest_m, kFarthest_m, "x_m");
    add(footprint.centre.y_m, -kFarthest_m, kFarthest_m, "y_m");
    add(footprint.yaw_rad, -1000.0, 1000.0, "yaw_rad");
    add(footprint.half_length_m, 0.0, 0.5 * kLongest_m, "half_length_m");
    add(footprint.half_width_m, 0.0, 0.5 * kLongest_m, "half_width_m");
    add(bottom_m, -kFarthest_m, kFarthest_m, "bottom_m");
    add(top_m - bottom_m, 0.0, kLongest_m, "top_m");
  };
  // All three lists are checked, decks also for what they carry.
  for (std::size_t i = 0; i < props.blocks.size(); ++i) {
    const PropBlock& block = props.blocks[i];
    check("elements/blocks/" + std::to_string(i), block.footprint, block.bottom_m, block.top_m);
  }
  for (std::size_t i = 0; i < props.below.size(); ++i) {
    const PropBlock& block = props.below[i];
    check("elements/below/" + std::to_string(i), block.footprint, block.bottom_m, block.top_m);
  }
  for (std::size_t i = 0; i < props.decks.size(); ++i) {
    const PropDeck& deck = props.decks[i];
    const std::string field = "elements/decks/" + std::to_string(i);
    check(field, deck.footprint, deck.bottom_m, deck.top_m);
    if (deck.carries_kg >= 0.0 && std::isfinite(deck.carries_kg)) continue;
    violations.push_back({"out_of_range", field + "/carries_kg", "must be finite and not below 0",
                          FormatDouble(deck.carries_kg)});
  }
  return violations;
}

}  // namespace latticeworld
