#include "tools/commands/dataset_command.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/common/text.h"
#include "latticeworld/dataset/writing/dataset_writer.h"
#include "tools/arguments.h"
#include "tools/dataset_sources.h"
#include "tools/interrupt.h"
#include "tools/progress_display.h"

namespace latticeworld::tools {
namespace {

// Progress is shown this often over all groups, so that logs stay short.
constexpr std::size_t kSteps = 50;

bool IsGiven(const CLI::App& command, const std::string& name) {
  return command.get_option(name)->count() > 0;
}

Result<DatasetOptions> ReadOptions(const CLI::App& command) {
  ArgumentReader reader(&command);
  DatasetOptions options;
  options.seed = reader.Unsigned("--seed", options.seed);
  options.threads = reader.Whole("--threads", options.threads);
  options.size_m = reader.Number("--size", options.size_m);
  const auto split = reader.NumberPair("--split");
  const std::string prompts = reader.Choice("--prompts", {"full", "short"}, "full");
  const std::string layouts = reader.Choice("--layouts", {"source", "grounded"}, "source");
  reader.AllowOneOf({"--layout", "--environment"});
  if (split) {
    options.train_share = split->first;
    options.validation_share = split->second;
  }
  options.prompts = *FromName<PromptForm>(prompts);
  options.layouts = *FromName<LayoutsBy>(layouts);
  options.images = !IsGiven(command, "--no-images");
  if (IsGiven(command, "--layout")) options.environment = false;
  if (IsGiven(command, "--environment")) options.layout = false;
  if (ValueOf(command, "--annotator") == "remote") options.groups_per_part = kGroupsPerRemotePart;
  // Asked before the source is looked at, which takes longer.
  reader.AddIllegal({{"train_share", "--split"},
                     {"validation_share", "--split"},
                     {"size", "--size"},
                     {"threads", "--threads"}},
                    Validate(options));
  LW_RETURN_IF_ERROR(reader.status());
  return options;
}

std::string TimeText(double seconds) {
  char text[32];
  const long whole = std::lround(seconds);
  std::snprintf(text, sizeof(text), "%ld:%02ld:%02ld", whole / 3600, whole / 60 % 60, whole % 60);
  return text;
}

// Shows how many groups are done, how fast, and how long the rest will take at that.
class GroupDisplay {
 public:
  explicit GroupDisplay(ProgressDisplay* display)
      : display_(display), begin_(std::chrono::steady_clock::now()) {}

  void Show(const DatasetProgress& where) {
    const std::size_t step = where.groups_done * kSteps / std::max<std::size_t>(where.groups, 1);
    if (where.groups_here > 0 && step == step_ && where.groups_done < where.groups) return;
    step_ = step;
    std::string text =
        std::to_string(where.groups_done) + " of " + std::to_string(where.groups) + " groups";
    if (where.groups_here > 0) {
      const double gone_s =
          std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
      const double per_second = static_cast<double>(where.groups_here) / std::max(gone_s, 1e-3);
      const auto left = static_cast<double>(where.groups - where.groups_done);
      text += ", " + std::to_string(std::lround(per_second)) + " a second, " +
              TimeText(left / per_second) + " left";
    }
    display_->Show(text, static_cast<double>(where.groups_done) /
                             static_cast<double>(std::max<std::size_t>(where.groups, 1)));
  }

