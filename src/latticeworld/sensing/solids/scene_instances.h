#ifndef LATTICEWORLD_SENSING_SOLIDS_SCENE_INSTANCES_H_
#define LATTICEWORLD_SENSING_SOLIDS_SCENE_INSTANCES_H_

#include <memory>

#include "latticeworld/common/progress.h"
#include "latticeworld/common/result.h"
#include "latticeworld/environment/agent_group.h"
#include "latticeworld/sensing/solids/mesh_instances.h"
#include "latticeworld/sensing/solids/ray_scene.h"

namespace latticeworld {

// The assets' meshes: one prototype for each model, share of leaves, detail and individual that
// occurs. Errors: CANCELLED, the device's.
Result<std::unique_ptr<MeshInstances>> AssetInstances(RTCDevice device, const Scene& scene,
                                                      const RaySceneOptions& options,
                                                      const Progress& progress);
// The simple body of a category. Errors are the device's.
Result<MeshPrototype> BodyPrototype(RTCDevice device, AgentCategory category);
// The bodies of the scene's agents where they begin. Errors are the device's.
Result<std::unique_ptr<MeshInstances>> AgentInstances(RTCDevice device, const Scene& scene);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SENSING_SOLIDS_SCENE_INSTANCES_H_
