#include "tools/commands/campaign_command.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <string>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "latticeworld/campaign/reports/metric_fields.h"
#include "latticeworld/campaign/reports/report.h"
#include "latticeworld/campaign/workers/campaign_folder.h"
#include "latticeworld/campaign/workers/dispatcher.h"
#include "latticeworld/campaign/workers/slurm_job.h"
#include "latticeworld/campaign/workers/worker.h"
#include "latticeworld/common/folder_lock.h"
#include "latticeworld/common/text.h"
#include "tools/arguments.h"
#include "tools/interrupt.h"
#include "tools/output_file.h"
#include "tools/progress_display.h"

namespace latticeworld::tools {
namespace {

namespace fs = std::filesystem;

// Progress is shown this often over all trials, so that logs stay short.
constexpr std::size_t kParts = 50;

struct CampaignArguments {
  fs::path file, out;
  int workers = 1;
  int shard = 0, shards = 1;
  double trial_time_s = 900.0;
};

bool IsGiven(const CLI::App& command, const std::string& name) {
  return command.get_option(name)->count() > 0;
}

Status BadShard(const std::string& given) {
  return Status::FromViolations(
      "unusable arguments",
      {{"bad_value", "--shard", "is " + Quote(given) + "; legal is I/N, 0 <= I < N <= 10000",
        given}});
}

Status ReadShard(const CLI::App& command, CampaignArguments* arguments) {
  const auto given = ValueOf(command, "--shard");
  if (!given) return Status();
  char rest = 0;
  const int read =
      std::sscanf(given->c_str(), "%5d/%5d%c", &arguments->shard, &arguments->shards, &rest);
  if (read != 2 || arguments->shard < 0 || arguments->shard >= arguments->shards ||
      arguments->shards > 10000)
    return BadShard(*given);
  return Status();
}

Result<CampaignArguments> ReadArguments(const CLI::App& command) {
  CampaignArguments arguments;
  ArgumentReader reader(&command);
  const int cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  arguments.workers = static_cast<int>(reader.Integer("--workers", 1, 256, cores));
  arguments.trial_time_s = reader.Number("--trial-time", arguments.trial_time_s);
  reader.AllowOneOf({"--check", "--plan", "--only", "--merge", "--slurm", "--worker"});
  reader.RequireBeside("--shards", "--slurm");
  reader.RequireBeside("--track", "--only");
  LW_RETURN_IF_ERROR(reader.status());
  if (!(arguments.trial_time_s >= 1.0)) {
    return InvalidArgument("--trial-time: is " + FormatDouble(arguments.trial_time_s) +
                           "; legal is 1 and more");
  }
  LW_RETURN_IF_ERROR(ReadShard(command, &arguments));
  arguments.file = *ValueOf(command, "FILE");
  arguments.out = ValueOf(command, "--out").value_or("");
  if (arguments.out.empty() && !IsGiven(command, "--check") && !IsGiven(command, "--plan"))
    return InvalidArgument("--out: is missing; give the folder for the results");
  return arguments;
}

// This program, wherever it was started from.
Result<fs::path> ThisProgram() {
  std::error_code error;
  fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (error) return Internal("cannot tell which program this is: " + error.message());
  return program;
}

std::string TimeText(double seconds) {
  char text[32];
  const long whole = std::lround(seconds);
  std::snprintf(text, sizeof(text), "%ld:%02ld:%02ld", whole / 3600, whole / 60 % 60, whole % 60);
  return text;
}

// Shows how many trials are done and how long the rest will take as the ones before did.
class TrialDisplay {
 public:
  TrialDisplay(ProgressDisplay* display, std::size_t total)
      : display_(display), total_(total), begin_(std::chrono::steady_clock::now()) {}

  void Show(std::size_t done) {
    const std::size_t part = done * kParts / total_;
    if (done > kParts && part == part_ && done < total_) return;
    part_ = part;
    const double gone_s =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
    const double left_s = gone_s / static_cast<double>(std::max<std::size_t>(done, 1)) *
                          static_cast<double>(total_ - done);
    const std::string text = std::to_string(done) + " of " + std::to_string(total_) + " trials" +
                             (done > 0 ? ", " + TimeText(left_s) + " left" : "");
    display_->Show(text, static_cast<double>(done) / static_cast<double>(total_));
  }

