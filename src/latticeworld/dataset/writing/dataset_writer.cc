#include "latticeworld/dataset/writing/dataset_writer.h"

#include <algorithm>
#include <atomic>
#include <iterator>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "latticeworld/common/digest.h"
#include "latticeworld/common/files.h"
#include "latticeworld/common/text.h"
#include "latticeworld/dataset/captions/prompt_texts.h"
#include "latticeworld/dataset/writing/data_card.h"
#include "latticeworld/dataset/writing/dataset_folder.h"
#include "latticeworld/dataset/writing/dataset_part.h"
#include "latticeworld/dataset/writing/part_maker.h"
#include "latticeworld/dataset/writing/whole_file.h"

namespace latticeworld {
namespace {

namespace fs = std::filesystem;

// What the folder's records are made of: work that goes on has to be of the same.
std::string FingerprintOf(const DatasetJob& job) {
  Digest groups;
  const std::size_t count = job.source->group_count();
  for (std::size_t i = 0; i < count; ++i) groups.AddText(job.source->GroupName(i));
  DatasetFacts facts;
  facts.version = job.version;
  facts.annotator = std::string(job.annotator->name());
  facts.source = job.source->card();
  facts.groups = count;
  facts.options = job.options;
  auto json = nlohmann::ordered_json::parse(ManifestJson(facts));
  for (const char* made : {"files", "images_sha256", "counts", "failed"}) json.erase(made);
  json["groups_sha256"] = groups.Hex();
  return json.dump(1) + "\n";
}

// Makes the missing parts over threads.
class PartsRun {
 public:
  PartsRun(const DatasetJob& job, const DatasetFolder& folder, const PromptTexts& prompts,
           const Progress& progress, const std::function<void(const DatasetProgress&)>& listener)
      : job_(job), folder_(folder), progress_(progress), listener_(listener) {
    maker_ = {job.source, job.annotator, &job.options, &prompts};
    where_.groups = job.source->group_count();
  }

  Status Run() {
    const std::size_t parts = PartCount();
    for (std::size_t part = 0; part < parts; ++part) {
      if (folder_.HasPart(part)) {
        where_.groups_done += End(part) - Begin(part);
      } else {
        missing_.push_back(part);
      }
    }
    if (listener_) listener_(where_);
    const unsigned cores = std::max(1u, std::thread::hardware_concurrency());
    const std::size_t wanted =
        job_.options.threads > 0 ? static_cast<std::size_t>(job_.options.threads) : cores;
    std::vector<std::thread> helpers;
    try {
      for (std::size_t i = 1; i < std::min(wanted, missing_.size()); ++i)
        helpers.emplace_back([this] { Work(); });
    } catch (const std::system_error&) {  // no more threads can be had: those that there are do all
    }
    Work();
    for (std::thread& helper : helpers) helper.join();
    return failure_;
  }

  std::size_t PartCount() const {
    const auto size = static_cast<std::size_t>(job_.options.groups_per_part);
    return (where_.groups + size - 1) / size;
  }

 private:
  std::size_t Begin(std::size_t part) const {
    return part * static_cast<std::size_t>(job_.options.groups_per_part);
  }
  std::size_t End(std::size_t part) const { return std::min(Begin(part + 1), where_.groups); }

  void Work() {
    while (!stop_.load()) {
      const std::size_t next = next_.fetch_add(1);
      if (next >= missing_.size()) return;
      Status status = MakePart(missing_[next]);
      if (status.ok()) continue;
      const std::lock_guard<std::mutex> lock(mutex_);
      if (failure_.ok()) failure_ = std::move(status);
      stop_.store(true);
    }
  }

  Status MakePart(std::size_t part) {
    LW_RETURN_IF_ERROR(folder_.RemoveImages(part));
    std::optional<DirectoryWriter> images;
    const auto sink = [&](const std::string& name, std::string_view bytes) -> Status {
      if (!images.has_value()) {
        auto writer = DirectoryWriter::Create(folder_.ImagesOf(part));
        if (!writer.ok()) return writer.status();
        images.emplace(*std::move(writer));
      }
      return images->Write(name, bytes);
    };
    const auto group_done = [this] {
      const std::lock_guard<std::mutex> lock(mutex_);
      ++where_.groups_done;
      ++where_.groups_here;
      if (listener_) listener_(where_);
    };
    LW_ASSIGN_OR_RETURN(const DatasetPart made,
                        maker_.Make(Begin(part), End(part), folder_.ImageNameOf(part), sink,
                                    progress_, group_done));
    if (images.has_value()) LW_RETURN_IF_ERROR(images->Commit());
    return WriteWholeFile(folder_.PartFile(part), EncodePart(made));
  }

  const DatasetJob& job_;
  const DatasetFolder& folder_;
  const Progress& progress_;
  const std::function<void(const DatasetProgress&)>& listener_;
  PartMaker maker_;
  std::vector<std::size_t> missing_;
  std::atomic<std::size_t> next_{0};
  std::atomic<bool> stop_{false};
  std::mutex mutex_;  // of all below
  DatasetProgress where_;
  Status failure_;
};

DatasetSummary SummaryOf(const DatasetTallies& tallies, std::size_t failed) {
  DatasetSummary summary;
  summary.failed = failed;
  for (const auto& split : EnumNames(DatasetSplit{})) {
    const std::string name(split.name);
    summary.instances += TallyOf(tallies, "instances/" + name);
    for (std::size_t task = 0; task < kDatasetTasks; ++task) {
      const std::string task_name(NameOf(static_cast<DatasetTask>(task)));
      summary.records[task] += TallyOf(tallies, "records/" + task_name + "/" + name);
    }
  }
  return summary;
}

Result<DatasetSummary> ReadSummary(const fs::path& manifest) {
  LW_ASSIGN_OR_RETURN(const std::string text, ReadFile(manifest, std::size_t{1} << 30));
  try {
    const auto json = nlohmann::json::parse(text);
    return SummaryOf(ReadTallies(json.at("counts")), json.at("failed").size());
  } catch (const nlohmann::json::exception&) {
    return DataLoss(manifest.string() + " is damaged");
  }
}

// The files of records, each put together of the parts' sections.
class JoinedFiles {
 public:
  explicit JoinedFiles(const DatasetFolder& folder) : folder_(folder) {}

