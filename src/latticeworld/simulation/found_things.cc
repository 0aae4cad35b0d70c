#include "latticeworld/simulation/found_things.h"

#include <map>
#include <string_view>
#include <utility>

#include "latticeworld/common/text.h"
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

FoundThing OfElement(const Element& element) {
  FoundThing named;
  named.name = element.name;
  named.kind = std::string(NameOf(element.kind));
  named.position_m = {element.position.x_m, element.position.y_m, element.z_m};
  named.orientation = Turned(element.yaw_rad);
  named.size_m = element.size_m;
  return named;
}

FoundThing OfElement(const ElementSnapshot& element) {
  FoundThing named;
  named.name = element.name;
  named.kind = std::string(NameOf(element.kind));
  named.position_m = element.position_m;
  named.orientation = element.orientation;
  named.size_m = element.size_m;
  if (element.broken) named.condition = ThingCondition::kBroken;
  return named;
}

void Fell(const WorldState& state, std::int32_t asset, FoundThing* named) {
  for (const FelledTree& felled : state.felled) {
    if (static_cast<std::int32_t>(felled.tree.asset) != asset) continue;
    named->condition = ThingCondition::kFelled;
    named->position_m = felled.tree.foot_m;
    named->orientation = Eigen::Quaterniond::FromTwoVectors(
                             Eigen::Vector3d::UnitZ(), felled.tree.tip_m - felled.tree.foot_m) *
                         named->orientation;
  }
}

// Elements by their names: as they are now, or as they begin.
std::map<std::string, FoundThing> ElementsOf(const Scene& scene, const WorldState* state) {
  std::map<std::string, FoundThing> elements;
  if (state == nullptr) {
    for (const Element& element : scene.elements) elements[element.name] = OfElement(element);
    return elements;
  }
  for (const ElementSnapshot& element : state->elements) {
    elements[element.name] = OfElement(element);
  }
  for (const Element& element : scene.elements) {
    FoundThing gone = OfElement(element);
    gone.condition = ThingCondition::kGone;
    elements.emplace(element.name, std::move(gone));
  }
  return elements;
}

std::vector<FoundThing> AllThings(const Scene& scene, const WorldState* state) {
  std::map<std::string, FoundThing> elements = ElementsOf(scene, state);
  std::vector<FoundThing> all;
  for (const SceneThing& thing : scene.things) {
    if (thing.asset >= 0) {
      all.push_back(OfAsset(scene, thing));
      if (state != nullptr) Fell(*state, thing.asset, &all.back());
    } else if (const auto found = elements.find(thing.name); found != elements.end()) {
      found->second.kind = thing.kind;
      all.push_back(std::move(found->second));
      elements.erase(found);
    }
  }
  for (auto& [name, element] : elements) all.push_back(std::move(element));
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
