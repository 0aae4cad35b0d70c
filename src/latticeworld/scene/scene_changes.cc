#include "latticeworld/scene/scene_changes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/scene/props/standing_props.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {
namespace {

// Share of a tree's height that the stem may be longer or shorter.
constexpr double kLengthTolerance = 0.02;
// No place of any world is farther from its centre [m].
constexpr double kFarthest_m = 1e5;

std::string TextOf(const Eigen::Vector3d& point) {
  return FormatDouble(point.x()) + " " + FormatDouble(point.y()) + " " + FormatDouble(point.z());
}

// What is wrong with the places of a fallen tree of that height.
void CheckStem(const FallenTree& tree, double height_m, const std::string& field,
               std::vector<Violation>* violations) {
  bool legal = true;
  const auto check = [&](const char* name, const Eigen::Vector3d& point) {
    if (point.allFinite() && point.cwiseAbs().maxCoeff() <= kFarthest_m) return;
    legal = false;
    violations->push_back({"out_of_range", field + "/" + name,
                           "must be finite and at most " + FormatDouble(kFarthest_m) +
                               " m from the centre of the world",
                           TextOf(point)});
  };
  check("foot_m", tree.foot_m);
  check("tip_m", tree.tip_m);
  if (!legal) return;
  const double length_m = (tree.tip_m - tree.foot_m).norm();
  if (std::abs(length_m - height_m) <= kLengthTolerance * height_m) return;
  violations->push_back({"wrong_length", field,
                         "must be as long as the tree was high, " + FormatDouble(height_m) + " m",
                         FormatDouble(length_m)});
}

void Check(const GroundState& ground, std::vector<Violation>* violations) {
  const auto check = [&](const char* name, double value, double most, const char* legal) {
    if (value >= 0.0 && value <= most) return;
    violations->push_back({"out_of_range", std::string("ground/") + name,
                           std::string("must lie in ") + legal, FormatDouble(value)});
  };
  check("wetness", ground.wetness, 1.0, "[0, 1]");
  check("snow_depth_m", ground.snow_depth_m, 100.0, "[0, 100]");
  check("blown_sand", ground.blown_sand, 1.0, "[0, 1]");
}

}  // namespace

bool SceneChanges::Stands(std::uint32_t asset) const {
  const auto tree = std::lower_bound(
      fallen.begin(), fallen.end(), asset,
      [](const FallenTree& entry, std::uint32_t wanted) { return entry.asset < wanted; });
  if (tree != fallen.end() && tree->asset == asset) return false;
  return !std::binary_search(gone.begin(), gone.end(), asset);
}

bool operator==(const SceneChanges& a, const SceneChanges& b) {
  const auto same_tree = [](const FallenTree& one, const FallenTree& other) {
    return one.asset == other.asset && one.foot_m == other.foot_m && one.tip_m == other.tip_m;
  };
  if (a.gone != b.gone || a.ground != b.ground ||
      !std::equal(a.fallen.begin(), a.fallen.end(), b.fallen.begin(), b.fallen.end(), same_tree)) {
    return false;
  }
  if (a.props == nullptr || b.props == nullptr) return a.props == b.props;
  return a.props == b.props || *a.props == *b.props;
}

Status Validate(const SceneChanges& changes, const Scene& scene) {
  std::vector<Violation> violations;
  std::vector<bool> named;
  if (!changes.empty()) named.assign(scene.assets.size(), false);
  // Whether there is such an asset.
  const auto check = [&](const std::string& field, std::uint32_t asset, bool in_order) {
    const auto add = [&](const char* code, std::string message) {
      violations.push_back({code, field, std::move(message), std::to_string(asset)});
    };
    if (asset >= scene.assets.size()) {
      add("out_of_range",
          "must be below the scene's " + std::to_string(scene.assets.size()) + " assets");
      return false;
    }
    if (named[asset]) {
      add("duplicate", "asset " + std::to_string(asset) + " is named twice");
    } else if (!in_order) {
      add("wrong_order", "assets must be in increasing order");
    }
    named[asset] = true;
    return true;
  };
  for (std::size_t i = 0; i < changes.fallen.size(); ++i) {
    const FallenTree& tree = changes.fallen[i];
    const std::string field = "fallen/" + std::to_string(i);
    const bool in_order = i == 0 || changes.fallen[i - 1].asset <= tree.asset;
    if (!check(field + "/asset", tree.asset, in_order)) continue;
    const Asset& asset = scene.assets[tree.asset];
    if (asset.kind != AssetKind::kTree) {
      violations.push_back({"wrong_kind", field + "/asset",
                            "only trees fall, and asset " + std::to_string(tree.asset) + " is a " +
                                std::string(NameOf(asset.kind)),
                            std::to_string(tree.asset)});
      continue;
    }
    CheckStem(tree, asset.height_m, field, &violations);
  }
  for (std::size_t i = 0; i < changes.gone.size(); ++i) {
    check("gone/" + std::to_string(i), changes.gone[i],
          i == 0 || changes.gone[i - 1] <= changes.gone[i]);
  }
  if (changes.props != nullptr) {
    const std::vector<Violation> of_props = Validate(*changes.props);
    violations.insert(violations.end(), of_props.begin(), of_props.end());
  }
  if (changes.ground.has_value()) Check(*changes.ground, &violations);
  return Status::FromViolations("illegal scene changes", std::move(violations));
}

}  // namespace latticeworld