  Status Add(const DatasetPart& part) {
    for (std::size_t task = 0; task < kDatasetTasks; ++task) {
      for (std::size_t split = 0; split < kDatasetSplits; ++split)
        LW_RETURN_IF_ERROR(AddTo(task, split, part.lines[task][split]));
    }
    return AddTo(kDatasetTasks, 0, part.image_sums);
  }

  // tallies: of all parts.
  Status Commit(DatasetFacts* facts) {
    for (std::size_t task = 0; task <= kDatasetTasks; ++task) {
      for (std::size_t split = 0; split < kDatasetSplits; ++split) {
        std::optional<WholeFile>& file = files_[task][split];
        if (!file.has_value()) continue;
        const std::string sha256 = file->Sha256();
        LW_RETURN_IF_ERROR(file->Commit());
        if (task == kDatasetTasks) {
          facts->image_sums_sha256 = sha256;
          continue;
        }
        DatasetFile entry;
        entry.task = static_cast<DatasetTask>(task);
        entry.split = static_cast<DatasetSplit>(split);
        entry.path = NameOfFile(task, split);
        entry.records = TallyOf(facts->tallies, "records/" + std::string(NameOf(entry.task)) + "/" +
                                                    std::string(NameOf(entry.split)));
        entry.bytes = file->size();
        entry.sha256 = sha256;
        facts->files.push_back(std::move(entry));
      }
    }
    return Status();
  }

 private:
  static std::string NameOfFile(std::size_t task, std::size_t split) {
    if (task == kDatasetTasks) return "images.sha256";
    return std::string(NameOf(static_cast<DatasetTask>(task))) + "/" +
           std::string(NameOf(static_cast<DatasetSplit>(split))) + ".jsonl";
  }

  // A file that nothing goes into is not made.
  Status AddTo(std::size_t task, std::size_t split, const std::string& text) {
    if (text.empty()) return Status();
    std::optional<WholeFile>& file = files_[task][split];
    if (!file.has_value()) {
      const fs::path path = folder_.root() / NameOfFile(task, split);
      LW_RETURN_IF_ERROR(MakeDirectories(path.parent_path()));
      auto made = WholeFile::Create(path);
      if (!made.ok()) return made.status();
      file.emplace(*std::move(made));
    }
    return file->Append(text);
  }

  const DatasetFolder& folder_;
  std::array<std::array<std::optional<WholeFile>, kDatasetSplits>, kDatasetTasks + 1> files_;
};

Result<DatasetSummary> JoinParts(const DatasetJob& job, const DatasetFolder& folder,
                                 std::size_t parts, const Progress& progress) {
  DatasetFacts facts;
  facts.version = job.version;
  facts.annotator = std::string(job.annotator->name());
  facts.command = job.command;
  facts.source = job.source->card();
  facts.groups = job.source->group_count();
  facts.options = job.options;
  JoinedFiles files(folder);
  for (std::size_t i = 0; i < parts; ++i) {
    LW_RETURN_IF_ERROR(progress.CheckCancelled());
    LW_ASSIGN_OR_RETURN(DatasetPart part, ReadPart(folder.PartFile(i)));
    LW_RETURN_IF_ERROR(files.Add(part));
    for (const auto& [key, count] : part.tallies) facts.tallies[key] += count;
    std::move(part.failed.begin(), part.failed.end(), std::back_inserter(facts.failed));
  }
  LW_RETURN_IF_ERROR(files.Commit(&facts));
  LW_RETURN_IF_ERROR(WriteWholeFile(folder.root() / "README.md", DataCard(facts)));
  LW_RETURN_IF_ERROR(WriteWholeFile(folder.Manifest(), ManifestJson(facts)));
  folder.RemoveParts();
  return SummaryOf(facts.tallies, facts.failed.size());
}

}  // namespace

Result<DatasetSummary> WriteDataset(const DatasetJob& job, const Progress& progress,
                                    const std::function<void(const DatasetProgress&)>& listener) {
  LW_RETURN_IF_ERROR(Status::FromViolations("data set", Validate(job.options)));
  LW_ASSIGN_OR_RETURN(const PromptTexts prompts, PromptTexts::Make(job.options.size_m));
  LW_ASSIGN_OR_RETURN(const DatasetFolder folder,
                      DatasetFolder::Open(job.out, FingerprintOf(job), job.resume));
  if (folder.IsWhole()) {
    folder.RemoveParts();
    return ReadSummary(folder.Manifest());
  }
  LW_RETURN_IF_ERROR(folder.RemoveLeftovers());
  PartsRun run(job, folder, prompts, progress, listener);
  LW_RETURN_IF_ERROR(run.Run());
  return JoinParts(job, folder, run.PartCount(), progress);
}

}  // namespace latticeworld
