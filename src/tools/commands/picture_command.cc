#include "tools/commands/picture_command.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/common/range.h"
#include "latticeworld/common/request_fields.h"
#include "latticeworld/generation/bundle/bundle.h"
#include "latticeworld/rendering/picture.h"
#include "latticeworld/rendering/views/close_view.h"
#include "latticeworld/rendering/views/contact_sheet.h"
#include "latticeworld/rendering/views/octree_view.h"
#include "latticeworld/rendering/views/thematic_map.h"
#include "tools/arguments.h"
#include "tools/output_file.h"

namespace latticeworld::tools {
namespace {

constexpr double kDegree = M_PI / 180.0;
constexpr Range kPitches_deg = {-80.0, 80.0};
constexpr Range kHeadings_deg = {-3600.0, 3600.0};

// What a picture and its view call the options.
const FieldNames& OptionNames() {
  static const FieldNames names = {{"width", "--width"},
                                   {"position", "--at"},
                                   {"position x", "--at x"},
                                   {"position y", "--at y"},
                                   {"eye_height", "--eye"}};
  return names;
}

// The view that --at and what stands beside it ask for.
Result<CloseView> ReadCloseView(const CLI::App& command, const Scene& scene) {
  ArgumentReader arguments(&command);
  CloseView view;
  view.name = "close";
  const auto at = arguments.NumberPair("--at");
  const double heading_deg = arguments.Number("--heading", 90.0);
  const double pitch_deg = arguments.Number("--pitch", view.pitch_rad / kDegree);
  view.eye_height_m = arguments.Number("--eye", view.eye_height_m);
  LW_RETURN_IF_ERROR(arguments.status());
  view.position = {at->first, at->second};
  // Legal are those of a view, in degrees: what is not is told beside what the view says of the
  // rest.
  std::vector<Violation> violations;
  CheckRange("--heading", heading_deg, kHeadings_deg, " deg", &violations);
  CheckRange("--pitch", pitch_deg, kPitches_deg, " deg", &violations);
  if (!violations.empty()) {
    return RefuseUnread("--view close", std::move(violations), Validate(scene, view));
  }
  view.heading_rad = heading_deg * kDegree;
  view.pitch_rad = pitch_deg * kDegree;
  return view;
}

Result<std::string> DrawClose(const CLI::App& command, const Scene& scene, const std::string& view,
                              const PictureOptions& options) {
  if (ValueOf(command, "--at")) {
    LW_ASSIGN_OR_RETURN(const CloseView asked, ReadCloseView(command, scene));
    return DrawCloseView(scene, asked, options);
  }
  const std::vector<CloseView> views = ChooseViews(scene);
  if (view == "close") return DrawCloseViews(scene, views, options);
  std::string known;
  for (const CloseView& candidate : views) {
    if (candidate.name == view) return DrawCloseView(scene, candidate, options);
    if (candidate.name == "middle") continue;  // no view that can be asked for
    known += (known.empty() ? "; it has some for: " : ", ") + candidate.name;
  }
  return NotFound("this world has no place for --view " + view + known);
}

Result<std::string> Draw(const CLI::App& command, const World& world, const std::string& view,
                         const PictureOptions& options) {
  const Scene& scene = *world.scene;
  if (view == "top") return DrawTopView(scene, options);
  if (view == "oblique") return DrawObliqueView(scene, options);
  if (view == "close" || view == "street" || view == "shore" || view == "forest" || view == "hill")
    return DrawClose(command, scene, view, options);
  if (view == "sheet") return DrawContactSheet(scene, world.request.seed, options);
  if (view == "octomap") return DrawOctree(scene, options, Progress());
  if (const auto theme = FromName<MapTheme>(view)) return DrawThematicMap(scene, *theme, options);
  return DrawWorld(scene, options);
}

Status Picture(const CLI::App& command) {
  ArgumentReader arguments(&command);
  PictureOptions options;
  options.width_px = arguments.Whole("--width", options.width_px);
  options.quick = command.count("--quick") > 0;
  const std::string view =
      arguments.Choice("--view",
                       {"world", "top", "oblique", "close", "street", "shore", "forest", "hill",
                        "sheet", "height", "hillshade", "classes", "sketch", "octomap"},
                       "world");
  for (const char* option : {"--heading", "--pitch", "--eye"})
    arguments.RequireBeside(option, "--at");
  if (view != "close" && ValueOf(command, "--at")) {
    arguments.AddIllegal({},
                         {{"missing_option", "--at", "makes sense only beside --view close", ""}});
  }
  // What is not a number is found before the world is loaded.
  arguments.NumberPair("--at");
  for (const char* option : {"--heading", "--pitch", "--eye"}) arguments.Number(option, 0.0);
  LW_RETURN_IF_ERROR(arguments.status());

  LW_ASSIGN_OR_RETURN(const auto world, LoadBundle(*ValueOf(command, "DIR")));
  const Result<std::string> png = Draw(command, *world, view, options);
  LW_RETURN_IF_ERROR(UnderOptions(OptionNames(), png.status()));
  return ReplaceFile(*ValueOf(command, "--out"), *png).WithContext("--out");
}

}  // namespace

void AddPictureCommand(CLI::App* app, int* exit_status) {
  CLI::App* command = app->add_subcommand("picture", "Draws the world of a bundle as a PNG.");
  AddValueOption(command, "DIR", "DIR", "The bundle.");
  command->get_option("DIR")->required();
  AddValueOption(command, "--out", "FILE", "The picture; an existing one is replaced.");
  command->get_option("--out")->required();
  AddValueOption(command, "--width", "PX", "Width of one view, 64 to 4096 [1200].");
  AddValueOption(
      command, "--view", "NAME",
      "top (from above, north up), oblique (from the south) or world (both); close (what somebody "
      "in the world sees, at --at or at places that are worth it), or one of those places: street, "
      "shore, forest, hill; sheet (the world in all seasons, weathers, hours and styles); maps of "
      "one layer: height, hillshade, classes, sketch (as --sketch of generate takes it); octomap "
      "(its voxels from the south-east) [world].");
  command->add_flag("--quick", "Views from the side and close ones: coarse shapes, plain light.");
  AddValueOption(command, "--at", "X,Y", "Where a close view is from [m], east and north.");
  AddValueOption(command, "--heading", "DEG",
                 "Where it looks: 0 east, counter-clockwise [90, north].");
  AddValueOption(command, "--pitch", "DEG", "How far up from level it looks, -80 to 80 [-2.3].");
  AddValueOption(command, "--eye", "M", "How high the eye is above ground or water [1.7].");
  command->callback([command, exit_status] {
    const Status status = Picture(*command);
    if (!status.ok()) *exit_status = ReportFailure("picture", status);
  });
}

}  // namespace latticeworld::tools
