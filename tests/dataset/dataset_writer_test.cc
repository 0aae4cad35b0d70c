#include "latticeworld/dataset/dataset_writer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "dataset/test_source.h"
#include "latticeworld/common/digest.h"
#include "latticeworld/common/files.h"
#include "latticeworld/dataset/whole_file.h"
#include "latticeworld/dataset/written_annotator.h"
#include "latticeworld/language/remote/prompts.h"
#include "latticeworld/layout/claims_json.h"
#include "latticeworld/relief/sketch.h"

namespace latticeworld {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

std::string ReadAll(const fs::path& path) { return ReadFile(path, 1u << 30).value(); }

std::vector<Json> RecordsOf(const fs::path& path) {
  std::vector<Json> records;
  std::istringstream lines(ReadAll(path));
  for (std::string line; std::getline(lines, line);) records.push_back(Json::parse(line));
  return records;
}

class DatasetWriterTest : public testing::Test {
 protected:
  DatasetWriterTest() : annotator_(MakeWrittenAnnotator()) {
    std::string name = (fs::temp_directory_path() / "lw_dataset_XXXXXX").string();
    folder_ = ::mkdtemp(name.data());
  }
  ~DatasetWriterTest() override { fs::remove_all(folder_); }

  DatasetJob JobOf(const InstanceSource& source, const std::string& out) {
    DatasetJob job;
    job.source = &source;
    job.annotator = annotator_.get();
    job.out = folder_ / out;
    job.options.groups_per_part = 3;
    job.options.threads = 2;
    job.version = "test";
    return job;
  }

  // All that a data set consists of, by path.
  std::map<std::string, std::string> FilesOf(const std::string& out) {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder_ / out)) {
      if (entry.is_regular_file())
        files[fs::relative(entry.path(), folder_ / out).string()] = ReadAll(entry.path());
    }
    return files;
  }

  std::unique_ptr<Annotator> annotator_;
  fs::path folder_;
};

TEST_F(DatasetWriterTest, NothingOfOneImageIsInTwoSplits) {
  const FourEachSource source(60);
  DatasetJob job = JobOf(source, "out");
  job.options.environment = job.options.images = false;
  job.options.train_share = 0.6;
  job.options.validation_share = 0.2;
  const auto written = WriteDataset(job, Progress(), {});
  ASSERT_TRUE(written.ok()) << written.status().ToString();
  EXPECT_EQ(written->instances, 240u);
  std::map<std::string, std::set<std::string>> splits_of;
  std::map<std::string, std::set<std::string>> ids_of;
  for (const char* split : {"train", "validation", "test"}) {
    for (const Json& record : RecordsOf(folder_ / "out/layout" / (std::string(split) + ".jsonl"))) {
      splits_of[record.at("group")].insert(split);
      ids_of[record.at("group")].insert(record.at("id"));
    }
  }
  EXPECT_EQ(splits_of.size(), 60u);
  std::map<std::string, int> groups;
  for (const auto& [group, splits] : splits_of) {
    EXPECT_EQ(splits.size(), 1u) << group;
    EXPECT_EQ(ids_of[group].size(), 4u) << group;
    ++groups[*splits.begin()];
  }
  EXPECT_EQ(groups.size(), 3u) << "every split has some";
}

TEST_F(DatasetWriterTest, SplitsHaveTheSharesThatAreAskedFor) {
  DatasetOptions options;
  std::map<DatasetSplit, int> groups;
  for (int i = 0; i < 20000; ++i) ++groups[SplitOf("group-" + std::to_string(i), options)];
  EXPECT_NEAR(groups[DatasetSplit::kTrain] / 20000.0, 0.9, 0.01);
  EXPECT_NEAR(groups[DatasetSplit::kValidation] / 20000.0, 0.05, 0.01);
  EXPECT_NEAR(groups[DatasetSplit::kTest] / 20000.0, 0.05, 0.01);
}

