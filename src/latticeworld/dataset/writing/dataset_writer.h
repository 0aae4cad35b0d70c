#ifndef LATTICEWORLD_DATASET_WRITING_DATASET_WRITER_H_
#define LATTICEWORLD_DATASET_WRITING_DATASET_WRITER_H_

#include <array>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>

#include "latticeworld/common/progress.h"
#include "latticeworld/common/result.h"
#include "latticeworld/dataset/captions/annotator.h"
#include "latticeworld/dataset/sources/instance_source.h"
#include "latticeworld/dataset/writing/dataset_options.h"

namespace latticeworld {

// Tells how far the work has got.
struct DatasetProgress {
  std::size_t groups = 0;       // of the source
  std::size_t groups_done = 0;  // with those of earlier runs
  std::size_t groups_here = 0;  // done by this run
};

struct DatasetJob {
  const InstanceSource* source = nullptr;
  Annotator* annotator = nullptr;
  DatasetOptions options;
  std::filesystem::path out;
  bool resume = false;  // whether work that is there already is gone on with
  std::string version;  // of the program
  std::string command;  // for the card
};

struct DatasetSummary {
  std::size_t instances = 0;
  std::size_t failed = 0;  // groups that could not be read, instances that could not be described
  std::array<std::size_t, kDatasetTasks> records{};
};

// Writes a data set:
//
//   <task>/<split>.jsonl   records in chat format, in the order of the source's groups
//   images/<part>/<id>-height.png, -sketch.png
//   images.sha256          of every image, for sha256sum -c
//   README.md              the data card
//   dataset.json           the manifest; written last: with it the data set is whole
//   options.json           what it was begun with
//   parts/, .lock          while it is in the making
//
// Groups go in parts over threads; a part is there whole or not at all, and one that is there is
// not made again, so that work which was broken off at any moment goes on with `resume` and ends
// in the same bytes, whatever the number of threads. `progress`: may have no listener where there
// are several threads. listener: called by one thread at a time. Errors: INVALID_ARGUMENT
// (options); ALREADY_EXISTS (work is there and `resume` is not given); FAILED_PRECONDITION (`out`
// holds something else, or was made of other things; or another process works there);
// RESOURCE_EXHAUSTED (no room); PERMISSION_DENIED; CANCELLED; those of the annotator's server.
// After any of them all whole parts remain.
Result<DatasetSummary> WriteDataset(const DatasetJob& job, const Progress& progress,
                                    const std::function<void(const DatasetProgress&)>& listener);

}  // namespace latticeworld

#endif  // LATTICEWORLD_DATASET_WRITING_DATASET_WRITER_H_
