#include "latticeworld/simulation/found_things.h"

#include <map>
#include <string_view>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/geometry/upright.h"
#include "latticeworld/simulation/world_state.h"

namespace latticeworld {
namespace {

Eigen::Quaterniond Turned(double yaw_rad) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()));
}

FoundThing OfAsset(const Scene& scene, const SceneThing& thing) {
  const Asset& asset = scene.assets[static_cast<std::size_t>(thing.asset)];
  FoundThing named;
  named.name = thing.name;
  named.kind = thing.kind;
  named.model = scene.catalogue->models()[asset.model].name;
  named.position_m = {double{asset.x_m}, double{asset.y_m}, double{asset.z_m}};
  named.orientation = Turned(double{asset.yaw_rad});
  named.size_m = {2.0 * double{asset.half_length_m}, 2.0 * double{asset.half_width_m},
                  double{asset.height_m}};
  return named;
}

FoundThing OfProp(const Prop& prop) {
  FoundThing named;
  named.name = prop.name;
  named.kind = std::string(NameOf(prop.kind));
  named.position_m = {prop.position.x_m, prop.position.y_m, prop.z_m};
  named.orientation = Turned(prop.yaw_rad);
  named.size_m = prop.size_m;
  return named;
}

FoundThing OfProp(const PropSnapshot& prop) {
  FoundThing named;
  named.name = prop.name;
  named.kind = std::string(NameOf(prop.kind));
  named.position_m = prop.position_m;
  named.orientation = prop.orientation;
  named.size_m = prop.size_m;
  if (prop.broken) named.condition = ThingCondition::kBroken;
  return named;
}

void Fell(const WorldState& state, std::int32_t asset, FoundThing* named) {
  for (const FelledTree& felled : state.felled) {
    if (static_cast<std::int32_t>(felled.tree.asset) != asset) continue;
    named->condition = ThingCondition::kFelled;
    named->position_m = felled.tree.foot_m;
    named->orientation = TurnFromUp(felled.tree.tip_m - felled.tree.foot_m) * named->orientation;
  }
}

// Props by their names: as they are now, or as they begin.
std::map<std::string, FoundThing> PropsOf(const Scene& scene, const WorldState* state) {
  std::map<std::string, FoundThing> props;
  if (state == nullptr) {
    for (const Prop& prop : scene.props) props[prop.name] = OfProp(prop);
    return props;
  }
  for (const PropSnapshot& prop : state->props) {
    props[prop.name] = OfProp(prop);
  }
  for (const Prop& prop : scene.props) {
    FoundThing gone = OfProp(prop);
    gone.condition = ThingCondition::kGone;
    props.emplace(prop.name, std::move(gone));
  }
  return props;
}

std::vector<FoundThing> AllThings(const Scene& scene, const WorldState* state) {
  std::map<std::string, FoundThing> props = PropsOf(scene, state);
  std::vector<FoundThing> all;
  for (const SceneThing& thing : scene.things) {
    if (thing.asset >= 0) {
      all.push_back(OfAsset(scene, thing));
      if (state != nullptr) Fell(*state, thing.asset, &all.back());
    } else if (const auto found = props.find(thing.name); found != props.end()) {
      found->second.kind = thing.kind;
      all.push_back(std::move(found->second));
      props.erase(found);
    }
  }
  for (auto& [name, prop] : props) all.push_back(std::move(prop));
  return all;
}

Status NoneOf(const std::vector<std::string>& missing, const std::vector<FoundThing>& all) {
  constexpr std::size_t kMostNamed = 40;
  std::vector<std::string> quoted, legal;
  for (const std::string& name : missing) {
    if (quoted.size() < kMostNamed) quoted.push_back(Quote(name));
  }
  for (const FoundThing& thing : all) {
    if (legal.size() < kMostNamed) legal.push_back(thing.name);
  }
  std::string known = "this world has no single things and no elements";
  if (!all.empty()) {
    known = "there are " + Join(legal, ", ");
    if (all.size() > legal.size()) {
      known += " and " + std::to_string(all.size() - legal.size()) + " more";
    }
  }
  return NotFound("nothing is named " + Join(quoted, ", ") + "; " + known);
}

}  // namespace

Result<std::vector<FoundThing>> FindThings(const Scene& scene, const WorldState* state,
                                           const std::vector<std::string>& names) {
  std::vector<FoundThing> all = AllThings(scene, state);
  if (names.empty()) return all;
  std::map<std::string_view, const FoundThing*> by_name;
  for (const FoundThing& thing : all) by_name.emplace(thing.name, &thing);
  std::vector<FoundThing> found;
  std::vector<std::string> missing;
  for (const std::string& name : names) {
    const auto at = by_name.find(name);
    if (at == by_name.end()) {
      missing.push_back(name);
    } else {
      found.push_back(*at->second);
    }
  }
  if (!missing.empty()) return NoneOf(missing, all);
  return found;
}

}  // namespace latticeworld
