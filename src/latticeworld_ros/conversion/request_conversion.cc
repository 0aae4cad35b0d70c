#include "latticeworld_ros/conversion/request_conversion.h"

#include <algorithm>
#include <optional>
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
  fields.things = message.things;
  fields.visual_kind = message.visual_kind;
  fields.visual = message.visual;
  fields.visual_path = message.visual_path;
  fields.height_scale = message.height_scale;
  fields.height_offset = message.height_offset;
  fields.latitude = message.latitude;
  fields.longitude = message.longitude;
  fields.keep_altitude = message.keep_altitude;
  fields.elevation_unit = message.elevation_unit;
  fields.vocabulary = message.vocabulary;
  fields.reader = message.reader;
  fields.generator = message.generator;
  fields.seed = message.seed;
  fields.size = message.size;
  fields.resolution = message.resolution;
  return fields;
}

// The file's bytes. A relative path is looked for below each allowed directory in turn.
Result<std::string> ReadVisualFile(const std::string& path,
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

std::optional<VisualKind> KindOf(std::uint8_t constant) {
  switch (constant) {
    case Ros::NONE:
      return VisualKind::kNone;
    case Ros::HEIGHT_MAP:
      return VisualKind::kHeightMap;
    case Ros::SKETCH:
      return VisualKind::kSketch;
    case Ros::ELEVATION:
      return VisualKind::kElevation;
    default:
      return std::nullopt;
  }
}

void CheckVisual(const GenerateWorldFields& fields, std::vector<Violation>* violations) {
  const std::optional<VisualKind> kind = KindOf(fields.visual_kind);
  if (!kind) {
    const std::string given = std::to_string(static_cast<int>(fields.visual_kind));
    violations->push_back(
        {"unknown_value", "visual_kind",
         given + " is unknown; legal are 0 (NONE), 1 (HEIGHT_MAP), 2 (SKETCH), 3 (ELEVATION)",
         given});
    return;
  }
  if (!FromName<ElevationUnit>(fields.elevation_unit)) {
    violations->push_back({"unknown_value", "elevation_unit",
                           "is " + Quote(fields.elevation_unit) +
                               "; legal are degrees, metres, or none to let the numbers decide",
                           fields.elevation_unit});
  }
  const bool has_visual = !fields.visual.data.empty(), has_path = !fields.visual_path.empty();
  if (kind == VisualKind::kNone && (has_visual || has_path)) {
    violations->push_back({"conflict", has_visual ? "visual" : "visual_path",
                           "a visual instruction is given, but visual_kind is 0 (NONE); legal with "
                           "one are 1 (HEIGHT_MAP), 2 (SKETCH), 3 (ELEVATION)",
                           ""});
  }
  if (kind != VisualKind::kNone && has_visual == has_path) {
    violations->push_back({has_visual ? "conflict" : "missing_value", "visual",
                           std::string(has_visual ? "both" : "neither") +
                               " of visual and visual_path given; a " + std::string(NameOf(*kind)) +
                               " needs one of them",
                           ""});
  }
}

// The visual instruction of fields that CheckVisual accepted.
Status TakeVisual(const GenerateWorldFields& fields, const RequestDefaults& defaults,
                  GenerationRequest* request) {
  request->visual_kind = *KindOf(fields.visual_kind);
  if (request->visual_kind == VisualKind::kNone) return Status();
  if (fields.visual_path.empty()) {
    request->visual.assign(fields.visual.data.begin(), fields.visual.data.end());
    request->visual_name = fields.visual.format;
  } else {
    LW_ASSIGN_OR_RETURN(request->visual,
                        ReadVisualFile(fields.visual_path, defaults.visual_directories));
    request->visual_name = fields.visual_path;
  }
  if (fields.height_scale != 0.0) request->height_map.height_scale_m = fields.height_scale;
  request->height_map.height_offset_m = fields.height_offset;
  request->elevation.centered = fields.latitude == 0.0 && fields.longitude == 0.0;
  request->elevation.latitude_deg = fields.latitude;
  request->elevation.longitude_deg = fields.longitude;
  request->elevation.keep_altitude = fields.keep_altitude;
  request->elevation.unit = *FromName<ElevationUnit>(fields.elevation_unit);
  return Status();
}

}  // namespace

GenerateWorldFields FieldsOf(const latticeworld_msgs::GenerateWorld::Request& request) {
  return CopyFields(request);
}
GenerateWorldFields FieldsOf(const latticeworld_msgs::GenerateWorldTaskGoal& goal) {
  return CopyFields(goal);
}

Result<GenerationRequest> ToGenerationRequest(GenerateWorldFields fields,
                                              const RequestDefaults& defaults,
                                              const WorldGenerator& generator,
                                              std::uint64_t drawn_seed) {
  std::vector<Violation> violations;
  CheckVisual(fields, &violations);
  const bool legal_visual = violations.empty();

  GenerationRequest request;
  if (legal_visual) LW_RETURN_IF_ERROR(TakeVisual(fields, defaults, &request));
  request.layout_instruction = std::move(fields.layout_instruction);
  request.environment_instruction = std::move(fields.environment_instruction);
  request.things = std::move(fields.things);
  request.vocabulary = std::move(fields.vocabulary);
  request.reader = fields.reader.empty() ? defaults.reader : std::move(fields.reader);
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
