#ifndef LATTICEWORLD_TESTS_DATASET_SCRATCH_DATASET_H_
#define LATTICEWORLD_TESTS_DATASET_SCRATCH_DATASET_H_

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "latticeworld/dataset/captions/annotator.h"
#include "latticeworld/dataset/sources/instance_source.h"
#include "latticeworld/dataset/writing/dataset_writer.h"

namespace latticeworld {

// The whole of a file that is there.
std::string ReadAll(const std::filesystem::path& path);

// Tests that write data sets into a folder of their own, with the written annotator.
class ScratchDatasetTest : public testing::Test {
 protected:
  ScratchDatasetTest();
  ~ScratchDatasetTest() override;

  // Parts of three groups, on two threads.
  DatasetJob JobOf(const InstanceSource& source, const std::string& out) const;
  // The bytes of all that a data set consists of, by path.
  std::map<std::string, std::string> FilesOf(const std::string& out) const;

  std::unique_ptr<Annotator> annotator_;
  std::filesystem::path folder_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_TESTS_DATASET_SCRATCH_DATASET_H_
