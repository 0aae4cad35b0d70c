#include "latticeworld/episode/world_files.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

#include "latticeworld/common/files.h"
#include "latticeworld/common/text.h"
#include "latticeworld/generation/bundle/bundle.h"

namespace latticeworld {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxFiles = 256;
constexpr std::size_t kMaxFileBytes = 2048u << 20;

// A new directory for temporary files, gone with it.
class TemporaryDirectory {
 public:
  static Result<std::unique_ptr<TemporaryDirectory>> Create() {
    std::error_code error;
    const fs::path base = fs::temp_directory_path(error);
    if (error) return NotFound("there is no directory for temporary files: " + error.message());
    std::string name = (base / "latticeworld-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) {
      return ResourceExhausted("cannot make " + name + ": " + std::strerror(errno));
    }
    return std::unique_ptr<TemporaryDirectory>(new TemporaryDirectory(name));
  }
  ~TemporaryDirectory() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;
  const fs::path& path() const { return path_; }

 private:
  explicit TemporaryDirectory(fs::path path) : path_(std::move(path)) {}
  const fs::path path_;
};

// Letters, digits, '_', '-' and '.' in parts of which none begins with '.': none leads outside.
bool IsPlain(const std::string& path) {
  if (path.empty() || path.size() > 200) return false;
  bool begins = true;
  for (const char letter : path) {
    if (begins && (letter == '.' || letter == '/')) return false;
    begins = letter == '/';
    const bool known = (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
                       (letter >= '0' && letter <= '9') || std::strchr("_-./", letter) != nullptr;
    if (!known) return false;
  }
  return !begins;
}

Result<std::vector<WorldFile>> ReadAll(const fs::path& directory) {
  std::vector<WorldFile> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(directory)) {
    if (!entry.is_regular_file()) continue;
    LW_ASSIGN_OR_RETURN(std::string data, ReadFile(entry.path(), kMaxFileBytes));
    files.push_back({entry.path().lexically_relative(directory).generic_string(), std::move(data)});
  }
  std::sort(files.begin(), files.end(),
            [](const WorldFile& a, const WorldFile& b) { return a.path < b.path; });
  return files;
}

Status WriteAll(const std::vector<WorldFile>& files, const fs::path& directory) {
  if (files.empty()) return DataLoss("there are no files of a world");
  if (files.size() > kMaxFiles) {
    return DataLoss("there are " + std::to_string(files.size()) +
                    " files; a world has no more than " + std::to_string(kMaxFiles));
  }
  for (const WorldFile& file : files) {
    if (!IsPlain(file.path)) return DataLoss(Quote(file.path) + " is no file of a world");
    fs::create_directories((directory / file.path).parent_path());
    LW_RETURN_IF_ERROR(WriteFile(directory / file.path, file.data));
  }
  return Status();
}

}  // namespace

Result<std::vector<WorldFile>> PackWorld(const World& world) {
  try {
    LW_ASSIGN_OR_RETURN(const auto temporary, TemporaryDirectory::Create());
    const fs::path bundle = temporary->path() / "world";
    LW_RETURN_IF_ERROR(SaveBundle(world, bundle));
    return ReadAll(bundle);
  } catch (const std::exception& error) {  // std::filesystem
    return Internal(std::string("cannot pack the world: ") + error.what());
  }
}

Result<std::shared_ptr<const World>> UnpackWorld(const std::vector<WorldFile>& files) {
  try {
    LW_ASSIGN_OR_RETURN(const auto temporary, TemporaryDirectory::Create());
    const fs::path bundle = temporary->path() / "world";
    LW_RETURN_IF_ERROR(WriteAll(files, bundle));
    return LoadBundle(bundle);
  } catch (const std::exception& error) {  // std::filesystem
    return DataLoss(std::string("cannot unpack the world: ") + error.what());
  }
}

}  // namespace latticeworld
