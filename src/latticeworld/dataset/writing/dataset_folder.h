#ifndef LATTICEWORLD_DATASET_WRITING_DATASET_FOLDER_H_
#define LATTICEWORLD_DATASET_WRITING_DATASET_FOLDER_H_

#include <cstddef>
#include <filesystem>
#include <string>

#include "latticeworld/common/folder_lock.h"
#include "latticeworld/common/result.h"

namespace latticeworld {

// The folder of a data set in the making (dataset_writer.h), held against other processes.
class DatasetFolder {
 public:
  // Makes it where it is not there. fingerprint: what its records are made of. Errors:
  // ALREADY_EXISTS (work on it has begun, and `resume` is not given), FAILED_PRECONDITION (it
  // holds something else or was begun with another fingerprint; another process works on it), and
  // those of WholeFile.
  static Result<DatasetFolder> Open(const std::filesystem::path& root,
                                    const std::string& fingerprint, bool resume);

  const std::filesystem::path& root() const { return root_; }
  std::filesystem::path Manifest() const { return root_ / "dataset.json"; }
  bool IsWhole() const;  // it has its manifest

  std::filesystem::path PartFile(std::size_t part) const;
  std::filesystem::path ImagesOf(std::size_t part) const;
  std::string ImageNameOf(std::size_t part) const;  // the same below the root
  // Whether the part is there and undamaged.
  bool HasPart(std::size_t part) const;

  // What a process that was broken off left half-written.
  Status RemoveLeftovers() const;
  Status RemoveImages(std::size_t part) const;
  // All parts and the lock, once the files that were made of the parts are there.
  void RemoveParts() const;

 private:
  DatasetFolder(std::filesystem::path root, FolderLock lock);

  std::filesystem::path root_;
  FolderLock lock_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_DATASET_WRITING_DATASET_FOLDER_H_
