#include "tools/commands/export_command.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "latticeworld/common/files.h"
#include "latticeworld/common/text.h"
#include "latticeworld/exporting/chosen_assets.h"
#include "latticeworld/exporting/gltf/world_glb.h"
#include "latticeworld/exporting/maps/geotiff.h"
#include "latticeworld/exporting/maps/height_arrays.h"
#include "latticeworld/exporting/maps/map_server.h"
#include "latticeworld/exporting/maps/point_cloud.h"
#include "latticeworld/exporting/simulators/mjcf_world.h"
#include "latticeworld/exporting/simulators/sdf_world.h"
#include "latticeworld/exporting/simulators/usd_world.h"
#include "latticeworld/generation/bundle/bundle.h"
#include "latticeworld/generation/bundle/bundle_files.h"
#include "latticeworld/mapping/octree/octree.h"
#include "latticeworld/mapping/traversability.h"
#include "latticeworld/species/species_catalogue.h"
#include "tools/arguments.h"
#include "tools/interrupt.h"
#include "tools/output_file.h"
#include "tools/progress_display.h"

namespace latticeworld::tools {
namespace {

namespace fs = std::filesystem;

// What was asked for; what is absent is the format's own.
struct Request {
  std::string format;
  fs::path out;
  std::optional<ExportRegion> region;
  std::optional<double> ground_step_m, spacing_m, resolution_m;
  std::optional<int> texture_px, detail, heightmap_size, heightmap_bits;
  std::optional<bool> small_plants;
  std::optional<MapValues> map_values;
  bool expand = false, agents = true;
  std::uint64_t seed = 0;
};

// Options that only some formats know.
struct OptionUse {
  const char* option;
  std::vector<std::string> formats;
};
const std::vector<OptionUse>& OptionUses() {
  static const std::vector<OptionUse> uses = {
      {"--region", {"glb", "usd", "sdf", "mjcf", "geotiff", "heights", "ply", "las"}},
      {"--expand", {"glb", "usd"}},
      {"--no-agents", {"glb"}},
      {"--ground-step", {"glb", "usd"}},
      {"--texture", {"glb", "usd", "sdf", "mjcf"}},
      {"--detail", {"glb", "usd", "sdf", "mjcf"}},
      {"--plants", {"glb", "usd", "sdf", "mjcf", "ply", "las"}},
      {"--heightmap-size", {"sdf"}},
      {"--heightmap-bits", {"sdf"}},
      {"--spacing", {"ply", "las"}},
      {"--seed", {"ply", "las"}},
      {"--map-values", {"map"}},
      {"--resolution", {"octomap"}}};
  return uses;
}

// What the formats call the options.
const FieldNames& OptionNames() {
  static const FieldNames names = {{"region", "--region"},
                                   {"ground_step_m", "--ground-step"},
                                   {"texture_px", "--texture"},
                                   {"detail", "--detail"},
                                   {"heightmap_vertices", "--heightmap-size"},
                                   {"heightmap_bits", "--heightmap-bits"},
                                   {"spacing_m", "--spacing"},
                                   {"resolution_m", "--resolution"}};
  return names;
}

std::vector<Violation> CheckUse(const CLI::App& command, const std::string& format) {
  std::vector<Violation> violations;
  for (const OptionUse& use : OptionUses()) {
    if (command.count(use.option) == 0) continue;
    bool fits = false;
    for (const std::string& legal : use.formats) fits = fits || legal == format;
    if (fits) continue;
    violations.push_back({"wrong_format", use.option,
                          "makes sense only beside --to " + Join(use.formats, ", "), ""});
  }
  return violations;
}

// "west,south,east,north" in metres; nullopt: those are not four numbers.
std::optional<ExportRegion> ParseRegion(const std::string& text) {
  const std::vector<std::string> parts = Split(text, ',');
  double values[4];
  if (parts.size() != 4) return std::nullopt;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const char* const end = parts[i].data() + parts[i].size();
    const auto read = std::from_chars(parts[i].data(), end, values[i]);
    if (read.ec != std::errc() || read.ptr != end) return std::nullopt;
  }
  return ExportRegion{values[0], values[1], values[2], values[3]};
}

Result<Request> ReadRequest(const CLI::App& command) {
  ArgumentReader arguments(&command);
  Request request;
  request.format = arguments.Choice(
      "--to", {"glb", "usd", "sdf", "mjcf", "geotiff", "heights", "map", "octomap", "ply", "las"},
      "glb");
  request.out = *ValueOf(command, "--out");
  // What is not given stays unset: formats have defaults of their own.
  const auto number = [&](const char* option, std::optional<double>* value) {
    if (command.count(option) > 0) *value = arguments.Number(option, 0.0);
  };
  const auto whole = [&](const char* option, std::optional<int>* value) {
    if (command.count(option) > 0) *value = arguments.Whole(option, 0);
  };
  number("--ground-step", &request.ground_step_m);
  number("--spacing", &request.spacing_m);
  number("--resolution", &request.resolution_m);
  whole("--texture", &request.texture_px);
  whole("--detail", &request.detail);
  whole("--heightmap-size", &request.heightmap_size);
  whole("--heightmap-bits", &request.heightmap_bits);
  if (command.count("--plants") > 0)
    request.small_plants = arguments.Choice("--plants", {"all", "large"}, "all") == "all";
  request.map_values =
      FromName<MapValues>(arguments.Choice("--map-values", {"graded", "trinary"}, ""));
  request.expand = command.count("--expand") > 0;
  request.agents = command.count("--no-agents") == 0;
  request.seed = arguments.Unsigned("--seed", 0);
  if (const auto text = ValueOf(command, "--region")) {
    request.region = ParseRegion(*text);
    if (!request.region) {
      arguments.Refuse("--region", *text,
                       "four numbers parted by commas, west,south,east,north [m]");
    }
  }
  arguments.AddIllegal({}, CheckUse(command, request.format));
  LW_RETURN_IF_ERROR(arguments.status());
  return request;
}

Result<std::string> Glb(const World& world, const Request& request, const Progress& progress) {
  WorldGlbOptions options;
  options.region = request.region;
  options.ground_step_m = request.ground_step_m;
  options.texture_px = request.texture_px.value_or(options.texture_px);
  options.detail = request.detail.value_or(options.detail);
  options.small_plants = request.small_plants.value_or(options.small_plants);
  options.expand = request.expand;
  options.agents = request.agents;
  return WorldGlb(*world.scene, *SpeciesCatalogue::BuiltIn(), options, progress);
}

Result<std::string> Points(const World& world, const Request& request, const Progress& progress) {
  PointCloudOptions options;
  options.region = request.region;
  options.spacing_m = request.spacing_m.value_or(options.spacing_m);
  options.small_plants = request.small_plants.value_or(options.small_plants);
  options.seed = request.seed;
  LW_ASSIGN_OR_RETURN(const auto points, SamplePoints(*world.scene, options, progress));
  if (request.format == "ply") return ToPly(points);
  return ToLas(points, world.geo);
}

Result<std::string> Octomap(const World& world, const Request& request, const Progress& progress) {
  OctreeOptions options;
  options.resolution_m = request.resolution_m.value_or(world.scene->geometry().resolution_m());
  LW_ASSIGN_OR_RETURN(const OctreeData data, BuildBinaryData(*world.scene, options, progress));
  return BinaryFile(data, options.resolution_m);
}

Result<std::vector<ExportFile>> Sdf(const World& world, const Request& request,
                                    const Progress& progress) {
  SdfOptions options;
  options.region = request.region;
  options.heightmap_vertices = request.heightmap_size.value_or(options.heightmap_vertices);
  options.heightmap_bits = request.heightmap_bits.value_or(options.heightmap_bits);
  options.texture_px = request.texture_px.value_or(options.texture_px);
  options.detail = request.detail.value_or(options.detail);
  options.small_plants = request.small_plants.value_or(options.small_plants);
  return SdfFiles(*world.scene, world.id, world.geo, options, progress);
}

Result<std::vector<ExportFile>> Mjcf(const World& world, const Request& request,
                                     const Progress& progress) {
  MjcfOptions options;
  options.region = request.region;
  options.texture_px = request.texture_px.value_or(options.texture_px);
  options.detail = request.detail.value_or(options.detail);
  options.small_plants = request.small_plants.value_or(options.small_plants);
  return MjcfFiles(*world.scene, world.id, world.geo, options, progress);
}

Result<std::vector<ExportFile>> Usd(const World& world, const Request& request,
                                    const Progress& progress) {
  UsdOptions options;
  options.region = request.region;
  options.ground_step_m = request.ground_step_m;
  options.texture_px = request.texture_px.value_or(options.texture_px);
  options.detail = request.detail.value_or(options.detail);
  options.small_plants = request.small_plants.value_or(options.small_plants);
  options.expand = request.expand;
  return UsdFiles(*world.scene, world.id, world.geo, options, progress);
}

Result<std::vector<ExportFile>> Heights(const World& world, const Request& request,
                                        const Progress& progress) {
  HeightArraysOptions options;
  options.region = request.region;
  return HeightFiles(*world.scene, world.id, world.geo, options, progress);
}

Result<std::vector<ExportFile>> Map(const World& world, MapValues values) {
  const Scene& scene = *world.scene;
  LW_ASSIGN_OR_RETURN(MapServerFiles map,
                      ToMapServer(BuildOccupancy(scene, RobotLimits()), scene.geometry(), values));
  return std::vector<ExportFile>{{"map.pgm", std::move(map.pgm)},
                                 {"map.yaml", std::move(map.yaml)}};
}

Result<std::string> File(const World& world, const Request& request, const Progress& progress) {
  if (request.format == "glb") return Glb(world, request, progress);
  if (request.format == "octomap") return Octomap(world, request, progress);
  return Points(world, request, progress);
}

Result<std::vector<ExportFile>> Folder(const World& world, const Request& request,
                                       const Progress& progress) {
  if (request.format == "sdf") return Sdf(world, request, progress);
  if (request.format == "mjcf") return Mjcf(world, request, progress);
  if (request.format == "usd") return Usd(world, request, progress);
  if (request.format == "heights") return Heights(world, request, progress);
  if (request.format == "map") return Map(world, request.map_values.value_or(MapValues::kGraded));
  GeoTiffOptions options;
  options.region = request.region;
  return GeoTiffFiles(*world.scene, world.geo, options, progress);
}

bool IsFolder(const std::string& format) {
  return format == "sdf" || format == "mjcf" || format == "usd" || format == "heights" ||
         format == "map" || format == "geotiff";
}

Status WriteFolder(const World& world, const Request& request, const Progress& progress,
                   std::size_t* bytes) {
  const fs::path target =
      request.out.has_filename() ? request.out : request.out.parent_path();  // "lake/"
  auto directory = DirectoryWriter::Create(target);
  if (!directory.ok()) return directory.status().WithContext("--out");
  LW_ASSIGN_OR_RETURN(const auto files, Folder(world, request, progress));
  for (const ExportFile& file : files) {
    LW_RETURN_IF_ERROR(directory->Write(file.name, file.content).WithContext("--out"));
    *bytes += file.content.size();
  }
  return directory->Commit().WithContext("--out");
}

Status WriteSingle(const World& world, const Request& request, const Progress& progress,
                   std::size_t* bytes) {
  LW_ASSIGN_OR_RETURN(const std::string content, File(world, request, progress));
  *bytes = content.size();
  return ReplaceFile(request.out, content).WithContext("--out");
}

// What readers that know no instances leave out; empty where the export has none.
std::string InstancesWarning(const World& world, const Request& request) {
  const bool usd = request.format == "usd";
  if ((request.format != "glb" && !usd) || request.expand) return "";
  const Scene& scene = *world.scene;
  if (ChooseAssets(scene, request.region.value_or(WholeWorld(scene.geometry())),
                   request.small_plants.value_or(true))
          .empty()) {
    return "";
  }
  return std::string("warning: ") + request.out.string() +
         ": plants, stones and buildings are instances (" +
         (usd ? "PointInstancer), of which newton shows one copy a model"
              : "EXT_mesh_gpu_instancing), which Blender, trimesh, Open3D and newton do not read") +
         ": --expand for them\n";
}

Status Export(const CLI::App& command) {
  LW_ASSIGN_OR_RETURN(Request request, ReadRequest(command));
  const std::string directory = *ValueOf(command, "DIR");
  LW_ASSIGN_OR_RETURN(const auto world, LoadBundle(directory));
  if (request.format == "map" && !request.map_values) {
    LW_ASSIGN_OR_RETURN(const Manifest manifest, ReadManifest(directory));
    request.map_values = manifest.map_values;
  }
  ProgressDisplay display;
  Progress progress(
      [&display](std::string_view stage, double fraction) { display.Show(stage, fraction); });
  const CancelOnInterrupt interrupt(&progress);
  std::size_t bytes = 0;
  Status status;
  try {
    status = IsFolder(request.format) ? WriteFolder(*world, request, progress, &bytes)
                                      : WriteSingle(*world, request, progress, &bytes);
  } catch (const std::bad_alloc&) {
    status = ResourceExhausted("not enough memory: take a --region, or less detail");
  }
  display.Clear();
  LW_RETURN_IF_ERROR(UnderOptions(OptionNames(), status));
  std::cout << request.out.string() << ": " << world->id << " as " << request.format << ", "
            << bytes << " bytes\n";
  std::cerr << InstancesWarning(*world, request);
  return Status();
}

}  // namespace

