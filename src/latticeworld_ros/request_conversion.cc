#include "latticeworld_ros/request_conversion.h"

#include <algorithm>
#include <random>
#include <utility>

#include "latticeworld/common/files.h"
#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

using Ros = latticeworld_msgs::GenerateWorld::Request;

template <typename Message>
GenerateWorldFields CopyFields(const Message& message) {
  GenerateWorldFields fields;
  fields.layout_instruction = message.layout_instruction;
  fields.environment_instruction = message.environment_instruction;
  fields.visual_kind = message.visual_kind;
  fields.visual = message.visual;
  fields.visual_path = message.visual_path;
  fields.height_scale = message.height_scale;
  fields.height_offset = message.height_offset;
  fields.vocabulary = message.vocabulary;
  fields.generator = message.generator;
  fields.seed = message.seed;
  fields.size = message.size;
  fields.resolution = message.resolution;
  return fields;
}

// The file's bytes. A relative path is looked for below each allowed directory in turn.
Result<std::string> ReadVisual(const std::string& path,
                               const std::vector<std::filesystem::path>& directories) {
  // What is no path must not reach the file system, and neither the message as it is.
  LW_RETURN_IF_ERROR(ValidateText("visual_path", path, 4096));
  Result<std::filesystem::path> file = ResolveBelow(path, directories);
  if (!std::filesystem::path(path).is_absolute()) {
    for (const auto& directory : directories) {
      file = ResolveBelow(directory / path, directories);
      if (file.ok()) break;
    }
  }
  if (!file.ok()) return file.status().WithContext("visual_path");
  Result<std::string> bytes = ReadFile(*file, kMaxVisualBytes);
  if (!bytes.ok()) return bytes.status().WithContext("visual_path");
  return bytes;
}

void CheckVisual(const GenerateWorldFields& fields, std::vector<Violation>* violations) {
  if (fields.visual_kind != Ros::NONE && fields.visual_kind != Ros::HEIGHT_MAP) {
    const std::string given = std::to_string(static_cast<int>(fields.visual_kind));
    violations->push_back({"unknown_value", "visual_kind",
                           given + " is unknown; legal are 0 (NONE), 1 (HEIGHT_MAP)", given});
    return;
  }
  const bool has_visual = !fields.visual.data.empty(), has_path = !fields.visual_path.empty();
  if (fields.visual_kind == Ros::NONE && (has_visual || has_path)) {
    violations->push_back({"conflict", has_visual ? "visual" : "visual_path",
                           "a visual instruction is given, but visual_kind is 0 (NONE); legal with "
                           "one is 1 (HEIGHT_MAP)",
                           ""});
  }
  if (fields.visual_kind == Ros::HEIGHT_MAP && has_visual == has_path) {
    violations->push_back({has_visual ? "conflict" : "missing_value", "visual",
                           std::string(has_visual ? "both" : "neither") +
                               " of visual and visual_path given; a height map needs one of them",
                           ""});
  }
}

}  // namespace

GenerateWorldFields FieldsOf(const latticeworld_msgs::GenerateWorld::Request& request) {
  return CopyFields(request);
}
GenerateWorldFields FieldsOf(const latticeworld_msgs::GenerateWorldTaskGoal& goal) {
  return CopyFields(goal);
}

Result<GenerationRequest> FromRos(GenerateWorldFields fields, const RequestDefaults& defaults,
                                  const WorldGenerator& generator, std::uint64_t drawn_seed) {
  std::vector<Violation> violations;
  CheckVisual(fields, &violations);
  const bool legal_visual = violations.empty();

  GenerationRequest request;
  if (legal_visual && fields.visual_kind == Ros::HEIGHT_MAP) {
    request.visual_kind = VisualKind::kHeightMap;
    if (fields.visual_path.empty()) {
      request.visual.assign(fields.visual.data.begin(), fields.visual.data.end());
    } else {
      LW_ASSIGN_OR_RETURN(request.visual,
                          ReadVisual(fields.visual_path, defaults.visual_directories));
    }
    if (fields.height_scale != 0.0) request.height_map.height_scale_m = fields.height_scale;
    request.height_map.height_offset_m = fields.height_offset;
  }
  request.layout_instruction = std::move(fields.layout_instruction);
  request.environment_instruction = std::move(fields.environment_instruction);
  request.vocabulary = std::move(fields.vocabulary);
  request.generator = fields.generator.empty() ? defaults.generator : std::move(fields.generator);
  request.seed = fields.seed != 0 ? fields.seed : drawn_seed;
  if (fields.size != 0.0) request.size_m = fields.size;
  if (fields.resolution != 0.0) request.resolution_m = fields.resolution;

  const Status core = generator.Validate(request);
  if (core.ok() && violations.empty()) return request;
  if (violations.empty()) return core;
  violations.insert(violations.end(), core.violations().begin(), core.violations().end());
  return Status::FromViolations("generate_world", std::move(violations));
}

std::uint64_t DrawSeed() {
  std::random_device device;
  const std::uint64_t high = device(), low = device();
  return std::max<std::uint64_t>(1, (high << 32) | low);
}

}  // namespace latticeworld