TEST_F(DatasetWriterTest, RecordsHoldWhatAModelIsSentAndShouldAnswer) {
  const FourEachSource source(10);
  DatasetJob job = JobOf(source, "out");
  job.options.train_share = 1.0;
  job.options.validation_share = 0.0;
  ASSERT_TRUE(WriteDataset(job, Progress(), {}).ok());
  const auto layouts = RecordsOf(folder_ / "out/layout/train.jsonl");
  const auto environments = RecordsOf(folder_ / "out/environment/train.jsonl");
  ASSERT_EQ(layouts.size(), 40u);
  ASSERT_EQ(environments.size(), 40u);
  std::size_t at = 0;
  for (std::size_t group = 0; group < 10; ++group) {
    const auto instances = source.ReadGroup(group).value();
    for (const Instance& instance : instances) {
      const Json& layout = layouts[at];
      const Json& environment = environments[at++];
      ASSERT_EQ(layout.at("id"), instance.id) << "in the source's order";
      const Json& said = layout.at("messages");
      ASSERT_EQ(said.size(), 3u);
      const auto answer =
          ParseLayout(said[2].at("content").get<std::string>(), instance.layout.vocabulary);
      ASSERT_TRUE(answer.ok()) << answer.status().ToString();
      EXPECT_TRUE(answer->cells == instance.layout.cells);
      const auto claims =
          DecodeClaims(layout.at("claims").get<std::string>(), instance.layout.vocabulary);
      ASSERT_TRUE(claims.ok()) << claims.status().ToString();
      EXPECT_FALSE(claims->empty());
      for (const Claim& claim : *claims) EXPECT_TRUE(Measure(claim, instance.layout).holds);

      const auto config =
          ParseEnvironment(environment.at("messages")[2].at("content").get<std::string>());
      EXPECT_TRUE(config.ok()) << config.status().ToString();
      EXPECT_EQ(environment.at("messages")[0].at("role"), "system");
      // The instruction stands at the end of what the user says: what is before is LatticeWorld's.
      EnvironmentRequest request;
      request.layout = &instance.layout;
      request.relief = instance.relief.get();
      const std::string user = environment.at("messages")[1].at("content");
      const std::string heading = "Description of the environment:\n";
      const std::size_t begin = user.find(heading) + heading.size();
      request.instruction = user.substr(begin, user.rfind("\n\n") - begin);
      const auto sent = EnvironmentMessages(request, /*sees=*/false);
      EXPECT_EQ(user, (*sent)[1].text);
      EXPECT_EQ(environment.at("messages")[0].at("content"), (*sent)[0].text);
    }
  }
}

TEST_F(DatasetWriterTest, ShortPromptsLeaveTheSystemMessageOut) {
  const FourEachSource source(2);
  DatasetJob job = JobOf(source, "out");
  job.options.prompts = PromptForm::kShort;
  job.options.train_share = 1.0;
  job.options.validation_share = 0.0;
  ASSERT_TRUE(WriteDataset(job, Progress(), {}).ok());
  for (const char* file : {"layout/train.jsonl", "environment/train.jsonl"}) {
    for (const Json& record : RecordsOf(folder_ / "out" / file)) {
      ASSERT_EQ(record.at("messages").size(), 2u);
      EXPECT_EQ(record.at("messages")[0].at("role"), "user");
    }
  }
}

TEST_F(DatasetWriterTest, ImagesAreTheReliefAsAUserCouldGiveIt) {
  const FourEachSource source(3);
  DatasetJob job = JobOf(source, "out");
  job.options.train_share = 1.0;
  job.options.validation_share = 0.0;
  ASSERT_TRUE(WriteDataset(job, Progress(), {}).ok());
  std::map<std::string, Json> records;
  for (const Json& record : RecordsOf(folder_ / "out/layout/train.jsonl"))
    records[record.at("id")] = record;
  int with_relief = 0;
  for (std::size_t group = 0; group < 3; ++group) {
    const auto instances = source.ReadGroup(group).value();
    for (const Instance& instance : instances) {
      const Json& record = records.at(instance.id);
      if (instance.relief == nullptr) {
        EXPECT_TRUE(record.at("images").empty());
        continue;
      }
      ++with_relief;
      HeightMapOptions heights;
      heights.height_scale_m = record.at("height_scale_m");
      heights.height_offset_m = record.at("height_offset_m");
      const auto relief = ReadHeightMap(
          ReadAll(folder_ / "out" / record.at("images")[0].get<std::string>()), heights);
      ASSERT_TRUE(relief.ok()) << relief.status().ToString();
      ASSERT_EQ(relief->height_m.size(), instance.relief->height_m.size());
      const double step_m = heights.height_scale_m / 65535.0;
      for (std::size_t i = 0; i < relief->height_m.size(); ++i) {
        ASSERT_NEAR(relief->height_m.data()[i], instance.relief->height_m.data()[i], step_m);
      }
      const auto sketch =
          ReadSketch(ReadAll(folder_ / "out" / record.at("images")[1].get<std::string>()));
      ASSERT_TRUE(sketch.ok()) << sketch.status().ToString();
      for (const Stroke stroke : {Stroke::kValley, Stroke::kRidge})
        EXPECT_GT(std::count(sketch->begin(), sketch->end(), stroke), 50);
    }
  }
  EXPECT_GT(with_relief, 0);
  EXPECT_GT(RecordsOf(folder_ / "out/relief/train.jsonl").size(), 0u);
}

