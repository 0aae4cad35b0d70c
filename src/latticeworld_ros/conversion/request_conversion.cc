#include "latticeworld_ros/conversion/request_conversion.h"

#include <algorithm>
#include <optional>
#include <random>
#include <utility>

#include "latticeworld/common/files.h"
#include "latticeworld/common/text.h"
#include "latticeworld_ros/conversion/same_fields.h"

namespace latticeworld {
namespace {

using Request = latticeworld_msgs::GenerateWorld::Request;
using Goal = latticeworld_msgs::GenerateWorldTaskGoal;

static_assert(HaveSameFields<Request, Goal>(),
              "srv/GenerateWorld.srv and action/GenerateWorldTask.action ask for the same");

// The file's bytes. A relative path is looked for below each allowed directory in turn.
Result<std::string> ReadVisualFile(const std::string& path,
                                   const std::vector<std::filesystem::path>& directories) {
  // What is no path must not reach the file system, and neither the message as it is.
  LW_RETURN_IF_ERROR(ValidateText("visual_path", path, 4096));
  Result<std::string> bytes = ReadFileBelow(path, directories, kMaxVisualBytes);
  if (!std::filesystem::path(path).is_absolute()) {
    for (const auto& directory : directories) {
      bytes = ReadFileBelow(directory / path, directories, kMaxVisualBytes);
      const StatusCode code = bytes.status().code();
      if (code != StatusCode::kNotFound && code != StatusCode::kPermissionDenied) break;
    }
  }
  if (!bytes.ok()) return bytes.status().WithContext("visual_path");
  return bytes;
}

std::optional<VisualKind> KindOf(std::uint8_t constant) {
  switch (constant) {
    case Request::NONE:
      return VisualKind::kNone;
    case Request::HEIGHT_MAP:
      return VisualKind::kHeightMap;
    case Request::SKETCH:
      return VisualKind::kSketch;
    case Request::ELEVATION:
      return VisualKind::kElevation;
    default:
      return std::nullopt;
  }
}

template <typename Message>
void CheckVisual(const Message& fields, std::vector<Violation>* violations) {
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
template <typename Message>
Status TakeVisual(const Message& fields, const RequestDefaults& defaults,
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

template <typename Message>
Result<AcceptedRequest> ToGenerationRequest(const Message& message, const RequestDefaults& defaults,
                                            const WorldGenerator& generator,
                                            std::uint64_t drawn_seed) {
  std::vector<Violation> violations;
  CheckVisual(message, &violations);

  GenerationRequest request;
  if (violations.empty()) LW_RETURN_IF_ERROR(TakeVisual(message, defaults, &request));
  request.layout_instruction = message.layout_instruction;
  request.environment_instruction = message.environment_instruction;
  request.things = message.things;
  request.vocabulary = message.vocabulary;
  request.reader = message.reader.empty() ? defaults.reader : message.reader;
  request.generator = message.generator.empty() ? defaults.generator : message.generator;
  request.seed = message.seed != 0 ? message.seed : drawn_seed;
  if (message.size != 0.0) request.size_m = message.size;
  if (message.resolution != 0.0) request.resolution_m = message.resolution;

  Result<AcceptedRequest> accepted = generator.Accept(std::move(request));
  if (violations.empty()) return accepted;
  const std::vector<Violation>& of_core = accepted.status().violations();
  violations.insert(violations.end(), of_core.begin(), of_core.end());
  return Status::FromViolations("generate_world", std::move(violations));
}
template Result<AcceptedRequest> ToGenerationRequest(const Request&, const RequestDefaults&,
                                                     const WorldGenerator&, std::uint64_t);
template Result<AcceptedRequest> ToGenerationRequest(const Goal&, const RequestDefaults&,
                                                     const WorldGenerator&, std::uint64_t);

std::uint64_t DrawSeed() {
  std::random_device device;
  const std::uint64_t high = device(), low = device();
  return std::max<std::uint64_t>(1, (high << 32) | low);
}

}  // namespace latticeworld
