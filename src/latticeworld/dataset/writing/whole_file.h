#ifndef LATTICEWORLD_DATASET_WRITING_WHOLE_FILE_H_
#define LATTICEWORLD_DATASET_WRITING_WHOLE_FILE_H_

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "latticeworld/common/digest.h"
#include "latticeworld/common/result.h"

namespace latticeworld {

// What the temporary name of a file that is not whole yet ends with.
inline constexpr std::string_view kUnfinished = ".unfinished";

// A file that is written piece by piece and is there whole or not at all: until Commit it has a
// temporary name, and without Commit it is removed.
class WholeFile {
 public:
  // What was there before stays until Commit. Errors: PERMISSION_DENIED, NOT_FOUND,
  // RESOURCE_EXHAUSTED (no room), INTERNAL; each names the file.
  static Result<WholeFile> Create(const std::filesystem::path& path);
  WholeFile(WholeFile&& other) noexcept;
  WholeFile& operator=(WholeFile&&) = delete;
  ~WholeFile();

  Status Append(std::string_view bytes);
  // Syncs and renames; a loss of power does not undo it.
  Status Commit();

  std::size_t size() const { return size_; }       // [bytes]
  std::string Sha256() { return digest_->Hex(); }  // call once, after the last Append

 private:
  WholeFile(std::filesystem::path path, int fd);
  std::filesystem::path Temporary() const;

  std::filesystem::path path_;
  int fd_;  // -1 once committed or moved from
  std::size_t size_ = 0;
  std::unique_ptr<Digest> digest_;
};

// Create, Append and Commit.
Status WriteWholeFile(const std::filesystem::path& path, std::string_view content);

// Makes a directory and those above it. Errors: as above.
Status MakeDirectories(const std::filesystem::path& path);

}  // namespace latticeworld

#endif  // LATTICEWORLD_DATASET_WRITING_WHOLE_FILE_H_