TEST_F(DatasetWriterTest, BytesDoNotDependOnThreadsNorOnBreaks) {
  const FourEachSource source(20);
  DatasetJob job = JobOf(source, "whole");
  ASSERT_TRUE(WriteDataset(job, Progress(), {}).ok());
  const auto whole = FilesOf("whole");

  job.out = folder_ / "single";
  job.options.threads = 1;
  ASSERT_TRUE(WriteDataset(job, Progress(), {}).ok());
  EXPECT_EQ(FilesOf("single"), whole);

  job.out = folder_ / "broken";
  job.resume = true;
  int breaks = 0;
  for (const int answers : {0, 17, 5, 30, 1000}) {
    FailingAnnotator failing(annotator_.get(), answers);
    job.annotator = &failing;
    job.options.threads = 1 + breaks % 3;
    source.reads = 0;
    const auto written = WriteDataset(job, Progress(), {});
    if (answers == 1000) {
      ASSERT_TRUE(written.ok()) << written.status().ToString();
      EXPECT_LT(source.reads, 20) << "what is whole is not made again";
    } else {
      ++breaks;
      EXPECT_EQ(written.status().code(), StatusCode::kUnavailable);
      EXPECT_FALSE(fs::exists(folder_ / "broken/dataset.json"));
    }
  }
  EXPECT_EQ(FilesOf("broken"), whole);
}

TEST_F(DatasetWriterTest, WhatWasHalfWrittenAndWhatIsDamagedIsMadeAgain) {
  const FourEachSource source(9);
  DatasetJob job = JobOf(source, "whole");
  ASSERT_TRUE(WriteDataset(job, Progress(), {}).ok());
  FailingAnnotator failing(annotator_.get(), 25);
  job.annotator = &failing;
  job.out = folder_ / "broken";
  job.options.threads = 1;
  ASSERT_FALSE(WriteDataset(job, Progress(), {}).ok());
  const fs::path parts = folder_ / "broken/parts";
  ASSERT_TRUE(fs::exists(parts / "000001"));
  const std::string bytes = ReadAll(parts / "000000");
  std::ofstream(parts / "000000") << bytes.substr(0, bytes.size() / 2);
  std::ofstream(parts / "000002.unfinished") << "half of a";
  fs::create_directories(folder_ / "broken/images/.000002.abcdef");
  fs::create_directories(folder_ / "broken/images/000002");
  std::ofstream(folder_ / "broken/images/000002/left.png") << "half of a";
  job.annotator = annotator_.get();
  job.resume = true;
  const auto written = WriteDataset(job, Progress(), {});
  ASSERT_TRUE(written.ok()) << written.status().ToString();
  EXPECT_EQ(FilesOf("broken"), FilesOf("whole"));
}

TEST_F(DatasetWriterTest, WhatCannotBeReadOrDescribedIsToldAndTheRestGoesOn) {
  FourEachSource source(12);
  source.broken = {3, 7};
  FailingAnnotator annotator(annotator_.get(), 1000);
  annotator.speechless = "image-5-180";
  DatasetJob job = JobOf(source, "out");
  job.annotator = &annotator;
  const auto written = WriteDataset(job, Progress(), {});
  ASSERT_TRUE(written.ok()) << written.status().ToString();
  EXPECT_EQ(written->instances, 39u);
  EXPECT_EQ(written->failed, 3u);
  const Json failed = Json::parse(ReadAll(folder_ / "out/dataset.json")).at("failed");
  ASSERT_EQ(failed.size(), 3u);
  EXPECT_EQ(failed[0].at("group"), "image-3");
  EXPECT_EQ(failed[0].at("reason"), "DATA_LOSS: image-3.png is truncated");
  EXPECT_EQ(failed[1].at("instance"), "image-5-180");
  EXPECT_NE(ReadAll(folder_ / "out/README.md").find("image-7.png is truncated"), std::string::npos);
}

