#include "tools/commands/rebuild_command.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/common/text.h"
#include "latticeworld/generation/bundle/bundle.h"
#include "latticeworld/generation/bundle/bundle_files.h"
#include "latticeworld/generation/bundle/rebuild.h"
#include "latticeworld/generation/sketch_translator.h"
#include "tools/arguments.h"
#include "tools/interrupt.h"
#include "tools/progress_display.h"

namespace latticeworld::tools {
namespace {

Status Rebuild(const CLI::App& command) {
  const std::string directory = *ValueOf(command, "DIR");
  LW_ASSIGN_OR_RETURN(const auto recorded, LoadBundle(directory));
  auto sketches = SketchTranslator::Load(ValueOf(command, "--sketch-model").value_or(""));
  if (!sketches.ok()) return sketches.status().WithContext("--sketch-model");
  ProgressDisplay display;
  Progress progress(
      [&display](std::string_view stage, double fraction) { display.Show(stage, fraction); });
  const CancelOnInterrupt cancel_on_interrupt(&progress);
  const auto rebuilt = RebuildWorld(*recorded, progress, *std::move(sketches));
  display.Clear();
  if (!rebuilt.ok()) return rebuilt.status();
  LW_ASSIGN_OR_RETURN(const Manifest before, ReadManifest(directory));
  if (const auto out = ValueOf(command, "--out")) {
    LW_RETURN_IF_ERROR(SaveBundle(**rebuilt, *out, before.map_values));
  }
  LW_ASSIGN_OR_RETURN(const Manifest after, MakeManifest(**rebuilt, before.map_values));
  const std::vector<std::string> differing = DifferingFiles(before, after);
  if (!differing.empty()) {
    return FailedPrecondition("the bundle holds " + recorded->id + ", but this program makes " +
                              (before.world_id == after.world_id ? "the same" : after.world_id) +
                              " of its request and replies with other bytes in " +
                              Join(differing, ", "));
  }
  const auto replies = std::count_if(recorded->replies.begin(), recorded->replies.end(),
                                     [](const ModelReply& reply) { return reply.failure.ok(); });
  std::cout << recorded->id << ": made again, the same, from " << replies << " recorded replies\n";
  return Status();
}

}  // namespace

void AddRebuildCommand(CLI::App* app, int* exit_status) {
  CLI::App* command = app->add_subcommand(
      "rebuild",
      "Makes a bundle's world again from its request and its model's recorded replies, without the "
      "model, and says whether it is the same, byte for byte, or which files differ.");
  AddValueOption(command, "DIR", "DIR", "The bundle.");
  command->get_option("DIR")->required();
  AddValueOption(command, "--sketch-model", "FILE",
                 "The ONNX model that the world's sketch became land by, where one did.");
  AddValueOption(command, "--out", "DIR",
                 "Saves it there as a bundle of its own, the same or not.");
  command->callback([command, exit_status] {
    const Status status = Rebuild(*command);
    if (!status.ok()) *exit_status = ReportFailure("rebuild", status);
  });
}

}  // namespace latticeworld::tools
