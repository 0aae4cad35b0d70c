#ifndef LATTICEWORLD_ROS_CONVERSION_REQUEST_CONVERSION_H_
#define LATTICEWORLD_ROS_CONVERSION_REQUEST_CONVERSION_H_

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/generation/world_generator.h"
#include "latticeworld_ros/conversion/messages.h"

namespace latticeworld {

struct RequestDefaults {
  std::string reader;
  std::string generator;
  std::vector<std::filesystem::path> visual_directories;
};

// The core's request with every empty field filled in, and accepted by the generator. Message:
// generate_world's request or the goal of generate_world_action, which have the same fields (the
// build sees to that). drawn_seed: for a request that leaves the seed to us; not 0. Errors:
// INVALID_ARGUMENT with every violation of both sides at once; what reading visual_path says
// (NOT_FOUND, PERMISSION_DENIED, ...).
template <typename Message>
Result<AcceptedRequest> ToGenerationRequest(const Message& message, const RequestDefaults& defaults,
                                            const WorldGenerator& generator,
                                            std::uint64_t drawn_seed);

// A seed that nobody chose, never 0: the operating system's.
std::uint64_t DrawSeed();

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_CONVERSION_REQUEST_CONVERSION_H_
