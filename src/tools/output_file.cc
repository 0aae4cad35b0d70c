#include "tools/output_file.h"

#include <system_error>

#include "latticeworld/common/files.h"

namespace latticeworld::tools {

Status ReplaceFile(const std::filesystem::path& path, const std::string& content) {
  std::filesystem::path temporary = path;
  temporary += ".part";
  Status status = WriteFile(temporary, content);
  if (status.ok()) status = RenameFile(temporary, path);
  std::error_code ignored;
  if (!status.ok()) std::filesystem::remove(temporary, ignored);
  return status;
}

}  // namespace latticeworld::tools
