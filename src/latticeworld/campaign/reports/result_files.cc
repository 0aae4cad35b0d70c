#include "latticeworld/campaign/reports/result_files.h"

#include <unistd.h>

#include <string>
#include <system_error>

#include "latticeworld/common/files.h"

namespace latticeworld {

namespace fs = std::filesystem;

Status WriteWhole(const fs::path& path, std::string_view content) {
  fs::path temporary = path;
  temporary += "." + std::to_string(::getpid()) + ".part";
  Status status = WriteFile(temporary, content);
  std::error_code error;
  if (status.ok()) {
    fs::rename(temporary, path, error);
    if (error) status = Internal("cannot rename to " + path.string() + ": " + error.message());
  }
  if (!status.ok()) fs::remove(temporary, error);
  return status;
}

}  // namespace latticeworld
