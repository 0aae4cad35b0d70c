#ifndef LATTICEWORLD_EXPORTING_GLTF_WORLD_GLB_H_
#define LATTICEWORLD_EXPORTING_GLTF_WORLD_GLB_H_

#include <optional>
#include <string>
#include <vector>

#include "latticeworld/common/progress.h"
#include "latticeworld/common/result.h"
#include "latticeworld/exporting/export_region.h"

namespace latticeworld {

class SpeciesCatalogue;
struct Scene;

struct WorldGlbOptions {
  std::optional<ExportRegion> region;  // absent: the whole world
  // The distance between vertices of ground and water, [0.05, 100]; absent: the world's cells. A
  // side has at most kMostGroundVertices.
  std::optional<double> ground_step_m;
  int texture_px = 2048;  // longer side of the ground's colours at most, [16, 8192]
  int detail = 1;         // of the meshes, [0, 2], 0 the finest
  // A thing is a node of its own instead of an instance: for readers without
  // EXT_mesh_gpu_instancing.
  bool expand = false;
  bool small_plants = true;  // grass, reed, flowers, crops
  bool agents = true;        // where they begin
};
// Errors: INVALID_ARGUMENT with every violation.
Status Validate(const WorldGlbOptions& options, const Scene& scene);

inline constexpr int kMostGroundVertices = 2049;   // a side
inline constexpr std::size_t kMostNodes = 100000;  // of expanded things

// A world as it begins, as one glTF 2.0 binary file in glTF's axes (x east, y up, z south; metres;
// the origin is the world's). The scene has nodes "ground" and "water" (where there is some), "sun"
// (KHR_lights_punctual), "assets", "props" and "agents". Children of "assets" are, for every
// mesh (ModelNameOf, model_library.h), material and one of three shades, one node with instances
// (EXT_mesh_gpu_instancing), which the file then requires, each with its number in the scene's
// assets ("_ASSET"); or, expanded, one node a thing, named "<model>_<number of the asset>".
// Children of "props" and "agents" are named as those are. Names are GlbNames::kPlain. Nodes
// have extras: "kind" ("ground", "water", "sun", an AssetKind, "prop", "agent"); of assets,
// props and agents "model" (catalogue's model, kind of prop, species); of an expanded thing
// "asset".
//
// The ground is triangulated as HeightField, at the lattice's vertices exactly on it, and has the
// unlit colours of the land in season and snow as its texture. The sun's illuminance is
// kSunIlluminance_lux times the scene's sun_intensity: bright for readers that set no exposure, not
// what a photometer would say. Reports the stage "glb". Errors: INVALID_ARGUMENT (options; more
// than kMostNodes expanded things), RESOURCE_EXHAUSTED, CANCELLED, INTERNAL.
Result<std::string> WorldGlb(const Scene& scene, const SpeciesCatalogue& species,
                             const WorldGlbOptions& options, const Progress& progress);

inline constexpr double kSunIlluminance_lux = 3.0;

}  // namespace latticeworld

#endif  // LATTICEWORLD_EXPORTING_GLTF_WORLD_GLB_H_