TEST_F(DatasetWriterTest, ManifestHoldsForEveryFile) {
  const FourEachSource source(10);
  DatasetJob job = JobOf(source, "out");
  ASSERT_TRUE(WriteDataset(job, Progress(), {}).ok());
  const Json manifest = Json::parse(ReadAll(folder_ / "out/dataset.json"));
  std::set<std::string> told = {"README.md", "dataset.json", "options.json", "images.sha256"};
  for (const Json& file : manifest.at("files")) {
    const std::string bytes = ReadAll(folder_ / "out" / file.at("path").get<std::string>());
    EXPECT_EQ(file.at("sha256"), Sha256Hex(bytes));
    EXPECT_EQ(file.at("bytes"), bytes.size());
    EXPECT_EQ(file.at("records"), std::count(bytes.begin(), bytes.end(), '\n'));
    told.insert(file.at("path"));
  }
  const std::string sums = ReadAll(folder_ / "out/images.sha256");
  EXPECT_EQ(manifest.at("images_sha256"), Sha256Hex(sums));
  std::istringstream lines(sums);
  for (std::string line; std::getline(lines, line);) {
    EXPECT_EQ(line.substr(0, 64), Sha256Hex(ReadAll(folder_ / "out" / line.substr(66))));
    told.insert(line.substr(66));
  }
  std::set<std::string> there;
  for (const auto& [path, bytes] : FilesOf("out")) there.insert(path);
  EXPECT_EQ(there, told) << "nothing else lies there";
}

TEST_F(DatasetWriterTest, AFolderOfSomethingElseIsRefused) {
  const FourEachSource source(2);
  DatasetJob job = JobOf(source, "other");
  job.resume = true;
  fs::create_directories(folder_ / "other");
  std::ofstream(folder_ / "other/thesis.tex") << "mine";
  EXPECT_EQ(WriteDataset(job, Progress(), {}).status().code(), StatusCode::kFailedPrecondition);
  EXPECT_EQ(FilesOf("other").size(), 1u);

  job.out = folder_ / "other/thesis.tex";
  EXPECT_EQ(WriteDataset(job, Progress(), {}).status().code(), StatusCode::kFailedPrecondition);
  EXPECT_EQ(ReadAll(folder_ / "other/thesis.tex"), "mine");
}

TEST_F(DatasetWriterTest, OnlyTheSameWorkIsGoneOnWithAndByOneProcess) {
  const FourEachSource source(4);
  DatasetJob job = JobOf(source, "out");
  ASSERT_TRUE(WriteDataset(job, Progress(), {}).ok());
  const auto whole = FilesOf("out");
  EXPECT_EQ(WriteDataset(job, Progress(), {}).status().code(), StatusCode::kAlreadyExists);
  job.resume = true;
  const auto again = WriteDataset(job, Progress(), {});
  ASSERT_TRUE(again.ok()) << again.status().ToString();
  EXPECT_EQ(again->instances, 16u);
  job.options.seed = 2;
  EXPECT_EQ(WriteDataset(job, Progress(), {}).status().code(), StatusCode::kFailedPrecondition);
  EXPECT_EQ(FilesOf("out"), whole);

  job = JobOf(source, "held");
  fs::create_directories(folder_ / "held");
  const auto hold = FolderHold::Take(folder_ / "held/.lock");
  ASSERT_TRUE(hold.ok());
  EXPECT_EQ(WriteDataset(job, Progress(), {}).status().code(), StatusCode::kFailedPrecondition);
}

TEST_F(DatasetWriterTest, CancellingLeavesWhatCanBeGoneOnWith) {
  const FourEachSource source(12);
  DatasetJob job = JobOf(source, "out");
  job.options.threads = 1;
  Progress progress;
  const auto cancelled = WriteDataset(job, progress, [&](const DatasetProgress& where) {
    if (where.groups_here == 7) progress.Cancel();
  });
  EXPECT_EQ(cancelled.status().code(), StatusCode::kCancelled);
  job.resume = true;
  std::size_t known = 0;
  const auto written = WriteDataset(job, Progress(), [&](const DatasetProgress& where) {
    if (where.groups_here == 0) known = where.groups_done;
  });
  ASSERT_TRUE(written.ok());
  EXPECT_EQ(known, 6u) << "two whole parts of three groups";
}

TEST_F(DatasetWriterTest, EveryUnusableOptionIsNamed) {
  const FourEachSource source(1);
  DatasetJob job = JobOf(source, "out");
  job.options.layout = job.options.environment = false;
  job.options.train_share = 1.5;
  job.options.threads = -1;
  const auto written = WriteDataset(job, Progress(), {});
  EXPECT_EQ(written.status().code(), StatusCode::kInvalidArgument);
  EXPECT_EQ(written.status().violations().size(), 3u);
  EXPECT_FALSE(fs::exists(job.out));
}

}  // namespace
}  // namespace latticeworld
