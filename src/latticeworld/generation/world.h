#ifndef LATTICEWORLD_GENERATION_WORLD_H_
#define LATTICEWORLD_GENERATION_WORLD_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "latticeworld/common/enum_names.h"
#include "latticeworld/environment/environment_config.h"
#include "latticeworld/generation/fidelity/fidelity.h"
#include "latticeworld/geometry/grid_geometry.h"
#include "latticeworld/language/generator.h"
#include "latticeworld/layout/symbolic_layout.h"
#include "latticeworld/relief/elevation/elevation.h"
#include "latticeworld/relief/relief.h"
#include "latticeworld/scene/scene.h"

namespace latticeworld {

enum class VisualKind : std::uint8_t { kNone, kHeightMap, kSketch, kElevation };

constexpr std::array<EnumName<VisualKind>, 4> EnumNames(VisualKind) {
  return {{{VisualKind::kNone, "none"},
           {VisualKind::kHeightMap, "height_map"},
           {VisualKind::kSketch, "sketch"},
           {VisualKind::kElevation, "elevation"}}};
}

// A 16-bit picture of the largest legal size, uncompressed, and its header.
inline constexpr std::size_t kMaxVisualBytes = 256u << 20;

// What a person asks for. Empty and zero fields have a meaning, so that text alone is enough.
struct GenerationRequest {
  std::string layout_instruction;       // x_L; may be empty only with a visual instruction
  std::string environment_instruction;  // x_C; may be empty
  std::string things;                   // single things as JSON (things_of_json.h); "": none
  VisualKind visual_kind = VisualKind::kNone;
  std::string visual;             // bytes of the picture or file, at most kMaxVisualBytes
  std::string visual_name;        // the file's own; only SRTM elevation needs it ("N40W106.hgt")
  std::string sketch_translator;  // "": the generator's; "embedded", or a model's name
  HeightMapOptions height_map;    // of a height map, and of a sketch; else not looked at
  ElevationOptions elevation;  // of elevation, but for size_m and resolution_m; else not looked at
  std::string vocabulary;  // "": chosen from the text, "wild" for a picture alone; "suburb", "wild"
  std::string reader;      // who reads the instructions; "": the default one
  std::string generator;   // who answers them; "": the default one
  std::uint64_t seed = 0;  // never 0 here: callers draw one for a user who gave none
  double size_m = 512.0;
  double resolution_m = 0.5;
};

struct StageTime {
  std::string name;
  double seconds = 0.0;
};

// A generated world. Immutable and shared.
struct World {
  std::string id;  // "world-<first 12 digits of the content's SHA-256>": same content, same id
  GenerationRequest request;  // as resolved: vocabulary, reader, generator and translator filled in
  SymbolicLayout layout;
  EnvironmentConfig environment;
  std::shared_ptr<const Scene> scene;
  std::optional<GeoOrigin> geo;     // where it lies on the earth; nullopt: nowhere
  FidelityReport fidelity;          // how well it matches the words
  std::vector<ModelReply> replies;  // of a language model, layout first; empty: none was asked
  std::vector<std::string> warnings;
  std::vector<StageTime> stages;  // in order: relief, layout, environment, terrain, scene
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_GENERATION_WORLD_H_
