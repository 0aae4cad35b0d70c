#include "latticeworld/dataset/writing/dataset_writer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <vector>

#include "dataset/scratch_dataset.h"
#include "dataset/test_source.h"
#include "latticeworld/common/digest.h"
#include "latticeworld/language/remote/prompts.h"
#include "latticeworld/layout/claims/claims_json.h"
#include "latticeworld/relief/sketch/sketch.h"

namespace latticeworld {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

std::vector<Json> RecordsOf(const fs::path& path) {
  std::vector<Json> records;
  std::istringstream lines(ReadAll(path));
  for (std::string line; std::getline(lines, line);) records.push_back(Json::parse(line));
  return records;
}

class DatasetWriterTest : public ScratchDatasetTest {};

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

TEST_F(DatasetWriterTest, LayoutsOfTheEmbeddedGeneratorHaveWhatTheWordsSay) {
  const FourEachSource source(6);
  DatasetJob job = JobOf(source, "out");
  job.options.layouts = LayoutsBy::kGrounded;
  job.options.train_share = 1.0;
  job.options.validation_share = 0.0;
  const auto written = WriteDataset(job, Progress(), {});
  ASSERT_TRUE(written.ok()) << written.status().ToString();
  EXPECT_EQ(written->instances + written->failed, 24u);
  EXPECT_GE(written->instances, 12u);
  std::map<std::string, Instance> places;
  for (std::size_t group = 0; group < 6; ++group)
    for (Instance& instance : source.ReadGroup(group).value()) places[instance.id] = instance;
  std::map<std::string, std::string> laid_out;
  for (const Json& record : RecordsOf(folder_ / "out/layout/train.jsonl")) {
    const Instance& place = places.at(record.at("id"));
    const std::string text = record.at("messages")[2].at("content");
    const auto layout = ParseLayout(text, place.layout.vocabulary);
    ASSERT_TRUE(layout.ok()) << layout.status().ToString();
    EXPECT_NE(layout->cells, place.layout.cells) << "nothing was laid out anew";
    const auto claims =
        DecodeClaims(record.at("claims").get<std::string>(), place.layout.vocabulary);
    ASSERT_TRUE(claims.ok()) << claims.status().ToString();
    EXPECT_FALSE(claims->empty());
    for (const Claim& claim : *claims)
      EXPECT_TRUE(Measure(claim, *layout).holds) << Measure(claim, *layout).explanation;
    laid_out[record.at("id")] = text;
  }
  for (const Json& record : RecordsOf(folder_ / "out/environment/train.jsonl")) {
    const std::string user = record.at("messages")[1].at("content");
    EXPECT_NE(user.find(laid_out.at(record.at("id"))), std::string::npos)
        << "the environment is for another layout";
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
