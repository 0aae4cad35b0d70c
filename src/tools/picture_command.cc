#include "tools/picture_command.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <filesystem>
#include <string>

#include "latticeworld/common/files.h"
#include "latticeworld/exporting/octree_view.h"
#include "latticeworld/exporting/picture.h"
#include "latticeworld/exporting/thematic_map.h"
#include "latticeworld/generation/bundle.h"
#include "tools/arguments.h"

namespace latticeworld::tools {
namespace {

constexpr int kMinWidth_px = 64;
constexpr int kMaxWidth_px = 4096;

Result<std::string> Draw(const Scene& scene, const std::string& view,
                         const PictureOptions& options) {
  if (view == "top") return DrawTopView(scene, options);
  if (view == "oblique") return DrawObliqueView(scene, options);
  if (view == "octomap") return DrawOctree(scene, options, Progress());
  if (const auto theme = FromName<MapTheme>(view)) return DrawThematicMap(scene, *theme, options);
  return DrawWorld(scene, options);
}

// The old picture, if any, stays until the new one is whole.
Status ReplaceFile(const std::filesystem::path& path, const std::string& content) {
  std::filesystem::path temporary = path;
  temporary += ".part";
  Status status = WriteFile(temporary, content);
  std::error_code error;
  if (status.ok()) {
    std::filesystem::rename(temporary, path, error);
    if (error) status = Internal("cannot rename to " + path.string() + ": " + error.message());
  }
  if (!status.ok()) std::filesystem::remove(temporary, error);
  return status;
}

Status Picture(const CLI::App& command) {
  ArgumentReader arguments(&command);
  PictureOptions options;
  options.width_px =
      static_cast<int>(arguments.Integer("--width", kMinWidth_px, kMaxWidth_px, options.width_px));
  const std::string view = arguments.Choice(
      "--view", {"world", "top", "oblique", "height", "hillshade", "classes", "sketch", "octomap"},
      "world");
  LW_RETURN_IF_ERROR(arguments.status());

  LW_ASSIGN_OR_RETURN(const auto world, LoadBundle(*ValueOf(command, "DIR")));
  LW_ASSIGN_OR_RETURN(const std::string png, Draw(*world->scene, view, options));
  return ReplaceFile(*ValueOf(command, "--out"), png).WithContext("--out");
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
      "top (from above, north up), oblique (from the south) or world (both); maps of one "
      "layer: height, hillshade, classes, sketch (as --sketch of generate takes it); "
      "octomap (its voxels from the south-east) [world].");
  command->callback([command, exit_status] {
    const Status status = Picture(*command);
    if (!status.ok()) *exit_status = ReportFailure("picture", status);
  });
}

}  // namespace latticeworld::tools
