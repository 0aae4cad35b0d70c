#ifndef LATTICEWORLD_SCENE_PROPS_PROPS_H_
#define LATTICEWORLD_SCENE_PROPS_PROPS_H_

#include <cstdint>
#include <vector>

#include "latticeworld/common/status.h"
#include "latticeworld/scene/footprint.h"
#include "latticeworld/scene/props/prop.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {

// No world holds more props than this, those that are spawned included.
inline constexpr int kMaxProps = 2000;

// A prop of usual size, mass and strength, at the centre of the world; without a name.
Prop UsualProp(PropKind kind);
// Returns the usual mass of a prop of that size [kg]. Crates are empty boxes, gates are slatted,
// the others are of solid wood or stone.
double UsualMass(PropKind kind, const Eigen::Vector3d& size_m);
// Bridges: 100 kg for each square metre [kg]. Posts: the moment at which wood of 12 MPa breaks, a
// quarter of what sound wood bears, for what has stood in soil [N m]. Others: 0.
double UsualStrength(PropKind kind, const Eigen::Vector3d& size_m);

// A prop of that kind, at the centre of the world and without a name. size_m: components of 0 are
// usual for the kind; of a loose stone x is the diameter, and the others are not looked at.
// mass_kg, strength: 0 is usual for kind and size, and for the kind alone where the size is
// illegal, so that Validate names only what was given.
Prop PropOf(PropKind kind, const Eigen::Vector3d& size_m, double mass_kg = 0.0,
            double strength = 0.0);

// Everything that is wrong with its numbers, which are called as spawn_element has them: "size.x",
// "mass", "strength", "heading", "position.x". The name is not looked at, nor what is in the way.
std::vector<Violation> Validate(const Prop& prop);

// What it covers, seen from above; a gate's closed panel.
Footprint FootprintOf(const Prop& prop);
// Height of its origin where it stands on the ground [m]; the deck of a bridge is level with the
// higher one of the banks at its ends, a gate's panel with the highest ground below it.
double GroundUnder(const Terrain& terrain, const Prop& prop);

// The scene's props: those of its single things, which it has already, crates beside houses,
// loose stones on gentle ground, above all on rock and barren land, rows of posts along roads,
// gates with their two posts between houses and streets, and footbridges over narrow waters, most
// of them near roads. Some tens on a square kilometre; nothing overlaps anything solid or stands
// nearer than 4 m to where an agent begins. Draws from streams of its own of the seed. Sorted by
// name.
std::vector<Prop> PlaceProps(const Scene& scene, std::uint64_t seed);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SCENE_PROPS_PROPS_H_
