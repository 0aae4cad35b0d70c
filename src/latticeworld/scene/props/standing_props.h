#ifndef LATTICEWORLD_SCENE_PROPS_STANDING_PROPS_H_
#define LATTICEWORLD_SCENE_PROPS_STANDING_PROPS_H_

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <memory>
#include <optional>
#include <vector>

#include "latticeworld/common/status.h"
#include "latticeworld/scene/footprint.h"
#include "latticeworld/scene/props/prop.h"

namespace latticeworld {

struct Scene;
struct SceneChanges;
struct Terrain;

// What rises less than this above its place is walked and driven over, and is in nobody's way.
inline constexpr double kLowestBlock_m = 0.1;

// A crate, a stone, a post or a gate's panel, as something in the way: an upright box around it. Or
// a part of a road's bridge.
struct PropBlock {
  Footprint footprint;
  double bottom_m = 0.0, top_m = 0.0;  // map frame
  bool hangs = false;                  // bodies may pass below it: a railing or an arch
  double carries_kg = 0.0;             // of a railing: what the deck carries that it stands on
};
bool operator==(const PropBlock& a, const PropBlock& b);

// A bridge as a way over what is below it: of the props, or a piece of one that a road takes.
struct PropDeck {
  Footprint footprint;
  double bottom_m = 0.0, top_m = 0.0;  // map frame; bodies stand on the top
  double carries_kg = 0.0;
};
bool operator==(const PropDeck& a, const PropDeck& b);

// The props of a world as maps, lines of sight and paths know them, in the order of their names,
// and after them the bridges of its roads. Bridges that broke and posts that did are in no list.
struct StandingProps {
  std::vector<PropBlock> blocks;  // railings too
  std::vector<PropDeck> decks;
  std::vector<PropBlock> below;  // what holds up decks: piers and arches
};
bool operator==(const StandingProps& a, const StandingProps& b);

// The upright box around a prop whose frame (see Prop) is at that pose, whatever side it
// lies on.
PropBlock BoxAround(const Prop& prop, const Eigen::Vector3d& position_m,
                    const Eigen::Quaterniond& orientation);
// The same. None: it is a bridge, or too low to be in the way.
std::optional<PropBlock> BlockOf(const Prop& prop, const Eigen::Vector3d& position_m,
                                 const Eigen::Quaterniond& orientation);
// bridge: of that kind, where it begins.
PropDeck DeckOf(const Prop& bridge);

// Those props where they begin.
StandingProps StandingAtBegin(const std::vector<Prop>& props);
// The scene's, and its bridges.
StandingProps StandingAtBegin(const Scene& scene);
// The bridges of its roads alone.
void AddBridges(const Terrain& terrain, StandingProps* standing);
// The props after the changes, never null.
std::shared_ptr<const StandingProps> PropsIn(const Scene& scene, const SceneChanges& changes);

// Everything that is wrong: numbers that are not finite or no place of any world, sizes beyond
// those of props, and more of them than a world holds.
std::vector<Violation> Validate(const StandingProps& props);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SCENE_PROPS_STANDING_PROPS_H_
