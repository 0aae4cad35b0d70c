#include "tools/commands/generate_command.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <filesystem>
#include <iostream>
#include <memory>
#include <random>
#include <string>
#include <utility>

#include "latticeworld/catalogue/catalogue.h"
#include "latticeworld/common/files.h"
#include "latticeworld/generation/bundle/bundle.h"
#include "latticeworld/generation/sketch_translator.h"
#include "latticeworld/generation/world_generator.h"
#include "tools/arguments.h"
#include "tools/interrupt.h"
#include "tools/language_arguments.h"
#include "tools/progress_display.h"
#include "tools/world_summary.h"

namespace latticeworld::tools {
namespace {

// A seed for a user who gave none: not 0, and short enough to be typed again.
std::uint64_t DrawSeed() {
  std::random_device device;
  return 1 + device() % 1000000000u;
}

// The file of the visual instruction that is given, if any is.
Status ReadVisualFile(const CLI::App& command, GenerationRequest* request) {
  constexpr std::pair<const char*, VisualKind> kOptions[] = {
      {"--height-map", VisualKind::kHeightMap},
      {"--sketch", VisualKind::kSketch},
      {"--elevation", VisualKind::kElevation}};
  for (const auto& [option, kind] : kOptions) {
    const auto file = ValueOf(command, option);
    if (!file) continue;
    auto content = ReadFile(*file, kMaxVisualBytes);
    if (!content.ok()) return content.status().WithContext(option);
    request->visual_kind = kind;
    request->visual = *std::move(content);
    request->visual_name = *file;
  }
  return Status();
}

constexpr std::size_t kMaxThingsBytes = 1u << 20;

Result<GenerationRequest> ReadRequest(const CLI::App& command) {
  GenerationRequest request;
  ArgumentReader arguments(&command);
  // Options of the relief are legal only beside the relief that they are for.
  arguments.AllowOneOf({"--height-map", "--sketch", "--elevation"});
  for (const char* option : {"--height-scale", "--height-offset"}) {
    arguments.RequireBesideOneOf(option, {"--height-map", "--sketch"});
  }
  arguments.RequireBeside("--sketch-model", "--sketch");
  for (const char* option : {"--at", "--keep-altitude", "--elevation-unit"}) {
    arguments.RequireBeside(option, "--elevation");
  }
  // Numbers and choices are read first, so that all that are wrong are told together.
  request.height_map.height_scale_m =
      arguments.Number("--height-scale", request.height_map.height_scale_m);
  request.height_map.height_offset_m =
      arguments.Number("--height-offset", request.height_map.height_offset_m);
  request.seed = arguments.Unsigned("--seed", 0);
  request.size_m = arguments.Number("--size", request.size_m);
  request.resolution_m = arguments.Number("--resolution", request.resolution_m);
  if (const auto place = arguments.NumberPair("--at")) {
    request.elevation.centered = false;
    request.elevation.latitude_deg = place->first;
    request.elevation.longitude_deg = place->second;
  }
  request.elevation.keep_altitude = !command.get_option("--keep-altitude")->empty();
  request.elevation.unit =
      *FromName<ElevationUnit>(arguments.Choice("--elevation-unit", {"degrees", "metres"}, ""));
  LW_RETURN_IF_ERROR(arguments.status());

  // Texts and files follow.
  if (request.seed == 0) request.seed = DrawSeed();
  request.vocabulary = ValueOf(command, "--vocabulary").value_or("");
  request.reader = ValueOf(command, "--reader").value_or("");
  request.generator = ValueOf(command, "--generator").value_or("");
  LW_ASSIGN_OR_RETURN(request.layout_instruction, TextOf(command, "--layout"));
  LW_ASSIGN_OR_RETURN(request.environment_instruction, TextOf(command, "--environment"));
  if (const auto file = ValueOf(command, "--things")) {
    auto things = ReadFile(*file, kMaxThingsBytes);
    if (!things.ok()) return things.status().WithContext("--things");
    request.things = *std::move(things);
  }
  LW_RETURN_IF_ERROR(ReadVisualFile(command, &request));
  return request;
}

// The request's members are told by the options that set them.
Status ByOptions(const Status& status) {
  if (status.violations().empty()) return status;
  static constexpr std::pair<std::string_view, std::string_view> kOptions[] = {
      {"layout_instruction", "--layout"}, {"environment_instruction", "--environment"},
      {"vocabulary", "--vocabulary"},     {"reader", "--reader"},
      {"generator", "--generator"},       {"size", "--size"},
      {"resolution", "--resolution"},     {"size / resolution", "--size / --resolution"}};
  std::vector<Violation> violations = status.violations();
  for (Violation& violation : violations)
    for (const auto& [member, option] : kOptions)
      if (violation.pointer == member) violation.pointer = option;
  return Status::FromViolations("unusable arguments", std::move(violations));
}

// What worlds are furnished with: the built-in catalogue and what the user adds to it.
Result<std::shared_ptr<const Catalogue>> CatalogueOf(const CLI::App& command) {
  const auto path = ValueOf(command, "--catalogue");
  if (!path) return Catalogue::BuiltIn();
  auto catalogue = Catalogue::Load({*path});
  if (!catalogue.ok()) return catalogue.status().WithContext("--catalogue");
  return catalogue;
}

// Whether a bundle can be written there, before any work is done for it.
Status CheckTarget(const std::filesystem::path& target) {
  return DirectoryWriter::Create(target).status().WithContext("--out");
}

Status Generate(const CLI::App& command) {
  LW_ASSIGN_OR_RETURN(GenerationRequest request, ReadRequest(command));
  std::filesystem::path target = *ValueOf(command, "--out");
  if (target.empty()) return InvalidArgument("--out: is empty; give the directory to be made");
  if (!target.has_filename()) target = target.parent_path();  // a trailing slash
  LW_ASSIGN_OR_RETURN(LanguageStack language, LoadLanguage(command));
  auto sketches = SketchTranslator::Load(ValueOf(command, "--sketch-model").value_or(""));
  if (!sketches.ok()) return sketches.status().WithContext("--sketch-model");
  LW_ASSIGN_OR_RETURN(auto catalogue, CatalogueOf(command));
  WorldGenerator generator(std::move(language), *std::move(sketches), std::move(catalogue));
  auto accepted = generator.Accept(std::move(request));
  if (!accepted.ok()) return ByOptions(accepted.status());
  LW_RETURN_IF_ERROR(CheckTarget(target));

  // The shares are of the time of a default world; a language model reads as long as it reads.
  ProgressDisplay display({{"terrain", 0.36}, {"scene", 0.19}, {"save", 0.45}});
  Progress progress(
      [&display](std::string_view stage, double fraction) { display.Show(stage, fraction); });
  const CancelOnInterrupt cancel_on_interrupt(&progress);
  const auto world = generator.Generate(*std::move(accepted), progress);
  if (!world.ok()) {
    display.Clear();
    return world.status();
  }
  display.Show("save", 0.0);
  const Status saved = SaveBundle(**world, target);
  display.Clear();
  LW_RETURN_IF_ERROR(saved);

  PrintSummary(**world, StandardOutputIsTerminal(), &std::cout);
  std::cout << "bundle       " << target.string() << "\n";
  return Status();
}

}  // namespace

void AddGenerateCommand(CLI::App* app, int* exit_status) {
  CLI::App* command =
      app->add_subcommand("generate",
                          "Generates a world from words (and a height map, a sketch or real "
                          "elevation) and saves it as a bundle.");
  // These make the request: words, and a relief from a height map, a sketch or elevation.
  AddValueOption(command, "--layout", "TEXT",
                 "What the land looks like, in words; @FILE reads them from a file. Needed unless "
                 "there is a height map, a sketch or elevation.");
  AddValueOption(command, "--environment", "TEXT",
                 "Season, weather, time of day and what lives there; @FILE reads a file. Without "
                 "it, what --layout says of these; the rest follows from the layout.");
  AddValueOption(
      command, "--height-map", "FILE",
      "Relief: an 8- or 16-bit greyscale PNG, PGM or TIFF, 33 to 8193 pixels a side; of one "
      "that is not square the middle square.");
  AddValueOption(
      command, "--sketch", "FILE",
      "Relief: strokes on white, blue along valley floors, black along ridges; PNG, "
      "JPEG or TIFF, drawn, scanned or photographed; of one that is not square the middle "
      "square.");
  AddValueOption(command, "--sketch-model", "FILE",
                 "ONNX model that turns the sketch into land [the embedded method].");
  AddValueOption(command, "--elevation", "FILE",
                 "Relief: real land in true metres; GeoTIFF, SRTM .hgt or Arc/Info ASCII grid.");
  AddValueOption(command, "--at", "LAT,LON",
                 "Place in the elevation that becomes the world's centre, degrees (WGS 84) [the "
                 "middle of the data].");
  AddValueOption(command, "--things", "FILE",
                 "single things as JSON: kind, place or arrangement (docs/things.md)");
  AddValueOption(command, "--elevation-unit", "NAME",
                 "degrees or metres: of an ASCII grid, which names no coordinate system [judged by "
                 "its numbers].");
  // These set heights of the relief, and what the world is furnished with.
  command->add_flag("--keep-altitude",
                    "Heights as in the elevation; without it the lowest point becomes 0.");
  AddValueOption(command, "--height-scale", "METRES",
                 "Height from a black to a white pixel of the height map, 0 to 9000; from the "
                 "lowest to the highest point of a sketch's land, 1 to 9000 [100].");
  AddValueOption(command, "--height-offset", "METRES",
                 "Height of a black pixel of the height map, or of the lowest point of a "
                 "sketch's land, -9000 to 9000 [0].");
  AddValueOption(
      command, "--catalogue", "PATH",
      "Adds to what worlds are furnished with: a file (see latticeworld catalogue), or a "
      "directory of them.");
  AddValueOption(command, "--vocabulary", "NAME", "suburb or wild. Without it the words decide.");
  // These say who reads and generates, and set the seed, the grid and the bundle.
  AddLanguageOptions(command);
  AddValueOption(command, "--seed", "N",
                 "The same request and seed give the same world. 0 or none: one is drawn and "
                 "shown.");
  AddValueOption(command, "--size", "METRES", "Side of the world, 16 to 8192 [512].");
  AddValueOption(command, "--resolution", "METRES",
                 "Side of a cell, 0.05 to 16 [0.5]. A side has 32 to 8192 cells.");
  AddValueOption(command, "--out", "DIR", "The bundle: a directory that does not exist yet.");
  command->get_option("--out")->required();
  command->callback([command, exit_status] {
    const Status status = Generate(*command);
    if (!status.ok()) *exit_status = ReportFailure("generate", status);
  });
}

}  // namespace latticeworld::tools