void AddExportCommand(CLI::App* app, int* exit_status) {
  CLI::App* command = app->add_subcommand(
      "export", "Writes a bundle's world, as it begins, in the formats of other programs.");
  // These say what is written, in which format and where.
  AddValueOption(command, "DIR", "DIR", "The bundle.");
  command->get_option("DIR")->required();
  AddValueOption(
      command, "--to", "FORMAT",
      "glb (glTF 2.0, one file), usd (Universal Scene Description, a folder), sdf (Gazebo, a "
      "folder), mjcf (MuJoCo, a folder), geotiff (elevation, water, classes, traversability: a "
      "folder), heights (arrays of NumPy, "
      "a folder), map (map_server, a folder), octomap (a .bt), ply, las (points, one "
      "file).");
  command->get_option("--to")->required();
  AddValueOption(command, "--out", "PATH",
                 "A file, which is replaced, or a folder, which must not be there yet.");
  command->get_option("--out")->required();
  // These change what is written; each names the formats that it is for.
  AddValueOption(command, "--region", "W,S,E,N",
                 "Only what stands there [m]: west, south, east, north [the whole world].");
  command->add_flag("--expand", "glb, usd: a node a thing, for readers that know no instances.");
  command->add_flag("--no-agents", "glb: without the agents.");
  AddValueOption(command, "--ground-step", "M",
                 "glb, usd: between vertices of the ground, 0.05 to 100 [the world's resolution].");
  AddValueOption(command, "--texture", "PX",
                 "glb, usd, sdf, mjcf: the ground's colours, 16 to 8192 a side at most [2048].");
  AddValueOption(command, "--detail", "N",
                 "glb, usd, sdf, mjcf: of the meshes, 0 (finest) to 2 [glb, usd: 1, others: 2].");
  AddValueOption(command, "--plants", "WHICH",
                 "all, or large: no grass, flowers and crops [sdf, mjcf: large, others: all].");
  AddValueOption(command, "--heightmap-size", "N",
                 "sdf: vertices a side, 2^n + 1 [as fine as the world, at most 2049].");
  AddValueOption(command, "--heightmap-bits", "N", "sdf: 16, or 8 for Gazebo classic [16].");
  AddValueOption(command, "--spacing", "M",
                 "ply, las: a point to so much squared of all surfaces, 0.02 to 100 [0.5].");
  AddValueOption(command, "--seed", "N", "ply, las: of the points' places on things [0].");
  AddValueOption(
      command, "--map-values", "WHICH",
      "map: graded, or trinary, 0, 100 and -1 alone, as map_saver writes [the bundle's].");
  AddValueOption(command, "--resolution", "M", "octomap: edge of a voxel [the world's].");
  command->callback([command, exit_status] {
    const Status status = Export(*command);
    if (!status.ok()) *exit_status = ReportFailure("export", status);
  });
}

}  // namespace latticeworld::tools
