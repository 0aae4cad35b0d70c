#ifndef LATTICEWORLD_ROS_CONVERSION_REQUEST_CONVERSION_H_
#define LATTICEWORLD_ROS_CONVERSION_REQUEST_CONVERSION_H_

#include <sensor_msgs/CompressedImage.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "latticeworld/common/result.h"
#include "latticeworld/common/status.h"
#include "latticeworld/generation/world.h"
#include "latticeworld/generation/world_generator.h"
#include "latticeworld_ros/conversion/messages.h"

namespace latticeworld {

// The fields that generate_world and generate_world_action share: their types differ, their
// meaning does not.
struct GenerateWorldFields {
  std::string layout_instruction;
  std::string environment_instruction;
  std::string things;
  std::uint8_t visual_kind = 0;
  sensor_msgs::CompressedImage visual;
  std::string visual_path;
  double height_scale = 0.0;
  double height_offset = 0.0;
  double latitude = 0.0;
  double longitude = 0.0;
  bool keep_altitude = false;
  std::string elevation_unit;
  std::string vocabulary;
  std::string reader;
  std::string generator;
  std::uint64_t seed = 0;
  double size = 0.0;
  double resolution = 0.0;
};
GenerateWorldFields FieldsOf(const latticeworld_msgs::GenerateWorld::Request& request);
GenerateWorldFields FieldsOf(const latticeworld_msgs::GenerateWorldTaskGoal& goal);

struct RequestDefaults {
  std::string reader;
  std::string generator;
  std::vector<std::filesystem::path> visual_directories;
};

// The core's request with every empty field filled in, and valid for the generator. drawn_seed: for
// a request that leaves the seed to us; not 0. Errors: INVALID_ARGUMENT with every violation of
// both sides at once; what reading visual_path says (NOT_FOUND, PERMISSION_DENIED, ...).
Result<GenerationRequest> ToGenerationRequest(GenerateWorldFields fields,
                                              const RequestDefaults& defaults,
                                              const WorldGenerator& generator,
                                              std::uint64_t drawn_seed);

// A seed that nobody chose, never 0: the operating system's.
std::uint64_t DrawSeed();

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_CONVERSION_REQUEST_CONVERSION_H_
