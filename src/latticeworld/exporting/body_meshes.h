#ifndef LATTICEWORLD_EXPORTING_BODY_MESHES_H_
#define LATTICEWORLD_EXPORTING_BODY_MESHES_H_

#include <string>

#include "latticeworld/environment/attributes.h"
#include "latticeworld/exporting/gltf/glb_document.h"
#include "latticeworld/scene/props/prop.h"
#include "latticeworld/terrain/ways/bridge.h"

namespace latticeworld {

struct Species;

// The body of a species in metres, its front along x of base_link and its lowest point at the
// origin, in the colours of that style; gives the number of the mesh "agent/<species>".
int AddBody(const Species& species, ArtisticStyle style, GlbDocument* document);

// A prop of that kind and of size 1 in its own frame (scene/props/prop.h), so that scaling it by
// a prop's size gives the prop; gives the number of the mesh "prop/<kind>".
int AddProp(PropKind kind, ArtisticStyle style, GlbDocument* document);

// A part of a bridge of that kind as a box of size 1 around the origin; gives the number of the
// mesh "bridge/<kind>/<part>".
int AddBridgePart(BridgeKind kind, BridgePartKind part, ArtisticStyle style, GlbDocument* document);

}  // namespace latticeworld

#endif  // LATTICEWORLD_EXPORTING_BODY_MESHES_H_
