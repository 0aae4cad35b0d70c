#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "dataset/scratch_dataset.h"
#include "dataset/test_source.h"
#include "latticeworld/common/folder_lock.h"
#include "latticeworld/dataset/writing/dataset_writer.h"

// Data sets that are broken off and gone on with, and folders that are not theirs.
namespace latticeworld {
namespace {

namespace fs = std::filesystem;

class DatasetContinuationTest : public ScratchDatasetTest {};

TEST_F(DatasetContinuationTest, BytesDoNotDependOnThreadsNorOnBreaks) {
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

TEST_F(DatasetContinuationTest, WhatWasHalfWrittenAndWhatIsDamagedIsMadeAgain) {
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

TEST_F(DatasetContinuationTest, AFolderOfSomethingElseIsRefused) {
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

TEST_F(DatasetContinuationTest, OnlyTheSameWorkIsGoneOnWithAndByOneProcess) {
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
  const auto lock = FolderLock::Take(folder_ / "held/.lock");
  ASSERT_TRUE(lock.ok());
  EXPECT_EQ(WriteDataset(job, Progress(), {}).status().code(), StatusCode::kFailedPrecondition);
}

TEST_F(DatasetContinuationTest, CancellingLeavesWhatCanBeGoneOnWith) {
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

}  // namespace
}  // namespace latticeworld
