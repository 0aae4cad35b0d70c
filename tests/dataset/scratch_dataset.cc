#include "dataset/scratch_dataset.h"

#include <cstdlib>

#include "latticeworld/common/files.h"
#include "latticeworld/dataset/captions/written_annotator.h"

namespace latticeworld {

namespace fs = std::filesystem;

std::string ReadAll(const fs::path& path) { return ReadFile(path, 1u << 30).value(); }

ScratchDatasetTest::ScratchDatasetTest() : annotator_(MakeWrittenAnnotator()) {
  std::string name = (fs::temp_directory_path() / "lw_dataset_XXXXXX").string();
  folder_ = ::mkdtemp(name.data());
}

ScratchDatasetTest::~ScratchDatasetTest() { fs::remove_all(folder_); }

DatasetJob ScratchDatasetTest::JobOf(const InstanceSource& source, const std::string& out) const {
  DatasetJob job;
  job.source = &source;
  job.annotator = annotator_.get();
  job.out = folder_ / out;
  job.options.groups_per_part = 3;
  job.options.threads = 2;
  job.version = "test";
  return job;
}

std::map<std::string, std::string> ScratchDatasetTest::FilesOf(const std::string& out) const {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder_ / out)) {
    if (entry.is_regular_file())
      files[fs::relative(entry.path(), folder_ / out).string()] = ReadAll(entry.path());
  }
  return files;
}

}  // namespace latticeworld
