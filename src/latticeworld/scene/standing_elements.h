#ifndef LATTICEWORLD_SCENE_STANDING_ELEMENTS_H_
#define LATTICEWORLD_SCENE_STANDING_ELEMENTS_H_

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <memory>
#include <optional>
#include <vector>

#include "latticeworld/common/status.h"
#include "latticeworld/scene/element.h"
#include "latticeworld/scene/footprint.h"

namespace latticeworld {

struct Scene;
struct SceneChanges;
struct Terrain;

// What rises less than this above its place is walked and driven over, and is in nobody's way.
inline constexpr double kLowestBlock_m = 0.1;

// A crate, a stone, a post or a gate's panel, as something in the way: an upright box around it. Or
// a part of a road's bridge.
struct ElementBlock {
  Footprint footprint;
  double bottom_m = 0.0, top_m = 0.0;  // map frame
  bool hangs = false;                  // bodies may pass below it: a railing or an arch
  double carries_kg = 0.0;             // of a railing: what the deck carries that it stands on
};
bool operator==(const ElementBlock& a, const ElementBlock& b);

// A bridge as a way over what is below it: of the elements, or a piece of one that a road takes.
struct ElementDeck {
  Footprint footprint;
  double bottom_m = 0.0, top_m = 0.0;  // map frame; bodies stand on the top
  double carries_kg = 0.0;
};
bool operator==(const ElementDeck& a, const ElementDeck& b);

// The elements of a world as maps, lines of sight and paths know them, in the order of their names,
// and after them the bridges of its roads. Bridges that broke and posts that did are in no list.
struct StandingElements {
  std::vector<ElementBlock> blocks;  // railings too
  std::vector<ElementDeck> decks;
  std::vector<ElementBlock> below;  // what holds up decks: piers and arches
};
bool operator==(const StandingElements& a, const StandingElements& b);

// The upright box around an element whose frame (see Element) is at that pose, whatever side it
// lies on.
ElementBlock BoxAround(const Element& element, const Eigen::Vector3d& position_m,
                       const Eigen::Quaterniond& orientation);
// The same. None: it is a bridge, or too low to be in the way.
std::optional<ElementBlock> BlockOf(const Element& element, const Eigen::Vector3d& position_m,
                                    const Eigen::Quaterniond& orientation);
// bridge: of that kind, where it begins.
ElementDeck DeckOf(const Element& bridge);

// Those elements where they begin.
StandingElements StandingAtBegin(const std::vector<Element>& elements);
// The scene's, and its bridges.
StandingElements StandingAtBegin(const Scene& scene);
// The bridges of its roads alone.
void AddBridges(const Terrain& terrain, StandingElements* standing);
// The elements after the changes, never null.
std::shared_ptr<const StandingElements> ElementsIn(const Scene& scene, const SceneChanges& changes);

// Everything that is wrong: numbers that are not finite or no place of any world, sizes beyond
// those of elements, and more of them than a world holds.
std::vector<Violation> Validate(const StandingElements& elements);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SCENE_STANDING_ELEMENTS_H_