 private:
  ProgressDisplay* display_;
  std::size_t total_, part_ = 0;
  std::chrono::steady_clock::time_point begin_;
};

void PrintPlan(const CampaignFolder& folder) {
  for (const PlannedTrial& trial : folder.plan) std::printf("%s\n", trial.id.c_str());
}

void PrintResult(const TrialOutcome& outcome) {
  std::printf("%-28s %s%s%s\n", "ended by", outcome.ended_by.c_str(),
              outcome.why.empty() ? "" : ": ", outcome.why.c_str());
  for (const MetricField& field : kMetricFields)
    std::printf("%-28s %s\n", field.name, FormatDouble(field.get(outcome.metrics)).c_str());
}

// What a robot did, sample by sample.
std::string TrackCsv(const TrialOutcome& outcome) {
  std::string csv = "time_s,x_m,y_m,z_m,yaw_rad,power_w,time_to_collision_s\r\n";
  for (const TrialSample& sample : outcome.record.samples) {
    const double cells[] = {
        sample.time_s,  sample.position_m.x(), sample.position_m.y(),     sample.position_m.z(),
        sample.yaw_rad, sample.power_w,        sample.time_to_collision_s};
    for (std::size_t i = 0; i < std::size(cells); ++i)
      csv += (i == 0 ? "" : ",") + FormatDouble(cells[i]);
    csv += "\r\n";
  }
  return csv;
}

Status RunOne(const CampaignFolder& folder, const CLI::App& command) {
  const std::string id = *ValueOf(command, "--only");
  const auto found = std::find_if(folder.plan.begin(), folder.plan.end(),
                                  [&](const PlannedTrial& trial) { return trial.id == id; });
  if (found == folder.plan.end())
    return InvalidArgument("--only: there is no trial " + Quote(id) + "; --plan lists them");
  LW_RETURN_IF_ERROR(PrepareFolder(folder, /*resume=*/true));
  TrialRunner runner(&folder);
  LW_ASSIGN_OR_RETURN(const TrialOutcome outcome,
                      runner.Run(static_cast<std::size_t>(found - folder.plan.begin())));
  PrintResult(outcome);
  if (const auto file = ValueOf(command, "--track"))
    return ReplaceFile(*file, TrackCsv(outcome)).WithContext("--track");
  return Status();
}

Status WriteJob(const CampaignFolder& folder, const CampaignArguments& arguments,
                const CLI::App& command) {
  ArgumentReader reader(&command);
  SlurmJob job;
  job.shards = static_cast<int>(reader.Integer("--shards", 1, 10000, 4));
  LW_RETURN_IF_ERROR(reader.status());
  job.name = folder.campaign.name;
  LW_ASSIGN_OR_RETURN(job.program, ThisProgram());
  job.file = fs::absolute(arguments.file);
  job.out = fs::absolute(arguments.out);
  job.workers = arguments.workers;
  return ReplaceFile(*ValueOf(command, "--slurm"), SlurmJobFile(job)).WithContext("--slurm");
}

// "latticeworld campaign FILE --out DIR", for people to type.
std::string CommandText(const CampaignArguments& arguments) {
  return "latticeworld campaign " + arguments.file.string() + " --out " + arguments.out.string();
}

Status Merge(const CampaignFolder& folder, const CampaignArguments& arguments,
             const Progress& progress) {
  LW_RETURN_IF_ERROR(WriteTablesAndReport(folder, CommandText(arguments), progress));
  std::printf("report: %s\n", (folder.out / "report.html").c_str());
  return Status();
}

Status RunAll(const CampaignFolder& folder, const CampaignArguments& arguments,
              const CLI::App& command) {
  const bool sharded = IsGiven(command, "--shard");
  LW_RETURN_IF_ERROR(PrepareFolder(folder, IsGiven(command, "--resume") || sharded));
  const std::string part = sharded ? "." + std::to_string(arguments.shard) : "";
  LW_ASSIGN_OR_RETURN(const FolderLock lock, FolderLock::Take(folder.out / (".lock" + part)));
  if (IsGiven(command, "--retry-errors")) LW_RETURN_IF_ERROR(RemoveErrors(folder));
  LW_ASSIGN_OR_RETURN(const auto missing, MissingTrials(folder, arguments.shard, arguments.shards));

  DispatchOptions options;
  options.workers = arguments.workers;
  options.trial_time_s = arguments.trial_time_s;
  options.wall_times = folder.out / ("wall_times" + part + ".csv");
  // Not by its name: another build may have taken the place of this one by then.
  options.command = {"/proc/self/exe",       "campaign", arguments.file.string(), "--out",
                     arguments.out.string(), "--worker"};
  ProgressDisplay display;
  TrialDisplay trials(&display, missing.size());
  Progress progress(
      [&display](std::string_view stage, double fraction) { display.Show(stage, fraction); });
  const CancelOnInterrupt cancel_on_interrupt(&progress);
  if (!missing.empty()) trials.Show(0);
  const Status run = Dispatch(folder, missing, options, progress,
                              [&trials](std::size_t done) { trials.Show(done); });
  if (!run.ok() || sharded) {
    display.Clear();
    return run;
  }
  const Status merged = Merge(folder, arguments, progress);
  display.Clear();
  return merged;
}

Status RunCampaign(const CLI::App& command) {
  LW_ASSIGN_OR_RETURN(const CampaignArguments arguments, ReadArguments(command));
  auto opened = OpenCampaign(arguments.file, arguments.out);
  if (!opened.ok()) return opened.status();
  const CampaignFolder folder = *std::move(opened);
  if (IsGiven(command, "--check")) {
    std::printf("%zu trials in %zu worlds\n", folder.plan.size(), folder.campaign.worlds.size());
    return Status();
  }
  if (IsGiven(command, "--plan")) {
    PrintPlan(folder);
    return Status();
  }
  if (IsGiven(command, "--worker")) return ServeTrials(folder);
  if (IsGiven(command, "--only")) return RunOne(folder, command);
  if (IsGiven(command, "--slurm")) return WriteJob(folder, arguments, command);
  if (IsGiven(command, "--merge")) {
    LW_RETURN_IF_ERROR(PrepareFolder(folder, /*resume=*/true));
    return Merge(folder, arguments, Progress());
  }
  return RunAll(folder, arguments, command);
}

}  // namespace

void AddCampaignCommand(CLI::App* app, int* exit_status) {
  CLI::App* command = app->add_subcommand(
      "campaign",
      "Runs a campaign: every robot tries every task of every world under every condition, in "
      "processes of their own, and a report tells what came of it.");
  AddValueOption(command, "FILE", "FILE", "The campaign, YAML (docs/campaigns.md).");
  command->get_option("FILE")->required();
  AddValueOption(command, "--out", "DIR", "Folder for the results.");
  AddValueOption(command, "--workers", "N", "Processes, 1 to 256 [as many as cores].");
  command->add_flag("--resume", "Goes on with the results in DIR where it was broken off.");
  command->add_flag("--retry-errors", "With --resume: tries again what could not be run.");
  AddValueOption(command, "--trial-time", "S",
                 "Longest that a trial and its world may take before it counts as hung [900].");
  command->add_flag("--check", "Only looks whether the file is usable.");
  command->add_flag("--plan", "Only lists the trials.");
  AddValueOption(command, "--only", "ID", "Runs one trial and tells its metrics; keeps no result.");
  AddValueOption(command, "--track", "CSV", "With --only: where the robot was, sample by sample.");
  AddValueOption(command, "--shard", "I/N", "Runs the I-th of N parts, and makes no report.");
  command->add_flag("--merge", "Makes tables and report of the results of shards.");
  AddValueOption(command, "--slurm", "FILE", "Only writes a Slurm array job that runs it.");
  AddValueOption(command, "--shards", "N", "With --slurm: tasks of the array, 1 to 10000 [4].");
  command->add_flag("--worker",
                    "Runs trials that it is told on standard input; for the program's own use.");
  command->callback([command, exit_status] {
    const Status status = RunCampaign(*command);
    if (!status.ok()) *exit_status = ReportFailure("campaign", status);
  });
}

}  // namespace latticeworld::tools
