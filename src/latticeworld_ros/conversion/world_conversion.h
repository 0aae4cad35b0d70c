#ifndef LATTICEWORLD_ROS_CONVERSION_WORLD_CONVERSION_H_
#define LATTICEWORLD_ROS_CONVERSION_WORLD_CONVERSION_H_

#include <geometry_msgs/Point.h>

#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/generation/world.h"
#include "latticeworld_ros/conversion/messages.h"

namespace latticeworld {

struct PropDeck;

// Frames are map, stamps are left at zero: who publishes sets them.
latticeworld_msgs::WorldInfo ToWorldInfo(const World& world);
latticeworld_msgs::Layout ToLayout(const World& world);
latticeworld_msgs::Environment ToEnvironment(const World& world);
latticeworld_msgs::Reading ToReading(const World& world);
std::vector<latticeworld_msgs::StageTime> ToStageTimeMessages(const std::vector<StageTime>& stages);
std::vector<latticeworld_msgs::ClaimOutcome> ToClaimOutcomeMessages(
    const std::vector<ClaimOutcome>& claims);

// What generate_world answers once a world runs: all but the status. Answer: the service's response
// or the result of generate_world_action, which have the same fields (the build sees to that).
// stages: those of the world, and of what made it run.
template <typename Answer>
Answer ToGenerationAnswer(const World& world, const std::vector<StageTime>& stages);

// Most points that one query_terrain may ask for.
inline constexpr std::size_t kMaxTerrainPoints = 1000000;

// The ground at each point in that weather, and the highest of the decks above it. Errors:
// OUT_OF_RANGE naming the first point that is not inside the world (or not finite);
// RESOURCE_EXHAUSTED for too many.
Result<std::vector<latticeworld_msgs::TerrainSample>> SampleTerrain(
    const Scene& scene, const Atmosphere& atmosphere, const std::vector<PropDeck>& decks,
    const std::vector<geometry_msgs::Point>& points);

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_CONVERSION_WORLD_CONVERSION_H_
