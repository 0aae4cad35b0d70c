#include "latticeworld/campaign/workers/campaign_folder.h"

#include <algorithm>
#include <system_error>
#include <utility>

#include "latticeworld/campaign/campaign_file.h"
#include "latticeworld/campaign/reports/result_files.h"
#include "latticeworld/common/files.h"
#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

namespace fs = std::filesystem;

Status FailureOf(const std::string& what, const std::error_code& error) {
  const std::string message = what + ": " + error.message();
  if (error == std::errc::no_space_on_device) return ResourceExhausted(message);
  if (error == std::errc::permission_denied || error == std::errc::read_only_file_system)
    return PermissionDenied(message);
  return Internal(message);
}

// A broken-off process leaves "<file>.<pid>.part" of results, and ".<world>.unfinished-XXXXXX" of
// worlds, whose own names begin with no dot.
void RemoveParts(const fs::path& directory) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(directory, error)) {
    const std::string name = entry.path().filename().string();
    std::error_code ignored;
    if (EndsWith(name, ".part") || StartsWith(name, ".")) fs::remove_all(entry.path(), ignored);
  }
}

// Whether something is in the folder that no campaign has put there. The copy of the campaign's
// file comes before all else, so that several shards may begin at the same time.
bool HoldsForeignThings(const fs::path& out, const fs::path& kept) {
  std::error_code error;
  if (!fs::is_directory(out, error)) return true;
  for (const auto& entry : fs::directory_iterator(out, error)) {
    const bool is_copy = StartsWith(entry.path().filename().string(), kept.filename().string());
    if (!is_copy && !fs::exists(kept, error)) return true;
  }
  return false;
}

}  // namespace

Result<CampaignFolder> OpenCampaign(const fs::path& file, const fs::path& out) {
  CampaignFolder folder;
  LW_ASSIGN_OR_RETURN(folder.text, ReadFile(file, kMaxCampaignBytes));
  auto campaign = ParseCampaign(folder.text, file.parent_path());
  if (!campaign.ok()) return campaign.status();
  folder.campaign = *std::move(campaign);
  folder.out = out;
  folder.plan = PlanOf(folder.campaign);
  return folder;
}

Status PrepareFolder(const CampaignFolder& folder, bool resume) {
  std::error_code error;
  const fs::path kept = folder.out / "campaign.yaml";
  if (fs::exists(folder.out, error)) {
    if (fs::exists(kept, error)) {
      LW_ASSIGN_OR_RETURN(const std::string text, ReadFile(kept, kMaxCampaignBytes));
      if (text != folder.text) {
        return FailedPrecondition("the results in " + folder.out.string() +
                                  " are of another campaign file: " + kept.string() +
                                  " differs; give a new folder");
      }
      if (!resume) {
        return Status(StatusCode::kAlreadyExists,
                      folder.out.string() + " has results of this campaign; --resume goes on");
      }
    } else if (HoldsForeignThings(folder.out, kept)) {
      return FailedPrecondition(folder.out.string() +
                                " is there and is no campaign's folder; give a new one");
    }
  }
  fs::create_directories(folder.out, error);
  if (error) return FailureOf("cannot make " + folder.out.string(), error);
  if (!fs::exists(kept, error)) LW_RETURN_IF_ERROR(WriteWhole(kept, folder.text));
  for (const char* name : {"worlds", "tasks", "trials"}) {
    fs::create_directories(folder.out / name, error);
    if (error) return FailureOf("cannot make " + (folder.out / name).string(), error);
  }
  return Status();
}

Result<std::vector<std::size_t>> MissingTrials(const CampaignFolder& folder, int shard,
                                               int shards) {
  if (shards == 1) {
    for (const char* name : {"worlds", "tasks", "trials"}) RemoveParts(folder.out / name);
  }
  const bool by_world = folder.campaign.worlds.size() >= static_cast<std::size_t>(shards);
  std::vector<std::size_t> missing;
  for (std::size_t i = 0; i < folder.plan.size(); ++i) {
    const std::size_t key = by_world ? folder.plan[i].world : i;
    if (key % static_cast<std::size_t>(shards) != static_cast<std::size_t>(shard)) continue;
    const auto result = ReadTrialResult(folder.out, folder.plan[i].id);
    if (result.ok()) continue;
    if (result.status().code() != StatusCode::kNotFound) return result.status();
    missing.push_back(i);
  }
  return missing;
}

Result<std::vector<FinishedTrial>> ReadResults(const CampaignFolder& folder) {
  std::vector<FinishedTrial> finished;
  std::size_t missing = 0;
  for (const PlannedTrial& trial : folder.plan) {
    auto result = ReadTrialResult(folder.out, trial.id);
    if (result.ok()) {
      finished.push_back({trial, *std::move(result)});
    } else if (result.status().code() == StatusCode::kNotFound) {
      ++missing;
    } else {
      return result.status();
    }
  }
  if (missing == 0) return finished;
  return FailedPrecondition(std::to_string(missing) + " of " + std::to_string(folder.plan.size()) +
                            " trials have no result; --resume runs them");
}

Status RemoveErrors(const CampaignFolder& folder) {
  for (const PlannedTrial& trial : folder.plan) {
    const auto result = ReadTrialResult(folder.out, trial.id);
    if (!result.ok() || result->error.empty()) continue;
    std::error_code error;
    fs::remove(TrialResultFile(folder.out, trial.id), error);
    if (error) return FailureOf("cannot remove the result of " + trial.id, error);
  }
  return Status();
}

}  // namespace latticeworld