 private:
  ProgressDisplay* display_;
  std::size_t step_ = 0;
  std::chrono::steady_clock::time_point begin_;
};

// What a server that cannot be had leaves, beside what was wrong with it.
Status WithWayOn(const Status& status) {
  const bool outage =
      status.code() == StatusCode::kUnavailable || status.code() == StatusCode::kDeadlineExceeded;
  if (!outage) return status;
  return Status(status.code(),
                status.message() + "; what is whole stays, and --resume goes on with it");
}

// The command without what changes no byte of the result, and without places on this machine.
std::string CommandText(const CLI::App& command) {
  std::string text = "latticeworld dataset";
  for (const CLI::Option* option : command.get_options()) {
    const std::string name = option->get_name();
    if (option->count() == 0 || name == "--resume" || name == "--threads" || name == "--out")
      continue;
    text += " " + name;
    if (option->get_expected_min() == 0) continue;  // a flag
    const std::string kind = option->get_type_name();
    const bool place = kind == "DIR" || kind == "FILE" || StartsWith(name, "--remote-");
    text += " " + (place ? kind : option->results().front());
  }
  return text + " --out DIR";
}

// Everything that is illegal in one; where nothing is, the first failure of another kind.
Status Together(const std::vector<Status>& statuses) {
  std::vector<Violation> violations;
  for (const Status& status : statuses) {
    if (status.violations().empty() && status.code() == StatusCode::kInvalidArgument) {
      violations.push_back({"illegal_value", "", status.message(), ""});
    }
    violations.insert(violations.end(), status.violations().begin(), status.violations().end());
  }
  LW_RETURN_IF_ERROR(Status::FromViolations("unusable arguments", std::move(violations)));
  for (const Status& status : statuses) LW_RETURN_IF_ERROR(status);
  return Status();
}

Status RunDataset(const CLI::App& command) {
  DatasetJob job;
  const Result<DatasetOptions> options = ReadOptions(command);
  if (options.ok()) job.options = *options;
  const auto source = MakeDatasetSource(command);
  const auto annotator = MakeDatasetAnnotator(command, job.options.size_m);
  LW_RETURN_IF_ERROR(Together({options.status(), source.status(), annotator.status()}));
  job.source = source->get();
  job.annotator = annotator->get();
  job.out = *ValueOf(command, "--out");
  job.resume = IsGiven(command, "--resume");
  job.version = LATTICEWORLD_VERSION;
  job.command = CommandText(command);

  Progress progress;
  const CancelOnInterrupt cancel_on_interrupt(&progress);
  ProgressDisplay display;
  GroupDisplay groups(&display);
  const auto written =
      WriteDataset(job, progress, [&groups](const DatasetProgress& where) { groups.Show(where); });
  display.Clear();
  if (!written.ok()) return WithWayOn(written.status());
  std::printf("%zu instances", written->instances);
  for (std::size_t task = 0; task < kDatasetTasks; ++task) {
    if (written->records[task] == 0) continue;
    const std::string name(NameOf(static_cast<DatasetTask>(task)));
    std::printf(", %zu records for %s", written->records[task], name.c_str());
  }
  if (written->failed > 0)
    std::printf("; %zu left out, see %s", written->failed, (job.out / "dataset.json").c_str());
  std::printf("\n");
  return Status();
}

}  // namespace

void AddDatasetCommand(CLI::App* app, int* exit_status) {
  CLI::App* command = app->add_subcommand(
      "dataset",
      "Writes training data: places with instructions that are true of them, as JSON Lines in "
      "chat format with images, splits, a manifest and a data card (docs/datasets.md).");
  AddValueOption(command, "--out", "DIR", "Folder for the data set.");
  command->get_option("--out")->required();
  AddDatasetSourceOptions(command);
  AddValueOption(command, "--seed", "N", "Of the places that are generated and of the words [0].");
  command->add_flag("--layout", "Only instructions for layouts.");
  command->add_flag("--environment", "Only instructions for environments.");
  command->add_flag("--no-images", "No height maps and sketches, and nothing that needs them.");
  AddValueOption(command, "--prompts", "FORM",
                 "full: what a model is sent; short: without the system message [full].");
  AddValueOption(command, "--layouts", "WHOSE",
                 "source: the places that instructions were written for; grounded: what the "
                 "embedded generator answers to them [source].");
  AddValueOption(command, "--split", "TRAIN,VALIDATION",
                 "Shares of the groups; the rest is for tests [0.9,0.05].");
  AddValueOption(command, "--size", "M",
                 "Side of the world that environments are for, 16 to 8192 [512].");
  AddValueOption(command, "--threads", "N", "0 to 256 [0: as many as cores].");
  command->add_flag("--resume", "Goes on in DIR where it was broken off.");
  command->callback([command, exit_status] {
    const Status status = RunDataset(*command);
    if (!status.ok()) *exit_status = ReportFailure("dataset", status);
  });
}

}  // namespace latticeworld::tools
