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
  if (status.ok()) status = RenameFile(temporary, path);
  std::error_code ignored;
  if (!status.ok()) fs::remove(temporary, ignored);
  return status;
}

}  // namespace latticeworld
