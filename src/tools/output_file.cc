#include "tools/output_file.h"

#include <system_error>

#include "latticeworld/common/files.h"

namespace latticeworld::tools {

Status ReplaceFile(const std::filesystem::path& path, const std::string& content) {
  std::filesystem::path temporary = path;
  temporary += ".part";
  Status status = WriteFile(temporary, content);
  std::error_code error;
  if (status.ok()) {
    std::filesystem::rename(temporary, path, error);
    if (error) status = Internal("cannot rename to " + path.string() + ": " + error.message());
  }
  if (!status.ok()) std::filesystem::remove(temporary, error);
  return status;
}

}  // namespace latticeworld::tools
