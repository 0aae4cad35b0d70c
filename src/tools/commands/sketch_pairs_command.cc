#include "tools/commands/sketch_pairs_command.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <cstdio>
#include <string>
#include <string_view>

#include "latticeworld/dataset/sources/sketch_pairs.h"
#include "tools/arguments.h"
#include "tools/interrupt.h"
#include "tools/progress_display.h"

namespace latticeworld::tools {
namespace {

Status WritePairs(const CLI::App& command) {
  ArgumentReader arguments(&command);
  SketchPairOptions options;
  options.count = static_cast<std::size_t>(arguments.Integer("--count", 1, 1000000, 1000));
  options.side = arguments.Whole("--side", options.side);
  options.seed = arguments.Unsigned("--seed", options.seed);
  options.threads = arguments.Whole("--threads", options.threads);
  const FieldNames names = {{"count", "--count"}, {"side", "--side"}, {"threads", "--threads"}};
  if (!arguments.status().ok()) {
    arguments.AddIllegal(names, Validate(options));
    return arguments.status();
  }
  const std::string out = *ValueOf(command, "--out");
  ProgressDisplay display;
  Progress progress(
      [&display](std::string_view stage, double fraction) { display.Show(stage, fraction); });
  const CancelOnInterrupt interrupt(&progress);
  const Result<std::size_t> made = WriteSketchPairs(options, out, progress);
  display.Clear();
  LW_RETURN_IF_ERROR(UnderOptions(names, made.status()));
  std::printf("%zu pairs in %s, %zu of them made by this call\n", options.count, out.c_str(),
              *made);
  return Status();
}

}  // namespace

void AddSketchPairsCommand(CLI::App* app, int* exit_status) {
  CLI::App* command = app->add_subcommand(
      "sketch-pairs",
      "Writes pairs of eroded land (16-bit PNG) and the sketch of it (PNG), which "
      "training/latticeworld_training/sketch_training.py trains a sketch model on. Goes on where a "
      "call with the same --seed and --side ended.");
  AddValueOption(command, "--out", "DIR", "Folder for the pairs.");
  command->get_option("--out")->required();
  AddValueOption(command, "--count", "N", "How many, 1 to 1000000 [1000].");
  AddValueOption(command, "--side", "N", "Samples a side, 64 to 1024 [256].");
  AddValueOption(command, "--seed", "N", "Another seed, other land [0].");
  AddValueOption(command, "--threads", "N", "0 for as many as cores [0].");
  command->callback([command, exit_status] {
    const Status status = WritePairs(*command);
    if (!status.ok()) *exit_status = ReportFailure("sketch-pairs", status);
  });
}

}  // namespace latticeworld::tools
