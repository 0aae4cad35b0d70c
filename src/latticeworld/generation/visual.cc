#include "latticeworld/generation/visual.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "latticeworld/common/random.h"
#include "latticeworld/common/text.h"
#include "latticeworld/relief/elevation/elevation.h"
#include "latticeworld/relief/sketch/sketch.h"

namespace latticeworld {
namespace {

constexpr std::size_t kMaxNameBytes = 4096;
// Samples a side of a sketch's relief. A sketch says no more than these hold, however many cells
// the world has.
constexpr int kMinSketchSamples = 64;
constexpr int kMaxSketchSamples = 2048;

// What a kind is read from, for messages.
std::string_view FormatsOf(VisualKind kind) {
  switch (kind) {
    case VisualKind::kNone:
      return "";
    case VisualKind::kHeightMap:
      return "a PNG, PGM or TIFF";
    case VisualKind::kSketch:
      return "a PNG, JPEG or TIFF";
    case VisualKind::kElevation:
      return "a GeoTIFF, an SRTM .hgt or an Arc/Info ASCII grid";
  }
  return "";
}

SketchOptions SketchOptionsOf(const GenerationRequest& request, const GridGeometry& geometry) {
  SketchOptions options;
  options.samples = std::clamp(geometry.rows(), kMinSketchSamples, kMaxSketchSamples);
  options.size_m = geometry.size_m();
  options.height_scale_m = request.height_map.height_scale_m;
  options.height_offset_m = request.height_map.height_offset_m;
  options.seed = StreamSeed(request.seed, "relief");
  return options;
}

ElevationOptions ElevationOptionsOf(const GenerationRequest& request,
                                    const GridGeometry& geometry) {
  ElevationOptions options;
  options.size_m = geometry.size_m();
  options.resolution_m = geometry.resolution_m();
  options.centered = request.elevation.centered;
  options.latitude_deg = request.elevation.latitude_deg;
  options.longitude_deg = request.elevation.longitude_deg;
  options.keep_altitude = request.elevation.keep_altitude;
  options.unit = request.elevation.unit;
  return options;
}

bool IsKnown(VisualKind kind) {
  for (const auto& entry : EnumNames(kind)) {
    if (entry.value == kind) return true;
  }
  return false;
}

}  // namespace

std::vector<Violation> ValidateVisualOptions(const GenerationRequest& request) {
  // Size and resolution are checked where the whole request is.
  const GridGeometry any = GridGeometry::FromCells(kMinSketchSamples, kMaxSize_m);
  switch (request.visual_kind) {
    case VisualKind::kNone:
      break;
    case VisualKind::kHeightMap:
      return Validate(request.height_map);
    case VisualKind::kSketch:
      return Validate(SketchOptionsOf(request, any));
    case VisualKind::kElevation: {
      ElevationOptions options = request.elevation;
      options.size_m = ElevationOptions().size_m;
      options.resolution_m = ElevationOptions().resolution_m;
      return Validate(options);
    }
  }
  return {};
}

std::vector<Violation> ValidateVisual(const GenerationRequest& request,
                                      const SketchTranslator& sketches) {
  // Without a kind that is known and wanted nothing else can be said.
  if (!IsKnown(request.visual_kind)) {
    const std::string given = std::to_string(static_cast<int>(request.visual_kind));
    return {{"unknown_value", "visual_kind",
             "is " + given + "; legal are " + LegalNames<VisualKind>(), given}};
  }
  if (request.visual_kind == VisualKind::kNone) {
    if (request.visual.empty()) return {};
    return {{"visual_without_kind", "visual_kind",
             "a picture is given, so its kind must be height_map, sketch or elevation, not none",
             "none"}};
  }
  // All else that is wrong is told together: bytes, name, translator and options.
  const std::string name(NameOf(request.visual_kind));
  std::vector<Violation> violations;
  if (request.visual.empty()) {
    violations.push_back({"missing_visual", "visual",
                          "visual_kind is " + name + ", but none is given; give the bytes of " +
                              std::string(FormatsOf(request.visual_kind)) + ", or visual_kind none",
                          ""});
  }
  if (request.visual.size() > kMaxVisualBytes) {
    const std::string given = std::to_string(request.visual.size());
    violations.push_back({"out_of_range", "visual",
                          "the " + name + " is " + given + " bytes long; at most " +
                              std::to_string(kMaxVisualBytes) + " are legal",
                          given});
  }
  if (const Status status = ValidateText("visual_name", request.visual_name, kMaxNameBytes);
      !status.ok()) {
    violations.push_back({"illegal_value", "visual_name", status.message(), ""});
  }
  if (request.visual_kind == VisualKind::kSketch && !request.sketch_translator.empty() &&
      request.sketch_translator != sketches.name()) {
    violations.push_back({"unknown_value", "sketch_translator",
                          "is " + Quote(request.sketch_translator) +
                              "; here sketches become land " + "by " + sketches.name() +
                              " alone: legal is that, or none",
                          request.sketch_translator});
  }
  for (Violation& violation : ValidateVisualOptions(request)) {
    violations.push_back(std::move(violation));
  }
  return violations;
}

void ResolveVisual(const SketchTranslator& sketches, GenerationRequest* request) {
  const VisualKind kind = request->visual_kind;
  request->sketch_translator = kind == VisualKind::kSketch ? sketches.name() : "";
  if (kind != VisualKind::kHeightMap && kind != VisualKind::kSketch) {
    request->height_map = HeightMapOptions();
  }
  if (kind != VisualKind::kElevation) {
    request->elevation = ElevationOptions();
    request->visual_name.clear();
    return;
  }
  const ElevationOptions given = request->elevation;
  request->elevation = ElevationOptions();
  request->elevation.keep_altitude = given.keep_altitude;
  request->elevation.unit = given.unit;
  request->elevation.centered = given.centered;
  if (!given.centered) {
    request->elevation.latitude_deg = given.latitude_deg;
    request->elevation.longitude_deg = given.longitude_deg;
  }
  const std::size_t slash = request->visual_name.find_last_of("/\\");
  if (slash != std::string::npos) request->visual_name.erase(0, slash + 1);
}

Result<std::optional<Relief>> ReadVisual(const GenerationRequest& request,
                                         const SketchTranslator& sketches,
                                         const GridGeometry& geometry, const Progress& progress) {
  const auto read = [&]() -> Result<Relief> {
    switch (request.visual_kind) {
      case VisualKind::kSketch:
        return sketches.Translate(request.visual, SketchOptionsOf(request, geometry), progress);
      case VisualKind::kElevation:
        return ReadElevation(request.visual, request.visual_name,
                             ElevationOptionsOf(request, geometry));
      default:
        return ReadHeightMap(request.visual, request.height_map);
    }
  };
  if (request.visual_kind == VisualKind::kNone) return std::optional<Relief>();
  LW_ASSIGN_OR_RETURN(Relief relief, read());
  return std::optional<Relief>(std::move(relief));
}

}  // namespace latticeworld
